//! Who goes where, found a little at a time.
//!
//! Locks first, then regions for sections from the outermost in, then slots within each region.

use std::collections::BTreeMap;

use glam::DVec3;

use super::costs::{Measure, Ways};
use super::guide::{carry, flip};
use super::solver::Solver;
use super::{Assignment, AssignmentSpec, Cost, check_locks};
use crate::adjacency::propose;
use crate::error::Error;
use crate::formation::Formation;

/// Costs looked at in a step: some ten milliseconds in a browser.
const STEP_COSTS: usize = 1 << 22;

/// Who takes which place is asked of two formations of one number of agents.
#[derive(Clone, Copy, Debug)]
pub struct Question<'a> {
    /// Where they come from.
    pub source: &'a Formation,
    /// The slots.
    pub target: &'a Formation,
    /// What is to be least, and what is given.
    pub spec: &'a AssignmentSpec,
    /// By level of groups from the outermost in: the group of each agent; agents in none have none.
    pub sections: &'a [Vec<Option<u32>>],
    /// As if everybody (of a section, where they are kept) stood mirrored along the longest direction.
    pub is_flipped: bool,
    /// As if everybody were first carried as the locked agents are to their slots.
    pub is_predicted: bool,
}

/// The work on a question.
pub struct Job {
    spec: AssignmentSpec,
    sources: Vec<DVec3>,
    targets: Vec<DVec3>,
    sections: Vec<Vec<Option<u32>>>,
    is_flipped: bool,
    /// By agent and by slot: mean lengths of Delaunay edges; empty unless the cost asks for them.
    spacings: [Vec<f64>; 2],
    tasks: Vec<Task>,
    current: Option<(Task, Solver)>,
    slots: Vec<u32>,
    settled: usize,
}

/// Agents that share these slots among themselves, within sections down to a level.
#[derive(Default)]
struct Task {
    agents: Vec<u32>,
    slots: Vec<u32>,
    level: usize,
    /// Of a task that gives regions to sections: the part of each agent.
    parts: Vec<u32>,
}

impl Job {
    /// Refuses locks that contradict each other, and a prediction from none.
    ///
    /// # Panics
    /// When the formations differ in number.
    pub fn new(question: &Question) -> Result<Self, Error> {
        let Question { source, target, spec, is_flipped, is_predicted, .. } = *question;
        let agent_count = source.agent_count();
        assert_eq!(agent_count, target.agent_count(), "as many sources as targets");
        check_locks(&spec.locks, agent_count, |index| format!("locks[{index}]"))?;
        if is_predicted && spec.locks.is_empty() {
            return Err(Error::NothingToPredictFrom);
        }
        let mut sources: Vec<DVec3> = source.places().iter().collect();
        let targets: Vec<DVec3> = target.places().iter().collect();
        if is_predicted {
            let pairs: Vec<_> = spec.locks.iter().map(|&(agent, slot)| (sources[agent as usize], targets[slot as usize])).collect();
            carry(&mut sources, &pairs);
        }
        let locked: BTreeMap<u32, u32> = spec.locks.iter().copied().collect();
        let slots = match spec.cost {
            Cost::Keep => kept(&locked, agent_count),
            _ => (0..agent_count as u32).map(|agent| *locked.get(&agent).unwrap_or(&u32::MAX)).collect(),
        };
        let mut job = Self {
            spec: spec.clone(),
            sources,
            targets,
            sections: if spec.keep_groups { question.sections.to_vec() } else { vec![] },
            is_flipped,
            spacings: if spec.cost == Cost::LeastEffort { [spacings(source), spacings(target)] } else { [vec![], vec![]] },
            tasks: vec![],
            current: None,
            settled: slots.iter().filter(|slot| **slot != u32::MAX).count(),
            slots,
        };
        let is_taken: Vec<bool> = taken(&job.slots);
        let free = |is_free: &dyn Fn(usize) -> bool| (0..agent_count).filter(|&each| is_free(each)).map(|each| each as u32).collect();
        let agents = free(&|agent| job.slots[agent] == u32::MAX);
        job.add(Task { agents, slots: free(&|slot| !is_taken[slot]), ..Task::default() });
        Ok(job)
    }

