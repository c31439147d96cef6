//! Avoidance in steps: check, try rung after rung, keep the best.

use super::attempt::Attempt;
use super::climb::{Climb, ClimbStep};
use super::problem::Problem;
use super::reroute::Parting;
use super::rungs::{Bend, RUNGS, Rung};
use super::streams::Streams;
use super::warp::{is_flung, is_sane, stuck, swirl};
use super::{Avoidance, AvoidanceReport, Edited, SLACK};
use crate::motion::{Approach, Motion};

/// What a step came to.
pub enum AvoidanceStep {
    /// How far it is, 0–1; never falls.
    Progress(f64),
    /// The best that was found.
    Done(Box<Edited>),
}

/// The work on one motion.
pub struct AvoidanceJob {
    phase: Phase,
    rung: usize,
    best: Option<Best>,
    streams: Option<Streams>,
    /// Nothing is moved, whatever is too near.
    only_checks: bool,
}

/// The best attempt so far.
struct Best {
    attempt: Attempt,
    /// Whether somebody has to run or to go far astray.
    is_hasty: bool,
    /// Whether the guide as it is does less harm.
    is_harmful: bool,
}

impl Best {
    fn of(attempt: Attempt, problem: &Problem) -> Self {
        let is_harmful = attempt.open_count > 0 && is_flung(&attempt, problem) || brings_nearer(&attempt, problem);
        Self { is_hasty: !is_sane(&attempt, problem), is_harmful, attempt }
    }

    /// What counts against it, first what counts most.
    fn faults(&self) -> (bool, usize, usize, bool) {
        (self.is_harmful, self.attempt.through_count, self.attempt.open_count, self.is_hasty)
    }
}

enum Phase {
    Checking(Box<(Avoidance, Motion)>),
    Climbing(Box<(Problem, Climb)>),
    Finished,
}

impl AvoidanceJob {
    /// Nothing is done yet.
    ///
    /// # Panics
    /// When the minimum distance is not above zero: nothing is to be avoided then.
    pub fn new(avoidance: Avoidance, guide: Motion) -> Self {
        assert!(avoidance.minimum_distance > 0.0, "there is a distance to keep");
        Self { phase: Phase::Checking(Box::new((avoidance, guide))), rung: 0, best: None, streams: None, only_checks: false }
    }

    /// The same numbers of a motion that is to stay as it is.
    ///
    /// # Panics
    /// As [`AvoidanceJob::new`].
    pub fn check(avoidance: Avoidance, motion: Motion) -> Self {
        Self { only_checks: true, ..Self::new(avoidance, motion) }
    }

    /// Works for some milliseconds; longer for thousands of agents.
    ///
    /// # Panics
    /// After it was done: a bug of the caller.
    pub fn step(&mut self) -> AvoidanceStep {
        match std::mem::replace(&mut self.phase, Phase::Finished) {
            Phase::Checking(given) => self.begin(Problem::of(given.0, given.1)),
            Phase::Climbing(mut at) => {
                let (problem, climb) = &mut *at;
                match climb.step(problem) {
                    ClimbStep::Progress(within) => {
                        self.phase = Phase::Climbing(at);
                        self.progress(within)
                    }
                    ClimbStep::Done(attempt) => {
                        self.keep(*attempt, problem);
                        self.end_rung(at.0)
                    }
                }
            }
            Phase::Finished => panic!("the job was done"),
        }
    }

    fn progress(&self, within: f64) -> AvoidanceStep {
        AvoidanceStep::Progress((self.rung as f64 + within) / RUNGS.len() as f64)
    }

    fn begin(&mut self, problem: Problem) -> AvoidanceStep {
        if self.only_checks || !problem.can_be_mended() {
            return as_it_is(problem);
        }
        self.streams = Streams::of(&problem.guide, &problem.clashes, problem.avoidance.minimum_distance);
        self.start_rung(problem);
        self.progress(0.0)
    }

