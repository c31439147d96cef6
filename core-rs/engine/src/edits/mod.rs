//! What changes a whole motion.
//!
//! An edit takes a motion and gives another of the same agents and samples; it knows neither scenes nor methods. Avoidance is the
//! first. Long work is a job of steps, as everywhere.

mod avoidance;
mod deviation;
mod spline;

pub use avoidance::{Avoidance, AvoidanceJob, AvoidanceReport, AvoidanceStep, Blocked, Breach, Edited, Hold, Other, nearest_to};
pub use deviation::Deviation;
pub use eigenform_apart::Outline;