    /// Works for a moment; how far it is, 1 when it is done.
    pub fn step(&mut self) -> f64 {
        let Some((task, mut solver)) = self.current.take().or_else(|| self.next()) else { return 1.0 };
        if solver.step(STEP_COSTS / task.agents.len()) {
            self.close(task, &solver);
        } else {
            self.current = Some((task, solver));
        }
        if self.current.is_none() && self.tasks.is_empty() {
            return 1.0;
        }
        let under_way = self.current.as_ref().filter(|(task, _)| task.parts.is_empty()).map_or(0, |(_, solver)| solver.settled());
        // Regions are about half of the work; whoever has a slot is all of it.
        (self.settled + under_way) as f64 / self.slots.len().max(1) as f64 * 0.999
    }

    /// The answer, once it is done.
    ///
    /// # Panics
    /// Before.
    pub fn into_assignment(self) -> Assignment {
        Assignment::new(self.slots).expect("everybody has a slot of their own")
    }

    fn add(&mut self, task: Task) {
        if !task.agents.is_empty() {
            self.tasks.push(task);
        }
    }

    fn next(&mut self) -> Option<(Task, Solver)> {
        let mut task = self.tasks.pop()?;
        while task.level < self.sections.len() {
            task.parts = parts(&task.agents, &self.sections[task.level]);
            // One part is all of them.
            if task.parts.iter().any(|part| *part != task.parts[0]) && has_section(&task.agents, &self.sections[task.level]) {
                let solver = Solver::new(self.regions(&task), task.slots.len());
                return Some((task, solver));
            }
            task.level += 1;
        }
        task.parts.clear();
        let solver = Solver::new(self.ways(&task), task.slots.len());
        Some((task, solver))
    }

    fn close(&mut self, task: Task, solver: &Solver) {
        let slot_of = |at: usize| task.slots[solver.targets()[at] as usize];
        if task.parts.is_empty() {
            for (at, agent) in task.agents.iter().enumerate() {
                self.slots[*agent as usize] = slot_of(at);
            }
            self.settled += task.agents.len();
            return;
        }
        let mut within: BTreeMap<Option<u32>, Task> = BTreeMap::new();
        for (at, &agent) in task.agents.iter().enumerate() {
            let part = within.entry(self.sections[task.level][agent as usize]).or_default();
            part.level = task.level + 1;
            part.agents.push(agent);
            part.slots.push(slot_of(at));
        }
        for (_, mut part) in within {
            // Which of its agents a slot was found for is chance.
            crate::order::sort_by_key(&mut part.slots, |slot| u128::from(*slot));
            self.add(part);
        }
    }

    /// From where the agents stand to the slots, by the cost asked for.
    fn ways(&self, task: &Task) -> Ways {
        let (mut sources, mut targets) = (only(&self.sources, &task.agents), only(&self.targets, &task.slots));
        if self.is_flipped {
            flip(&mut sources);
        }
        let measure = match self.spec.cost {
            Cost::Euclidean => Measure::Euclidean,
            Cost::Manhattan => Measure::Manhattan,
            _ => Measure::Squared,
        };
        if measure == Measure::Squared {
            center(&mut sources);
            center(&mut targets);
        }
        let ways = Ways::new(measure, &sources, &targets);
        match &self.spacings {
            [from, _] if from.is_empty() => ways,
            [from, to] => ways.with_effort(self.spec.lambda, only(from, &task.agents), only(to, &task.slots)),
        }
    }

