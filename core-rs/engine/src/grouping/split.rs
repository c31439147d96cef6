//! Where a graph comes apart most easily.
//!
//! Agents line up by their values in the second mode; of all places to cut the line the one is taken that cuts the least weight of
//! ties for the sizes it makes (paper A, section 3.1: the second eigenvector bisects a graph).

use super::fiedler::fiedler;
use super::graph::Graph;
use crate::formation::Formation;
use crate::order;

/// Values nearer than this, relative to their range, are one: symmetric agents are not parted by round-off.
const SAME_VALUE: f64 = 1e-7;

/// Costs nearer than this, relative to the less, are one: the first of them is taken.
pub(super) const SAME_COST: f64 = 1e-9;

/// A graph in two.
pub(super) struct Split {
    /// What is cut for the sizes made; 0 where nothing is.
    pub(super) cost: f64,
    /// Local agents, ascending each.
    pub(super) sides: [Vec<u32>; 2],
}

/// The best cut of a graph; none for fewer than two agents or agents all alike that nothing tells apart.
///
/// The cost is cut / (min(|A|, s) · min(|B|, s)): with `share` s = n / k the sides of k equal parts cost least, and a side as large
/// as it may become gains nothing by more.
pub(super) fn split(graph: &Graph, formation: &Formation, share: f64) -> Option<Split> {
    let pieces = graph.pieces();
    if pieces.len() > 1 {
        return Some(apart(&pieces));
    }
    if graph.agent_count() < 2 {
        return None;
    }
    let values = fiedler(graph, formation);
    let line = order::by_key(values.iter().map(|value| u128::from(order::of_real(*value))));
    let range = values[*line.last()? as usize] - values[line[0] as usize];
    let mut is_left = vec![false; line.len()];
    let mut cut = 0.0;
    let mut best: Option<(f64, usize)> = None;
    for count in 1..line.len() {
        let [agent, next] = [line[count - 1], line[count]];
        is_left[agent as usize] = true;
        for &(other, weight) in graph.neighbors(agent) {
            cut += if is_left[other as usize] { -weight } else { weight };
        }
        if values[next as usize] - values[agent as usize] <= SAME_VALUE * range {
            continue;
        }
        let side = |size: usize| (size as f64).min(share.max(1.0));
        let cost = cut.max(0.0) / (side(count) * side(line.len() - count));
        if best.is_none_or(|(least, _)| cost < least * (1.0 - SAME_COST)) {
            best = Some((cost, count));
        }
    }
    let (cost, count) = best?;
    let mut sides = [line[..count].to_vec(), line[count..].to_vec()];
    for side in &mut sides {
        order::sort_by_key(side, |agent| u128::from(*agent));
    }
    Some(Split { cost, sides })
}

/// The piece that comes nearest to half of the agents against all others, of equals the first.
fn apart(pieces: &[Vec<u32>]) -> Split {
    let total: usize = pieces.iter().map(Vec::len).sum();
    let size = |piece: &Vec<u32>| piece.len().min(total - piece.len());
    let largest = pieces.iter().map(size).max().unwrap_or(0);
    let chosen = pieces.iter().position(|piece| size(piece) == largest).unwrap_or(0);
    let mut others: Vec<u32> =
        pieces.iter().enumerate().filter(|(index, _)| *index != chosen).flat_map(|(_, piece)| piece.clone()).collect();
    order::sort_by_key(&mut others, |agent| u128::from(*agent));
    Split { cost: 0.0, sides: [pieces[chosen].clone(), others] }
}
