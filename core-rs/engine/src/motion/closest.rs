//! How near any two agents come, between samples too.
//!
//! Exact: every pair that could be the nearest in a piece is tried analytically. Few could, and mostly those of the piece before, so
//! they are listed once for as many pieces as nobody has moved far enough to break the list.

use std::ops::Sub;

use glam::{DVec2, DVec3};

use super::Motion;
use super::pair_list::PairList;
use crate::formation::{Places, near_pair};

/// Distances that differ by less are one, meters: the earlier moment and the lower indices are named then. A formation that keeps its
/// shape would otherwise name whatever rounding picks, and that is not the same on every machine.
const SAME_DISTANCE: f64 = 1e-9;

/// Two agents at their nearest.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Approach {
    /// Meters.
    pub distance: f64,
    /// Seconds.
    pub time: f64,
    /// Lower index first.
    pub agents: (u32, u32),
}

/// How near the agents of a motion come.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Closeness {
    /// `approaches[k]` is the nearest of any two agents from sample k to the next, exact for the straight piece; of distances within
    /// 1e-9 m the lowest pair. Empty for fewer than two agents or samples.
    pub approaches: Vec<Approach>,
    /// How many (sample, pair) are nearer than the limit.
    pub near_count: usize,
}

impl Closeness {
    /// The nearest of all, the earliest of those within 1e-9 m.
    pub fn nearest(&self) -> Option<Approach> {
        let least = self.approaches.iter().map(|approach| approach.distance).min_by(f64::total_cmp)?;
        self.approaches.iter().find(|approach| approach.distance <= least + SAME_DISTANCE).copied()
    }
}

/// How near the agents come; `limit` in meters, 0 to count nothing.
///
/// Time grows with the number of pairs within the limit or the least distance, whichever is greater.
pub fn closeness(motion: &Motion, limit: f64) -> Closeness {
    let mut result = Closeness::default();
    let sample_count = motion.times().len();
    if sample_count == 0 {
        return result;
    }
    let Some(mut pair) = near_pair(motion.places(0)) else { return result };
    let mut list = PairList::default();
    let limit = limit.max(0.0);
    for k in 1..sample_count {
        let mut piece = Piece::new(motion, k - 1, k, pair, limit);
        piece.search(&mut list);
        pair = piece.nearest.pair;
        result.near_count += piece.near_count;
        result.approaches.push(piece.approach());
    }
    // Every piece counts at its start; this one is the end.
    let mut end = Piece::new(motion, sample_count - 1, sample_count - 1, pair, limit);
    end.search(&mut list);
    result.near_count += end.near_count;
    result
}

/// From one sample to another: everybody moves straight.
struct Piece<'a> {
    motion: &'a Motion,
    samples: [usize; 2],
    limit: f64,
    nearest: Nearest,
    near_count: usize,
}

/// The nearest pair of a piece so far; t is 0 at its start, 1 at its end.
struct Nearest {
    distance: f64,
    t: f64,
    pair: (u32, u32),
}

impl<'a> Piece<'a> {
    /// `pair` bounds the distance from above; the nearest of the piece before is a good one.
    fn new(motion: &'a Motion, start: usize, end: usize, pair: (u32, u32), limit: f64) -> Self {
        let ends = [motion.places(start), motion.places(end)];
        let (distance_squared, t) = nearest_approach(apart_in_space(ends, pair));
        let nearest = Nearest { distance: distance_squared.sqrt(), t, pair };
        Self { motion, samples: [start, end], limit, nearest, near_count: 0 }
    }

    fn search(&mut self, list: &mut PairList) {
        let ends = self.samples.map(|k| self.motion.places(k));
        if self.motion.heights().is_none() {
            self.try_pairs(list, |pair| apart(ends.map(Places::plan), pair));
        } else {
            self.try_pairs(list, |pair| apart_in_space(ends, pair));
        }
    }

    /// `apart` tells what separates a pair at both ends.
    fn try_pairs<V: Separation>(&mut self, list: &mut PairList, apart: impl Fn((u32, u32)) -> [V; 2]) {
        let radius = self.limit.max(self.nearest.distance + SAME_DISTANCE);
        let (nearest, near_count) = (&mut self.nearest, &mut self.near_count);
        let limit_squared = self.limit * self.limit;
        let mut bound_squared = (nearest.distance + SAME_DISTANCE).powi(2);
        list.for_each(self.motion, self.samples, radius, |a, b| {
            let [from, to] = apart((a, b));
            *near_count += usize::from(from.dot(from) < limit_squared);
            let (distance_squared, t) = nearest_approach([from, to]);
            if distance_squared <= bound_squared {
                nearest.offer(distance_squared.sqrt(), t, (a, b));
                bound_squared = (nearest.distance + SAME_DISTANCE).powi(2);
            }
        });
    }

