//! What moves agents from one moment to the next, whatever leads them.

use eigenform_force::{Bodies, Crowd, Setting};

use super::{CrowdRules, Outline};

/// A crowd under forces, or one of another kind to compare it with.
pub(super) enum Walkers {
    Forces(Box<Crowd>),
    #[cfg(feature = "comparison")]
    Reciprocal(Box<eigenform_orca::Walkers>),
}

/// How fast anybody would be, units a second.
#[derive(Clone, Copy)]
pub(super) struct Speeds {
    pub(super) wished: f64,
    /// When giving way, of those who need a limit for it.
    #[cfg_attr(not(feature = "comparison"), expect(dead_code, reason = "forces know no limit"))]
    pub(super) greatest: f64,
}

/// What stands in the way.
pub(super) struct InTheWay {
    pub(super) obstacles: Vec<Outline>,
    /// By agent, whether it goes through: no way leads around.
    pub(super) goes_through: Vec<bool>,
}

impl Walkers {
    /// In units, as everything here.
    pub(super) fn new(rules: &CrowdRules, bodies: Bodies, way: InTheWay, usual_radius: f64, speeds: Speeds) -> Self {
        let InTheWay { obstacles, goes_through } = way;
        #[cfg(feature = "comparison")]
        if rules.is_reciprocal {
            let Speeds { wished, greatest } = speeds;
            let setting = eigenform_orca::Setting { obstacles, unit: rules.unit, wished, greatest };
            return Self::Reciprocal(Box::new(eigenform_orca::Walkers::new(bodies, setting)));
        }
        let setting = Setting { obstacles, goes_through, usual_radius, hurry: speeds.wished, seed: rules.seed };
        Self::Forces(Box::new(Crowd::new(rules.constants, rules.feedback, bodies, setting)))
    }

    /// Where everybody is: x and y by agent.
    pub(super) fn places(&self) -> [&[f64]; 2] {
        match self {
            Self::Forces(crowd) => crowd.places(),
            #[cfg(feature = "comparison")]
            Self::Reciprocal(walkers) => walkers.places(),
        }
    }

    /// Where everybody wants to be next.
    pub(super) fn aims_mut(&mut self) -> [&mut [f64]; 2] {
        match self {
            Self::Forces(crowd) => crowd.aims_mut(),
            #[cfg(feature = "comparison")]
            Self::Reciprocal(walkers) => walkers.aims_mut(),
        }
    }

    /// How fast everybody can be; nobody where nothing but a pace of their own limits them.
    pub(super) fn top_speeds_mut(&mut self) -> &mut [f64] {
        match self {
            Self::Forces(crowd) => crowd.top_speeds_mut(),
            #[cfg(feature = "comparison")]
            Self::Reciprocal(_) => &mut [],
        }
    }

    /// Moves on by `seconds`; agents want to be where they aim `within` seconds from now.
    pub(super) fn step(&mut self, seconds: f64, within: f64) {
        match self {
            Self::Forces(crowd) => crowd.step(seconds, within),
            #[cfg(feature = "comparison")]
            Self::Reciprocal(walkers) => walkers.step(seconds, within),
        }
    }
}
