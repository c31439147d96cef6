//! Letting those who are stuck spread out, on request: the guide bent many ways, each pushed apart, and those that keep apart.
//!
//! What comes of a bend cannot be foreseen, so several widths of each are tried.

use super::attempt::Attempt;
use super::climb::{Climb, ClimbStep};
use super::problem::Problem;
use super::rungs::LOOSE;
use super::warp::{dilate, stuck, swirl};
use super::{Avoidance, Edited};
use crate::motion::{Approach, Motion};
use crate::order;

/// How a guide is bent.
#[derive(Clone, Copy, Debug)]
enum Warp {
    /// Each of the stuck keeps so many minimum distances to its right.
    Swirl(f64),
    /// They stand so many times as far from their middle again.
    Dilation(f64),
}

const WARPS: [Warp; 12] = [
    Warp::Swirl(1.2),
    Warp::Dilation(0.15),
    Warp::Swirl(2.0),
    Warp::Dilation(0.3),
    Warp::Swirl(2.8),
    Warp::Dilation(0.5),
    Warp::Swirl(4.0),
    Warp::Dilation(0.8),
    Warp::Swirl(5.5),
    Warp::Dilation(1.2),
    Warp::Swirl(8.0),
    Warp::Swirl(12.0),
];

/// What a step came to.
pub enum SpreadStep {
    /// How far it is, 0–1; never falls.
    Progress(f64),
    /// Every motion that keeps apart, the one nearest to the guide first; where none does, the one that leaves fewest too near.
    Done(Vec<Edited>),
}

/// The work on one motion.
pub struct SpreadJob {
    problem: Problem,
    is_stuck: Vec<bool>,
    tried: usize,
    climb: Climb,
    attempts: Vec<Attempt>,
}

impl SpreadJob {
    /// Nothing is tried yet; `left`: the meetings that avoidance left too near.
    ///
    /// # Panics
    /// When the minimum distance is not above zero, or the guide has fewer than four samples: nothing can be bent then.
    pub fn new(avoidance: Avoidance, guide: Motion, left: &[Approach]) -> Self {
        assert!(avoidance.minimum_distance > 0.0 && guide.times().len() >= 4, "there is something to bend");
        let problem = Problem::of(avoidance, guide);
        let is_stuck = stuck(left, &problem.clashes, problem.guide.agent_count());
        let climb = climb(&problem, &is_stuck, 0);
        Self { problem, is_stuck, tried: 0, climb, attempts: Vec::new() }
    }

    /// Works for some milliseconds; longer for thousands of agents.
    pub fn step(&mut self) -> SpreadStep {
        let within = match self.climb.step(&mut self.problem) {
            ClimbStep::Progress(within) => within,
            ClimbStep::Done(attempt) => {
                self.keep(*attempt);
                self.tried += 1;
                if self.tried == WARPS.len() {
                    return SpreadStep::Done(self.finish());
                }
                self.climb = climb(&self.problem, &self.is_stuck, self.tried);
                0.0
            }
        };
        SpreadStep::Progress((self.tried as f64 + within) / WARPS.len() as f64)
    }

    /// Keeps all that leave nobody too near, or else the one that leaves fewest.
    fn keep(&mut self, attempt: Attempt) {
        let fewest = self.attempts.first().map_or(usize::MAX, |best| best.open_count);
        if attempt.open_count < fewest {
            self.attempts.clear();
        }
        if attempt.open_count < fewest || attempt.open_count == 0 {
            self.attempts.push(attempt);
        }
    }

    fn finish(&mut self) -> Vec<Edited> {
        let mut attempts: Vec<Option<Attempt>> = std::mem::take(&mut self.attempts).into_iter().map(Some).collect();
        let widths = attempts.iter().flatten().map(|attempt| u128::from(order::of_real(attempt.deviation_lengths()[1])));
        let nearest_first = order::by_key(widths);
        let Problem { breaches, shut_off, avoidance: Avoidance { is_clamped, .. }, .. } = &self.problem;
        let taken = nearest_first.into_iter().filter_map(|index| attempts[index as usize].take());
        taken.map(|attempt| attempt.into_edited(breaches.clone(), shut_off.clone(), *is_clamped)).collect()
    }
}

fn climb(problem: &Problem, is_stuck: &[bool], tried: usize) -> Climb {
    Climb::new(problem, LOOSE, tried + 1, |paths| match WARPS[tried] {
        Warp::Swirl(width) => swirl(paths, is_stuck, width * problem.avoidance.minimum_distance),
        Warp::Dilation(growth) => dilate(paths, is_stuck, &problem.clashes, growth),
    })
}
