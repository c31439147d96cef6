//! A deviation, and who is still too near under it.

use eigenform_apart::Paths;

use super::breaches::Breach;
use super::obstacles::Blocked;
use super::open::{open_blocks, open_clashes};
use super::problem::Problem;
use super::sampling::lengths;
use super::shut::ShutOff;
use super::{AvoidanceReport, Edited, SLACK};
use crate::edits::deviation::Deviation;
use crate::edits::moved::moved;
use crate::motion::{Approach, Motion, clashes};

/// What came of one rung.
pub(super) struct Attempt {
    pub(super) rung: usize,
    /// A knot a sample.
    pub(super) deviation: Paths,
    pub(super) motion: Motion,
    pub(super) clashes: Vec<Approach>,
    pub(super) blocked: Vec<Blocked>,
    /// How many of all those no keyframe is to blame for.
    pub(super) open_count: usize,
    /// How many go through an obstacle.
    pub(super) through_count: usize,
}

impl Attempt {
    /// The guide moved by a deviation, checked exactly.
    pub(super) fn new(rung: usize, problem: &Problem, deviation: Paths) -> Self {
        let motion = moved(&problem.guide, &deviation);
        let clashes = clashes(&motion, problem.avoidance.minimum_distance - SLACK);
        let blocked = problem.avoidance.blocked(&motion, SLACK);
        let blocks = || open_blocks(&blocked, &problem.breaches, &problem.shut_off);
        let open_count = open_clashes(&clashes, &problem.breaches, &motion).count() + blocks().count();
        let through_count = blocks().filter(|at| at.distance < 0.0).count();
        Self { rung, deviation, motion, clashes, blocked, open_count, through_count }
    }

    /// As it is handed out.
    pub(super) fn into_edited(self, breaches: Vec<Breach>, shut_off: Vec<ShutOff>, is_clamped: [bool; 2]) -> Edited {
        let deviation = Deviation::new(self.motion.times().to_vec(), &self.deviation, is_clamped);
        let report = AvoidanceReport {
            deviation: self.deviation_lengths(),
            unsolved: self.clashes,
            blocked: self.blocked,
            breaches,
            shut_off,
            rung: self.rung,
        };
        Edited { motion: self.motion, deviation: Some(deviation), report }
    }

    /// Mean and greatest length of the deviation, meters.
    pub(super) fn deviation_lengths(&self) -> [f64; 2] {
        lengths(&self.deviation)
    }
}
