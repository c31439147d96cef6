//! Who goes where, found a little at a time.
//!
//! Locks first, then regions for sections from the outermost in, then slots within each region.

use std::sync::Arc;

use glam::{DVec2, DVec3};

use super::costs::{Measure, Ways};
use super::guide::{carry, flip};
use super::solver::Solver;
use super::terrain::{Around, Ground, Terrain};
use super::{Assignment, AssignmentSpec, Cost, check_locks};
use crate::adjacency::propose;
use crate::error::Error;
use crate::formation::Formation;
use crate::obstacle::{Norm, ObstacleShape};

/// No slot, or no number, yet.
const NONE: u32 = u32::MAX;

/// Costs looked at in a step: some ten milliseconds in a browser.
const STEP_COSTS: usize = 1 << 22;

/// How much of the work it is to look for ways around obstacles.
const SURVEY_SHARE: f64 = 0.5;

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
    /// Whether agents are taken to stand where they do.
    is_in_place: bool,
    /// Obstacles to be looked at before anything else.
    survey: Option<Box<dyn Terrain>>,
    /// The same once it is known that they are in the way.
    terrain: Option<Arc<dyn Terrain>>,
    /// By slot, whether it costs nothing; empty where none does.
    spared: Vec<bool>,
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
        let mut slots = vec![NONE; agent_count];
        for &(agent, slot) in &spec.locks {
            slots[agent as usize] = slot;
        }
        if spec.cost == Cost::Keep {
            keep_others(&mut slots);
        }
        let mut job = Self {
            spec: spec.clone(),
            sources,
            targets,
            sections: if spec.keep_groups { question.sections.to_vec() } else { vec![] },
            is_flipped,
            is_in_place: !is_flipped && !is_predicted,
            survey: None,
            terrain: None,
            spared: vec![],
            spacings: if spec.cost == Cost::LeastEffort { [spacings(source), spacings(target)] } else { [vec![], vec![]] },
            tasks: vec![],
            current: None,
            settled: slots.iter().filter(|slot| **slot != NONE).count(),
            slots,
        };
        let [agents, slots] = job.free();
        job.add(Task { agents, slots, ..Task::default() });
        Ok(job)
    }

    /// The same where ways lead around obstacles, `distance` meters from them: costs are of the shortest way. Mirrored or carried
    /// agents go straight. Refuses more obstacles than can be gone around.
    pub fn around(question: &Question, shapes: &[ObstacleShape], distance: f64) -> Result<Self, Error> {
        let mut job = Self::new(question)?;
        if !shapes.is_empty() && !job.slots.is_empty() {
            let norm = norm_of(question.spec.cost);
            job.survey = Some(Box::new(Ground::new([question.source, question.target], shapes, distance, norm)?));
        }
        Ok(job)
    }

    /// The same where some slots cost nothing whoever takes them: those who do stay where they are.
    #[must_use]
    pub fn sparing(mut self, slots: &[u32]) -> Self {
        if !slots.is_empty() {
            self.spared = vec![false; self.slots.len()];
            for slot in slots {
                self.spared[*slot as usize] = true;
            }
        }
        self
    }

    /// Works for a moment; how far it is, 1 when it is done. Refuses obstacles that leave an agent no way to a slot.
    pub fn step(&mut self) -> Result<f64, Error> {
        if let Some(survey) = &mut self.survey {
            let progress = survey.survey();
            if progress >= 1.0 {
                self.take_survey()?;
            }
            return Ok(progress * SURVEY_SHARE);
        }
        let surveyed = if self.terrain.is_some() { SURVEY_SHARE } else { 0.0 };
        Ok(surveyed + (1.0 - surveyed) * self.assign())
    }

    fn assign(&mut self) -> f64 {
        let Some((task, mut solver)) = self.current.take().or_else(|| self.next()) else { return 1.0 };
        if solver.step(STEP_COSTS / task.agents.len()) {
            self.close(&task, &solver);
        } else {
            self.current = Some((task, solver));
        }
        if self.current.is_none() && self.tasks.is_empty() {
            return 1.0;
        }
        let under_way = self.current.as_ref().filter(|(task, _)| task.parts.is_empty());
        let under_way = under_way.map_or(0.0, |(task, solver)| task.agents.len() as f64 * solver.progress());
        // Not 1 while a task is left, although everybody may have a slot before the last prices are found.
        (self.settled as f64 + under_way) / self.slots.len().max(1) as f64 * 0.999
    }

    /// Where obstacles are in somebody's way, agents and slots are matched a region at a time; else all goes straight.
    fn take_survey(&mut self) -> Result<(), Error> {
        let Some(survey) = self.survey.take() else { return Ok(()) };
        let terrain: Arc<dyn Terrain> = Arc::from(survey);
        let [agents, slots] = self.free();
        if terrain.parts(&agents, &slots) {
            self.tasks.clear();
            for [agents, slots] in terrain.regions(&agents, &slots)? {
                self.add(Task { agents, slots, ..Task::default() });
            }
        }
        self.terrain = Some(terrain);
        Ok(())
    }

    /// Agents without a slot, and slots without an agent.
    fn free(&self) -> [Vec<u32>; 2] {
        let is_taken = taken(&self.slots);
        let free = |is_free: &dyn Fn(usize) -> bool| (0..self.slots.len()).filter(|&each| is_free(each)).map(|each| each as u32).collect();
        [free(&|agent| self.slots[agent] == NONE), free(&|slot| !is_taken[slot])]
    }

    /// By agent, where its way to one of `slots` bends around obstacles, once it is done.
    pub fn bends_to(&self, slots: &[u32]) -> Vec<Vec<DVec2>> {
        let bends = |(agent, slot): (u32, &u32)| self.terrain.as_ref().map_or_else(Vec::new, |terrain| terrain.bends(agent, *slot));
        (0..).zip(slots).map(bends).collect()
    }

    /// By agent the slot it got, once it is done.
    pub fn slots(&self) -> &[u32] {
        &self.slots
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
            let has_sections = task.agents.iter().any(|agent| self.sections[task.level][*agent as usize].is_some());
            if has_sections && part_count(&task.parts) > 1 {
                let solver = Solver::new(self.regions(&task), task.slots.len());
                return Some((task, solver));
            }
            task.level += 1;
        }
        task.parts.clear();
        let solver = Solver::new(self.ways(&task), task.slots.len());
        Some((task, solver))
    }

    fn close(&mut self, task: &Task, solver: &Solver) {
        let slot_of = |at: usize| task.slots[solver.targets()[at] as usize];
        if task.parts.is_empty() {
            for (at, agent) in task.agents.iter().enumerate() {
                self.slots[*agent as usize] = slot_of(at);
            }
            self.settled += task.agents.len();
            return;
        }
        // A task a part, and one for all who are in no section.
        let mut within: Vec<Task> = (0..=part_count(&task.parts)).map(|_| Task { level: task.level + 1, ..Task::default() }).collect();
        let others = within.len() - 1;
        for (at, &agent) in task.agents.iter().enumerate() {
            let section = self.sections[task.level][agent as usize];
            let part = &mut within[section.map_or(others, |_| task.parts[at] as usize)];
            part.agents.push(agent);
            part.slots.push(slot_of(at));
        }
        for mut part in within {
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
        let around = self.detours(task).map(|terrain| Around {
            terrain,
            sets: Arc::new(task.agents.iter().map(|agent| vec![*agent]).collect()),
            sources: (0..task.agents.len() as u32).collect(),
            slots: task.slots.clone(),
        });
        let ways = if let Some(around) = around {
            Ways::new(measure, &heights_of(&sources), &heights_of(&targets)).leading(around)
        } else {
            // Nobody's squares change alike beside those that cost nothing.
            if measure == Measure::Squared && self.spared.is_empty() {
                center(&mut sources);
                center(&mut targets);
            }
            Ways::new(measure, &sources, &targets)
        };
        match &self.spacings {
            [from, _] if from.is_empty() => ways.sparing(self.spared_of(task)),
            [from, to] => {
                let ways = ways.with_effort(self.spec.lambda, only(from, &task.agents), only(to, &task.slots));
                ways.sparing(self.spared_of(task))
            }
        }
    }

    fn spared_of(&self, task: &Task) -> Vec<bool> {
        if self.spared.is_empty() { vec![] } else { only(&self.spared, &task.slots) }
    }

    /// What is in the way between these agents and slots.
    fn detours(&self, task: &Task) -> Option<Arc<dyn Terrain>> {
        self.terrain.clone().filter(|terrain| self.is_in_place && terrain.parts(&task.agents, &task.slots))
    }

    /// From the barycenters of sections to the slots: squared, so that regions are cells which lines part. Around obstacles: the mean of
    /// the squared ways of its agents, which is the same but for a number for each section.
    fn regions(&self, task: &Task) -> Ways {
        let mut sums = vec![(DVec3::ZERO, 0.0); part_count(&task.parts)];
        for (part, agent) in task.parts.iter().zip(&task.agents) {
            let (sum, count) = &mut sums[*part as usize];
            *sum += self.sources[*agent as usize];
            *count += 1.0;
        }
        let middle = |part: &u32| sums[*part as usize].0 / sums[*part as usize].1;
        let mut sources: Vec<DVec3> = task.parts.iter().map(middle).collect();
        let mut targets = only(&self.targets, &task.slots);
        let ways = if let Some(terrain) = self.detours(task) {
            let mut sets = vec![Vec::new(); sums.len()];
            task.parts.iter().zip(&task.agents).for_each(|(part, agent)| sets[*part as usize].push(*agent));
            let around = Around { terrain, sets: Arc::new(sets), sources: task.parts.clone(), slots: task.slots.clone() };
            Ways::new(Measure::Squared, &heights_of(&sources), &heights_of(&targets)).leading(around)
        } else {
            if self.spared.is_empty() {
                center(&mut sources);
                center(&mut targets);
            }
            Ways::new(Measure::Squared, &sources, &targets)
        };
        ways.sparing(self.spared_of(task)).with_kinds(task.parts.clone())
    }
}

