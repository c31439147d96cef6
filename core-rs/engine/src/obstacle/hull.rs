//! The least convex outline about points.

use glam::DVec2;

use crate::order::{key_of_two, of_real, sort_by_key};

/// The convex hull, counterclockwise (Andrew's monotone chain).
pub fn hull(mut points: Vec<DVec2>) -> Vec<DVec2> {
    sort_by_key(&mut points, |point| key_of_two(of_real(point.x), of_real(point.y)));
    points.dedup();
    let mut hull: Vec<DVec2> = Vec::new();
    for is_upper in [false, true] {
        let base = hull.len();
        let mut add = |p: DVec2| {
            while hull.len() >= base + 2 && (hull[hull.len() - 1] - hull[hull.len() - 2]).perp_dot(p - hull[hull.len() - 1]) <= 0.0 {
                hull.pop();
            }
            hull.push(p);
        };
        for k in 0..points.len() {
            add(points[if is_upper { points.len() - 1 - k } else { k }]);
        }
        // Each half ends where the other starts.
        hull.pop();
    }
    hull
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_hull_turns_counterclockwise_and_leaves_out_what_is_inside() {
        let square = [[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0]].map(DVec2::from_array);
        let mut points = square.to_vec();
        points.extend([DVec2::ONE, DVec2::new(1.0, 0.0)]);
        assert_eq!(hull(points), square);
    }
}
