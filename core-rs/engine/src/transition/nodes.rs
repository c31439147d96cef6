//! What the nodes of a tree of groups see of one keyframe.
//!
//! To a node its children are a formation of their own: groups stand at their barycenters, agents where they stand, and the ties
//! between two children are the sum of those between their agents (paper A, section 4.4).

use std::sync::Arc;

use glam::DVec3;

use super::End;
use crate::adjacency::{Adjacency, Tie};
use crate::formation::Formation;
use crate::grouping::{Node, Part, Tree};
use crate::order::{key_of_pair, sort_by_key};

/// Positions within a group are rounded to this, meters.
///
/// A group that is moved as a whole then looks the same from within, to the last bit, and is not planned again: the round-off of a
/// move is a thousandth of this. Eight levels of it stay far below what the ends are exact to.
const GRAIN: f64 = 1.0 / (1_u64 << 34) as f64;

/// Digits of a weight that a move's round-off reaches; dropped within groups for the same reason.
const NOISY_BITS: u32 = 16;

/// By node of the tree: its parts as the agents of an end. Within groups positions are about the group's barycenter.
pub(crate) fn nodes_at(tree: &Tree, formation: &Formation, adjacency: &Adjacency) -> Vec<End> {
    let places: Vec<DVec3> = tree.agents().iter().map(|&agent| formation.places().at(agent as usize)).collect();
    let center = |range: std::ops::Range<usize>| {
        let count = range.len().max(1) as f64;
        places[range].iter().sum::<DVec3>() / count
    };
    let has_heights = formation.heights().is_some();
    let mut ties = ties_by_node(tree, adjacency);
    let node_end = |(index, node): (usize, &Node)| {
        let is_root = index == 0;
        let origin = if is_root { DVec3::ZERO } else { center(node.range()) };
        let place = |part: &Part| {
            let place = center(part.range.clone()) - origin;
            if is_root { place } else { (place / GRAIN).round() * GRAIN }
        };
        let (plan, heights) = node.parts().iter().map(place).map(|place| (place.truncate(), place.z)).unzip();
        let formation = if has_heights { Formation::spatial(plan, heights) } else { Formation::new(plan) };
        let adjacency = Adjacency::new(node.parts().len(), summed(std::mem::take(&mut ties[index]), is_root));
        End { formation: Arc::new(formation), adjacency: Arc::new(adjacency) }
    };
    tree.nodes().iter().enumerate().map(node_end).collect()
}

/// Ties between parts, by the node at which their agents part.
fn ties_by_node(tree: &Tree, adjacency: &Adjacency) -> Vec<Vec<Tie>> {
    let mut ties = vec![Vec::new(); tree.nodes().len()];
    for tie in adjacency.ties() {
        if let Some((node, [p, q])) = tree.parting(tie.a, tie.b) {
            ties[node].push(Tie { a: p.min(q), b: p.max(q), factor: 1.0, weight: tie.weight });
        }
    }
    ties
}

fn summed(mut ties: Vec<Tie>, is_root: bool) -> Vec<Tie> {
    sort_by_key(&mut ties, |tie| key_of_pair((tie.a, tie.b)));
    let sum = |same: &[Tie]| {
        let weight = same.iter().map(|tie| tie.weight).sum();
        Tie { weight: if is_root { weight } else { without_noise(weight) }, ..same[0] }
    };
    ties.chunk_by(|p, q| (p.a, p.b) == (q.a, q.b)).map(sum).collect()
}

/// A positive number to the nearest of those that end in zeros.
fn without_noise(weight: f64) -> f64 {
    let half = 1_u64 << (NOISY_BITS - 1);
    f64::from_bits((weight.to_bits() + half) >> NOISY_BITS << NOISY_BITS)
}

#[cfg(test)]
mod tests {
    use glam::DVec2;

    use super::*;
    use crate::grouping::Branch;

    fn tied(agent_count: usize, ties: &[(u32, u32, f64)]) -> Adjacency {
        Adjacency::new(agent_count, ties.iter().map(|&(a, b, weight)| Tie { a, b, factor: 1.0, weight }).collect())
    }

    fn ties(end: &End) -> Vec<(u32, u32, f64)> {
        end.adjacency.ties().iter().map(|tie| (tie.a, tie.b, tie.weight)).collect()
    }

    /// Two pairs within one group, an agent beside them in it, and one alone.
    fn tree() -> Tree {
        Tree::new(6, &[Branch { members: vec![4], children: vec![Branch::leaf(vec![0, 1]), Branch::leaf(vec![2, 3])] }])
    }

    fn formation() -> Formation {
        Formation::from(vec![[0.0, 0.0], [2.0, 0.0], [8.0, 4.0], [8.0, 6.0], [7.0, 5.0], [1.0, 9.0]])
    }

    #[test]
    fn groups_stand_at_their_barycenters_and_their_ties_add_up() {
        let adjacency = tied(6, &[(0, 1, 1.0), (0, 2, 2.0), (1, 2, 0.5), (1, 4, 8.0), (1, 5, 0.25), (2, 3, 16.0), (3, 5, 0.75)]);
        let ends = nodes_at(&tree(), &formation(), &adjacency);
        assert_eq!(*ends[0].formation, Formation::from(vec![[5.0, 3.0], [1.0, 9.0]]));
        assert_eq!(ties(&ends[0]), [(0, 1, 1.0)]);
        assert_eq!(*ends[1].formation, Formation::from(vec![[-4.0, -3.0], [3.0, 2.0], [2.0, 2.0]]));
        assert_eq!(ties(&ends[1]), [(0, 1, 2.5), (0, 2, 8.0)]);
        assert_eq!(*ends[2].formation, Formation::from(vec![[-1.0, 0.0], [1.0, 0.0]]));
        assert_eq!(ties(&ends[3]), [(0, 1, 16.0)]);
    }

    #[test]
    fn a_group_moved_as_a_whole_looks_the_same_from_within() {
        let spiral = |shift: DVec2| (0..40).map(|i| DVec2::from_angle(f64::from(i)) * 0.1 * f64::from(i) + shift).collect();
        let everyone = Tree::new(40, &[Branch::leaf((0..40).collect())]);
        let within = |shift: DVec2| {
            let formation = Formation::new(spiral(shift));
            let adjacency = crate::adjacency::build(&formation, &crate::adjacency::AdjacencySpec::default(), &[]).expect("few ties");
            nodes_at(&everyone, &formation, &adjacency).remove(1)
        };
        let (here, there) = (within(DVec2::ZERO), within(DVec2::new(1.37, -20.11)));
        assert_eq!(here.formation, there.formation);
        assert_eq!(ties(&here), ties(&there));
    }
}
