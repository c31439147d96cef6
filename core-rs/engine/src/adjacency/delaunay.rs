//! The ties that positions alone suggest: the Delaunay subdivision.
//!
//! A Delaunay triangulation is not unique where agents share a circle, which every grid and every ring does; the triangulation
//! then depends on the order of the agents and on rounding. The subdivision leaves out what is not unique (spectral.md, section 2):
//! a square cell keeps its four sides, a ring its cycle, and relabeling or moving the formation changes nothing.

use std::f64::consts::PI;

use glam::DVec2;

use super::coincidence::representatives;
use super::components::Components;
use super::triangulation::{Raw, triangulate};
use crate::formation::{Formation, principal_axes};

/// Agents nearer than this, relative to the extent, stand in one place.
pub const COINCIDENCE_TOLERANCE: f64 = 1e-9;

/// A triangle whose height is at most this fraction of its longest side has no inside to speak of.
///
/// Coordinates carry errors of 1e-11 of the extent far from the origin; this stays clear of them and below anything a person draws.
const SLIVER_TOLERANCE: f64 = 1e-6;

/// Opposite angles that sum to π within this, radians, say that four agents share a circle.
const COCIRCULAR_TOLERANCE: f64 = 1e-6;

/// Lengths that differ by less than this fraction are equally short.
const EQUAL_LENGTH_TOLERANCE: f64 = 1e-9;

type Edge = (u32, u32);

/// The Delaunay subdivision of a formation: pairs a < b, ascending, connecting all agents.
///
/// Coincident agents are tied to the lowest of them; agents on one line form a chain.
pub fn propose(formation: &Formation) -> Vec<Edge> {
    let formation = normalized(formation);
    let points = formation.positions();
    let representative = representatives(points, COINCIDENCE_TOLERANCE * formation.extent());
    let mut edges: Vec<Edge> = (0..).zip(&representative).filter(|&(agent, &of)| agent != of).map(|(agent, &of)| (of, agent)).collect();
    let apart: Vec<u32> = (0..).zip(&representative).filter(|&(agent, &of)| agent == of).map(|(agent, _)| agent).collect();
    edges.extend(subdivision(points, &apart));
    edges.sort_unstable();
    edges
}

/// Positions about the middle of the bounding box, scaled by a power of two to an extent near 1: products of differences neither
/// lose digits far from the origin nor underflow.
fn normalized(formation: &Formation) -> Formation {
    let (low, high) = formation.bounds();
    let extent = low.distance(high);
    let scale = if extent > 0.0 { libm::ldexp(1.0, -libm::ilogb(extent)) } else { 0.0 };
    Formation::new(formation.positions().iter().map(|&p| (p - low.midpoint(high)) * scale).collect())
}

/// The subdivision of agents that all stand apart, `agents` ascending.
fn subdivision(points: &[DVec2], agents: &[u32]) -> Vec<Edge> {
    let Raw { triangles, edges: raw } = triangulate(points, agents);
    let mut corners: Vec<Corner> = Vec::with_capacity(3 * triangles.len());
    for [a, b, c] in triangles.into_iter().filter(|triangle| !is_sliver(points, *triangle)) {
        corners.extend([corner(points, a, b, c), corner(points, b, c, a), corner(points, c, a, b)]);
    }
    if corners.is_empty() {
        return chain(points, agents);
    }
    corners.sort_unstable_by_key(|corner| corner.edge);
    let mut edges: Vec<Edge> =
        corners.chunk_by(|p, q| p.edge == q.edge).filter(|sides| !is_diagonal(sides)).map(|sides| sides[0].edge).collect();
    join_components(points, agents, raw, &mut edges);
    edges
}

/// One corner of a kept triangle: the edge it faces and its angle, radians.
struct Corner {
    edge: Edge,
    angle: f64,
}

fn corner(points: &[DVec2], apex: u32, a: u32, b: u32) -> Corner {
    let (to_a, to_b) = (points[a as usize] - points[apex as usize], points[b as usize] - points[apex as usize]);
    Corner { edge: (a.min(b), a.max(b)), angle: to_a.perp_dot(to_b).abs().atan2(to_a.dot(to_b)) }
}

/// Whether the triangles at both sides of an edge have one circumcircle: then another diagonal would do as well.
fn is_diagonal(sides: &[Corner]) -> bool {
    matches!(sides, [one, other] if (one.angle + other.angle - PI).abs() <= COCIRCULAR_TOLERANCE)
}

fn is_sliver(points: &[DVec2], [a, b, c]: [u32; 3]) -> bool {
    let [a, b, c] = [a, b, c].map(|agent| points[agent as usize]);
    let longest_squared = a.distance_squared(b).max(b.distance_squared(c)).max(c.distance_squared(a));
    let height_times_longest = (b - a).perp_dot(c - a).abs();
    height_times_longest <= SLIVER_TOLERANCE * longest_squared
}

