//! What forces and avoidance came to in a segment, as the person reads it.

use serde::Serialize;

use super::hurry::Hurry;
use crate::edits::{Blocked, Breach, Deviation, ShutOff};
use crate::measure::{Clearance, Extreme};

/// What the forces came to in a segment. Flat in the segment's report.
#[derive(Debug, Serialize)]
#[serde(rename_all = "camelCase")]
pub struct Crowded {
    /// How far agents are from their guide, over agents and samples, meters.
    pub guide_deviation: Extreme,
    /// How far they were from the target when the time was over, by forces alone, meters.
    pub arrival_error: Extreme,
    /// Seconds until everybody was there by forces alone; none when that was not waited for, or never.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub arrived_after: Option<f64>,
    /// Who has to be faster than they can to be there in time; nobody where nothing is limited.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub hurried: Vec<Hurry>,
    #[serde(skip)]
    pub(super) deviation: Deviation,
}

/// What avoidance came to in a segment. Flat in the segment's report.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(rename_all = "camelCase")]
pub struct Avoided {
    /// The nearest that any two came before; none for fewer than two agents.
    pub guide_clearance: Option<Clearance>,
    /// How far agents are from where the method has them, over agents and samples, meters.
    pub deviation: Extreme,
    /// Every meeting that is still too near, by time; empty when it is solved.
    pub unsolved: Vec<Clearance>,
    /// Everybody still too near to an obstacle, at the nearest.
    pub blocked: Vec<Blocked>,
    /// Who stands too near in a keyframe already.
    pub breaches: Vec<Breach>,
    /// Whom no way leads around obstacles: they go where the method has them.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub shut_off: Vec<ShutOff>,
    /// The attempt that was kept, from 1; 0 when none was needed.
    pub rung: usize,
    /// What may help where it is not solved, the likeliest first.
    pub suggestions: Vec<Suggestion>,
}

/// A next step for the person.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[serde(tag = "kind", rename_all = "camelCase")]
pub enum Suggestion {
    /// These two take each other's places in the target: together they then go less far.
    Swap {
        /// Lower index first.
        agents: (u32, u32),
    },
    /// Everybody takes the place that makes the sum of squared ways least: such ways hardly ever clash.
    Assign,
    /// Straight ways.
    Straight,
    /// More sharing of the two bases.
    Sharing {
        /// ρ.
        sharing: f64,
    },
    /// What this motion keeps.
    Distance {
        /// Meters.
        distance: f64,
    },
    /// A keyframe between, where they are nearest.
    Keyframe {
        /// Scene seconds.
        time: f64,
    },
}
