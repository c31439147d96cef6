//! Who takes which place of the next formation.
//!
//! The exact optimum, never an approximation: shortest augmenting paths on costs that are computed when they are asked for, so that
//! no matrix of agents × agents is ever stored.

mod augment;
mod costs;
mod squared;

pub use squared::squared;

use augment::Search;
use costs::ByFunction;

/// A bijection from source slots to target slots.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Assignment(Vec<u32>);

impl Assignment {
    /// `targets[source]` is the target slot; `None` unless every slot occurs once.
    pub fn new(targets: Vec<u32>) -> Option<Self> {
        let mut taken = vec![false; targets.len()];
        let is_bijection =
            targets.iter().all(|&target| taken.get_mut(target as usize).is_some_and(|taken| !std::mem::replace(taken, true)));
        is_bijection.then_some(Self(targets))
    }

    /// By source slot, its target slot.
    pub fn targets(&self) -> &[u32] {
        &self.0
    }

    /// The target slot of a source slot.
    ///
    /// # Panics
    /// When there is no such slot.
    pub fn target(&self, source: usize) -> usize {
        self.0[source] as usize
    }

    /// The sum of `cost(source, target)` over all slots.
    pub fn total(&self, cost: impl Fn(usize, usize) -> f64) -> f64 {
        self.0.iter().enumerate().map(|(source, &target)| cost(source, target as usize)).sum()
    }
}

/// The assignment of `agent_count` sources to as many targets with the least sum of `cost(source, target)`, which must be finite.
///
/// Exact up to the rounding of sums of costs. Ties at any step go to the lowest index, so equal costs give equal assignments on every
/// machine. Cubic at worst.
///
/// Jonker and Volgenant, "A shortest augmenting path algorithm for dense and sparse linear assignment problems" (1987).
pub fn solve(agent_count: usize, cost: impl Fn(usize, usize) -> f64) -> Assignment {
    let costs = ByFunction { agent_count, cost };
    let mut search = Search::new(&costs, vec![0.0; agent_count]);
    search.reduce();
    search.finish();
    search.into_assignment()
}

/// The assignment with the greatest sum of `gain(source, target)`; else as [`solve`].
pub fn maximize(agent_count: usize, gain: impl Fn(usize, usize) -> f64) -> Assignment {
    solve(agent_count, |source, target| -gain(source, target))
}