    /// From the barycenters of sections to the slots: squared, so that regions are cells which lines part.
    fn regions(&self, task: &Task) -> Ways {
        let mut sums: BTreeMap<u32, (DVec3, f64)> = BTreeMap::new();
        for (part, agent) in task.parts.iter().zip(&task.agents) {
            let (sum, count) = sums.entry(*part).or_default();
            *sum += self.sources[*agent as usize];
            *count += 1.0;
        }
        let mut sources: Vec<DVec3> = task.parts.iter().map(|part| sums[part].0 / sums[part].1).collect();
        let mut targets = only(&self.targets, &task.slots);
        center(&mut sources);
        center(&mut targets);
        Ways::new(Measure::Squared, &sources, &targets).with_kinds(task.parts.clone())
    }
}

/// The slots of their own numbers; whoever loses one takes that which the chain of locks leaves.
fn kept(locked: &BTreeMap<u32, u32>, agent_count: usize) -> Vec<u32> {
    let mut slots: Vec<u32> = (0..agent_count as u32).map(|agent| *locked.get(&agent).unwrap_or(&agent)).collect();
    let is_slot: Vec<bool> = locked.values().fold(vec![false; agent_count], |mut is_slot, slot| {
        is_slot[*slot as usize] = true;
        is_slot
    });
    for first in locked.keys().filter(|agent| !is_slot[**agent as usize]) {
        let mut last = *first;
        while let Some(next) = locked.get(&last) {
            last = *next;
        }
        slots[last as usize] = *first;
    }
    slots
}

fn taken(slots: &[u32]) -> Vec<bool> {
    let mut is_taken = vec![false; slots.len()];
    for slot in slots.iter().filter(|slot| **slot != u32::MAX) {
        is_taken[*slot as usize] = true;
    }
    is_taken
}

fn has_section(agents: &[u32], sections: &[Option<u32>]) -> bool {
    agents.iter().any(|agent| sections[*agent as usize].is_some())
}

/// Numbers from 0: one a section, and one for each agent in none.
fn parts(agents: &[u32], sections: &[Option<u32>]) -> Vec<u32> {
    let (mut numbers, mut count) = (BTreeMap::new(), 0);
    let mut number = |agent: &u32| {
        let section = sections[*agent as usize];
        let part = *numbers.entry(section.ok_or(*agent)).or_insert(count);
        count = count.max(part + 1);
        part
    };
    agents.iter().map(&mut number).collect()
}

/// Mean length of the Delaunay edges at each agent, meters; 0 where it has none.
pub(super) fn spacings(formation: &Formation) -> Vec<f64> {
    let mut sums = vec![(0.0, 0.0_f64); formation.agent_count()];
    for (a, b) in propose(formation) {
        for end in [a, b] {
            let (sum, count) = &mut sums[end as usize];
            *sum += formation.places().distance(a as usize, b as usize);
            *count += 1.0;
        }
    }
    sums.into_iter().map(|(sum, count)| sum / count.max(1.0)).collect()
}

/// About the barycenter, rounded so coarsely that coordinates on a grid stay exact and ties stay ties. Moving a formation as a whole
/// changes the squared distances of every assignment alike, and the nearer they are, the less there is to search.
fn center(points: &mut [DVec3]) {
    let Some(&first) = points.first() else { return };
    let (low, high) = points.iter().fold((first, first), |(low, high), point| (low.min(*point), high.max(*point)));
    let extent = low.distance(high);
    // By its exponent, not its logarithm, which is not the same on every machine.
    let step = if extent > 0.0 { libm::ldexp(1.0, libm::ilogb(extent) - 6) } else { 1.0 };
    let mean = points.iter().sum::<DVec3>() / points.len() as f64;
    let plan = (mean / step).round() * step;
    let middle = if low.z == high.z { plan.with_z(low.z) } else { plan };
    for point in points {
        *point -= middle;
    }
}

fn only<T: Copy>(all: &[T], which: &[u32]) -> Vec<T> {
    which.iter().map(|each| all[*each as usize]).collect()
}
