//! Some of the agents with the ties among them, numbered anew.

use crate::adjacency::{Adjacency, Components};

/// The graph that a few agents are of a larger one.
pub(super) struct Graph {
    /// Ascending; local agent i is `agents[i]`.
    pub(super) agents: Vec<u32>,
    neighbors: Vec<Vec<(u32, f64)>>,
}

impl Graph {
    /// `agents` ascend. Its weights are those of the ties squared: one short tie holds more than the many long ones that lead across
    /// the gap between any two groups.
    pub(super) fn of(adjacency: &Adjacency, agents: &[u32]) -> Self {
        let mut neighbors = vec![Vec::new(); agents.len()];
        for tie in adjacency.ties() {
            if let (Ok(a), Ok(b)) = (agents.binary_search(&tie.a), agents.binary_search(&tie.b)) {
                neighbors[a].push((b as u32, tie.weight * tie.weight));
                neighbors[b].push((a as u32, tie.weight * tie.weight));
            }
        }
        Self { agents: agents.to_vec(), neighbors }
    }

    /// The graph of some of its own agents, given by local numbers, ascending.
    pub(super) fn within(&self, kept: &[u32]) -> Self {
        let among = |&(other, weight): &(u32, f64)| kept.binary_search(&other).ok().map(|index| (index as u32, weight));
        let neighbors = kept.iter().map(|&agent| self.neighbors(agent).iter().filter_map(among).collect()).collect();
        Self { agents: kept.iter().map(|&agent| self.agents[agent as usize]).collect(), neighbors }
    }

    pub(super) fn agent_count(&self) -> usize {
        self.agents.len()
    }

    /// Whom a local agent is tied to, and how firmly.
    pub(super) fn neighbors(&self, agent: u32) -> &[(u32, f64)] {
        &self.neighbors[agent as usize]
    }

    /// Sum of the weights at a local agent.
    pub(super) fn degree(&self, agent: u32) -> f64 {
        self.neighbors(agent).iter().map(|(_, weight)| weight).sum()
    }

    /// Its Laplacian times a vector.
    pub(super) fn laplacian_times(&self, vector: &[f64]) -> Vec<f64> {
        let row = |(agent, own): (u32, &f64)| self.neighbors(agent).iter().map(|&(other, w)| w * (own - vector[other as usize])).sum();
        (0..).zip(vector).map(row).collect()
    }

    /// Local agents by what ties them together, each list ascending, lists by their first.
    pub(super) fn pieces(&self) -> Vec<Vec<u32>> {
        let mut components = Components::new(self.agent_count());
        for agent in 0..self.agent_count() as u32 {
            self.neighbors(agent).iter().for_each(|&(other, _)| {
                components.join(agent, other);
            });
        }
        components.lists()
    }
}
