//! The way around an obstacle: how far along and how far away a place is.
//!
//! The convex hull is what counts: notches are not entered. All places at one distance from it lie on a line of straight pieces and
//! arcs; places at another distance lie beside it, so that lengths along one such line serve for all.

use std::f64::consts::{PI, TAU};

use crate::trig::{around, bearing, direction, turn};
use glam::DVec2;

use super::ObstacleShape;
use super::hull::hull;

/// What is this near, of the whole way around, is in one place: where a straight piece and an arc meet.
const SAME_PLACE: f64 = 1e-9;

/// A rounded convex polygon, walked around counterclockwise.
#[derive(Clone, Debug)]
pub struct Rim {
    corners: Vec<Corner>,
    radius: f64,
    perimeter: f64,
}

/// An arc about a corner and the straight piece after it.
#[derive(Clone, Copy, Debug)]
struct Corner {
    at: DVec2,
    /// Of the normal where the arc begins, radians.
    angle: f64,
    /// How far the normal turns along the arc.
    turn: f64,
    /// To the next corner.
    edge: DVec2,
    /// Lengths of the straight pieces, and turns, before this corner.
    straight_before: f64,
    turned_before: f64,
}

/// A place beside a rim.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Beside {
    /// Straight pieces behind it, meters.
    straight: f64,
    /// Arcs behind it, radians.
    turned: f64,
    /// How far outside the hull, meters; negative inside.
    pub clearance: f64,
}

impl Rim {
    /// Around an obstacle.
    pub fn of(shape: &ObstacleShape) -> Self {
        match shape {
            ObstacleShape::Circle { center, radius } => Self::around(&[*center], *radius),
            ObstacleShape::Polygon { points } => Self::around(&hull(points.clone()), 0.0),
        }
    }

    fn around(points: &[DVec2], radius: f64) -> Self {
        let count = points.len();
        let edge = |k: usize| points[(k + 1) % count] - points[k % count];
        let (mut straight_before, mut turned_before) = (0.0, 0.0);
        let corners = points.iter().enumerate().map(|(k, at)| {
            let (before, after) = (edge(k + count - 1), edge(k));
            let (angle, turn) = if count == 1 { (0.0, TAU) } else { (bearing(-before.perp()), turn(before, after).max(0.0)) };
            let corner = Corner { at: *at, angle, turn, edge: after, straight_before, turned_before };
            straight_before += after.length();
            turned_before += turn;
            corner
        });
        Self { corners: corners.collect(), radius, perimeter: straight_before }
    }

    /// Where a place is.
    pub fn beside(&self, place: DVec2) -> Beside {
        let mut nearest = (f64::INFINITY, &self.corners[0], DVec2::ZERO, 0.0);
        let mut is_inside = self.corners.len() > 1;
        for corner in &self.corners {
            let way = place - corner.at;
            let length_squared = corner.edge.length_squared();
            let t = if length_squared > 0.0 { (way.dot(corner.edge) / length_squared).clamp(0.0, 1.0) } else { 0.0 };
            let out = way - t * corner.edge;
            // The end of a piece is the corner after it.
            if t < 1.0 && out.length_squared() < nearest.0 {
                nearest = (out.length_squared(), corner, out, t);
            }
            is_inside &= corner.edge.perp_dot(way) >= 0.0;
        }
        let (distance_squared, corner, out, t) = nearest;
        let distance = distance_squared.sqrt();
        let clearance = if is_inside { -distance } else { distance } - self.radius;
        if t > 0.0 || is_inside {
            let straight = corner.straight_before + t * corner.edge.length();
            return Beside { straight, turned: corner.turned_before + corner.turn, clearance };
        }
        let along = around(bearing(out) - corner.angle, TAU);
        // Round-off before the arc is its beginning, beyond it its end.
        let turned = if along <= corner.turn {
            along
        } else if along > PI + 0.5 * corner.turn {
            0.0
        } else {
            corner.turn
        };
        Beside { straight: corner.straight_before, turned: corner.turned_before + turned, clearance }
    }

    /// How far along the line at `clearance` from the hull a place is, meters.
    pub fn along(&self, beside: &Beside, clearance: f64) -> f64 {
        beside.straight + (self.radius + clearance) * beside.turned
    }

    /// The shorter way around, meters along that line, counterclockwise positive; of two equal ones the counterclockwise.
    pub fn travel(&self, from: &Beside, to: &Beside, clearance: f64) -> f64 {
        let whole = self.length(clearance);
        let ahead = around(self.along(to, clearance) - self.along(from, clearance), whole);
        if ahead <= whole * (0.5 + SAME_PLACE) { ahead } else { ahead - whole }
    }

