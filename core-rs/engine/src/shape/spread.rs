//! Places that push one another apart inside a shape.

use glam::DVec2;

use super::region::Region;
use crate::formation::PairSearch;

/// Rounds of the whole: the spread of the distances no longer falls after them.
const ROUNDS: u32 = 60;

/// How far beyond the mean distance one pushes, at first and in the end, as a share of it. Far, and gaps are filled from further away;
/// near, and all distances become alike, that along a thin line and that in the open, too.
const REACH: [f64; 2] = [0.4, 0.05];

/// Rounds in which the reach shrinks; in the rest what is left to move comes to rest.
const SHRINKING: f64 = 48.0;

/// The share of what is too near that each of a pair gives way at once: with six around each, more would swing.
const STIFFNESS: f64 = 0.25;

/// The longest move of a round, as a share of the mean distance.
const LONGEST: f64 = 0.3;

/// How much further than the least distance the last rounds push, so that they end.
const SLACK: f64 = 1e-3;

/// Places on the move.
pub(super) struct Spread {
    places: Vec<DVec2>,
    /// Where they came from: at the least distance already.
    packed: Vec<DVec2>,
    /// Mean distance to the nearest, meters.
    spacing: f64,
    round: u32,
    search: PairSearch,
}

impl Spread {
    /// Places about `spacing` meters apart, none nearer than the least distance.
    pub(super) fn new(places: Vec<DVec2>, spacing: f64) -> Self {
        Self { packed: places.clone(), places, spacing, round: 0, search: PairSearch::default() }
    }

    /// A round; how much of all is done.
    pub(super) fn step(&mut self, region: &Region) -> f64 {
        let t = (f64::from(self.round) / SHRINKING).min(1.0);
        let reach = self.spacing * (1.0 + REACH[0] + (REACH[1] - REACH[0]) * t);
        let nearest = self.push(region, reach);
        self.spacing = nearest.iter().map(|squared| squared.sqrt().min(reach)).sum::<f64>() / nearest.len() as f64;
        self.round += 1;
        f64::from(self.round) / f64::from(ROUNDS)
    }

    /// The places, none nearer to another than `least`: where the shape is too full to spread them so, those they came from.
    pub(super) fn settle(&mut self, region: &Region, least: f64) -> Vec<DVec2> {
        for _ in 0..=ROUNDS {
            let before = self.places.clone();
            if self.keeps(region, least) {
                return before;
            }
        }
        std::mem::take(&mut self.packed)
    }

    /// Whether nobody is nearer than `least` to another; who is goes apart.
    pub(super) fn keeps(&mut self, region: &Region, least: f64) -> bool {
        self.push(region, least * (1.0 + SLACK)).iter().all(|&squared| squared >= least * least)
    }

    /// Moves all who are nearer than `reach` apart; the squared distance from each to its nearest before, if that is within reach.
    fn push(&mut self, region: &Region, reach: f64) -> Vec<f64> {
        let Self { places, search, .. } = self;
        let mut nearest = vec![f64::INFINITY; places.len()];
        let mut pushes = vec![DVec2::ZERO; places.len()];
        search.for_each_within(places, reach, |a, b, squared| {
            let (a, b) = (a as usize, b as usize);
            let distance = squared.sqrt();
            let away = if distance > 0.0 { (places[b] - places[a]) / distance } else { DVec2::X };
            let push = away * (STIFFNESS * (reach - distance));
            pushes[a] -= push;
            pushes[b] += push;
            nearest[a] = nearest[a].min(squared);
            nearest[b] = nearest[b].min(squared);
        });
        for (place, push) in places.iter_mut().zip(pushes) {
            if push != DVec2::ZERO {
                *place = region.moved(*place, push.clamp_length_max(LONGEST * reach));
            }
        }
        nearest
    }
}
