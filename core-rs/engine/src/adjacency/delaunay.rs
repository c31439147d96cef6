//! The ties that positions alone suggest: the Delaunay subdivision.
//!
//! A Delaunay triangulation is not unique where agents share a circle or a sphere, which every grid and every ring does; the
//! triangulation then depends on the order of the agents and on rounding. The subdivision leaves out what is not unique (spectral.md,
//! section 2): a square cell keeps its four sides, a ring its cycle, a cube its twelve edges, and relabeling or moving the formation
//! changes nothing.

use glam::{DVec2, DVec3};

use super::Edge;
use super::coincidence::representatives;
use super::facets::neighbors_in_space;
use super::subdivision::{SLIVER_TOLERANCE, subdivision};
use crate::formation::{Formation, Places};
use crate::order;

/// Agents nearer than this, relative to the extent, stand in one place.
pub const COINCIDENCE_TOLERANCE: f64 = 1e-9;

/// The Delaunay subdivision of a formation, in its plane where it has one: pairs a < b, ascending, connecting all agents.
///
/// Coincident agents are tied to the lowest of them; agents on one line form a chain.
pub fn propose(formation: &Formation) -> Vec<Edge> {
    let (points, extent) = normalized(formation.places());
    let representative = representatives(&points, COINCIDENCE_TOLERANCE * extent);
    let mut edges: Vec<Edge> = (0..).zip(&representative).filter(|&(agent, &of)| agent != of).map(|(agent, &of)| (of, agent)).collect();
    let apart: Vec<u32> = (0..).zip(&representative).filter(|&(agent, &of)| agent == of).map(|(agent, _)| agent).collect();
    let standing: Vec<DVec3> = apart.iter().map(|&agent| points[agent as usize]).collect();
    let own = plane_of(&standing).map_or_else(|| neighbors_in_space(&standing), |plan| subdivision(&plan));
    edges.extend(own.into_iter().map(|(a, b)| (apart[a as usize], apart[b as usize])));
    order::sort_by_key(&mut edges, |edge| order::key_of_pair(*edge));
    edges
}

/// Places about the middle of the bounding box, scaled by a power of two to an extent near 1, with that extent: products of
/// differences neither lose digits far from the origin nor underflow.
fn normalized(places: Places<'_>) -> (Vec<DVec3>, f64) {
    let (low, high) = places.bounds();
    let extent = low.distance(high);
    let scale = if extent > 0.0 { libm::ldexp(1.0, -libm::ilogb(extent)) } else { 0.0 };
    (places.iter().map(|place| (place - low.midpoint(high)) * scale).collect(), extent * scale)
}

