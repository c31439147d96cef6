//! Proposals for groups, which a person accepts or edits.

use super::Branch;
use super::connected::connected;
use super::graph::Graph;
use super::split::{SAME_COST, Split, split};
use crate::adjacency::Adjacency;
use crate::formation::Formation;
use crate::order;

/// Bisecting deeper is not asked for: a scene's groups nest eight deep at most, and a proposal may land inside others.
pub const MOST_LEVELS: u32 = 6;

/// More parts are not asked for.
pub const MOST_PARTS: u32 = 200;

/// How groups are sought.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Way {
    /// In two by the second eigenvector, and each half again: 1 level makes two groups, 2 make two groups of two. 1 to [`MOST_LEVELS`].
    Bisect {
        /// How often.
        levels: u32,
    },
    /// So many groups, side by side: the weakest cut is taken again and again. 1 to [`MOST_PARTS`].
    Parts {
        /// How many.
        count: u32,
    },
    /// Those whom ties of at least so much connect; who is connected to nobody stays by itself.
    Connected {
        /// The factor of a tie.
        factor: f64,
    },
}

/// Groups of `agents` (any order, each once) by their ties at one formation; the same for the same input.
///
/// Every group has its agents ascending, and groups go by their lowest agent. Fewer agents than parts asked for are a group each; a cut
/// graph falls apart along its pieces first. `bisect` and `parts` put every agent in a group. A pair of sparse solves finds the second
/// eigenvector of many agents: 1,260 take tens of milliseconds a cut, not a dense eigenproblem.
///
/// # Panics
/// When an agent is not of the formation: a bug.
pub fn propose(formation: &Formation, adjacency: &Adjacency, agents: &[u32], way: Way) -> Vec<Branch> {
    let mut agents = agents.to_vec();
    order::sort_by_key(&mut agents, |agent| u128::from(*agent));
    agents.dedup();
    let graph = || Graph::of(adjacency, &agents);
    match way {
        Way::Bisect { levels } => bisect(&graph(), formation, levels.min(MOST_LEVELS)),
        Way::Parts { count } => parts(graph(), formation, count.clamp(1, MOST_PARTS) as usize),
        Way::Connected { factor } => connected(adjacency, &agents, factor),
    }
}

fn bisect(graph: &Graph, formation: &Formation, levels: u32) -> Vec<Branch> {
    if levels == 0 {
        return Vec::new();
    }
    let share = graph.agent_count() as f64 / 2.0;
    let Some(Split { sides, .. }) = split(graph, formation, share) else { return Vec::new() };
    let mut groups = Vec::new();
    for side in sides {
        let half = graph.within(&side);
        let children = bisect(&half, formation, levels - 1);
        let lowest = half.agents[0];
        let branch = if children.is_empty() { Branch::leaf(half.agents) } else { Branch { members: Vec::new(), children } };
        put(&mut groups, lowest, branch);
    }
    groups.into_iter().map(|(_, group)| group).collect()
}

fn parts(whole: Graph, formation: &Formation, count: usize) -> Vec<Branch> {
    let share = whole.agent_count() as f64 / count as f64;
    let with_split = |graph: Graph| {
        let split = split(&graph, formation, share);
        (graph, split)
    };
    let mut parts = vec![with_split(whole)];
    while parts.len() < count {
        let Some(weakest) = weakest(&parts) else { break };
        let (graph, split) = parts.remove(weakest);
        if let Some(Split { sides, .. }) = split {
            parts.extend(sides.map(|side| with_split(graph.within(&side))));
        }
    }
    let mut groups = Vec::new();
    for (Graph { agents, .. }, _) in parts {
        if let Some(&lowest) = agents.first() {
            put(&mut groups, lowest, Branch::leaf(agents));
        }
    }
    groups.into_iter().map(|(_, group)| group).collect()
}

/// The part that comes apart at the least cost; of equal costs the larger, then the earlier.
fn weakest(parts: &[(Graph, Option<Split>)]) -> Option<usize> {
    let mut best: Option<(usize, f64, usize)> = None;
    for (part, (graph, split)) in parts.iter().enumerate() {
        let Some(Split { cost, .. }) = split else { continue };
        let size = graph.agent_count();
        let is_weaker = best.is_none_or(|(_, least, largest)| {
            let slack = SAME_COST * least;
            *cost < least - slack || (*cost <= least + slack && size > largest)
        });
        if is_weaker {
            best = Some((part, *cost, size));
        }
    }
    best.map(|(part, ..)| part)
}

/// Into its place by the lowest agent.
fn put(groups: &mut Vec<(u32, Branch)>, lowest: u32, group: Branch) {
    let place = groups.partition_point(|other| other.0 < lowest);
    groups.insert(place, (lowest, group));
}
