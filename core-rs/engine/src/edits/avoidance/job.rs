//! Avoidance in steps: check, try rung after rung, keep the best.

use eigenform_apart::{Paths, Solver, State};

use super::attempt::{Attempt, free_count, open_count};
use super::breaches::{Breach, breaches};
use super::meetings::Lister;
use super::reroute::reroute;
use super::rungs::{RUNGS, Ways};
use super::sampling::{at_knots, at_samples, difference, lifted, sum};
use super::swirl::{is_sane, stuck, swirl};
use super::{Avoidance, AvoidanceReport, BREACH_LIMIT, Edited, SLACK};
use crate::edits::deviation::Deviation;
use crate::motion::{Approach, Motion, clashes};

/// Pushes of one step; a few milliseconds.
const VISITS_PER_STEP: usize = 20_000;

/// More pairs than this that a rung leaves too near are not worth a repair on the frames.
const REPAIRABLE_CLASHES: usize = 12;

/// More agents × samples than this are not repaired on the frames: 200 MB.
const REPAIRABLE_SAMPLES: usize = 4_000_000;

/// So many knots have a number of their own.
const REPAIRABLE_LENGTH: usize = 1 << 16;

/// What a step came to.
pub enum AvoidanceStep {
    /// How far it is, 0–1; never falls.
    Progress(f64),
    /// The best that was found.
    Done(Box<Edited>),
}

/// The work on one motion.
pub struct AvoidanceJob {
    avoidance: Avoidance,
    guide: Motion,
    ways: Ways,
    /// Of the guide.
    clashes: Vec<Approach>,
    breaches: Vec<Breach>,
    lister: Lister,
    phase: Phase,
    rung: usize,
    best: Option<Attempt>,
}

enum Phase {
    Checking,
    Climbing(Box<Solver>),
    /// A result at the frames, and the deviation it started from.
    Repairing(Box<Solver>, Box<Paths>),
    Finished,
}

impl AvoidanceJob {
    /// Nothing is done yet.
    ///
    /// # Panics
    /// When the minimum distance is not above zero: nothing is to be avoided then.
    pub fn new(avoidance: Avoidance, guide: Motion) -> Self {
        assert!(avoidance.minimum_distance > 0.0, "there is a distance to keep");
        let ways = Ways::of(&guide);
        Self {
            avoidance,
            guide,
            ways,
            clashes: Vec::new(),
            breaches: Vec::new(),
            lister: Lister::default(),
            phase: Phase::Checking,
            rung: 0,
            best: None,
        }
    }

    /// Works for some milliseconds; longer for thousands of agents.
    ///
    /// # Panics
    /// After it was done: a bug of the caller.
    pub fn step(&mut self) -> AvoidanceStep {
        match std::mem::replace(&mut self.phase, Phase::Finished) {
            Phase::Checking => self.check(),
            Phase::Climbing(solver) => self.climb(solver),
            Phase::Repairing(solver, from) => self.repair(solver, from),
            Phase::Finished => panic!("the job was done"),
        }
    }

    fn progress(&self, sweeps: usize, limit: usize) -> AvoidanceStep {
        let within = sweeps as f64 / limit as f64;
        AvoidanceStep::Progress((self.rung as f64 + within.min(1.0)) / RUNGS.len() as f64)
    }

    fn check(&mut self) -> AvoidanceStep {
        let unsolved = clashes(&self.guide, self.avoidance.minimum_distance - SLACK);
        if self.guide.agent_count() > 0 {
            self.breaches = breaches(&self.guide, &self.avoidance, SLACK, BREACH_LIMIT);
        }
        let blocked = self.avoidance.blocked(&self.guide, SLACK);
        let is_open = open_count(&unsolved, &self.breaches, &self.guide) + free_count(&blocked, &self.breaches) > 0;
        // Three samples have one between the keyframes; a bump needs two.
        let can_move = self.ways.mean > 0.0 && self.guide.times().len() >= 4 && self.breaches.len() < BREACH_LIMIT;
        if !is_open || !can_move {
            let report = AvoidanceReport { deviation: [0.0; 2], unsolved, blocked, breaches: std::mem::take(&mut self.breaches), rung: 0 };
            let motion = std::mem::replace(&mut self.guide, Motion::new(Vec::new(), 0, Vec::new()));
            return AvoidanceStep::Done(Box::new(Edited { motion, deviation: None, report }));
        }
        self.clashes = unsolved;
        self.start_rung();
        self.progress(0, 1)
    }

