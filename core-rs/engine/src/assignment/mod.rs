//! Who takes which place of the next formation.
//!
//! The exact optimum, never an approximation: shortest augmenting paths on costs that are computed when they are asked for, so that
//! no matrix of agents × agents is ever stored. Where obstacles are between, a cost is of the shortest way around them.

mod augment;
mod costs;
mod guide;
mod job;
mod solver;
mod spec;
mod terrain;

pub use job::{Job, Question};
pub use spec::{AssignmentSpec, Cost, DEFAULT_LAMBDA, check_locks};

use glam::{DVec2, DVec3};

use augment::Search;
use costs::ByFunction;

use crate::error::Error;
use crate::formation::Formation;
use crate::obstacle::ObstacleShape;

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
        // A sum of nothing would be −0.
        self.0.iter().enumerate().map(|(source, &target)| cost(source, target as usize)).fold(0.0, |sum, cost| sum + cost)
    }
}

/// The assignment of `agent_count` sources to as many targets with the least sum of `cost(source, target)`, which must be finite.
///
/// Exact up to the rounding of sums of costs. Ties at any step go to the lowest index, so equal costs give equal assignments on every
/// machine. Cubic at worst.
///
/// Jonker and Volgenant, "A shortest augmenting path algorithm for dense and sparse linear assignment problems" (1987).
pub fn solve(agent_count: usize, cost: impl Fn(usize, usize) -> f64) -> Assignment {
    let costs = ByFunction { source_count: agent_count, cost };
    let mut search = Search::new(&costs, vec![0.0; agent_count]);
    search.reduce(&costs);
    search.finish(&costs, usize::MAX);
    Assignment(search.targets().to_vec())
}

/// The assignment with the greatest sum of `gain(source, target)`; else as [`solve`].
pub fn maximize(agent_count: usize, gain: impl Fn(usize, usize) -> f64) -> Assignment {
    solve(agent_count, |source, target| -gain(source, target))
}

/// The assignment of the agents of `source` to the slots of `target` with the least sum of squared distances; else as [`solve`].
///
/// # Panics
/// When the formations differ in number.
pub fn squared(source: &Formation, target: &Formation) -> Assignment {
    least(source, target, Cost::Squared)
}

/// The same with the least sum of distances.
///
/// # Panics
/// When the formations differ in number.
pub fn shortest(source: &Formation, target: &Formation) -> Assignment {
    least(source, target, Cost::Euclidean)
}

fn least(source: &Formation, target: &Formation, cost: Cost) -> Assignment {
    let spec = AssignmentSpec { cost, ..AssignmentSpec::default() };
    let question = Question { source, target, spec: &spec, sections: &[], is_flipped: false, is_predicted: false };
    let Ok(assignment) = assign(&question) else { unreachable!("without locks and obstacles nothing contradicts") };
    assignment
}

/// The answer to a question at once.
///
/// # Panics
/// When the formations differ in number.
pub fn assign(question: &Question) -> Result<Assignment, Error> {
    let mut job = Job::new(question)?;
    while job.step()? < 1.0 {}
    Ok(job.into_assignment())
}

/// The same with ways that keep `distance` meters from obstacles, and where the way of each agent bends around them.
///
/// # Panics
/// When the formations differ in number.
pub fn assign_around(question: &Question, shapes: &[ObstacleShape], distance: f64) -> Result<(Assignment, Vec<Vec<DVec2>>), Error> {
    let mut job = Job::around(question, shapes, distance)?;
    while job.step()? < 1.0 {}
    let bends = job.bends_to(job.slots());
    Ok((job.into_assignment(), bends))
}

/// What an assignment costs, in the unit of its cost: square meters, or meters of Euclidean and Manhattan. Of [`Cost::Keep`] it is the
/// sum of squared distances. `bends`: by agent, where its way bends; agents beyond its end go straight.
pub fn cost_of(question: &Question, assignment: &Assignment, bends: &[Vec<DVec2>]) -> f64 {
    let Question { source, target, spec, .. } = *question;
    let (from, to) = (source.places(), target.places());
    let norm = job::norm_of(spec.cost);
    // As long as its way in plan, as high as it climbs.
    let way = |agent: usize, slot: usize| {
        let straight = from.at(agent) - to.at(slot);
        let Some(bends) = bends.get(agent).filter(|bends| !bends.is_empty()) else { return straight };
        let ends = [from.at(agent), to.at(slot)].map(DVec3::truncate);
        let places = [&ends[..1], bends, &ends[1..]].concat();
        DVec2::new(places.windows(2).map(|pair| norm.of(pair[1] - pair[0])).sum(), 0.0).extend(straight.z)
    };
    match spec.cost {
        Cost::Squared | Cost::Keep => assignment.total(|agent, slot| way(agent, slot).length_squared()),
        Cost::Euclidean => assignment.total(|agent, slot| way(agent, slot).length()),
        Cost::Manhattan => assignment.total(|agent, slot| way(agent, slot).abs().element_sum()),
        Cost::LeastEffort => {
            let (from, to) = (job::spacings(source), job::spacings(target));
            let change = |agent: usize, slot: usize| (from[agent] - to[slot]).powi(2);
            assignment.total(|agent, slot| spec.lambda * way(agent, slot).length_squared() + (1.0 - spec.lambda) * change(agent, slot))
        }
    }
}
