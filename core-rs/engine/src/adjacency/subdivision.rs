//! The Delaunay subdivision of agents in a plane: the triangulation without what is not unique.

use std::f64::consts::PI;

use glam::DVec2;

use super::Edge;
use super::joining::join_components;
use super::triangulation::{Raw, triangulate};
use crate::formation::principal_axes;
use crate::order;
use crate::trig::direction;

/// A triangle whose height is at most this fraction of its longest side has no inside to speak of.
///
/// Coordinates carry errors of 1e-11 of the extent far from the origin; this stays clear of them and below anything a person draws.
pub(super) const SLIVER_TOLERANCE: f64 = 1e-6;

/// Opposite angles that sum to π within this, radians, say that four agents share a circle.
pub(super) const COCIRCULAR_TOLERANCE: f64 = 1e-6;

/// The subdivision of agents that all stand apart, within −1 … 1; a chain for those on one line. Pairs a < b, in any order.
pub(super) fn subdivision(points: &[DVec2]) -> Vec<Edge> {
    let Raw { triangles, edges: raw } = triangulate(points);
    let mut corners: Vec<Corner> = Vec::with_capacity(3 * triangles.len());
    for [a, b, c] in triangles.into_iter().filter(|triangle| !is_sliver(points, *triangle)) {
        corners.extend([corner(points, a, b, c), corner(points, b, c, a), corner(points, c, a, b)]);
    }
    if corners.is_empty() {
        return chain(points);
    }
    order::sort_by_key(&mut corners, |corner| order::key_of_pair(corner.edge));
    let mut edges: Vec<Edge> =
        corners.chunk_by(|p, q| p.edge == q.edge).filter(|sides| !is_diagonal(sides)).map(|sides| sides[0].edge).collect();
    let length = |(a, b): Edge| points[a as usize].distance(points[b as usize]);
    join_components(points.len(), raw.into_iter().map(|edge| (length(edge), edge)), &mut edges);
    edges
}

/// One corner of a kept triangle: the edge it faces and its angle, radians.
#[derive(Clone, Copy)]
struct Corner {
    edge: Edge,
    angle: f64,
}

fn corner(points: &[DVec2], apex: u32, a: u32, b: u32) -> Corner {
    let (to_a, to_b) = (points[a as usize] - points[apex as usize], points[b as usize] - points[apex as usize]);
    Corner { edge: (a.min(b), a.max(b)), angle: libm::atan2(to_a.perp_dot(to_b).abs(), to_a.dot(to_b)) }
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
fn chain(points: &[DVec2]) -> Vec<Edge> {
    let along = direction(principal_axes(points).angle);
    let place = |point: &DVec2| order::key_of_two(order::of_real(along.dot(*point)), order::of_real(along.perp_dot(*point)));
    let ordered = order::by_key(points.iter().map(place));
    ordered.windows(2).map(|pair| (pair[0].min(pair[1]), pair[0].max(pair[1]))).collect()
}