/// The agents within the plane they stand in, as they are where it is level; none when they need space. Extents are near 1.
fn plane_of(points: &[DVec3]) -> Option<Vec<DVec2>> {
    let first = *points.first().unwrap_or(&DVec3::ZERO);
    if points.iter().all(|point| point.z == first.z) {
        return Some(points.iter().map(|point| point.truncate()).collect());
    }
    let farthest = |measure: &dyn Fn(DVec3) -> f64| points.iter().copied().max_by(|&p, &q| measure(p).total_cmp(&measure(q)));
    let a = farthest(&|point| point.distance_squared(first))?;
    let b = farthest(&|point| point.distance_squared(a))?;
    let along = (b - a).normalize();
    let off = |point: DVec3| (point - a).reject_from_normalized(along);
    let across = farthest(&|point| off(point).length_squared()).map(off)?;
    let across = across.try_normalize().unwrap_or_else(|| along.any_orthonormal_vector());
    let normal = along.cross(across);
    let is_flat = points.iter().all(|&point| normal.dot(point - a).abs() <= SLIVER_TOLERANCE);
    is_flat.then(|| points.iter().map(|&point| DVec2::new(along.dot(point), across.dot(point))).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn check(points: &[[f64; 2]], expected: &[Edge]) {
        assert_eq!(propose(&Formation::from(points.to_vec())), expected, "{points:?}");
    }

    /// The same in three dimensions.
    fn check_in_space(points: &[[f64; 3]], expected: &[Edge]) {
        assert_eq!(propose(&in_space(points)), expected, "{points:?}");
    }

    fn in_space(points: &[[f64; 3]]) -> Formation {
        Formation::spatial(points.iter().map(|&[x, y, _]| DVec2::new(x, y)).collect(), points.iter().map(|point| point[2]).collect())
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

    #[test]
    fn a_cube_keeps_its_edges_and_a_block_its_cells() {
        let cube: Vec<[f64; 3]> = (0..8).map(|i| [f64::from(i & 1), f64::from(i >> 1 & 1), f64::from(i >> 2)]).collect();
        let mut edges: Vec<Edge> = (0..8).flat_map(|a| [1, 2, 4].map(|step| (a, a | step))).filter(|(a, b)| a != b).collect();
        edges.sort_unstable();
        check_in_space(&cube, &edges);
        let block: Vec<[f64; 3]> = (0..27).map(|i| [i % 3, i / 3 % 3, i / 9].map(f64::from)).collect();
        let expected = (0..27).flat_map(|a: u32| [1, 3, 9].map(|step| (a, a + step)));
        let is_cell = |&(a, b): &Edge| b < 27 && (a / 9 == b / 9 || b - a == 9) && (a / 3 == b / 3 || b - a != 1);
        check_in_space(&block, &expected.filter(is_cell).collect::<Vec<_>>());
    }

    #[test]
    fn an_octahedron_has_no_diagonal_and_its_middle_ties_everybody() {
        let corners = [[1.0, 0.0, 0.0], [-1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, -1.0, 0.0], [0.0, 0.0, 1.0], [0.0, 0.0, -1.0]];
        let rim: Vec<Edge> = (0..6).flat_map(|b| (0..b).map(move |a| (a, b))).filter(|(a, b)| a / 2 != b / 2).collect();
        let sorted = |mut edges: Vec<Edge>| {
            edges.sort_unstable();
            edges
        };
        check_in_space(&corners, &sorted(rim.clone()));
        let spokes = (0..6).map(|agent| (agent, 6));
        check_in_space(&[&corners[..], &[[0.0; 3]]].concat(), &sorted(rim.into_iter().chain(spokes).collect()));
    }

    #[test]
    fn a_tilted_plane_is_a_plane_and_a_tilted_line_a_line() {
        let tilted = |x: f64, y: f64| [x, y, 0.3 * x - 2.0 * y];
        let square = [tilted(0.0, 0.0), tilted(1.0, 0.0), tilted(1.0, 1.0), tilted(0.0, 1.0)];
        // Slanted, its sides no longer meet at right angles and its shorter diagonal stays.
        check_in_space(&square, &[(0, 1), (0, 2), (0, 3), (1, 2), (2, 3)]);
        check_in_space(&[[0.0; 3], [3.0, 6.0, 9.0], [1.0, 2.0, 3.0], [2.0, 4.0, 6.0]], &[(0, 2), (1, 3), (2, 3)]);
        check_in_space(&[[0.0, 0.0, 0.0], [0.0, 0.0, 2.0], [0.0, 0.0, 1.0]], &[(0, 2), (1, 2)]);
    }

    #[test]
    fn twins_in_space_are_tied_to_the_lowest() {
        check_in_space(&[[1.0, 1.0, 5.0]; 3], &[(0, 1), (0, 2)]);
        let tetrahedron = [[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [0.0, 4.0, 0.0], [0.0, 0.0, 4.0], [4.0, 0.0, 1e-10]];
        check_in_space(&tetrahedron, &[(0, 1), (0, 2), (0, 3), (1, 2), (1, 3), (1, 4), (2, 3)]);
    }

    #[test]
    fn a_pair_that_nobody_can_tell_apart_is_still_joined_to_the_rest() {
        let mut points = vec![[0.0, 0.0, 0.0], [10.0, 0.0, 0.0], [0.0, 10.0, 0.0], [0.0, 0.0, 10.0], [3.0, 3.0, 3.0]];
        points.push([3.0 + 1e-7, 3.0, 3.0]);
        let edges = propose(&in_space(&points));
        assert!(edges.contains(&(4, 5)) && edges.iter().any(|&(a, b)| a < 4 && b >= 4), "{edges:?}");
    }

    #[test]
    fn heights_all_alike_change_nothing() {
        let plan: Vec<DVec2> = (0..40).map(|i| DVec2::from_angle(f64::from(i)) * (1.0 + 0.3 * f64::from(i))).collect();
        assert_eq!(propose(&Formation::spatial(plan.clone(), vec![0.1; 40])), propose(&Formation::new(plan)));
    }
}
