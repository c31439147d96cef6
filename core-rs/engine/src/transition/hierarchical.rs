//! A motion for every node of a tree of groups, put together from the top down (paper A, section 4.4).

use std::sync::Arc;

use glam::DVec2;

use super::Transition;
use super::chain::{Chain, Ways};
use crate::grouping::Tree;

/// Agents move with their group about its barycenter, the group with the group around it.
pub struct Hierarchical {
    tree: Arc<Tree>,
    nodes: Vec<Arc<NodePlan>>,
}

/// How the parts of one node move, and what that was made from.
pub(super) struct NodePlan {
    chain: Chain,
    ways: Ways,
    transition: Box<dyn Transition>,
    /// Within a group: the share of each part's agents, by which the parts keep about the group's barycenter.
    shares: Option<Vec<f64>>,
    /// The instants that it will be asked for, and the parts' places there.
    ts: Arc<[f64]>,
    samples: Vec<DVec2>,
}

impl NodePlan {
    pub(super) fn new(chain: Chain, ways: Ways, transition: Box<dyn Transition>, shares: Option<Vec<f64>>, ts: Arc<[f64]>) -> Self {
        let mut samples = vec![DVec2::ZERO; ts.len() * transition.agent_count()];
        let plan = Self { chain, ways, transition, shares, ts: Arc::default(), samples: Vec::new() };
        plan.places_into(&ts, &mut samples);
        Self { ts, samples, ..plan }
    }

    /// Whether it would be made again just as it is.
    pub(super) fn serves(&self, chain: &Chain, ways: &Ways, ts: &[f64]) -> bool {
        self.ways == *ways && *self.ts == *ts && self.chain.looks_like(chain)
    }

    /// `out[k * parts + j]` is part j at `ts[k]`; within a group about its barycenter.
    fn places_into(&self, ts: &[f64], out: &mut [DVec2]) {
        let part_count = self.transition.agent_count();
        if let Some(start) = self.sampled_from(ts) {
            out.copy_from_slice(&self.samples[start * part_count..(start + ts.len()) * part_count]);
            return;
        }
        self.transition.evaluate_into(ts, out);
        let Some(shares) = &self.shares else { return };
        for places in out.chunks_exact_mut(part_count) {
            let center: DVec2 = places.iter().zip(shares).map(|(place, share)| *place * *share).sum();
            for place in places {
                *place -= center;
            }
        }
    }

    /// Where these instants begin among those sampled; none unless all are.
    fn sampled_from(&self, ts: &[f64]) -> Option<usize> {
        let first = *ts.first()?;
        let start = self.ts.partition_point(|known| *known < first);
        (self.ts.get(start..start + ts.len())? == ts).then_some(start)
    }
}

impl Hierarchical {
    /// `nodes` by node of the tree.
    pub(super) fn new(tree: Arc<Tree>, nodes: Vec<Arc<NodePlan>>) -> Self {
        assert_eq!(nodes.len(), tree.nodes().len(), "every node moves");
        Self { tree, nodes }
    }

    pub(super) fn nodes(&self) -> &[Arc<NodePlan>] {
        &self.nodes
    }

    /// About how many bytes it keeps.
    pub fn size(&self) -> usize {
        let node_size = |node: &Arc<NodePlan>| {
            let part_count = node.transition.agent_count();
            size_of_val(node.samples.as_slice()) + 2 * part_count * part_count * size_of::<f64>()
        };
        self.nodes.iter().map(node_size).sum()
    }
}

impl Transition for Hierarchical {
    fn agent_count(&self) -> usize {
        self.tree.agents().len()
    }

    fn evaluate_into(&self, ts: &[f64], out: &mut [DVec2]) {
        let agent_count = self.agent_count();
        assert_eq!(out.len(), ts.len() * agent_count, "a place for every agent at every t");
        // In the order of the tree a group's agents lie side by side.
        let mut places = vec![DVec2::ZERO; out.len()];
        let mut parts = Vec::new();
        for (node, plan) in self.tree.nodes().iter().zip(&self.nodes) {
            let part_count = node.parts().len();
            parts.resize(ts.len() * part_count, DVec2::ZERO);
            plan.places_into(ts, &mut parts);
            for (places, parts) in places.chunks_exact_mut(agent_count.max(1)).zip(parts.chunks_exact(part_count.max(1))) {
                for (part, offset) in node.parts().iter().zip(parts) {
                    for place in &mut places[part.range.clone()] {
                        *place += *offset;
                    }
                }
            }
        }
        for (out, places) in out.chunks_exact_mut(agent_count.max(1)).zip(places.chunks_exact(agent_count.max(1))) {
            for (agent, place) in self.tree.agents().iter().zip(places) {
                out[*agent as usize] = *place;
            }
        }
    }
}
