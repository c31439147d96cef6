//! An obstacle grown by the distance that is kept from it.

use std::f64::consts::TAU;

use crate::trig::{bearing, direction, turn};
use glam::DVec2;

use super::{ObstacleShape, sides, signed_area};

/// Ways along a wall bend so often in a full turn. Such a chord is 0.2 % shorter than its arc, and 0.5 % nearer to the corner.
const BENDS: f64 = 32.0;

/// cos(π / [`BENDS`]), and a little for rounding: how near a chord comes, of the distance.
const CHORD: f64 = 0.995_184_72;

/// A place is pushed out so much farther than asked for, of the distance: what is pushed is surely clear.
const BEYOND: f64 = 1e-9;

/// Everything nearer than `reach` meters to a point or a polygon.
pub(super) struct Wall {
    /// Counterclockwise.
    points: Vec<DVec2>,
    reach: f64,
    middle: DVec2,
    /// From the middle to the farthest point.
    extent: f64,
}

/// A place beside a corner of a wall, where a way may bend.
#[derive(Clone, Copy, Debug)]
pub(super) struct Bend {
    pub(super) at: DVec2,
    /// Along the wall, counterclockwise: to this place and on from it.
    along: [DVec2; 2],
}

impl Bend {
    /// Whether a straight way between here and there goes on along the wall without a kink.
    pub(super) fn is_smooth(&self, there: DVec2) -> bool {
        let way = (self.at - there).normalize_or_zero();
        let turns = [self.along[0].perp_dot(way), way.perp_dot(self.along[1])];
        // Rounding of two unit vectors.
        turns.iter().all(|turn| *turn >= -1e-9) || turns.iter().all(|turn| *turn <= 1e-9)
    }
}

impl Wall {
    pub(super) fn new(shape: &ObstacleShape, distance: f64) -> Self {
        let (mut points, reach) = match shape {
            ObstacleShape::Circle { center, radius } => (vec![*center], radius + distance),
            ObstacleShape::Polygon { points } => (points.clone(), distance),
        };
        points.dedup();
        if points.len() > 1 && points.first() == points.last() {
            points.pop();
        }
        if signed_area(&points) < 0.0 {
            points.reverse();
        }
        let middle = points.iter().sum::<DVec2>() / points.len() as f64;
        let extent = points.iter().map(|p| p.distance(middle)).fold(0.0, f64::max);
        Self { points, reach, middle, extent }
    }

    /// How far a place is beyond the wall, meters (negative: within it), and the direction that leads out.
    pub(super) fn beyond(&self, place: DVec2) -> (f64, DVec2) {
        let mut nearest = (f64::INFINITY, DVec2::ZERO, DVec2::ZERO);
        let mut is_inside = false;
        for (from, to) in sides(&self.points) {
            let out = place - nearest_on(*from, *to, place);
            if out.length_squared() < nearest.0 {
                nearest = (out.length_squared(), out, *to - *from);
            }
            is_inside ^=
                (from.y > place.y) != (to.y > place.y) && place.x < from.x + (to.x - from.x) * (place.y - from.y) / (to.y - from.y);
        }
        let (distance, out, edge) = (nearest.0.sqrt(), nearest.1, nearest.2);
        let sign = if is_inside { -1.0 } else { 1.0 };
        // On the line itself: across it, to the right of a polygon that turns left.
        let direction = if distance > 0.0 { sign * out / distance } else { (-edge.perp()).normalize_or(DVec2::X) };
        (sign * distance - self.reach, direction)
    }

    /// The nearest place beyond it; the place itself where it is.
    pub(super) fn out(&self, place: DVec2) -> DVec2 {
        let (beyond, direction) = self.beyond(place);
        if beyond >= 0.0 { place } else { place + (BEYOND * self.reach - beyond) * direction }
    }

    /// Whether a straight way keeps off; one place: whether it does.
    pub(super) fn is_clear_of(&self, from: DVec2, to: DVec2) -> bool {
        let apart = nearest_on(from, to, self.middle).distance_squared(self.middle);
        if apart >= (self.extent + self.reach) * (self.extent + self.reach) {
            return true;
        }
        let least = (CHORD * self.reach) * (CHORD * self.reach);
        sides(&self.points).all(|(a, b)| between((from, to), (*a, *b)) >= least) && (from != to || self.beyond(from).0 > -self.reach)
    }

    /// Where ways around it may bend: beside every corner that is none of a notch.
    pub(super) fn bends(&self) -> Vec<Bend> {
        let count = self.points.len();
        if count == 1 {
            return self.fan(self.points[0], 0.0, TAU).skip(1).collect();
        }
        let edge = |k: usize| self.points[(k + 1) % count] - self.points[k % count];
        let corner = |k: usize| {
            let (before, after) = (edge(k + count - 1), edge(k));
            let out = -before.perp();
            (self.points[k], bearing(out), turn(before, after))
        };
        (0..count).map(corner).filter(|(.., turn)| *turn > 0.0).flat_map(|(at, angle, turn)| self.fan(at, angle, turn)).collect()
    }

