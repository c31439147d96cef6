//! The paper's own ways to keep apart, beside those that a scene has: for comparison only.

/// What moves and parts a segment's agents in place of the scene's method and avoidance.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Counterpart {
    /// Paper A, section 4.3: social forces on the method's own way, then smoothed.
    GuidedForce,
    /// Its counter-example: social forces toward the target and nothing else. Nobody is made to arrive.
    PlainForce,
}

impl Counterpart {
    /// Every counterpart with its name.
    pub const ALL: [(&str, Self); 2] = [("social-force-guide", Self::GuidedForce), ("social-force", Self::PlainForce)];

    /// By its name.
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|(known, _)| *known == name).map(|(_, counterpart)| counterpart)
    }
}