    fn start_rung(&mut self, problem: Problem) {
        let rung = RUNGS[self.rung];
        let distance = problem.avoidance.minimum_distance;
        let climb = Climb::new(&problem, rung, self.rung + 1, |paths| match rung.bend {
            Bend::No | Bend::Close | Bend::Ways => {}
            Bend::Swirl(width) => {
                if let Some(best) = &self.best {
                    let is_stuck = stuck(&best.attempt.clashes, &problem.clashes, problem.guide.agent_count());
                    swirl(paths, &is_stuck, width * distance);
                }
            }
            Bend::Open(share) => self.streams.iter().for_each(|streams| streams.open(paths, share, distance)),
        });
        self.phase = Phase::Climbing(Box::new((problem, climb)));
    }

    /// Keeps an attempt that leaves fewer too near than any before, or as few without haste; a bent one only where it solves and can be
    /// shown. A gap leaves no other way than through it.
    fn keep(&mut self, attempt: Attempt, problem: &Problem) {
        let new = Best::of(attempt, problem);
        let is_wild = match RUNGS[self.rung].bend {
            Bend::No | Bend::Ways => false,
            Bend::Close => new.attempt.open_count > 0,
            Bend::Open(_) | Bend::Swirl(_) => new.attempt.open_count > 0 || new.is_hasty,
        };
        if !is_wild && self.best.as_ref().is_none_or(|best| new.faults() < best.faults()) {
            self.best = Some(new);
        }
    }

    /// Whether nobody is too near, and nobody has to run or go far astray where streams may still open, or a group part.
    fn is_good_enough(&self, problem: &Problem) -> bool {
        let may_open = self.streams.is_some() && RUNGS[self.rung..].iter().any(|rung| matches!(rung.bend, Bend::Open(_)));
        let may_part = problem.avoidance.has_groups() && RUNGS[self.rung - 1].parting != Parting::Groups;
        self.best.as_ref().is_some_and(|best| best.attempt.open_count == 0 && !(best.is_hasty && (may_open || may_part)))
    }

    fn end_rung(&mut self, problem: Problem) -> AvoidanceStep {
        self.rung += 1;
        let may_be_gaps = problem.avoidance.obstacles.len() > 1;
        let is_idle = |rung: &Rung| match rung.bend {
            Bend::Close => !may_be_gaps,
            Bend::Ways => problem.blocked.is_empty(),
            Bend::Open(_) => self.streams.is_none(),
            _ => false,
        };
        while RUNGS.get(self.rung).is_some_and(is_idle) {
            self.rung += 1;
        }
        if self.rung < RUNGS.len() && !self.is_good_enough(&problem) {
            self.start_rung(problem);
            return self.progress(0.0);
        }
        let best = self.best.take().expect("a rung was climbed");
        if best.is_harmful {
            return as_it_is(problem);
        }
        AvoidanceStep::Done(Box::new(best.attempt.into_edited(problem.breaches, problem.shut_off, problem.avoidance.is_clamped)))
    }
}

/// The guide, with what is too near on it.
fn as_it_is(problem: Problem) -> AvoidanceStep {
    let Problem { guide, clashes, blocked, breaches, shut_off, .. } = problem;
    let report = AvoidanceReport { deviation: [0.0; 2], unsolved: clashes, blocked, breaches, shut_off, rung: 0 };
    AvoidanceStep::Done(Box::new(Edited { motion: guide, deviation: None, report }))
}

/// Where keyframes have agents too near already: whether somebody comes nearer than anybody was.
fn brings_nearer(attempt: &Attempt, problem: &Problem) -> bool {
    let least = |clashes: &[Approach]| clashes.iter().map(|clash| clash.distance).fold(f64::INFINITY, f64::min);
    !problem.breaches.is_empty() && least(&attempt.clashes) < least(&problem.clashes) - SLACK
}
