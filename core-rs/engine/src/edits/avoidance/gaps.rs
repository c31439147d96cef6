//! Formations through a gap between two obstacles that is narrower than they are.
//!
//! Who goes through closes up across the way to what the gap has room for. Files that are then too near to one another go through in
//! turn: who has no room beside those ahead falls back behind them, just far enough. Before and behind the gap all are in their places.

use eigenform_apart::{Outline, Paths};
use glam::DVec2;

use super::at;
use super::reroute::{MARGIN, is_blocked};
use crate::order;

/// Files are wanted this far apart, in minimum distances.
const WANTED: f64 = 1.06;

/// They close up within so many times the way they shift, or less where there is less room.
const RUN_UP: f64 = 3.0;

/// Within less than the way itself across, nobody can close up; along, nobody may go back: a bump falls by 1.9 of its height a length.
const LEAST_RUN_UP: [f64; 2] = [0.5, 2.0];

/// Who comes so nearly at once, in minimum distances, is abreast.
const ABREAST: f64 = 0.1;

/// What two obstacles leave open.
struct Gap {
    middle: DVec2,
    /// From one obstacle to the other.
    across: DVec2,
    /// How far from the middle one may pass.
    half_width: f64,
    /// How far before and behind the middle the obstacles reach.
    half_depth: f64,
}

/// Somebody on the way through.
#[derive(Clone, Copy)]
struct Passer {
    agent: usize,
    /// Across the gap, and how far ahead of others.
    lane: f64,
    ahead: f64,
}

/// Leads those who are free to go through gaps beside what blocks them that are narrower than they come; whether there were any.
pub(super) fn lead_through(paths: &mut Paths, outlines: &[Outline], distance: f64, free: &[usize]) -> bool {
    let mut is_led = false;
    for (second, b) in outlines.iter().enumerate() {
        for a in &outlines[..second] {
            let Some(gap) = Gap::between(a, b, distance) else { continue };
            let blocks = |outline: &Outline| free.iter().any(|agent| is_blocked(paths, *agent, outline, distance));
            if blocks(a) || blocks(b) {
                for direction in [1.0, -1.0] {
                    is_led |= gap.lead(paths, [a, b], distance, free, direction);
                }
            }
        }
    }
    is_led
}

impl Gap {
    /// None where nobody gets through.
    fn between(a: &Outline, b: &Outline, distance: f64) -> Option<Self> {
        let [from, to] = nearest_points(a, b);
        let across = (to - from).normalize_or_zero();
        let width = from.distance(to) - a.radius - b.radius;
        let half_width = 0.5 * width - distance * (1.0 + MARGIN);
        let middle = from + (a.radius + 0.5 * width) * across;
        let depth_of = |outline: &Outline| {
            let along = |p: &[f64; 2]| (DVec2::from_array(*p) - middle).perp_dot(across).abs();
            outline.radius + outline.points.iter().map(along).fold(0.0, f64::max)
        };
        (half_width > 0.0).then(|| Self { middle, across, half_width, half_depth: depth_of(a).max(depth_of(b)) })
    }

    /// How far along the way through and across it a place is.
    fn within(&self, place: DVec2, direction: f64) -> [f64; 2] {
        let way = place - self.middle;
        [direction * way.perp_dot(self.across), way.dot(self.across)]
    }

    /// Leads everybody through who goes this way; whether there was anybody, and room to close up.
    fn lead(&self, paths: &mut Paths, obstacles: [&Outline; 2], distance: f64, free: &[usize], direction: f64) -> bool {
        let passers = self.passers(paths, obstacles, distance, free, direction);
        let [low, high] = span_of(passers.iter().map(|passer| passer.lane));
        if passers.is_empty() || high - low <= 2.0 * self.half_width {
            return false;
        }
        let share = 2.0 * self.half_width / (high - low);
        let lanes: Vec<f64> = passers.iter().map(|passer| share * (passer.lane - 0.5 * (low + high))).collect();
        let shifts = in_turn(&passers, &lanes, distance);
        let widest = passers.iter().zip(&lanes).map(|(passer, lane)| (passer.lane - lane).abs()).fold(0.0, f64::max);
        let farthest = shifts.iter().copied().map(f64::abs).fold(0.0, f64::max);
        let half_depth = self.half_depth + distance * (1.0 + MARGIN) + farthest;
        let last = paths.knot_count() - 1;
        let ends = passers.iter().flat_map(|passer| [0, last].map(|knot| self.within(at(paths, passer.agent, knot), direction)[0].abs()));
        let run_up = (ends.fold(f64::INFINITY, f64::min) - half_depth).min(RUN_UP * widest.max(farthest));
        if run_up <= LEAST_RUN_UP[0] * widest || run_up <= LEAST_RUN_UP[1] * farthest {
            return false;
        }
        for (passer, (lane, shift)) in passers.iter().zip(lanes.iter().zip(&shifts)) {
            for knot in 1..last {
                let [along, across] = self.within(at(paths, passer.agent, knot), direction);
                let share = fall((along.abs() - half_depth) / run_up);
                let by = share * (lane - across) * self.across - share * shift * direction * self.across.perp();
                paths.path_mut(0, passer.agent)[knot] += by.x;
                paths.path_mut(1, passer.agent)[knot] += by.y;
            }
        }
        true
    }

