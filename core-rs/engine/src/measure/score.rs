//! One number to choose a method by.

use super::distortion::Distortion;
use super::{extreme, walk};
use crate::adjacency::Adjacency;
use crate::formation::{PairSearch, near_pair};
use crate::motion::Motion;

/// What a radian of mean turning costs beside a mean distortion of 1.
const TURNING_COST: f64 = 0.02;

/// What it costs when every agent is, on every frame, in one pair at distance zero.
const CROWDING_COST: f64 = 0.5;

/// Scores are compared to this: round-off must not choose.
const RESOLUTION: f64 = 1e-6;

/// How good a candidate is; lower is better.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Score {
    /// Mean adjacency distortion.
    pub distortion: f64,
    /// Mean turning, radians.
    pub turning: f64,
    /// Least distance on the samples, meters; none for fewer than two agents.
    pub clearance: Option<f64>,
    /// D + 0.02 · turning + 0.5 · c / (samples · agents), c = Σ (1 − distance / minimum distance) over samples and pairs that are
    /// too near; rounded to a millionth.
    pub total: f64,
}

/// Judges a motion sampled at the parameters `ts`; `minimum_distance` in meters, 0 for none.
pub fn score(motion: &Motion, ts: &[f64], graphs: [&Adjacency; 2], minimum_distance: f64) -> Score {
    let distortion = extreme(&Distortion::new(motion, graphs).curve(motion, ts)).mean;
    let turning = extreme(&walk(motion).turning).mean;
    let near = nearness(motion, minimum_distance);
    let places = (ts.len() * motion.agent_count()).max(1) as f64;
    let total = distortion + TURNING_COST * turning + CROWDING_COST * near.crowding / places;
    Score { distortion, turning, clearance: near.least, total: (total / RESOLUTION).round() * RESOLUTION }
}

struct Nearness {
    least: Option<f64>,
    crowding: f64,
}

/// One pass over the near pairs of every sample serves both figures.
fn nearness(motion: &Motion, minimum_distance: f64) -> Nearness {
    let mut search = PairSearch::default();
    let mut least = None;
    let mut crowding = 0.0;
    for k in 0..motion.times().len() {
        let at = motion.places(k);
        let Some((a, b)) = near_pair(at) else { continue };
        // Any pair bounds the least distance from above.
        let bound = at.distance(a as usize, b as usize).min(least.unwrap_or(f64::INFINITY));
        let mut nearest: f64 = bound;
        search.for_each_within(at.plan(), bound.max(minimum_distance), |a, b, _| {
            let distance = at.distance(a as usize, b as usize);
            nearest = nearest.min(distance);
            if distance < minimum_distance {
                crowding += 1.0 - distance / minimum_distance;
            }
        });
        least = Some(nearest);
    }
    Nearness { least, crowding }
}

#[cfg(test)]
mod tests {
    use glam::DVec2;

    use super::*;

    #[test]
    fn crowding_counts_only_pairs_nearer_than_the_minimum_distance() {
        let places = [0.0, 0.25, 5.0].map(|x| DVec2::new(x, 0.0));
        let still = Motion::new(vec![0.0, 1.0], 3, [places, places].concat());
        let graph = Adjacency::new(3, Vec::new());
        let judged = score(&still, &[0.0, 1.0], [&graph, &graph], 0.5);
        // Half a conflict on each of two samples, over two samples of three agents.
        assert!((judged.total - 0.5 * (2.0 * 0.5) / 6.0).abs() <= RESOLUTION);
        assert_eq!(judged.clearance, Some(0.25));
        assert_eq!(score(&still, &[0.0, 1.0], [&graph, &graph], 0.0).total, 0.0);
    }
}