/// Ties each agent to the next along the line they stand on.
fn chain(points: &[DVec2], agents: &[u32]) -> Vec<Edge> {
    let standing: Vec<DVec2> = agents.iter().map(|&agent| points[agent as usize]).collect();
    let along = DVec2::from_angle(principal_axes(&standing).angle);
    let place = |agent: u32| (along.dot(points[agent as usize]), along.perp_dot(points[agent as usize]));
    let mut ordered = agents.to_vec();
    ordered.sort_by(|&a, &b| {
        let ((a_along, a_across), (b_along, b_across)) = (place(a), place(b));
        a_along.total_cmp(&b_along).then(a_across.total_cmp(&b_across))
    });
    ordered.windows(2).map(|pair| (pair[0].min(pair[1]), pair[0].max(pair[1]))).collect()
}

/// Ties what the subdivision cut off by the shortest raw edges that lead out of it, the lowest indices among equally short ones.
fn join_components(points: &[DVec2], agents: &[u32], raw: Vec<Edge>, edges: &mut Vec<Edge>) {
    let mut components = Components::new(points.len());
    let mut missing = agents.len() - 1;
    for &(a, b) in edges.iter() {
        missing -= usize::from(components.join(a, b));
    }
    if missing == 0 {
        return;
    }
    let length = |(a, b): Edge| points[a as usize].distance(points[b as usize]);
    let mut raw: Vec<(f64, Edge)> = raw.into_iter().map(|edge| (length(edge), edge)).collect();
    raw.sort_by(|p, q| p.0.total_cmp(&q.0).then(p.1.cmp(&q.1)));
    let mut rest = &mut raw[..];
    while missing > 0 && !rest.is_empty() {
        let limit = rest[0].0 * (1.0 + EQUAL_LENGTH_TOLERANCE);
        let (equal, longer) = rest.split_at_mut(rest.partition_point(|edge| edge.0 <= limit));
        equal.sort_unstable_by_key(|edge| edge.1);
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

#[cfg(test)]
mod tests {
    use super::*;

    fn check(points: &[[f64; 2]], expected: &[Edge]) {
        assert_eq!(propose(&Formation::from(points.to_vec())), expected, "{points:?}");
    }

    #[test]
    fn nobody_and_one_agent_have_no_ties() {
        check(&[], &[]);
        check(&[[3.0, 4.0]], &[]);
    }

    #[test]
    fn two_agents_are_tied() {
        check(&[[3.0, 4.0], [-1.0, 4.0]], &[(0, 1)]);
    }

    #[test]
    fn agents_in_one_place_are_tied_to_the_first() {
        check(&[[5.0, 5.0]; 2], &[(0, 1)]);
        check(&[[5.0, 5.0]; 4], &[(0, 1), (0, 2), (0, 3)]);
    }

    #[test]
    fn a_twin_is_tied_to_its_representative_alone() {
        check(&[[0.0, 0.0], [4.0, 0.0], [0.0, 3.0], [4.0, 1e-10]], &[(0, 1), (0, 2), (1, 2), (1, 3)]);
    }

    #[test]
    fn agents_on_a_line_form_a_chain() {
        check(&[[0.0, 0.0], [3.0, 3.0], [1.0, 1.0], [2.0, 2.0]], &[(0, 2), (1, 3), (2, 3)]);
        // Bent by less than anyone draws.
        check(&[[0.0, 0.0], [3.0, 1e-7], [1.0, 0.0], [2.0, -1e-7]], &[(0, 2), (1, 3), (2, 3)]);
    }

    #[test]
    fn a_square_keeps_its_sides() {
        check(&[[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]], &[(0, 1), (0, 3), (1, 2), (2, 3)]);
    }

    #[test]
    fn a_square_with_its_middle_keeps_the_spokes() {
        let sides_and_spokes = [(0, 1), (0, 3), (0, 4), (1, 2), (1, 4), (2, 3), (2, 4), (3, 4)];
        check(&[[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0], [0.5, 0.5]], &sides_and_spokes);
    }

    #[test]
    fn a_skew_quadrilateral_keeps_its_shorter_diagonal() {
        check(&[[0.0, 0.0], [4.0, 0.0], [5.0, 1.0], [0.0, 1.0]], &[(0, 1), (0, 3), (1, 2), (1, 3), (2, 3)]);
    }

    #[test]
    fn the_hull_of_a_dented_row_has_no_long_edge() {
        // The middle agent stands a hair inside the row: the sliver above it is no triangle.
        check(&[[0.0, 0.0], [2.0, 0.0], [1.0, -1e-9], [1.0, -2.0]], &[(0, 2), (0, 3), (1, 2), (1, 3), (2, 3)]);
    }

    #[test]
    fn an_agent_among_slivers_only_is_tied_by_its_shortest_raw_edge() {
        // Agent 3 between 2 and 4, 1e-7 and 2e-7 of the extent away: too far for a twin, too near for a triangle.
        let points = [[0.0, 0.0], [10.0, 0.0], [5.0, 5.0], [5.0 + 1e-6, 5.0], [5.0 + 3e-6, 5.0]];
        let edges = propose(&Formation::from(points.to_vec()));
        assert!(edges.contains(&(2, 3)), "{edges:?}");
    }
}
