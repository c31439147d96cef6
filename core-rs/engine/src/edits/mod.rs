//! What changes a whole motion.
//!
//! An edit takes a motion and gives another of the same agents and samples; it knows neither scenes nor methods. A crowd follows its
//! guide first, avoidance keeps apart whoever is too near then. Long work is a job of steps, as everywhere.

mod avoidance;
mod crowd;
mod deviation;
mod grain;
mod moved;

pub use avoidance::{
    Avoidance, AvoidanceJob, AvoidanceReport, AvoidanceStep, Blocked, Breach, Edited, Hold, Other, ShutOff, SpreadJob, SpreadStep,
    is_modest, judge, nearest_to,
};
pub use crowd::{Aim, CrowdJob, CrowdRules, CrowdStep, Ending, Led};
pub use deviation::Deviation;
pub use eigenform_apart::Outline;
pub use eigenform_force::{Constants, Feedback, NO_GROUP};