    fn approach(&self) -> Approach {
        let [start, end] = self.samples.map(|k| self.motion.times()[k]);
        let Nearest { distance, t, pair } = self.nearest;
        Approach { distance, time: start + t * (end - start), agents: pair }
    }
}

impl Nearest {
    fn offer(&mut self, distance: f64, t: f64, pair: (u32, u32)) {
        if distance < self.distance - SAME_DISTANCE || pair < self.pair {
            (self.t, self.pair) = (t, pair);
        }
        self.distance = self.distance.min(distance);
    }
}

/// What separates two agents at one instant, in plan or in space: most motions are in plan, and most of the time goes here.
pub(super) trait Separation: Copy + Sub<Output = Self> {
    fn dot(self, other: Self) -> f64;

    /// This and so much of a change.
    fn changed(self, t: f64, change: Self) -> Self;
}

impl Separation for DVec2 {
    fn dot(self, other: Self) -> f64 {
        self.dot(other)
    }

    fn changed(self, t: f64, change: Self) -> Self {
        self + t * change
    }
}

impl Separation for DVec3 {
    fn dot(self, other: Self) -> f64 {
        self.dot(other)
    }

    fn changed(self, t: f64, change: Self) -> Self {
        self + t * change
    }
}

/// What separates a pair at both ends of a piece in plan.
fn apart(ends: [&[DVec2]; 2], (a, b): (u32, u32)) -> [DVec2; 2] {
    ends.map(|at| at[a as usize] - at[b as usize])
}

