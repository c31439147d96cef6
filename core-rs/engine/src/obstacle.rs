//! What agents go around.
//!
//! Geometry only: it knows neither names nor who must keep away.

mod detours;
mod hull;
mod rim;
mod wall;

use glam::DVec2;
use serde::Serialize;

pub use detours::{Detours, Norm};
pub(crate) use hull::hull;
pub(crate) use rim::{Beside, Rim};

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

impl ObstacleShape {
    /// Whether a place is inside.
    pub fn contains(&self, place: DVec2) -> bool {
        match self {
            Self::Circle { center, radius } => center.distance_squared(place) < radius * radius,
            Self::Polygon { points } => {
                // A ray to the right leaves an odd number of times.
                let is_left_of = |(from, to): (&DVec2, &DVec2)| {
                    (from.y > place.y) != (to.y > place.y) && place.x < from.x + (to.x - from.x) * (place.y - from.y) / (to.y - from.y)
                };
                sides(points).filter(|side| is_left_of(*side)).count() % 2 == 1
            }
        }
    }

    /// Its middle: of a polygon that of the area.
    pub fn center(&self) -> DVec2 {
        match self {
            Self::Circle { center, .. } => *center,
            Self::Polygon { points } => {
                let Some(&origin) = points.first() else { return DVec2::ZERO };
                let moment = |edge: &[DVec2]| {
                    let [from, to] = [edge[0] - origin, edge[1] - origin];
                    (from + to) * from.perp_dot(to)
                };
                origin + points.windows(2).map(moment).sum::<DVec2>() / (6.0 * signed_area(points))
            }
        }
    }
}

/// The corners that each side of a polygon runs between.
fn sides(points: &[DVec2]) -> impl Iterator<Item = (&DVec2, &DVec2)> + Clone {
    points.iter().zip(points.iter().cycle().skip(1))
}

/// The first two sides of a polygon that cross within both, by the number of the corner that each starts from.
pub fn crossing(points: &[DVec2]) -> Option<(usize, usize)> {
    crossed(&sides(points))
}

/// The first two pieces of an open line that cross within both, by the number of the point that each starts from.
pub fn crossing_on_the_way(points: &[DVec2]) -> Option<(usize, usize)> {
    crossed(&points.iter().zip(points.iter().skip(1)))
}

fn crossed<'p>(sides: &(impl Iterator<Item = (&'p DVec2, &'p DVec2)> + Clone)) -> Option<(usize, usize)> {
    let turn = |a: DVec2, b: DVec2, c: DVec2| (b - a).perp_dot(c - a);
    let are_apart = |(from, to): (&DVec2, &DVec2), p: DVec2, q: DVec2| turn(*from, *to, p) * turn(*from, *to, q) < 0.0;
    for (first, side) in sides.clone().enumerate() {
        let mut others = sides.clone().enumerate().skip(first + 2);
        let crossed = others.find(|(_, other)| are_apart(side, *other.0, *other.1) && are_apart(*other, *side.0, *side.1));
        if let Some((second, _)) = crossed {
            return Some((first, second));
        }
    }
    None
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
    fn the_center_of_a_polygon_is_that_of_its_area() {
        let center =
            |points: &[[f64; 2]]| ObstacleShape::Polygon { points: points.iter().copied().map(DVec2::from_array).collect() }.center();
        assert_eq!(center(&[[1.0, 1.0], [5.0, 1.0], [5.0, 3.0], [1.0, 3.0]]), DVec2::new(3.0, 2.0));
        // An L of three unit squares, either way round.
        let mut corners = [[0.0, 0.0], [2.0, 0.0], [2.0, 1.0], [1.0, 1.0], [1.0, 2.0], [0.0, 2.0]];
        for _ in 0..2 {
            assert!(center(&corners).distance(DVec2::splat(5.0 / 6.0)) < 1e-15);
            corners.reverse();
        }
    }

    #[test]
    fn sides_that_cross_are_found_and_those_that_meet_are_not() {
        let check = |corners: &[[f64; 2]], expected: Option<(usize, usize)>| {
            let corners: Vec<DVec2> = corners.iter().copied().map(DVec2::from_array).collect();
            assert_eq!(crossing(&corners), expected, "{corners:?}");
        };
        check(&[[0.0, 0.0], [4.0, 0.0], [4.0, 2.0], [0.0, 2.0]], None);
        check(&[[0.0, 0.0], [2.0, 0.0], [2.0, 1.0], [1.0, 1.0], [1.0, 2.0], [0.0, 2.0]], None);
        check(&[[0.0, 0.0], [4.0, 4.0], [4.0, 0.0], [0.0, 3.0]], Some((0, 2)));
        check(&[[0.0, 0.0], [4.0, 0.0], [0.0, 3.0], [4.0, 3.0]], Some((1, 3)));
        // A corner on another side, and one given twice.
        check(&[[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [2.0, 0.0], [0.0, 4.0]], None);
        check(&[[0.0, 0.0], [4.0, 0.0], [4.0, 0.0], [4.0, 2.0]], None);
    }

    #[test]
    fn a_place_is_inside_a_notched_outline_or_not() {
        let corners = [[0.0, 0.0], [2.0, 0.0], [2.0, 1.0], [1.0, 1.0], [1.0, 2.0], [0.0, 2.0]].map(DVec2::from_array).to_vec();
        let shapes = [ObstacleShape::Polygon { points: corners }, ObstacleShape::Circle { center: DVec2::splat(0.5), radius: 1.2 }];
        let inside = |x: f64, y: f64| shapes.each_ref().map(|shape| shape.contains(DVec2::new(x, y)));
        assert_eq!(
            [inside(0.5, 0.5), inside(1.5, 1.1), inside(0.5, 1.8), inside(-0.5, 0.5)],
            [[true, true], [false, true], [true, false], [false, true]]
        );
    }

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
