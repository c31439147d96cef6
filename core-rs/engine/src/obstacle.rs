//! What agents go around.
//!
//! Geometry only: it knows neither names nor who must keep away.

use glam::DVec2;
use serde::Serialize;

/// The outline of an obstacle; meters, as formations.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
#[serde(tag = "kind", rename_all = "lowercase")]
pub enum ObstacleShape {
    /// All points nearer to the center than the radius.
    Circle {
        /// Its center.
        #[cfg_attr(feature = "types", ts(as = "(f64, f64)"))]
        center: DVec2,
        /// Greater than 0.
        radius: f64,
    },
    /// The points inside a closed line.
    Polygon {
        /// Its corners in either direction, the first not repeated.
        #[cfg_attr(feature = "types", ts(as = "Vec<(f64, f64)>"))]
        points: Vec<DVec2>,
    },
}

/// The area of a polygon, m²: positive counterclockwise, 0 for fewer than three corners.
pub fn signed_area(corners: &[DVec2]) -> f64 {
    let Some(&origin) = corners.first() else { return 0.0 };
    // From a corner of its own: far from the center of the stage, products of coordinates would lose the digits that matter.
    corners.windows(2).map(|edge| (edge[0] - origin).perp_dot(edge[1] - origin)).sum::<f64>() / 2.0
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_area_has_the_sign_of_the_direction() {
        let check = |corners: &[[f64; 2]], area: f64| {
            let corners: Vec<DVec2> = corners.iter().map(|&[x, y]| DVec2::new(x + 1e5, y - 1e5)).collect();
            assert_eq!(signed_area(&corners), area);
        };
        check(&[], 0.0);
        check(&[[1.0, 1.0], [2.0, 2.0]], 0.0);
        check(&[[0.0, 0.0], [4.0, 0.0], [4.0, 2.0], [0.0, 2.0]], 8.0);
        check(&[[0.0, 0.0], [0.0, 2.0], [4.0, 2.0], [4.0, 0.0]], -8.0);
        check(&[[0.0, 0.0], [1.0, 1.0], [5.0, 5.0]], 0.0);
    }
}
