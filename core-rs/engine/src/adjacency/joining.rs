//! Ties for those whom a proposal left apart.

use super::Edge;
use super::components::Components;
use crate::order;

/// Lengths that differ by less than this fraction are equally short.
const EQUAL_LENGTH_TOLERANCE: f64 = 1e-9;

/// Ties what `edges` leaves apart by the shortest of the candidates (length, edge) that lead out of it, the lowest indices among
/// equally short ones. The candidates connect all agents, and are looked at only where somebody is apart.
pub(super) fn join_components(agent_count: usize, candidates: impl Iterator<Item = (f64, Edge)>, edges: &mut Vec<Edge>) {
    let mut components = Components::new(agent_count);
    let mut missing = agent_count.saturating_sub(1);
    for &(a, b) in edges.iter() {
        missing -= usize::from(components.join(a, b));
    }
    if missing == 0 {
        return;
    }
    let mut candidates: Vec<(f64, Edge)> = candidates.collect();
    order::sort_by_key(&mut candidates, |&(length, (a, b))| order::key_of_two(order::of_real(length), u64::from(a) << 32 | u64::from(b)));
    let mut rest = &mut candidates[..];
    while missing > 0 && !rest.is_empty() {
        let limit = rest[0].0 * (1.0 + EQUAL_LENGTH_TOLERANCE);
        let (equal, longer) = rest.split_at_mut(rest.partition_point(|edge| edge.0 <= limit));
        order::sort_by_key(equal, |edge| order::key_of_pair(edge.1));
        for &mut (_, (a, b)) in equal {
            if components.join(a, b) {
                edges.push((a, b));
                missing -= 1;
            }
        }
        rest = longer;
    }
    assert_eq!(missing, 0, "a triangulation connects its agents");
}
