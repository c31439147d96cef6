//! The papers' own ways to keep apart and others', beside those that a scene has: for comparison only.

/// What a comparison asks of a segment beside its scene.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Aside {
    /// What moves it in place of what it asks for.
    pub counterpart: Option<Counterpart>,
    /// Whether forces go on until everybody has arrived by them.
    pub waits: bool,
    /// Meters a second of everybody who arrives when they do; none: at the keyframe's time.
    pub pace: Option<f64>,
}

/// What moves and parts a segment's agents in place of the scene's method and avoidance.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Counterpart {
    /// Paper A, section 4.3: social forces on the method's own way, then smoothed.
    GuidedForce,
    /// Its counter-example: social forces toward the target and nothing else. Nobody is made to arrive.
    PlainForce,
    /// Optimal reciprocal collision avoidance toward the target, as others have it (paper D, section 5.4). Nobody is made to arrive.
    #[cfg(feature = "comparison")]
    Orca,
}

impl Counterpart {
    /// Every counterpart with its name.
    pub const ALL: &[(&str, Self)] = &[
        ("social-force-guide", Self::GuidedForce),
        ("social-force", Self::PlainForce),
        #[cfg(feature = "comparison")]
        ("orca", Self::Orca),
    ];

    /// By its name.
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.iter().find(|(known, _)| *known == name).map(|(_, counterpart)| *counterpart)
    }
}