    /// The place beside what lies `along` the line at `line` from the hull, itself at `clearance`.
    pub fn place(&self, along: f64, line: f64, clearance: f64) -> DVec2 {
        let (corner, left) = self.piece(along, line);
        let arc = (self.radius + line) * corner.turn;
        let (at, normal) = if left < arc || corner.edge == DVec2::ZERO {
            (corner.at, direction(corner.angle + left / (self.radius + line)))
        } else {
            let direction = corner.edge.normalize();
            (corner.at + (left - arc) * direction, -direction.perp())
        };
        at + (self.radius + clearance) * normal
    }

    /// How fast who is at `clearance` moves where the line at `line` is followed with speed 1, just after `along` in a direction.
    pub fn pace(&self, along: f64, line: f64, clearance: f64, direction: f64) -> f64 {
        let (corner, left) = self.piece(along + direction.signum() * SAME_PLACE * self.length(line), line);
        let is_on_arc = left < (self.radius + line) * corner.turn || corner.edge == DVec2::ZERO;
        if is_on_arc { (self.radius + clearance) / (self.radius + line) } else { 1.0 }
    }

    fn length(&self, clearance: f64) -> f64 {
        self.perimeter + TAU * (self.radius + clearance)
    }

    /// The corner whose arc or straight piece is `along` the line at `line`, and how far beyond its beginning that is.
    fn piece(&self, along: f64, line: f64) -> (&Corner, f64) {
        let along = around(along, self.length(line));
        let begin = |corner: &Corner| corner.straight_before + (self.radius + line) * corner.turned_before;
        let after = self.corners.partition_point(|corner| begin(corner) <= along);
        let corner = &self.corners[after.saturating_sub(1)];
        (corner, along - begin(corner))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn square() -> Rim {
        let points = [[1.0, 1.0], [-1.0, 1.0], [0.0, 0.5], [-1.0, -1.0], [1.0, -1.0]].map(DVec2::from_array).to_vec();
        Rim::of(&ObstacleShape::Polygon { points })
    }

    fn circle() -> Rim {
        Rim::of(&ObstacleShape::Circle { center: DVec2::new(2.0, -1.0), radius: 1.5 })
    }

    #[test]
    fn a_place_is_found_again_along_any_line() {
        for rim in [square(), circle()] {
            for k in 0..40 {
                let place = DVec2::new(0.3, -0.2) + DVec2::from_angle(0.37 * f64::from(k)) * (4.2 + 0.1 * f64::from(k));
                let beside = rim.beside(place);
                for line in [0.5, 2.0, 7.0] {
                    let again = rim.place(rim.along(&beside, line), line, beside.clearance);
                    assert!(again.distance(place) < 1e-13, "{place} at {line}: {again}");
                }
            }
        }
    }

    #[test]
    fn clearance_is_to_the_hull_and_negative_inside() {
        let check = |rim: &Rim, x: f64, y: f64, clearance: f64| {
            assert!((rim.beside(DVec2::new(x, y)).clearance - clearance).abs() < 1e-15, "({x}, {y})");
        };
        check(&square(), 0.0, 3.0, 2.0);
        check(&square(), 4.0, 5.0, 5.0);
        check(&square(), 0.0, 0.75, -0.25);
        check(&circle(), 2.0, 2.0, 1.5);
        check(&circle(), 2.0, -0.5, -1.0);
    }

    #[test]
    fn the_shorter_way_around_is_taken() {
        let [east, north, south] = [[3.0, 0.0], [0.0, 3.0], [0.0, -3.0]].map(DVec2::from_array);
        let rim = square();
        let [east, north, south] = [east, north, south].map(|place| rim.beside(place));
        // Half of two edges and a quarter of the circle with a radius of 2.
        assert!((rim.travel(&east, &north, 2.0) - (2.0 + PI)).abs() < 1e-12);
        assert!((rim.travel(&north, &east, 2.0) + (2.0 + PI)).abs() < 1e-12);
        assert!((rim.travel(&south, &north, 2.0) - (4.0 + TAU)).abs() < 1e-12, "equal ways: counterclockwise");
        assert!((rim.travel(&north, &south, 2.0) - (4.0 + TAU)).abs() < 1e-12, "equal ways: counterclockwise");
    }
}
