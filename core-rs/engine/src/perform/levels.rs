//! A scene's groups as its hierarchies see them: the tree, and what each of its nodes sees of a keyframe.

use std::sync::Arc;

use crate::choice::Choice;
use crate::grouping::{Branch, Tree};
use crate::recent::{Recent, Same};
use crate::scene::{Group, TransitionSpec};
use crate::transition::{Chain, End, Hierarchical, Hierarchy, Way, nodes_at};

/// What 1,260 agents' nodes see of a keyframe is 1 MB.
const SEEN_LIMIT: usize = 64 << 20;

/// The nodes' places of one segment of 1,260 agents over 10 s are 7 MB.
const GROWN_LIMIT: usize = 96 << 20;

/// About how many bytes a node keeps of each of its parts and their ties.
const PART_BYTES: usize = 200;

/// Trees, nodes and the last plan of each segment, each found once for as long as what it came from is the same object.
pub(super) struct Levels {
    tree: Option<(Same<Vec<Group>>, Arc<Tree>)>,
    seen: Recent<(End, Same<Tree>), Arc<Vec<End>>>,
    grown: Recent<usize, Arc<Hierarchical>>,
}

impl Default for Levels {
    fn default() -> Self {
        Self { tree: None, seen: Recent::new(SEEN_LIMIT), grown: Recent::new(GROWN_LIMIT) }
    }
}

impl Levels {
    /// The planning of a segment by groups; `segment` is its number, by which what stayed of its last plan is used again.
    pub(super) fn hierarchy(&mut self, groups: &Arc<Vec<Group>>, chain: &Chain, segment: Option<usize>) -> Hierarchy {
        let tree = self.tree(groups, chain.agent_count());
        let ends: Vec<Arc<Vec<End>>> = chain.ends().iter().map(|end| self.nodes(&tree, end)).collect();
        let last = segment.and_then(|segment| self.grown.get(&segment));
        Hierarchy::new(tree, chain, &ends, last)
    }

    /// Keeps the plan of a segment for the next that is made of it.
    pub(super) fn keep(&mut self, segment: usize, plan: &Arc<Hierarchical>) {
        self.grown.put(segment, plan.clone(), plan.size());
    }

    pub(super) fn tree(&mut self, groups: &Arc<Vec<Group>>, agent_count: usize) -> Arc<Tree> {
        let groups = Same(groups.clone());
        if let Some((_, tree)) = self.tree.as_ref().filter(|(known, tree)| *known == groups && tree.agents().len() == agent_count) {
            return tree.clone();
        }
        let tree = Arc::new(Tree::new(agent_count, &branches(&groups.0)));
        self.tree = Some((groups, tree.clone()));
        tree
    }

    fn nodes(&mut self, tree: &Arc<Tree>, end: &End) -> Arc<Vec<End>> {
        let key = (end.clone(), Same(tree.clone()));
        if let Some(known) = self.seen.get(&key) {
            return known;
        }
        let nodes = Arc::new(nodes_at(tree, &end.formation, &end.adjacency));
        self.seen.put(key, nodes.clone(), PART_BYTES * (tree.agents().len() + tree.nodes().len()));
        nodes
    }
}

/// How a group moves: by the way of its own, or else as its segment chose. A method of its own has the segment's options.
pub(super) fn node_way(transition: &TransitionSpec, path: &[u32], choice: Choice) -> Way {
    let Some(node) = transition.nodes.iter().find(|node| node.group == path) else {
        return Way::of(choice, transition.keep_size);
    };
    let TransitionSpec { order, alignment, sharing, keep_size, .. } = *transition;
    let with = |method| Choice { method, order, alignment, sharing };
    Way { choice: with(node.method), keeps_size: keep_size, blend: node.blend.map(|blend| (with(blend.method), blend.amount)) }
}

fn branches(groups: &[Group]) -> Vec<Branch> {
    groups.iter().map(|group| Branch { members: group.members.clone(), children: branches(&group.children) }).collect()
}