    fn fan(&self, corner: DVec2, angle: f64, turn: f64) -> impl Iterator<Item = Bend> {
        let pieces = (turn / TAU * BENDS).ceil();
        let (step, reach) = (turn / pieces, self.reach);
        // Not past the arc's own ends, where a straight piece goes on.
        let tangent = move |at: f64| direction(angle + at.clamp(0.0, pieces) * step).perp();
        let ends = move |at: f64| {
            if turn < TAU {
                [tangent(at - 0.5), tangent(at + 0.5)]
            } else {
                [-0.5, 0.5].map(|by| direction(angle + (at + by) * step).perp())
            }
        };
        (0..=pieces as usize).map(move |k| Bend { at: corner + reach * direction(angle + k as f64 * step), along: ends(k as f64) })
    }
}

fn nearest_on(from: DVec2, to: DVec2, place: DVec2) -> DVec2 {
    let way = to - from;
    let length_squared = way.length_squared();
    if length_squared > 0.0 { from + ((place - from).dot(way) / length_squared).clamp(0.0, 1.0) * way } else { from }
}

/// The least distance between two straight pieces, squared.
fn between((a, b): (DVec2, DVec2), (c, d): (DVec2, DVec2)) -> f64 {
    let turn = |p: DVec2, q: DVec2, r: DVec2| (q - p).perp_dot(r - p);
    if turn(a, b, c) * turn(a, b, d) < 0.0 && turn(c, d, a) * turn(c, d, b) < 0.0 {
        return 0.0;
    }
    let off = |place: DVec2, (from, to): (DVec2, DVec2)| nearest_on(from, to, place).distance_squared(place);
    off(a, (c, d)).min(off(b, (c, d))).min(off(c, (a, b))).min(off(d, (a, b)))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn square() -> Wall {
        let points = [[2.0, 2.0], [2.0, 0.0], [0.0, 0.0], [0.0, 2.0]].map(DVec2::from_array).to_vec();
        Wall::new(&ObstacleShape::Polygon { points }, 0.5)
    }

    #[test]
    fn a_way_is_clear_that_keeps_the_distance_and_one_across_is_not() {
        let is_clear = |from: [f64; 2], to: [f64; 2]| square().is_clear_of(from.into(), to.into());
        assert!(is_clear([-3.0, 2.5], [5.0, 2.5]) && is_clear([-1.0, 0.0], [-1.0, 9.0]));
        assert!(!is_clear([-3.0, 2.4], [5.0, 2.4]) && !is_clear([-3.0, 1.0], [5.0, 1.2]));
        // Wholly inside, and beside.
        assert!(!is_clear([1.0, 1.0], [1.0, 1.0]) && is_clear([2.6, 1.0], [2.6, 1.0]));
    }

    #[test]
    fn who_stands_too_near_is_led_straight_out() {
        assert!(square().out(DVec2::new(1.9, 1.0)).distance(DVec2::new(2.5, 1.0)) < 1e-8);
        assert!(square().out(DVec2::new(1.0, -0.2)).distance(DVec2::new(1.0, -0.5)) < 1e-8);
        assert_eq!(square().out(DVec2::new(4.0, 1.0)), DVec2::new(4.0, 1.0));
    }

    #[test]
    fn a_way_bends_beside_corners_and_not_in_notches() {
        // Eight chords a quarter turn, both ends included.
        assert_eq!(square().bends().len(), 4 * 9);
        assert!(square().bends().iter().all(|bend| (square().beyond(bend.at).0).abs() < 1e-12));
        let ell = [[0.0, 0.0], [2.0, 0.0], [2.0, 1.0], [1.0, 1.0], [1.0, 2.0], [0.0, 2.0]].map(DVec2::from_array).to_vec();
        assert_eq!(Wall::new(&ObstacleShape::Polygon { points: ell }, 0.5).bends().len(), 5 * 9);
        assert_eq!(Wall::new(&ObstacleShape::Circle { center: DVec2::ONE, radius: 1.0 }, 0.5).bends().len(), 32);
    }

    #[test]
    fn a_way_meets_a_wall_smoothly_where_it_touches_it() {
        let corner = square().bends().into_iter().find(|bend| bend.at.distance(DVec2::new(2.5, 2.0)) < 1e-12).unwrap();
        // Up along the right side; from the front of it; along it from above.
        assert!(corner.is_smooth(DVec2::new(2.5, -7.0)));
        assert!(!corner.is_smooth(DVec2::new(7.0, 2.0)));
        assert!(corner.is_smooth(DVec2::new(2.45, 3.0)));
    }
}
