//! A deviation, and who is still too near under it.

use eigenform_apart::Paths;

use super::breaches::{Breach, Other};
use super::obstacles::Blocked;
use super::problem::Problem;
use super::sampling::{lengths, moved};
use super::shut::ShutOff;
use super::{AvoidanceReport, Edited, SLACK, is_among};
use crate::edits::deviation::Deviation;
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
}

impl Attempt {
    /// The guide moved by a deviation, checked exactly.
    pub(super) fn new(rung: usize, problem: &Problem, deviation: Paths) -> Self {
        let motion = moved(&problem.guide, &deviation);
        let clashes = clashes(&motion, problem.avoidance.minimum_distance - SLACK);
        let blocked = problem.avoidance.blocked(&motion, SLACK);
        let open_count =
            open_count(&clashes, &problem.breaches, &motion) + open_blocks(&blocked, &problem.breaches, &problem.shut_off).count();
        Self { rung, deviation, motion, clashes, blocked, open_count }
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

/// Agents that an obstacle blocks, that no keyframe has too near to it, and that have a way.
pub(super) fn open_blocks<'a>(blocked: &'a [Blocked], breaches: &[Breach], shut_off: &[ShutOff]) -> impl Iterator<Item = &'a Blocked> {
    let is_breach = |at: &Blocked| breaches.iter().any(|breach| breach.agent == at.agent && breach.other == Other::Obstacle(at.obstacle));
    blocked.iter().filter(move |at| !is_breach(at) && !is_among(shut_off, at.agent as usize))
}

/// Clashes of pairs that no keyframe has too near, in the sixth next to it.
pub(super) fn open_count(clashes: &[Approach], breaches: &[Breach], motion: &Motion) -> usize {
    let times = motion.times();
    let (start, end) = (times[0], times[times.len() - 1]);
    let is_excused = |clash: &Approach| {
        let fraction = (clash.time - start) / (end - start);
        breaches.iter().any(|breach| {
            let is_pair = breach.other == Other::Agent(clash.agents.1) && breach.agent == clash.agents.0;
            is_pair && if breach.end == 0 { fraction <= 1.0 / 6.0 } else { fraction >= 5.0 / 6.0 }
        })
    };
    clashes.iter().filter(|clash| !is_excused(clash)).count()
}
