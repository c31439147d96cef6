//! A crowd along a guide: the guide says where everybody is to be, social forces how they get there (paper D, sections 3.3 and 3.5;
//! paper A, section 4.3).
//!
//! Agents aim at where their guide is a short time ahead, so the plan stays and the forces are local: the way around an obstacle is the
//! guide's, and whom no way leads around keeps to its guide through it, pushed by no wall. The last stretch leads back onto the guide,
//! so that everybody arrives where and when it does. In space, forces are in plan and heights are the guide's.

mod ending;
mod guide;
mod job;
mod row;
#[cfg(test)]
mod tests;
mod walkers;

use eigenform_apart::Outline;
use eigenform_force::{Constants, Feedback};

use super::deviation::Deviation;
use crate::motion::Motion;

pub use job::{CrowdJob, CrowdStep};

/// Who is in the crowd, and how it moves. Lists have an entry an agent.
#[derive(Clone, Debug)]
pub struct CrowdRules {
    /// The table; its lengths are in units.
    pub constants: Constants,
    /// Which feedback there is.
    pub feedback: Feedback,
    /// The unit, meters.
    pub unit: f64,
    /// Body radii, meters.
    pub radius: Vec<f64>,
    /// Meters a second; infinite for no limit.
    pub top_speed: Vec<f64>,
    /// Subgroups from 0, or [`super::NO_GROUP`].
    pub group: Vec<u32>,
    /// What stands in the way.
    pub obstacles: Vec<Outline>,
    /// How far from it the guide is led around it, meters; 0: not at all.
    pub clearance: f64,
    /// Of the fluctuation.
    pub seed: u32,
    /// Agents avoid each other by optimal reciprocal collision avoidance, and there are no forces: to compare with.
    #[cfg(feature = "comparison")]
    pub is_reciprocal: bool,
    /// Where agents go.
    pub aim: Aim,
    /// How they arrive.
    pub ending: Ending,
    /// Whether to wait until all have arrived: it takes as long again or more, and changes nothing else.
    pub waits: bool,
    /// Meters a second of everybody who arrives when they do: the guide stands at its end for as long as they may be waited for, and
    /// the motion is over once they are there. None: it is over when the guide is.
    pub pace: Option<f64>,
}

/// Where agents aim.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Aim {
    /// A short time ahead on the guide.
    Guide,
    /// At the guide's end from the start.
    Target,
}

/// How a motion ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Ending {
    /// On the guide: exactly, with its velocity.
    Exact,
    /// As [`Self::Exact`], and smoothed throughout as far as nobody comes nearer than this, meters, or than they did.
    Smoothed(f64),
    /// Wherever the forces have led.
    AsItComes,
}

/// A motion that forces led along its guide.
pub struct Led {
    /// Sampled as the guide.
    pub motion: Motion,
    /// What was added to the guide.
    pub deviation: Deviation,
    /// How far that is over agents and samples: mean and greatest, meters.
    pub distance: [f64; 2],
    /// How far agents were from the guide's end when it ended, by forces alone: mean and greatest, meters.
    pub arrival_error: [f64; 2],
    /// Seconds from the start until everybody was near the guide's end by forces alone, and stayed; none when they were not, or when
    /// nobody waited for it.
    pub arrived_after: Option<f64>,
}
