//! Who is whose neighbor in space.
//!
//! Two agents are Delaunay neighbors when a ball through both holds nobody else, and for certain when it keeps everybody else out by
//! an angle: then the facet between their Voronoi cells has an inside. Asked pair by pair this needs no tetrahedra, which crates for
//! the purpose build and which are not unique where five agents share a sphere, as in every block.
//!
//! The centers of balls through a and b lie in the plane halfway between them. Agent c keeps out of those whose center lies in one
//! half of it: p̂·u ≤ h cot γ, where h is half the distance of a and b, u the center seen from their middle, p̂ the direction from
//! their line to c, and γ the angle at which c sees them.

use glam::{DVec2, DVec3};

use super::Edge;
use super::joining::join_components;
use super::subdivision::COCIRCULAR_TOLERANCE;
use crate::order;

/// The tangent of the angle by which a ball must keep everybody else out: two of them make the cocircular tolerance of the plane.
const CLEARANCE: f64 = COCIRCULAR_TOLERANCE / 2.0;

/// Balls wider than this, in distances of the two, do not count.
///
/// Agents in one face of a block are out of its plane by round-off, and a ball wide enough fits between any two of them. This is
/// beyond anything a person draws and, times the clearance, far above round-off.
const WIDEST: f64 = 1e3;

/// The Delaunay subdivision of agents that stand apart and in no plane, extents near 1: pairs a < b, connecting all.
///
/// O(n²) pairs, most of which a handful of others near one of them rule out.
pub(super) fn neighbors_in_space(points: &[DVec3]) -> Vec<Edge> {
    let count = points.len() as u32;
    let mut edges = Vec::new();
    let mut facet = Facet::default();
    let mut others: Vec<(f64, u32)> = Vec::with_capacity(points.len());
    for a in 0..count {
        let at = points[a as usize];
        others.clear();
        others.extend((0..count).filter(|&c| c != a).map(|c| (points[c as usize].distance_squared(at), c)));
        order::sort_by_key(&mut others, |other| u128::from(order::of_real(other.0)));
        edges.extend((a + 1..count).filter(|&b| facet.has_inside(points, (a, b), &others)).map(|b| (a, b)));
    }
    let pairs = (0..count).flat_map(|b| (0..b).map(move |a| (a, b)));
    let length = |(a, b): Edge| points[a as usize].distance(points[b as usize]);
    join_components(points.len(), pairs.map(|pair| (length(pair), pair)), &mut edges);
    edges
}

/// What is left of the centers of balls through two agents, a convex polygon; lengths in half their distance. Its buffers serve every
/// pair.
#[derive(Default)]
struct Facet {
    corners: Vec<DVec2>,
    spare: Vec<DVec2>,
}

impl Facet {
    /// Whether a ball through a and b keeps out all `others` of a, which come nearest first.
    fn has_inside(&mut self, points: &[DVec3], (a, b): Edge, others: &[(f64, u32)]) -> bool {
        let from = points[a as usize];
        let across = points[b as usize] - from;
        let length = across.length();
        let (e, f) = (across / length).any_orthonormal_pair();
        // Wider than the widest ball, so that its corners decide nothing.
        let wide = 2.0 * WIDEST;
        self.corners.clear();
        self.corners.extend([DVec2::new(-wide, -wide), DVec2::new(wide, -wide), DVec2::new(wide, wide), DVec2::new(-wide, wide)]);
        let mut reach = self.reach();
        for &(distance_squared, c) in others {
            // From here on everybody is too far away to be within a ball whose center is left: its radius is below (reach + 1) h.
            if 4.0 * distance_squared > (length * (2.1 * reach + 3.0)).powi(2) {
                break;
            }
            if c == b {
                continue;
            }
            let to_c = points[c as usize] - from;
            let aside = DVec2::new(to_c.dot(e), to_c.dot(f));
            let distance_aside = aside.length();
            let (sine, cosine) = (length * distance_aside, to_c.dot(to_c - across));
            // cot(γ + clearance) as a fraction.
            let (above, below) = (cosine - CLEARANCE * sine, sine + CLEARANCE * cosine);
            if below <= 0.0 {
                // Between the two.
                return false;
            }
            let offset = above / below;
            if offset < reach {
                if !self.cut(aside / distance_aside, offset) {
                    return false;
                }
                reach = self.reach();
            }
        }
        self.distance_to_middle() <= WIDEST
    }

    /// How far its corners are from the middle at most.
    fn reach(&self) -> f64 {
        self.corners.iter().map(|corner| corner.length_squared()).fold(0.0, f64::max).sqrt()
    }

    /// Keeps what lies in `normal`·u ≤ `offset`; whether that is anything.
    fn cut(&mut self, normal: DVec2, offset: f64) -> bool {
        let beyond = |corner: DVec2| normal.dot(corner) - offset;
        if self.corners.iter().all(|&corner| beyond(corner) <= 0.0) {
            return true;
        }
        self.spare.clear();
        let mut before = self.corners[self.corners.len() - 1];
        let mut before_beyond = beyond(before);
        for &corner in &self.corners {
            let corner_beyond = beyond(corner);
            if (before_beyond > 0.0) != (corner_beyond > 0.0) {
                self.spare.push(before + (corner - before) * (before_beyond / (before_beyond - corner_beyond)));
            }
            if corner_beyond <= 0.0 {
                self.spare.push(corner);
            }
            (before, before_beyond) = (corner, corner_beyond);
        }
        std::mem::swap(&mut self.corners, &mut self.spare);
        !self.corners.is_empty()
    }

    /// From the middle to the nearest center that is left.
    fn distance_to_middle(&self) -> f64 {
        let sides = self.corners.iter().zip(self.corners.iter().cycle().skip(1));
        let is_within = sides.clone().all(|(from, to)| from.perp_dot(*to) >= 0.0);
        if is_within { 0.0 } else { sides.map(|(from, to)| distance_to_side(*from, *to)).fold(f64::INFINITY, f64::min) }
    }
}

/// From the origin to the segment between two corners.
fn distance_to_side(from: DVec2, to: DVec2) -> f64 {
    let along = to - from;
    let t = (-from.dot(along) / along.length_squared()).clamp(0.0, 1.0);
    if t.is_nan() { from.length() } else { (from + t * along).length() }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_half_that_misses_the_polygon_leaves_it_whole_and_one_that_has_it_all_nothing() {
        let mut facet = Facet { corners: vec![DVec2::ZERO, DVec2::X, DVec2::ONE, DVec2::Y], spare: Vec::new() };
        assert!(facet.cut(DVec2::X, 2.0));
        assert_eq!(facet.corners.len(), 4);
        assert!(facet.cut(DVec2::X, 0.25));
        assert_eq!(facet.reach(), 1.0_f64.hypot(0.25));
        assert_eq!(facet.distance_to_middle(), 0.0);
        assert!(facet.cut(DVec2::NEG_Y, -0.5));
        assert_eq!(facet.distance_to_middle(), 0.5);
        assert!(!facet.cut(DVec2::Y, 0.25));
    }

    #[test]
    fn a_ball_wide_enough_for_round_off_does_not_count() {
        // A square bent by round-off far from the origin: a ball three thousand times as wide would touch one diagonal alone.
        let bent = [[0.0, 0.0, 1e-10], [1.0, 0.0, 0.0], [1.0, 1.0, 1e-10], [0.0, 1.0, 0.0], [0.5, 0.5, -0.7]];
        let points = bent.map(DVec3::from_array);
        let edges = neighbors_in_space(&points);
        assert!(!edges.contains(&(0, 2)) && !edges.contains(&(1, 3)), "{edges:?}");
    }
}
