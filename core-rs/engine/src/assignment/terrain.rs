//! The ground between agents and slots: how far it is from each to each where obstacles stand between them.

use std::sync::Arc;

use glam::DVec2;

use crate::error::Error;
use crate::formation::Formation;
use crate::obstacle::{Detours, Norm, ObstacleShape};

/// More places where ways may bend, or as many for each of so many agents, take too long and too much room.
const BEND_LIMIT: usize = 4_000;
const LENGTH_LIMIT: usize = 16_000_000;

/// Straight ways looked at in a step, an obstacle at a time: some ten milliseconds in a browser.
const STEP_LOOKS: usize = 1 << 18;

/// The way of an agent to a slot bends nowhere, and there is none; else where it bends last. Bends are fewer.
const STRAIGHT: u16 = u16::MAX;
const NO_WAY: u16 = STRAIGHT - 1;

/// The ways between everybody and every slot. A trait, so that a page whose agents go straight loads no code for it.
pub(super) trait Terrain {
    /// Looks around for a moment; how far it is, 1 when everything below can be asked.
    fn survey(&mut self) -> f64;

    /// Whether any of these agents and slots do not see each other.
    fn parts(&self, agents: &[u32], slots: &[u32]) -> bool;

    /// Agents and slots between which ways lead, a set at a time; refuses sets with too few slots for their agents.
    fn regions(&self, agents: &[u32], slots: &[u32]) -> Result<Vec<[Vec<u32>; 2]>, Error>;

    /// How far an agent has to each of the slots in plan, meters.
    fn lengths_into(&self, agent: u32, slots: &[u32], row: &mut [f64]);

    /// Where the way of an agent to a slot bends, in order; nowhere where it is straight or there is none.
    fn bends(&self, agent: u32, slot: u32) -> Vec<DVec2>;
}

/// Where an agent or a slot is, and what it sees.
struct Spot {
    place: DVec2,
    /// Where ways begin: a clear place near by where it is not clear itself; none where it is shut in.
    exit: Option<DVec2>,
    seen: Vec<u32>,
}

/// Obstacles between agents and slots.
pub(super) struct Ground {
    shapes: Vec<ObstacleShape>,
    distance: f64,
    norm: Norm,
    detours: Detours,
    agents: Vec<Spot>,
    slots: Vec<Spot>,
    /// By agent and slot: where a way that is not [`STRAIGHT`] bends last, once all was looked at. Costs ask for it again and again.
    last: Vec<u16>,
    /// By agent and bend, meters.
    lengths: Vec<f64>,
    looked: Looked,
}

/// What is looked for next.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Looked {
    Straight(usize),
    Bends,
    Slots(usize),
    Agents(usize),
    Done,
}

impl Ground {
    /// Refuses more obstacles than can be gone around.
    pub(super) fn new([source, target]: [&Formation; 2], shapes: &[ObstacleShape], distance: f64, norm: Norm) -> Result<Self, Error> {
        let detours = Detours::new(shapes, distance);
        let limit = BEND_LIMIT.min(LENGTH_LIMIT / source.agent_count().max(1));
        if detours.bend_count() > limit {
            return Err(Error::TooManyBends { count: detours.bend_count(), limit });
        }
        let spots = |formation: &Formation| -> Vec<Spot> {
            formation.positions().iter().map(|place| Spot { place: *place, exit: detours.exit(*place), seen: Vec::new() }).collect()
        };
        let (agents, slots) = (spots(source), spots(target));
        Ok(Self {
            shapes: shapes.to_vec(),
            distance,
            norm,
            detours,
            agents,
            slots,
            last: vec![],
            lengths: vec![],
            looked: Looked::Straight(0),
        })
    }