/// The same in space.
pub(super) fn apart_in_space(ends: [Places<'_>; 2], (a, b): (u32, u32)) -> [DVec3; 2] {
    ends.map(|places| places.at(a as usize) - places.at(b as usize))
}

/// The least squared length between two separations, and when, 0–1: the start when it stays the same.
pub(super) fn nearest_approach<V: Separation>([from, to]: [V; 2]) -> (f64, f64) {
    let change = to - from;
    let closing = -from.dot(change);
    let change_squared = change.dot(change);
    if closing <= 0.0 {
        (from.dot(from), 0.0)
    } else if closing >= change_squared {
        (to.dot(to), 1.0)
    } else {
        let t = closing / change_squared;
        let nearest = from.changed(t, change);
        (nearest.dot(nearest), t)
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn motion(samples: &[Vec<(f64, f64)>]) -> Motion {
        let times = (0..samples.len()).map(|k| k as f64).collect();
        Motion::new(times, samples[0].len(), samples.iter().flatten().map(|&(x, y)| DVec2::new(x, y)).collect())
    }

    #[test]
    fn two_agents_that_swap_places_meet_halfway_although_no_sample_sees_it() {
        let swap = closeness(&motion(&[vec![(0.0, 0.0), (2.0, 0.0)], vec![(2.0, 0.0), (0.0, 0.0)]]), 1.0);
        assert_eq!(swap.approaches, [Approach { distance: 0.0, time: 0.5, agents: (0, 1) }]);
        assert_eq!(swap.near_count, 0, "at no sample");
    }

    #[test]
    fn a_pair_is_nearest_where_it_passes() {
        let check = |from: [f64; 2], to: [f64; 2], distance: f64, t: f64| {
            let (found, when) = nearest_approach([from, to].map(DVec2::from_array));
            assert!((found.sqrt() - distance).abs() < 1e-15 && (when - t).abs() < 1e-15, "{from:?} to {to:?}: {found} at {when}");
        };
        check([-1.0, 0.5], [1.0, 0.5], 0.5, 0.5);
        check([-1.0, 0.0], [3.0, 0.0], 0.0, 0.25);
        check([1.0, 0.0], [2.0, 0.0], 1.0, 0.0);
        check([2.0, 1.0], [0.0, 1.0], 1.0, 1.0);
        check([3.0, 4.0], [3.0, 4.0], 5.0, 0.0);
        check([0.0, 0.0], [0.0, 0.0], 0.0, 0.0);
    }

    #[test]
    fn a_formation_that_keeps_its_shape_is_nearest_at_once_and_names_its_first_pair() {
        let square = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)].map(DVec2::from);
        let turned = |k: i32| square.map(|p| DVec2::from_angle(0.1 * f64::from(k)).rotate(p) + DVec2::new(0.3 * f64::from(k), 1e4));
        let motion = Motion::new((0..50).map(f64::from).collect(), 4, (0..50).flat_map(turned).collect());
        // A chord of the turn cuts the corner: the first piece is as near as any.
        let found = closeness(&motion, 0.0).nearest().unwrap();
        assert_eq!((found.agents, found.time < 1.0), ((0, 1), true), "{found:?}");
    }

    #[test]
    fn nobody_and_a_lone_agent_approach_nobody() {
        assert_eq!(closeness(&Motion::new(vec![0.0, 1.0], 0, Vec::new()), 1.0), Closeness::default());
        assert_eq!(closeness(&motion(&[vec![(0.0, 0.0)], vec![(1.0, 0.0)]]), 1.0), Closeness::default());
    }

    #[test]
    fn one_sample_has_near_pairs_and_no_approach() {
        let found = closeness(&motion(&[vec![(0.0, 0.0), (0.5, 0.0), (0.5, 0.5)]]), 0.6);
        assert_eq!(found, Closeness { approaches: Vec::new(), near_count: 2 });
    }

    /// Motions of a few agents: in a common drift, mostly slow, sometimes in one place, sometimes with one who is far or fast.
    fn motions() -> impl Strategy<Value = Motion> {
        let at = || (-9i32..9, -9i32..9).prop_map(|(x, y)| DVec2::new(f64::from(x), f64::from(y)));
        let step = prop_oneof![8 => Just(0.02), 1 => Just(0.0), 1 => Just(2.0)];
        (2usize..12, 1usize..24).prop_flat_map(move |(agents, samples)| {
            let starts = prop::collection::vec(prop_oneof![9 => at(), 1 => at().prop_map(|p| 5e3 * p)], agents);
            let ways = prop::collection::vec((at(), step.clone()), agents * samples);
            (starts, ways, at()).prop_map(move |(starts, ways, drift)| {
                let mut positions = starts;
                for (k, (way, step)) in ways.into_iter().take(agents * (samples - 1)).enumerate() {
                    positions.push(positions[k] + way * step + drift);
                }
                Motion::new((0..samples).map(|k| k as f64).collect(), agents, positions)
            })
        })
    }

    /// The same, in space: heights are borrowed from the places of another motion.
    fn motions_in_space() -> impl Strategy<Value = Motion> {
        let lifted = |plan: Motion, shift: f64| {
            let heights = plan.positions().iter().map(|p| (p.y - shift * p.x) / 2.0).collect();
            Motion::spatial(plan.times().to_vec(), plan.agent_count(), plan.positions().to_vec(), heights)
        };
        (motions(), -3.0..3.0f64).prop_map(move |(plan, shift)| lifted(plan, shift.round()))
    }

    proptest! {
        #[test]
        fn the_nearest_of_all_pairs_is_found(motion in prop_oneof![motions(), motions_in_space()], limit in prop_oneof![Just(0.0), 0.0..3.0f64, Just(1e6)]) {
            let agent_count = motion.agent_count() as u32;
            let pairs: Vec<_> = (0..agent_count).flat_map(|a| (a + 1..agent_count).map(move |b| (a, b))).collect();
            let found = closeness(&motion, limit);
            for (k, approach) in found.approaches.iter().enumerate() {
                let ends = [motion.places(k), motion.places(k + 1)];
                let distance = |&pair: &(u32, u32)| nearest_approach(apart_in_space(ends, pair)).0.sqrt();
                let least = pairs.iter().map(distance).fold(f64::INFINITY, f64::min);
                prop_assert_eq!(approach.distance, least);
                // The bounding pair may be as much above the least as a tie allows, and a lower pair above that.
                let first = pairs.iter().find(|pair| distance(pair) <= least + 1e-12).unwrap();
                prop_assert!(approach.agents <= *first && distance(&approach.agents) <= least + 2.0 * SAME_DISTANCE);
            }
            let is_near = |k: usize, pair: (u32, u32)| apart_in_space([motion.places(k); 2], pair)[0].length_squared() < limit * limit;
            let near = |k: usize| pairs.iter().filter(|pair| is_near(k, **pair)).count();
            prop_assert_eq!(found.near_count, (0..motion.times().len()).map(near).sum::<usize>());
        }
    }
}
