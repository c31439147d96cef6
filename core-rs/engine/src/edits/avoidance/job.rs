//! Avoidance in steps: check, try rung after rung, keep the best.

use super::attempt::Attempt;
use super::climb::{Climb, ClimbStep};
use super::problem::Problem;
use super::rungs::RUNGS;
use super::warp::{is_sane, stuck, swirl};
use super::{Avoidance, AvoidanceReport, Edited};
use crate::motion::Motion;

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
    best: Option<Attempt>,
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
        Self { phase: Phase::Checking(Box::new((avoidance, guide))), rung: 0, best: None }
    }

    /// Works for some milliseconds; longer for thousands of agents.
    ///
    /// # Panics
    /// After it was done: a bug of the caller.
    pub fn step(&mut self) -> AvoidanceStep {
        match std::mem::replace(&mut self.phase, Phase::Finished) {
            Phase::Checking(given) => self.check(Problem::of(given.0, given.1)),
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

    fn check(&mut self, problem: Problem) -> AvoidanceStep {
        if !problem.can_be_mended() {
            let Problem { guide, clashes, blocked, breaches, .. } = problem;
            let report = AvoidanceReport { deviation: [0.0; 2], unsolved: clashes, blocked, breaches, rung: 0 };
            return AvoidanceStep::Done(Box::new(Edited { motion: guide, deviation: None, report }));
        }
        self.start_rung(problem);
        self.progress(0.0)
    }

    fn start_rung(&mut self, problem: Problem) {
        let rung = RUNGS[self.rung];
        let climb = Climb::new(&problem, rung, self.rung + 1, |paths| {
            if let (Some(best), true) = (&self.best, rung.swirl > 0.0) {
                let is_stuck = stuck(&best.clashes, &problem.clashes, problem.guide.agent_count());
                swirl(paths, &is_stuck, rung.swirl * problem.avoidance.minimum_distance);
            }
        });
        self.phase = Phase::Climbing(Box::new((problem, climb)));
    }

    /// Keeps an attempt that leaves fewer too near than any before; a swirl only where it solves and can be shown.
    fn keep(&mut self, attempt: Attempt, problem: &Problem) {
        if RUNGS[self.rung].swirl > 0.0 && (attempt.open_count > 0 || !is_sane(&attempt, problem)) {
            return;
        }
        if self.best.as_ref().is_none_or(|best| attempt.open_count < best.open_count) {
            self.best = Some(attempt);
        }
    }

    fn end_rung(&mut self, problem: Problem) -> AvoidanceStep {
        self.rung += 1;
        let is_done = self.rung == RUNGS.len() || self.best.as_ref().is_some_and(|best| best.open_count == 0);
        if !is_done {
            self.start_rung(problem);
            return self.progress(0.0);
        }
        let best = self.best.take().expect("a rung was climbed");
        AvoidanceStep::Done(Box::new(best.into_edited(problem.breaches, problem.avoidance.is_clamped)))
    }
}
