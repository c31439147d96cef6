//! The tree of groups as index sets.
//!
//! Agents are put in the order of a walk through the tree, so that the set of every node is one range of that order.

use std::ops::Range;

use super::Branch;

/// Every agent once: in groups, in groups within groups, or a leaf of the root.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Tree {
    agents: Vec<u32>,
    nodes: Vec<Node>,
    /// By agent, from the root down: the part it belongs to at each node it is in.
    seats: Vec<Vec<u32>>,
}

/// A group, or the root that holds everybody.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Node {
    path: Vec<u32>,
    range: Range<usize>,
    parts: Vec<Part>,
}

/// A child of a node: a group, or an agent by itself.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Part {
    /// Where its agents are in the tree's order.
    pub range: Range<usize>,
    /// The index of its node; none for an agent by itself.
    pub node: Option<usize>,
}

impl Tree {
    /// The tree of `groups` over `agent_count` agents. Groups without agents are no nodes, but count in paths.
    ///
    /// # Panics
    /// When an agent is in two groups or there is no such agent: a bug, the document refuses it.
    pub fn new(agent_count: usize, groups: &[Branch]) -> Self {
        let mut tree = Self { agents: Vec::with_capacity(agent_count), nodes: Vec::new(), seats: vec![Vec::new(); agent_count] };
        let mut is_grouped = vec![false; agent_count];
        mark(groups, &mut is_grouped);
        let alone: Vec<u32> = (0..agent_count as u32).filter(|agent| !is_grouped[*agent as usize]).collect();
        tree.grow(Vec::new(), &alone, groups);
        assert_eq!(tree.agents.len(), agent_count, "nobody is in two groups");
        tree.take_seats();
        tree
    }

    /// All agents in the order of the tree.
    pub fn agents(&self) -> &[u32] {
        &self.agents
    }

    /// The root, then every group, each before the groups within it.
    pub fn nodes(&self) -> &[Node] {
        &self.nodes
    }

    /// The node at which two agents part, and the part of each there; none for an agent and itself.
    pub fn parting(&self, a: u32, b: u32) -> Option<(usize, [u32; 2])> {
        let mut node = 0;
        for (&a, &b) in self.seats[a as usize].iter().zip(&self.seats[b as usize]) {
            if a != b {
                return Some((node, [a, b]));
            }
            node = self.nodes[node].parts[a as usize].node?;
        }
        None
    }

    /// Adds the node of a group, whose set must not be empty unless it is the root; its index.
    fn grow(&mut self, path: Vec<u32>, members: &[u32], groups: &[Branch]) -> usize {
        let (index, start) = (self.nodes.len(), self.agents.len());
        self.nodes.push(Node::default());
        let mut parts = Vec::new();
        for (child, group) in groups.iter().enumerate().filter(|(_, group)| !is_empty(group)) {
            let path = [path.as_slice(), &[child as u32]].concat();
            let node = self.grow(path, &group.members, &group.children);
            parts.push(Part { range: self.nodes[node].range.clone(), node: Some(node) });
        }
        for &agent in members {
            parts.push(Part { range: self.agents.len()..self.agents.len() + 1, node: None });
            self.agents.push(agent);
        }
        self.nodes[index] = Node { path, range: start..self.agents.len(), parts };
        index
    }

    fn take_seats(&mut self) {
        // Parents come first, so every agent's seats run from the root down.
        for node in &self.nodes {
            for (part, Part { range, .. }) in node.parts.iter().enumerate() {
                for &agent in &self.agents[range.clone()] {
                    self.seats[agent as usize].push(part as u32);
                }
            }
        }
    }
}

impl Node {
    /// Child indices from the root; empty for the root itself.
    pub fn path(&self) -> &[u32] {
        &self.path
    }

    /// Where its agents are in the tree's order.
    pub fn range(&self) -> Range<usize> {
        self.range.clone()
    }

    /// Its groups in the order of the document, then its own agents.
    pub fn parts(&self) -> &[Part] {
        &self.parts
    }

    /// The share of each part's agents in all of the node's.
    pub fn shares(&self) -> Vec<f64> {
        self.parts.iter().map(|part| part.range.len() as f64 / self.range.len() as f64).collect()
    }
}

fn mark(groups: &[Branch], is_grouped: &mut [bool]) {
    for group in groups {
        group.members.iter().for_each(|&agent| is_grouped[agent as usize] = true);
        mark(&group.children, is_grouped);
    }
}

fn is_empty(group: &Branch) -> bool {
    group.members.is_empty() && group.children.iter().all(is_empty)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Agents 0 and 5 alone; {4, 3} and, within one group, 7 beside {1, 6} and an empty group before {2}.
    fn tree() -> Tree {
        let within = vec![Branch::leaf(vec![1, 6]), Branch::default(), Branch::leaf(vec![2])];
        Tree::new(8, &[Branch::leaf(vec![4, 3]), Branch { members: vec![7], children: within }])
    }

    #[test]
    fn the_set_of_every_node_is_a_range_and_agents_in_no_group_are_leaves_of_the_root() {
        let tree = tree();
        assert_eq!(tree.agents(), [4, 3, 1, 6, 2, 7, 0, 5]);
        let nodes: Vec<_> = tree.nodes().iter().map(|node| (node.path().to_vec(), node.range(), node.parts().len())).collect();
        let expected: [(&[u32], Range<usize>, usize); 5] =
            [(&[], 0..8, 4), (&[0], 0..2, 2), (&[1], 2..6, 3), (&[1, 0], 2..4, 2), (&[1, 2], 4..5, 1)];
        assert_eq!(nodes, expected.map(|(path, range, parts)| (path.to_vec(), range, parts)));
        assert_eq!(tree.nodes()[2].shares(), [0.5, 0.25, 0.25]);
    }

    #[test]
    fn two_agents_part_at_the_innermost_node_that_holds_both() {
        let check = |a, b, expected| assert_eq!(tree().parting(a, b), expected, "{a} and {b}");
        check(4, 3, Some((1, [0, 1])));
        check(3, 6, Some((0, [0, 1])));
        check(1, 6, Some((3, [0, 1])));
        check(2, 1, Some((2, [1, 0])));
        check(7, 2, Some((2, [2, 1])));
        check(0, 5, Some((0, [2, 3])));
        check(5, 5, None);
    }

    #[test]
    fn nobody_and_no_groups_are_a_root_alone() {
        assert_eq!(Tree::new(0, &[Branch::default()]).nodes(), [Node::default()]);
        assert_eq!(Tree::new(3, &[]).nodes()[0].parts().len(), 3);
    }
}
