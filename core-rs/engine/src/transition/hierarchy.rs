//! Plans a segment node by node, and nothing that stayed as it was.
//!
//! A node's parts are a [`Chain`] like any other, so every method, blend and join serves at every level. A group moved as a whole looks
//! the same from within: only the nodes around it are planned again.

use std::sync::Arc;

use super::chain::{Chain, End, Ways};
use super::hierarchical::{Hierarchical, NodePlan};
use super::planner::Planner;
use crate::grouping::Tree;

/// Nodes of more parts than this share their pieces with other segments; the others are planned faster than such a piece is found.
const SMALL_NODE: usize = 60;

/// What one step may cost, in multiplications; about 10 ms.
const WORK_PER_STEP: usize = 4_000_000;

/// A piece of planning is a few n³.
const PIECE_WORK: usize = 8;

/// What one place at one instant costs.
const SAMPLE_WORK: usize = 60;

/// A segment as the nodes of a tree see it, and the planning of their motions.
pub struct Hierarchy {
    tree: Arc<Tree>,
    /// By node.
    chains: Vec<Chain>,
    planners: Vec<Planner>,
    done: Vec<Arc<NodePlan>>,
    last: Option<Arc<Hierarchical>>,
}

impl Hierarchy {
    /// `ends[k][node]` is what a node sees of keyframe k of the chain; `last` is what this segment was before.
    pub fn new(tree: Arc<Tree>, chain: &Chain, ends: &[Arc<Vec<End>>], last: Option<Arc<Hierarchical>>) -> Self {
        let node_count = tree.nodes().len();
        let chains = (0..node_count).map(|node| chain.with_ends(ends.iter().map(|nodes| nodes[node].clone()).collect())).collect();
        let planners = std::iter::repeat_with(Planner::default).take(node_count).collect();
        Self { tree, chains, planners, done: Vec::new(), last }
    }

    /// Its tree.
    pub fn tree(&self) -> &Arc<Tree> {
        &self.tree
    }

    /// The most parts that a node has.
    pub fn most_parts(&self) -> usize {
        self.chains.iter().map(Chain::agent_count).max().unwrap_or(0)
    }

    /// Plans some more nodes, each by the ways of its path, to be asked for at `ts` (ascending; none when it is only tried); the
    /// transition once none is left. Then it may plan other ways.
    pub fn step(&mut self, shared: &mut Planner, ways: impl Fn(&[u32]) -> Ways, ts: &Arc<[f64]>) -> Option<Hierarchical> {
        let mut work = 0;
        while self.done.len() < self.tree.nodes().len() {
            if work > WORK_PER_STEP {
                return None;
            }
            work += self.advance(shared, &ways(self.tree.nodes()[self.done.len()].path()), ts);
        }
        Some(Hierarchical::new(self.tree.clone(), std::mem::take(&mut self.done)))
    }

    /// The next piece of the next node; what it cost.
    fn advance(&mut self, shared: &mut Planner, ways: &Ways, ts: &Arc<[f64]>) -> usize {
        let node = self.done.len();
        let chain = &self.chains[node];
        let known = self.last.as_ref().and_then(|last| last.nodes().get(node));
        if let Some(known) = known.filter(|known| known.serves(chain, ways, ts)) {
            self.done.push(known.clone());
            return 0;
        }
        let part_count = chain.agent_count();
        let planner = if part_count > SMALL_NODE { shared } else { &mut self.planners[node] };
        let Some(transition) = planner.step(chain, ways) else { return PIECE_WORK * part_count.pow(3) };
        let shares = (node > 0).then(|| self.tree.nodes()[node].shares());
        self.done.push(Arc::new(NodePlan::new(chain.clone(), *ways, transition, shares, ts.clone())));
        SAMPLE_WORK * part_count * ts.len()
    }
}
