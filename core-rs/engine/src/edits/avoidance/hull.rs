//! Ways around the convex hull of an obstacle, and out of its notches.

use std::f64::consts::{PI, TAU};

use eigenform_apart::Outline;
use glam::DVec2;

use crate::obstacle::hull;
use crate::trig::direction;

/// Corners of the circle about a corner.
const ROUND_CORNERS: usize = 16;

/// A way out ends so far beyond the hull, meters: what lies on it is no corner of it.
const BEYOND: f64 = 1e-6;

/// Points whose hull holds everything within `reach` of the outline.
pub(super) fn grown(outline: &Outline, reach: f64) -> Vec<DVec2> {
    let radius = (outline.radius + reach) / libm::cos(PI / ROUND_CORNERS as f64);
    let corner = |k: usize| {
        let angle = TAU * k as f64 / ROUND_CORNERS as f64;
        direction(angle) * radius
    };
    outline.points.iter().flat_map(|p| (0..ROUND_CORNERS).map(move |k| DVec2::from_array(*p) + corner(k))).collect()
}

pub(super) fn extent(points: &[DVec2]) -> f64 {
    let middle = points.iter().sum::<DVec2>() / points.len() as f64;
    points.iter().map(|p| p.distance(middle)).fold(0.0, f64::max)
}

/// The shortest way from `start` to `end` around points on one side of them; none when an end is among them.
pub(super) fn chain(points: &[DVec2], start: DVec2, end: DVec2, is_left: bool) -> Option<Vec<DVec2>> {
    let mut all = points.to_vec();
    all.extend([start, end]);
    let mut hull = hull(all);
    if is_left {
        hull.reverse();
    }
    // Counterclockwise, what comes after the start lies to the right of the way.
    let at = hull.iter().position(|p| *p == start)?;
    hull.rotate_left(at);
    let to = hull.iter().position(|p| *p == end)?;
    hull.truncate(to + 1);
    Some(hull)
}

/// Where a place within the hull of `points` comes out of it by the shortest straight way that keeps `clearance` meters from the
/// outline; the place itself when it is outside, none when no such way leads out.
pub(super) fn way_out(points: &[DVec2], outline: &Outline, place: DVec2, clearance: f64) -> Option<DVec2> {
    let hull = hull(points.to_vec());
    let edges = || (0..hull.len()).map(|k| (hull[k], hull[(k + 1) % hull.len()]));
    if edges().any(|(from, to)| (to - from).perp_dot(place - from) < 0.0) {
        return Some(place);
    }
    let exit = |(from, to): (DVec2, DVec2)| {
        let edge = to - from;
        let t = ((place - from).dot(edge) / edge.length_squared()).clamp(0.0, 1.0);
        from + t * edge - edge.perp().normalize() * BEYOND
    };
    let is_free = |exit: &DVec2| outline.least_clearance(place.to_array(), exit.to_array()).0 >= clearance;
    edges().map(exit).filter(is_free).min_by(|a, b| a.distance_squared(place).total_cmp(&b.distance_squared(place)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_way_around_passes_on_the_side_asked_for() {
        let points = grown(&Outline { points: vec![[0.0, 0.0]], radius: 1.0 }, 0.5);
        let (west, east) = (DVec2::new(-5.0, 0.0), DVec2::new(5.0, 0.0));
        let right = chain(&points, west, east, false).unwrap();
        let left = chain(&points, west, east, true).unwrap();
        assert!(right.iter().all(|p| p.y <= 1e-12) && left.iter().all(|p| p.y >= -1e-12));
        assert_eq!((right[0], right[right.len() - 1]), (west, east));
        assert_eq!(chain(&points, DVec2::ZERO, east, true), None);
    }

    #[test]
    fn a_notch_is_left_by_the_nearest_way_and_a_closed_room_is_not() {
        let ell = [[-2.0, -1.0], [2.0, -1.0], [2.0, 0.5], [0.0, 0.5], [0.0, 3.0], [-2.0, 3.0]];
        let outline = Outline { points: ell.to_vec(), radius: 0.0 };
        let points = grown(&outline, 0.5);
        let notch = DVec2::new(0.7, 1.2);
        let out = way_out(&points, &outline, notch, 0.5).unwrap();
        // Up and to the right, across the line from tip to tip.
        let way = (out - notch).normalize();
        assert!(way.x > 0.5 && way.y > 0.5, "{way}");
        assert_eq!(way_out(&points, &outline, out, 0.5), Some(out));
        // No way keeps more than the notch has.
        assert_eq!(way_out(&points, &outline, notch, 0.8), None);
    }
}