/// What measures the ways that a cost is of.
pub(super) fn norm_of(cost: Cost) -> Norm {
    if cost == Cost::Manhattan { Norm::Manhattan } else { Norm::Euclidean }
}

/// Everybody at one place in plan, as high as they are.
fn heights_of(points: &[DVec3]) -> Vec<DVec3> {
    points.iter().map(|point| point.with_x(0.0).with_y(0.0)).collect()
}

/// Who is not locked keeps the slot of their own number; whoever loses it takes the one that the chain of locks leaves.
fn keep_others(slots: &mut [u32]) {
    let is_taken = taken(slots);
    let heads: Vec<usize> = (0..slots.len()).filter(|&agent| slots[agent] != NONE && !is_taken[agent]).collect();
    for head in heads {
        let mut last = head;
        while slots[last] != NONE {
            last = slots[last] as usize;
        }
        slots[last] = head as u32;
    }
    for (own, slot) in (0..).zip(slots) {
        *slot = if *slot == NONE { own } else { *slot };
    }
}

/// By slot: whether somebody has it.
fn taken(slots: &[u32]) -> Vec<bool> {
    let mut is_taken = vec![false; slots.len()];
    for slot in slots.iter().filter(|slot| **slot != NONE) {
        is_taken[*slot as usize] = true;
    }
    is_taken
}

/// Numbers from 0: one a section, and one for each agent in none.
fn parts(agents: &[u32], sections: &[Option<u32>]) -> Vec<u32> {
    let mut numbers = vec![NONE; sections.iter().flatten().max().map_or(0, |most| *most as usize + 1)];
    let mut count = 0;
    let mut fresh = || {
        count += 1;
        count - 1
    };
    let number = |agent: &u32| match sections[*agent as usize].map(|section| &mut numbers[section as usize]) {
        Some(number) if *number != NONE => *number,
        Some(number) => {
            *number = fresh();
            *number
        }
        None => fresh(),
    };
    agents.iter().map(number).collect()
}

fn part_count(parts: &[u32]) -> usize {
    parts.iter().max().map_or(0, |most| *most as usize + 1)
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