    /// Who comes through once, in this direction, and is blocked or passes between both obstacles.
    fn passers(&self, paths: &Paths, obstacles: [&Outline; 2], distance: f64, free: &[usize], direction: f64) -> Vec<Passer> {
        let last = paths.knot_count() - 1;
        let along = |agent: usize, knot: usize| self.within(at(paths, agent, knot), direction)[0];
        let crossing = |agent: usize| {
            let mut crossings = (0..last).filter(|knot| (along(agent, *knot) < 0.0) != (along(agent, knot + 1) < 0.0));
            crossings.next().filter(|_| along(agent, 0) < 0.0 && crossings.next().is_none())
        };
        let open = self.half_width + distance;
        let coming: Vec<(usize, usize, f64)> = free
            .iter()
            .filter_map(|agent| {
                let knot = crossing(*agent)?;
                let [from, to] = [knot, knot + 1].map(|knot| self.within(at(paths, *agent, knot), direction));
                let lane = from[1] + (to[1] - from[1]) * (from[0] / (from[0] - to[0]));
                let is_passer = lane.abs() < open || obstacles.iter().any(|outline| is_blocked(paths, *agent, outline, distance));
                is_passer.then_some((*agent, knot, lane))
            })
            .collect();
        let middle = coming.iter().map(|(_, knot, _)| knot).sum::<usize>() / coming.len().max(1);
        coming.into_iter().map(|(agent, _, lane)| Passer { agent, lane, ahead: along(agent, middle) }).collect()
    }
}

/// How far each has to be ahead of where it comes, so that nobody is too near to those beside: the first where they are, the others just
/// behind them, and then as far ahead as behind.
fn in_turn(passers: &[Passer], lanes: &[f64], distance: f64) -> Vec<f64> {
    let wanted = WANTED * distance;
    let rank = |passer: &Passer| (-passer.ahead / (ABREAST * distance)).round();
    let first_first = order::by_key(
        passers.iter().zip(lanes).map(|(passer, lane)| order::key_of_two(order::of_real(rank(passer)), order::of_real(*lane))),
    );
    let mut placed: Vec<(f64, f64)> = Vec::with_capacity(passers.len());
    let mut shifts = vec![0.0; passers.len()];
    for index in first_first {
        let (own, lane) = (passers[index as usize].ahead, lanes[index as usize]);
        let mut place = own;
        let behind = |place: f64| {
            let least = |(ahead, beside): &(f64, f64)| {
                let apart = lane - beside;
                let along = (wanted * wanted - apart * apart).max(0.0).sqrt();
                ((place - ahead).abs() < along * (1.0 - 1e-9)).then_some(ahead - along)
            };
            placed.iter().filter_map(least).reduce(f64::min)
        };
        while let Some(next) = behind(place) {
            place = next;
        }
        placed.push((place, lane));
        shifts[index as usize] = place - own;
    }
    let [low, high] = span_of(shifts.iter().copied());
    shifts.iter().map(|shift| shift - 0.5 * (low + high)).collect()
}

/// The least and the greatest of some numbers.
fn span_of(values: impl Iterator<Item = f64>) -> [f64; 2] {
    values.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], value| [low.min(value), high.max(value)])
}

/// The points of two polygons that are nearest to one another.
fn nearest_points(a: &Outline, b: &Outline) -> [DVec2; 2] {
    let corners = |outline: &Outline| outline.points.iter().copied().map(DVec2::from_array).collect::<Vec<_>>();
    let [a, b] = [corners(a), corners(b)];
    let mut nearest = [a[0], b[0]];
    let mut offer = |pair: [DVec2; 2]| {
        if pair[0].distance_squared(pair[1]) < nearest[0].distance_squared(nearest[1]) {
            nearest = pair;
        }
    };
    for_each_side(&a, &b, |corner, beside| offer([corner, beside]));
    for_each_side(&b, &a, |corner, beside| offer([beside, corner]));
    nearest
}

/// Visits every corner with the nearest place of every side.
fn for_each_side(corners: &[DVec2], others: &[DVec2], mut visit: impl FnMut(DVec2, DVec2)) {
    for corner in corners {
        for (k, from) in others.iter().enumerate() {
            let side = others[(k + 1) % others.len()] - from;
            let length_squared = side.length_squared();
            let t = if length_squared > 0.0 { ((*corner - from).dot(side) / length_squared).clamp(0.0, 1.0) } else { 0.0 };
            visit(*corner, *from + t * side);
        }
    }
}

/// 1 up to 0, nothing from 1 on, with two derivatives everywhere.
fn fall(x: f64) -> f64 {
    let x = (1.0 - x).clamp(0.0, 1.0);
    x * x * x * (10.0 - x * (15.0 - 6.0 * x))
}
