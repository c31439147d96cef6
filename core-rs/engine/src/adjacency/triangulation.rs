//! The raw Delaunay triangulation: not unique where agents share a circle.
//!
//! The only file that names spade. It merges coincident sites and crawls while all sites so far lie on one line, so it gets neither:
//! the first three are a wide triangle, and the others follow along a curve on which the next is near the last.

use glam::DVec2;
use spade::{DelaunayTriangulation, HasPosition, Point2, Triangulation};

use crate::order;

/// Triangles and edges between agents.
#[derive(Debug, Default)]
pub(super) struct Raw {
    /// In any order, corners too.
    pub(super) triangles: Vec<[u32; 3]>,
    /// Pairs a < b, in any order.
    pub(super) edges: Vec<(u32, u32)>,
}

/// Triangulates agents that stand apart; `points` by agent index within −1 … 1. Empty when they all stand on one line.
pub(super) fn triangulate(points: &[DVec2]) -> Raw {
    let Some(widest) = wide_triangle(points) else { return Raw::default() };
    let count = points.len();
    let mut rest: Vec<u32> = (0..count as u32).filter(|agent| !widest.contains(agent)).collect();
    order::sort_by_key(&mut rest, |&agent| u128::from(along_z_curve(points[agent as usize])));
    let mut triangulation = DelaunayTriangulation::<Site>::with_capacity(count, 3 * count, 2 * count);
    for agent in widest.into_iter().chain(rest) {
        triangulation.insert(Site { at: points[agent as usize], agent }).expect("positions are finite and within range");
    }
    let triangles = triangulation.inner_faces().map(|face| face.vertices().map(|vertex| vertex.data().agent)).collect();
    let edges = triangulation.undirected_edges().map(|edge| {
        let [a, b] = edge.vertices().map(|vertex| vertex.data().agent);
        (a.min(b), a.max(b))
    });
    Raw { triangles, edges: edges.collect() }
}

/// An agent on its way through spade, whose vertex order is not the agents' order.
struct Site {
    at: DVec2,
    agent: u32,
}

impl HasPosition for Site {
    type Scalar = f64;

    fn position(&self) -> Point2<f64> {
        // spade refuses coordinates below 1.8e-43 that are not zero.
        spade::mitigate_underflow(Point2::new(self.at.x, self.at.y))
    }
}

/// Two agents far apart and the one farthest off their line; none when nobody is off it.
fn wide_triangle(points: &[DVec2]) -> Option<[u32; 3]> {
    let at = |agent: u32| points[agent as usize];
    let agents = 0..points.len() as u32;
    let farthest_from = |from: u32| {
        let distance = |agent: u32| at(agent).distance_squared(at(from));
        agents.clone().max_by(|&p, &q| distance(p).total_cmp(&distance(q)))
    };
    let a = farthest_from(0)?;
    let b = farthest_from(a)?;
    let off = |agent: u32| (at(b) - at(a)).perp_dot(at(agent) - at(a)).abs();
    let c = agents.clone().max_by(|&p, &q| off(p).total_cmp(&off(q)))?;
    (off(c) > 0.0).then_some([a, b, c])
}

/// A point's place along the Z-order curve over 2¹⁶ × 2¹⁶ cells of the square −1 … 1.
fn along_z_curve(point: DVec2) -> u64 {
    let cell = (point + 1.0) * f64::from(1 << 15);
    spread(cell.x as u64) | spread(cell.y as u64) << 1
}

/// The low 16 bits, a zero above each.
fn spread(bits: u64) -> u64 {
    [(8, 0x00ff_00ff), (4, 0x0f0f_0f0f), (2, 0x3333_3333), (1, 0x5555_5555)]
        .into_iter()
        .fold(bits, |bits, (shift, mask)| (bits | bits << shift) & mask)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_z_curve_visits_quarter_after_quarter() {
        let quarters = [[-0.5, -0.5], [0.5, -0.5], [-0.5, 0.5], [0.5, 0.5]].map(|at| along_z_curve(DVec2::from_array(at)));
        assert!(quarters.is_sorted_by(|p, q| p < q));
        assert_eq!(along_z_curve(DVec2::NEG_ONE), 0);
        assert_eq!(spread(0xffff), 0x5555_5555);
    }

    #[test]
    fn agents_on_one_line_have_no_triangle() {
        let line: Vec<DVec2> = (0..9).map(|i| DVec2::new(f64::from(i) / 9.0, 0.25)).collect();
        assert!(triangulate(&line).triangles.is_empty());
        assert!(triangulate(&line[..1]).edges.is_empty());
        assert!(triangulate(&[]).edges.is_empty());
    }
}
