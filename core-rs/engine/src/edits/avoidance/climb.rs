//! One attempt in steps: pushed apart at the knots, lifted to the frames, checked exactly, repaired there where little is missing.

use eigenform_apart::{Paths, Solver, State};

use super::attempt::Attempt;
use super::free;
use super::gaps::lead_through;
use super::problem::Problem;
use super::reroute::reroute;
use super::rungs::{Bend, Rung};
use super::sampling::{at_knots, at_samples, difference, lifted, sum};
use super::ways::lead_each;

/// Pushes of one step; a few milliseconds.
const VISITS_PER_STEP: usize = 20_000;

/// Sweeps that progress is told by: of an attempt with its repair.
const TYPICAL_SWEEPS: f64 = 200.0;

/// More pairs than this that an attempt leaves too near are not worth a repair on the frames.
const REPAIRABLE_CLASHES: usize = 12;

/// More agents × samples than this are not repaired on the frames: 200 MB.
const REPAIRABLE_SAMPLES: usize = 4_000_000;

/// So many knots have a number of their own.
const REPAIRABLE_LENGTH: usize = 1 << 16;

/// The work on one attempt.
pub(super) struct Climb {
    rung: Rung,
    number: usize,
    solver: Box<Solver>,
    /// What came of the knots, while it is repaired.
    lifted: Option<Box<Attempt>>,
    sweeps_before: usize,
}

/// What a step came to.
pub(super) enum ClimbStep {
    /// How far it is, 0–1.
    Progress(f64),
    /// It is as good as it gets.
    Done(Box<Attempt>),
}

impl Climb {
    /// Attempt `number` at the guide, once `warp` has bent its paths at the knots.
    pub(super) fn new(problem: &Problem, rung: Rung, number: usize, warp: impl FnOnce(&mut Paths)) -> Self {
        let Problem { avoidance, guide, ways, shut_off, .. } = problem;
        let knot_count = rung.knot_count(*ways, avoidance.minimum_distance, guide.times().len());
        let mut paths = at_knots(guide, knot_count);
        if !avoidance.obstacles.is_empty() {
            let free = free(guide.agent_count(), shut_off);
            if rung.bend == Bend::Close {
                lead_through(&mut paths, &avoidance.obstacles, avoidance.minimum_distance, &free);
            }
            if rung.bend == Bend::Ways {
                lead_each(&mut paths, avoidance, &free);
            } else {
                reroute(&mut paths, avoidance, rung.parting, &free);
            }
        }
        warp(&mut paths);
        let kernel = rung.kernel(*ways, avoidance, knot_count);
        let solver = Box::new(Solver::new(paths, kernel, rung.rules(avoidance)));
        Self { rung, number, solver, lifted: None, sweeps_before: 0 }
    }

    /// Works for some milliseconds; longer for thousands of agents.
    pub(super) fn step(&mut self, problem: &mut Problem) -> ClimbStep {
        if self.sweep(problem) == State::Working {
            let sweeps = (self.sweeps_before + self.solver.sweep_count()) as f64;
            return ClimbStep::Progress((sweeps / TYPICAL_SWEEPS).min(1.0));
        }
        match self.lifted.take() {
            None => self.lift(problem),
            Some(lifted) => {
                let deviation = sum(&lifted.deviation, &difference(self.solver.paths(), self.solver.guide()));
                let repaired = Attempt::new(self.number, problem, deviation);
                ClimbStep::Done(if repaired.open_count < lifted.open_count { Box::new(repaired) } else { lifted })
            }
        }
    }

    fn lift(&mut self, problem: &Problem) -> ClimbStep {
        let Problem { avoidance, guide, ways, .. } = problem;
        // From the guide itself, which a warp or a way around an obstacle has left before.
        let knot_count = self.solver.paths().knot_count();
        let deviation = difference(self.solver.paths(), &at_knots(guide, knot_count));
        let attempt = Box::new(Attempt::new(self.number, problem, lifted(&deviation, guide.times(), avoidance.is_clamped)));
        let sample_count = guide.times().len();
        let is_small = sample_count <= REPAIRABLE_LENGTH && sample_count * guide.agent_count() <= REPAIRABLE_SAMPLES;
        if attempt.open_count == 0 || attempt.open_count > REPAIRABLE_CLASHES || !is_small {
            return ClimbStep::Done(attempt);
        }
        let kernel = self.rung.frame_kernel(*ways, avoidance, knot_count, sample_count);
        let paths = at_samples(guide, &attempt.deviation);
        self.sweeps_before += self.solver.sweep_count();
        *self.solver = Solver::new(paths, kernel, self.rung.frame_rules(avoidance));
        self.lifted = Some(attempt);
        ClimbStep::Progress((self.sweeps_before as f64 / TYPICAL_SWEEPS).min(1.0))
    }

    /// Sweeps for a step's worth of pushes.
    fn sweep(&mut self, problem: &mut Problem) -> State {
        let before = self.solver.visits();
        loop {
            if self.solver.needs_list() {
                problem.lister.list(&mut self.solver, &problem.breaches, &problem.shut_off, &problem.avoidance);
            }
            let state = self.solver.sweep();
            if state != State::Working || self.solver.visits() - before >= VISITS_PER_STEP {
                return state;
            }
        }
    }
}