    fn look(&mut self) -> usize {
        let Self { detours, agents, slots, norm, .. } = self;
        let (count, bends) = (agents.len(), detours.bend_count());
        match self.looked {
            Looked::Straight(agent) if agent < count => {
                let from = agents[agent].exit;
                let sees = |slot: &Spot| from.zip(slot.exit).is_some_and(|(from, to)| detours.is_clear(from, to));
                self.last.extend(slots.iter().map(|slot| if sees(slot) { STRAIGHT } else { NO_WAY }));
                self.looked = Looked::Straight(agent + 1);
                count
            }
            Looked::Straight(_) => {
                // Nobody goes around anything when all see each other.
                self.looked = if self.last.contains(&NO_WAY) { Looked::Bends } else { Looked::Done };
                1
            }
            Looked::Bends => {
                if detours.find_row() {
                    self.looked = Looked::Slots(0);
                }
                bends
            }
            Looked::Slots(slot) if slot < count => {
                slots[slot].seen = slots[slot].exit.map_or_else(Vec::new, |exit| detours.seen_from(exit));
                self.looked = Looked::Slots(slot + 1);
                bends
            }
            Looked::Slots(_) => {
                self.looked = Looked::Agents(0);
                1
            }
            Looked::Agents(agent) if agent < count => {
                let spot = &mut agents[agent];
                spot.seen = spot.exit.map_or_else(Vec::new, |exit| detours.seen_from(exit));
                let from = spot.exit.unwrap_or(spot.place);
                let known = detours.from(from, &spot.seen, *norm).0;
                let mut looks = 2 * bends;
                for (slot, last) in slots.iter().zip(&mut self.last[agent * count..]).filter(|(_, last)| **last == NO_WAY) {
                    let Some(end) = slot.exit else { continue };
                    let mut least = f64::INFINITY;
                    for &bend in &slot.seen {
                        let length = known[bend as usize] + norm.of(end - detours.bend(bend));
                        if length < least {
                            (least, *last) = (length, bend as u16);
                        }
                    }
                    looks += slot.seen.len();
                }
                self.lengths.extend(known);
                self.looked = Looked::Agents(agent + 1);
                looks
            }
            Looked::Agents(_) | Looked::Done => {
                self.looked = Looked::Done;
                1
            }
        }
    }

    fn last_bend(&self, agent: u32, slot: u32) -> u16 {
        self.last[agent as usize * self.slots.len() + slot as usize]
    }

    /// How far a place is from where its ways begin.
    fn stub(&self, spot: &Spot) -> f64 {
        spot.exit.map_or(f64::INFINITY, |exit| self.norm.of(exit - spot.place))
    }

    fn length(&self, agent: u32, slot: u32) -> f64 {
        let (from, to) = (&self.agents[agent as usize], &self.slots[slot as usize]);
        let ends = self.stub(from) + self.stub(to);
        let (Some(start), Some(end)) = (from.exit, to.exit) else { return f64::INFINITY };
        ends + match self.last_bend(agent, slot) {
            STRAIGHT => self.norm.of(end - start),
            NO_WAY => f64::INFINITY,
            last => {
                let known = self.lengths[agent as usize * self.detours.bend_count() + last as usize];
                known + self.norm.of(end - self.detours.bend(u32::from(last)))
            }
        }
    }

    /// By agent and then by slot, a number that all have in common between which ways lead.
    fn region_numbers(&self) -> Vec<usize> {
        let (count, bends) = (self.agents.len(), self.detours.bend_count());
        let mut leader: Vec<usize> = (0..2 * count + bends).collect();
        let mut join = |a: usize, b: usize| {
            let [a, b] = [root(&mut leader, a), root(&mut leader, b)];
            leader[a.max(b)] = a.min(b);
        };
        for agent in 0..count {
            let reached = self.lengths[agent * bends..][..bends].iter().enumerate().filter(|(_, length)| length.is_finite());
            reached.for_each(|(bend, _)| join(agent, 2 * count + bend));
            let seen = self.last[agent * count..][..count].iter().enumerate().filter(|(_, last)| **last == STRAIGHT);
            seen.for_each(|(slot, _)| join(agent, count + slot));
        }
        for (slot, spot) in self.slots.iter().enumerate() {
            spot.seen.iter().for_each(|bend| join(count + slot, 2 * count + *bend as usize));
        }
        (0..2 * count).map(|each| root(&mut leader, each)).collect()
    }

    /// What shuts an agent in: the first obstacle toward a slot without which a way would lead there, else the first.
    fn refusal(&self, agent: u32, slot: u32) -> Error {
        let ends = [&self.agents[agent as usize], &self.slots[slot as usize]].map(|spot| spot.place);
        let obstacle = self.detours.barrier(&self.shapes, self.distance, ends) as u32;
        Error::NoWay { agent, obstacle, distance: self.distance }
    }
}

