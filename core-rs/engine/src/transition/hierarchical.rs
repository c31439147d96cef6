//! A motion for every node of a tree of groups, put together from the top down (paper A, section 4.4).

use std::ops::AddAssign;
use std::sync::Arc;

use glam::DVec2;

use super::Transition;
use super::chain::{Chain, Ways};
use crate::grouping::{Node, Tree};

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
    samples: Samples,
}

/// Places of parts, instant by instant.
#[derive(Default)]
struct Samples {
    plan: Vec<DVec2>,
    /// None on the plane.
    heights: Option<Vec<f64>>,
}

impl Samples {
    fn new(count: usize, has_heights: bool) -> Self {
        Self { plan: vec![DVec2::ZERO; count], heights: has_heights.then(|| vec![0.0; count]) }
    }
}

impl NodePlan {
    pub(super) fn new(chain: Chain, ways: Ways, transition: Box<dyn Transition>, shares: Option<Vec<f64>>, ts: Arc<[f64]>) -> Self {
        let mut samples = Samples::new(ts.len() * transition.agent_count(), chain.has_heights());
        let plan = Self { chain, ways, transition, shares, ts: Arc::default(), samples: Samples::default() };
        plan.places_into(&ts, &mut samples.plan, samples.heights.as_deref_mut());
        Self { ts, samples, ..plan }
    }

    /// Whether it would be made again just as it is.
    pub(super) fn serves(&self, chain: &Chain, ways: &Ways, ts: &[f64]) -> bool {
        self.ways == *ways && *self.ts == *ts && self.chain.looks_like(chain)
    }

    /// `plan[k * parts + j]` is part j at `ts[k]`, and so the heights where they are asked for; within a group about its barycenter.
    fn places_into(&self, ts: &[f64], plan: &mut [DVec2], mut heights: Option<&mut [f64]>) {
        let part_count = self.transition.agent_count();
        if let Some(start) = self.sampled_from(ts) {
            let known = start * part_count..(start + ts.len()) * part_count;
            plan.copy_from_slice(&self.samples.plan[known.clone()]);
            if let (Some(heights), Some(samples)) = (heights, &self.samples.heights) {
                heights.copy_from_slice(&samples[known]);
            }
            return;
        }
        self.transition.evaluate_into(ts, plan, heights.as_deref_mut());
        let Some(shares) = &self.shares else { return };
        for places in plan.chunks_exact_mut(part_count) {
            let center: DVec2 = places.iter().zip(shares).map(|(place, share)| *place * *share).sum();
            for place in places {
                *place -= center;
            }
        }
        for rises in heights.into_iter().flat_map(|heights| heights.chunks_exact_mut(part_count)) {
            let center: f64 = rises.iter().zip(shares).map(|(rise, share)| rise * share).sum();
            for rise in rises {
                *rise -= center;
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
            size_of_val(&node.samples.plan[..])
                + size_of_val(node.samples.heights.as_deref().unwrap_or_default())
                + 2 * part_count * part_count * size_of::<f64>()
        };
        self.nodes.iter().map(node_size).sum()
    }
}

impl Transition for Hierarchical {
    fn agent_count(&self) -> usize {
        self.tree.agents().len()
    }

    fn evaluate_into(&self, ts: &[f64], plan: &mut [DVec2], heights: Option<&mut [f64]>) {
        let agent_count = self.agent_count();
        assert_eq!(plan.len(), ts.len() * agent_count, "a place for every agent at every t");
        // In the order of the tree a group's agents lie side by side.
        let mut places = Samples::new(plan.len(), heights.is_some());
        let mut parts = Samples::new(0, heights.is_some());
        for (node, node_plan) in self.tree.nodes().iter().zip(&self.nodes) {
            let count = ts.len() * node.parts().len();
            parts.plan.resize(count, DVec2::ZERO);
            if let Some(heights) = &mut parts.heights {
                heights.resize(count, 0.0);
            }
            node_plan.places_into(ts, &mut parts.plan, parts.heights.as_deref_mut());
            add_parts(node, &parts.plan, &mut places.plan, agent_count);
            if let (Some(places), Some(parts)) = (&mut places.heights, &parts.heights) {
                add_parts(node, parts, places, agent_count);
            }
        }
        self.write_by_agent(&places.plan, plan);
        if let (Some(places), Some(heights)) = (&places.heights, heights) {
            self.write_by_agent(places, heights);
        }
    }
}

impl Hierarchical {
    /// From the order of the tree.
    fn write_by_agent<P: Copy>(&self, places: &[P], out: &mut [P]) {
        let agent_count = self.tree.agents().len().max(1);
        for (out, places) in out.chunks_exact_mut(agent_count).zip(places.chunks_exact(agent_count)) {
            for (agent, place) in self.tree.agents().iter().zip(places) {
                out[*agent as usize] = *place;
            }
        }
    }
}

/// Moves the agents of every part with it, instant by instant.
fn add_parts<P: Copy + AddAssign>(node: &Node, parts: &[P], places: &mut [P], agent_count: usize) {
    let part_count = node.parts().len().max(1);
    for (places, parts) in places.chunks_exact_mut(agent_count.max(1)).zip(parts.chunks_exact(part_count)) {
        for (part, offset) in node.parts().iter().zip(parts) {
            for place in &mut places[part.range.clone()] {
                *place += *offset;
            }
        }
    }
}