    fn start_rung(&mut self) {
        let rung = RUNGS[self.rung];
        let knot_count = rung.knot_count(self.ways, self.avoidance.minimum_distance, self.guide.times().len());
        let mut guide = at_knots(&self.guide, knot_count);
        if !self.avoidance.obstacles.is_empty() {
            reroute(&mut guide, &self.avoidance.obstacles, self.avoidance.minimum_distance, self.avoidance.is_clamped);
        }
        if let (Some(best), true) = (&self.best, rung.swirl > 0.0) {
            let is_stuck = stuck(&best.clashes, &self.clashes, self.guide.agent_count());
            swirl(&mut guide, &is_stuck, rung.swirl * self.avoidance.minimum_distance);
        }
        let kernel = rung.kernel(self.ways, &self.avoidance, knot_count);
        self.phase = Phase::Climbing(Box::new(Solver::new(guide, kernel, rung.rules(&self.avoidance))));
    }

    fn climb(&mut self, mut solver: Box<Solver>) -> AvoidanceStep {
        if self.sweep(&mut solver) == State::Working {
            let progress = self.progress(solver.sweep_count(), 200);
            self.phase = Phase::Climbing(solver);
            return progress;
        }
        // From the guide itself, which those who swirl have left before.
        let deviation = difference(solver.paths(), &at_knots(&self.guide, solver.paths().knot_count()));
        let deviation = lifted(&deviation, self.guide.times(), self.avoidance.is_clamped);
        let attempt = Attempt::new(self.rung + 1, &self.guide, deviation, &self.avoidance, SLACK, &self.breaches);
        let sample_count = self.guide.times().len();
        let is_small = sample_count <= REPAIRABLE_LENGTH && sample_count * self.guide.agent_count() <= REPAIRABLE_SAMPLES;
        let is_repairable = attempt.open_count <= REPAIRABLE_CLASHES && is_small;
        if attempt.open_count > 0 && is_repairable {
            let rung = RUNGS[self.rung];
            let kernel = rung.frame_kernel(self.ways, &self.avoidance, solver.paths().knot_count(), sample_count);
            let from = attempt.deviation.clone();
            let paths = at_samples(&self.guide, &from);
            self.keep(attempt);
            self.phase = Phase::Repairing(Box::new(Solver::new(paths, kernel, rung.frame_rules(&self.avoidance))), Box::new(from));
            return self.progress(1, 2);
        }
        self.keep(attempt);
        self.end_rung()
    }

    fn repair(&mut self, mut solver: Box<Solver>, from: Box<Paths>) -> AvoidanceStep {
        if self.sweep(&mut solver) == State::Working {
            let progress = self.progress(120 + solver.sweep_count(), 200);
            self.phase = Phase::Repairing(solver, from);
            return progress;
        }
        let deviation = sum(&from, &difference(solver.paths(), solver.guide()));
        let attempt = Attempt::new(self.rung + 1, &self.guide, deviation, &self.avoidance, SLACK, &self.breaches);
        self.keep(attempt);
        self.end_rung()
    }

    /// Sweeps for a step's worth of pushes.
    fn sweep(&mut self, solver: &mut Solver) -> State {
        let before = solver.visits();
        loop {
            if solver.needs_list() {
                self.lister.list(solver, &self.breaches, &self.avoidance);
            }
            let state = solver.sweep();
            if state != State::Working || solver.visits() - before >= VISITS_PER_STEP {
                return state;
            }
        }
    }

    /// Keeps an attempt that leaves fewer too near than any before; a swirl only where it solves and can be shown.
    fn keep(&mut self, attempt: Attempt) {
        if RUNGS[self.rung].swirl > 0.0 {
            let [_, widest] = attempt.deviation_lengths();
            if attempt.open_count > 0 || !is_sane(widest, &attempt.motion, &self.guide, self.avoidance.minimum_distance) {
                return;
            }
        }
        if self.best.as_ref().is_none_or(|best| attempt.open_count < best.open_count) {
            self.best = Some(attempt);
        }
    }

    fn end_rung(&mut self) -> AvoidanceStep {
        self.rung += 1;
        let is_done = self.rung == RUNGS.len() || self.best.as_ref().is_some_and(|best| best.open_count == 0);
        if !is_done {
            self.start_rung();
            return self.progress(0, 1);
        }
        let best = self.best.take().expect("a rung was climbed");
        let report = AvoidanceReport {
            deviation: best.deviation_lengths(),
            unsolved: best.clashes,
            blocked: best.blocked,
            breaches: std::mem::take(&mut self.breaches),
            rung: best.rung,
        };
        let deviation = Deviation::new(best.motion.times().to_vec(), &best.deviation, self.avoidance.is_clamped);
        AvoidanceStep::Done(Box::new(Edited { motion: best.motion, deviation: Some(deviation), report }))
    }
}