impl Terrain for Ground {
    fn survey(&mut self) -> f64 {
        let mut looks = 0;
        while looks < STEP_LOOKS && self.looked != Looked::Done {
            looks += self.look() * self.detours.wall_count();
        }
        let (part, done, all) = match self.looked {
            Looked::Straight(agent) => (0.0, agent, self.agents.len()),
            Looked::Bends => (1.0, 0, 1),
            Looked::Slots(slot) => (2.0, slot, self.slots.len()),
            Looked::Agents(agent) => (3.0, agent, self.agents.len()),
            Looked::Done => return 1.0,
        };
        // Four parts of one length, as far as is known; not 1 before the end.
        0.999 * (part + done as f64 / all.max(1) as f64) / 4.0
    }

    fn parts(&self, agents: &[u32], slots: &[u32]) -> bool {
        agents.iter().any(|agent| slots.iter().any(|slot| self.last_bend(*agent, *slot) != STRAIGHT))
    }

    fn regions(&self, agents: &[u32], slots: &[u32]) -> Result<Vec<[Vec<u32>; 2]>, Error> {
        let numbers = self.region_numbers();
        let mut regions: Vec<[Vec<u32>; 2]> = vec![Default::default(); numbers.len()];
        for agent in agents {
            regions[numbers[*agent as usize]][0].push(*agent);
        }
        for slot in slots {
            regions[numbers[self.agents.len() + *slot as usize]][1].push(*slot);
        }
        let crowded = regions.iter().find(|[agents, slots]| agents.len() > slots.len());
        let spare = regions.iter().find(|[agents, slots]| agents.len() < slots.len());
        if let (Some([agents, _]), Some([_, slots])) = (crowded, spare) {
            return Err(self.refusal(agents[agents.len() - 1], slots[0]));
        }
        regions.retain(|[agents, _]| !agents.is_empty());
        Ok(regions)
    }

    fn lengths_into(&self, agent: u32, slots: &[u32], row: &mut [f64]) {
        row.iter_mut().zip(slots).for_each(|(out, slot)| *out = self.length(agent, *slot));
    }

    fn bends(&self, agent: u32, slot: u32) -> Vec<DVec2> {
        let (from, to) = (&self.agents[agent as usize], &self.slots[slot as usize]);
        let (Some(start), Some(end)) = (from.exit, to.exit) else { return Vec::new() };
        let mut way = vec![];
        if end != to.place {
            way.push(end);
        }
        let last = self.last_bend(agent, slot);
        if last == NO_WAY {
            return Vec::new();
        }
        if last != STRAIGHT {
            let (_, before) = self.detours.from(start, &from.seen, self.norm);
            let mut next = Some(u32::from(last));
            while let Some(bend) = next {
                way.push(self.detours.bend(bend));
                next = before[bend as usize];
            }
        }
        if start != from.place {
            way.push(start);
        }
        way.reverse();
        way
    }
}

fn root(leader: &mut [usize], mut each: usize) -> usize {
    while leader[each] != each {
        leader[each] = leader[leader[each]];
        each = leader[each];
    }
    each
}

/// Ways around obstacles as costs take them: sources are sets of agents, a set of one as a rule.
#[derive(Clone)]
pub(super) struct Around {
    pub(super) terrain: Arc<dyn Terrain>,
    /// By set, its agents.
    pub(super) sets: Arc<Vec<Vec<u32>>>,
    /// By source, its set.
    pub(super) sources: Vec<u32>,
    pub(super) slots: Vec<u32>,
}

impl Around {
    /// The lengths of ways of a source to the slots, or their squares, in the mean of its agents.
    pub(super) fn row_into(&self, source: usize, is_squared: bool, row: &mut [f64]) {
        let set = &self.sets[self.sources[source] as usize];
        let mut own = vec![0.0; if set.len() > 1 { row.len() } else { 0 }];
        row.fill(0.0);
        for agent in set {
            let out = if own.is_empty() { &mut *row } else { &mut own };
            self.terrain.lengths_into(*agent, &self.slots, out);
            if is_squared {
                for length in out.iter_mut() {
                    *length *= *length;
                }
            }
            row.iter_mut().zip(&own).for_each(|(sum, own)| *sum += own / set.len() as f64);
        }
    }
}
