//! Ties and cuts: pairs that exist, once each, and not too many when groups are expanded.

use super::{at_most, within};
use crate::adjacency::{AdjacencySpec, COMPLETE_GROUP_LIMIT, GroupTie, TooManyTies, expanded_tie_count};
use crate::error::{Counted, Error};
use crate::formation::Formation;
use crate::order;
use crate::scene::place::Place;
use crate::scene::{Group, Scene, group_ties, limits};

pub(super) fn check(scene: &Scene) -> Result<(), Error> {
    let track = scene.main_track();
    let agent_count = track.agents.len();
    let top = Place::Top;
    let counts = Counts { agents: agent_count, obstacles: scene.obstacles.len() };
    lists(&scene.adjacency, &counts, &top.field("adjacency"))?;
    let group_ties = GroupTies::of(&scene.groups);
    let mut ties_in_all = 0;
    for (index, keyframe) in track.keyframes.iter().enumerate() {
        if let Some(own) = &keyframe.adjacency {
            lists(own, &counts, &top.field("keyframes").item(index).field("adjacency"))?;
        }
        let spec = keyframe.adjacency.as_ref().unwrap_or(&scene.adjacency);
        let count = group_ties.count_with(&keyframe.positions, spec) + spec.obstacle_ties.len();
        if count > limits::TIES_PER_KEYFRAME {
            return Err(Error::TooManyTies { keyframe: index, count, limit: limits::TIES_PER_KEYFRAME });
        }
        ties_in_all += count;
        // At once, not at the end: expanding large groups takes time at every keyframe.
        at_most(ties_in_all, limits::TIES_IN_ALL, Counted::TiesInAll, top.field("keyframes"))?;
    }
    Ok(())
}

/// What ties may name.
struct Counts {
    agents: usize,
    obstacles: usize,
}

fn lists(spec: &AdjacencySpec, counts: &Counts, place: &Place) -> Result<(), Error> {
    let (ties, cuts) = (place.field("ties"), place.field("cuts"));
    at_most(spec.ties.len(), limits::TIES_PER_KEYFRAME, Counted::Ties, ties)?;
    at_most(spec.cuts.len(), limits::CUTS, Counted::Cuts, cuts)?;
    for (index, &(a, b, factor)) in spec.ties.iter().enumerate() {
        pair(a, b, counts.agents, &ties.item(index))?;
        within(factor, &limits::FACTOR, ties.item(index))?;
    }
    for (index, &(a, b)) in spec.cuts.iter().enumerate() {
        pair(a, b, counts.agents, &cuts.item(index))?;
    }
    once(spec.ties.iter().map(|&(a, b, _)| (a, b)), &ties)?;
    once(spec.cuts.iter().copied(), &cuts)?;
    obstacle_ties(&spec.obstacle_ties, counts, &place.field("obstacleTies"))
}

fn obstacle_ties(ties: &[(u32, u32, f64)], counts: &Counts, place: &Place) -> Result<(), Error> {
    at_most(ties.len(), limits::TIES_PER_KEYFRAME, Counted::Ties, place)?;
    for (index, &(agent, obstacle, factor)) in ties.iter().enumerate() {
        let place = place.item(index);
        let (agent_count, obstacle_count) = (counts.agents, counts.obstacles);
        if agent as usize >= agent_count {
            return Err(Error::UnknownAgent { agent, agent_count, place: place.to_string() });
        }
        if obstacle as usize >= obstacle_count {
            return Err(Error::UnknownObstacle { obstacle, obstacle_count, place: place.to_string() });
        }
        within(factor, &limits::FACTOR, place)?;
    }
    match repeated(ties.iter().map(|&(agent, obstacle, _)| (agent, obstacle))) {
        Some(((agent, obstacle), index)) => Err(Error::RepeatedObstacleTie { agent, obstacle, place: place.item(index).to_string() }),
        None => Ok(()),
    }
}

fn pair(a: u32, b: u32, agent_count: usize, place: &Place) -> Result<(), Error> {
    for agent in [a, b] {
        if agent as usize >= agent_count {
            return Err(Error::UnknownAgent { agent, agent_count, place: place.to_string() });
        }
    }
    if a == b { Err(Error::SelfTie { agent: a, place: place.to_string() }) } else { Ok(()) }
}

fn once(pairs: impl Iterator<Item = (u32, u32)>, place: &Place) -> Result<(), Error> {
    match repeated(pairs.map(|(a, b)| (a.min(b), a.max(b)))) {
        Some(((a, b), index)) => Err(Error::RepeatedPair { a, b, place: place.item(index).to_string() }),
        None => Ok(()),
    }
}

/// A pair that was there before, and its index.
fn repeated(pairs: impl Iterator<Item = (u32, u32)>) -> Option<((u32, u32), usize)> {
    let pairs: Vec<(u32, u32)> = pairs.collect();
    let order = order::by_key(pairs.iter().map(|pair| order::key_of_pair(*pair)));
    let two = order.windows(2).find(|two| pairs[two[0] as usize] == pairs[two[1] as usize])?;
    Some((pairs[two[1] as usize], two[1] as usize))
}

/// What groups tie at any keyframe; where it depends on the formation, it is counted there.
enum GroupTies {
    Same(usize),
    Varying(Vec<GroupTie>),
}

impl GroupTies {
    fn of(groups: &[Group]) -> Self {
        let ties = group_ties(groups);
        if ties.iter().all(|group| group.members.len() <= COMPLETE_GROUP_LIMIT) {
            Self::Same(ties.iter().map(|group| group.members.len() * group.members.len().saturating_sub(1) / 2).sum())
        } else {
            Self::Varying(ties)
        }
    }

    /// Ties of groups and by hand at one formation; up to one more than the limit.
    fn count_with(&self, formation: &Formation, spec: &AdjacencySpec) -> usize {
        match self {
            Self::Same(count) => count + spec.ties.len(),
            Self::Varying(ties) => expanded_tie_count(formation, spec, ties).unwrap_or_else(|TooManyTies { count }| count),
        }
    }
}
