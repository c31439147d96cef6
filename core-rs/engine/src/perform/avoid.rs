//! Keeps a segment's agents apart, once it is known where the method has them.

mod suggest;

use super::brief::Brief;
use super::innermost::innermost_groups;
use super::outcome::Avoided;
use super::tied;
use crate::choice::Choice;
use crate::edits::{Avoidance, AvoidanceJob, AvoidanceStep, Deviation, Edited, judge};
use crate::measure::{Clearance, Extreme};
use crate::motion::{Approach, Motion, closeness};
use crate::transition::Chain;

/// The work of keeping apart.
pub(super) struct Avoiding {
    job: AvoidanceJob,
    guide_clearance: Option<Clearance>,
    progress: f64,
}

/// What is kept of it.
pub(super) struct Kept {
    pub(super) motion: Motion,
    pub(super) deviation: Option<Deviation>,
    pub(super) avoided: Option<Avoided>,
}

impl Kept {
    /// Nobody was to be kept apart.
    pub(super) fn as_is(motion: Motion) -> Self {
        Self { motion, deviation: None, avoided: None }
    }

    /// How many meetings are still too near.
    pub(super) fn unsolved_count(&self) -> usize {
        self.avoided.as_ref().map_or(0, |avoided| avoided.unsolved.len())
    }

    /// Whether a keyframe itself is to blame.
    pub(super) fn has_breaches(&self) -> bool {
        self.avoided.as_ref().is_some_and(|avoided| !avoided.breaches.is_empty())
    }
}

impl Avoiding {
    /// Starts on a guide; gives it back where the segment keeps nobody apart. A guide that `is_settled` is checked and stays as it is.
    pub(super) fn of(brief: &Brief, chain: &Chain, guide: Motion, is_settled: bool) -> Result<Self, Motion> {
        if !brief.own.transition.avoidance || brief.minimum_distance <= 0.0 || guide.agent_count() == 0 {
            return Err(guide);
        }
        let guide_clearance = closeness(&guide, 0.0).nearest().map(clearance);
        let asked = avoidance(brief, chain, &guide);
        let job = if is_settled { AvoidanceJob::check(asked, guide) } else { AvoidanceJob::new(asked, guide) };
        Ok(Self { job, guide_clearance, progress: 0.0 })
    }

    /// Works for some milliseconds; what came of it once it is done.
    pub(super) fn step(&mut self, brief: &Brief, choice: &Choice) -> Option<Kept> {
        match self.job.step() {
            AvoidanceStep::Progress(progress) => {
                self.progress = progress;
                None
            }
            AvoidanceStep::Done(edited) => {
                let Edited { motion, deviation, report } = *edited;
                let suggestions = suggest::suggestions(&report, &motion, choice, brief.minimum_distance);
                let [mean, max] = report.deviation;
                let avoided = Avoided {
                    guide_clearance: self.guide_clearance,
                    deviation: Extreme { mean, max },
                    unsolved: report.unsolved.into_iter().map(clearance).collect(),
                    blocked: report.blocked,
                    breaches: report.breaches,
                    shut_off: report.shut_off,
                    rung: report.rung,
                    suggestions,
                };
                Some(Kept { motion, deviation, avoided: Some(avoided) })
            }
        }
    }

    /// 0–1; never falls.
    pub(super) fn progress(&self) -> f64 {
        self.progress
    }
}

/// What a counterpart comes to where avoidance would have worked: the same numbers, found by the same check.
pub(super) fn judged(brief: &Brief, chain: &Chain, motion: &Motion, deviation: Extreme) -> Option<Avoided> {
    let is_asked = brief.minimum_distance > 0.0 && motion.agent_count() > 0;
    is_asked.then(|| {
        let report = judge(&avoidance(brief, chain, motion), motion);
        Avoided {
            guide_clearance: None,
            deviation,
            unsolved: report.unsolved.into_iter().map(clearance).collect(),
            blocked: report.blocked,
            breaches: report.breaches,
            shut_off: report.shut_off,
            rung: 0,
            suggestions: Vec::new(),
        }
    })
}

/// What a segment asks to be kept apart, on its way by `guide` along `chain`.
pub(super) fn avoidance(brief: &Brief, chain: &Chain, guide: &Motion) -> Avoidance {
    Avoidance {
        minimum_distance: brief.minimum_distance,
        is_clamped: brief.stops().map(|is_stop| !is_stop),
        seed: brief.seed,
        obstacles: brief.outlines(),
        holds: tied::holds(guide, chain, &brief.obstacles, brief.minimum_distance),
        groups: if brief.obstacles.is_empty() { Vec::new() } else { innermost_groups(&brief.groups, guide.agent_count()) },
    }
}

pub(super) fn clearance(approach: Approach) -> Clearance {
    let Approach { distance, time, agents } = approach;
    Clearance { distance, time, agents }
}

/// A meeting as the engine's rooms below know it.
pub(super) fn approach(clearance: &Clearance) -> Approach {
    let Clearance { distance, time, agents } = *clearance;
    Approach { distance, time, agents }
}
