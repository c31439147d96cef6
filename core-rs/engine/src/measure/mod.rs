//! The numbers to judge a transition by.
//!
//! They take a motion and graphs, never a scene: any motion can be measured, wherever it comes from.

mod distortion;
mod headings;
mod movement;
mod score;

use serde::Serialize;

use crate::adjacency::Adjacency;
use crate::motion::{Approach, Motion, closeness};

pub use movement::{Movement, MovementCurves, movement};
pub use score::{Score, score};

use distortion::Distortion;
use headings::Headings;

/// A pair is nearer than the minimum distance only by more than this, meters: positions are exact to a thousandth of it.
const DISTANCE_TOLERANCE: f64 = 1e-6;

/// A mean and a greatest value.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct Extreme {
    /// The mean.
    pub mean: f64,
    /// The greatest.
    pub max: f64,
}

/// The nearest that any two agents come.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct Clearance {
    /// Meters.
    pub distance: f64,
    /// Scene seconds.
    pub time: f64,
    /// Lower index first.
    pub agents: (u32, u32),
}

/// The fastest that any agent moves.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct TopSpeed {
    /// Meters a second, over the step between two samples.
    pub speed: f64,
    /// The middle of that step, scene seconds.
    pub time: f64,
    /// Who.
    pub agent: u32,
}

/// How large the formation gets about its barycenter.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct Range {
    /// The least.
    pub min: f64,
    /// The greatest.
    pub max: f64,
}

/// The measures of one transition.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
#[serde(rename_all = "camelCase")]
pub struct Measures {
    /// Adjacency distortion D(t) over the samples.
    pub distortion: Extreme,
    /// Change of heading over the whole way, radians, over the agents.
    pub turning: Extreme,
    /// Between samples too; none for fewer than two agents.
    pub clearance: Option<Clearance>,
    /// How many (sample, pair) are nearer than the minimum distance.
    pub near_collisions: usize,
    /// Meters, over the agents.
    pub path_length: Extreme,
    /// Of all agents and steps.
    pub top_speed: TopSpeed,
    /// RMS distance from the barycenter over the samples, meters.
    pub rms_radius: Range,
}

/// One value a sample of the motion.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Curves {
    /// Nearest approach from this sample to the next, meters; at the last sample that of the step before it. Infinite for fewer than
    /// two agents.
    pub clearance: Vec<f64>,
    /// D(t).
    pub distortion: Vec<f64>,
    /// Mean change of heading a second at this sample, rad/s.
    pub turning: Vec<f64>,
    /// Of the fastest agent in the step that ends here (at the first sample: that starts here), m/s.
    pub top_speed: Vec<f64>,
    /// Mean way so far, meters.
    pub path_length: Vec<f64>,
}

/// Measures a motion between two formations; `ts` are the parameters t of its samples, `graphs` the ties at both ends,
/// `minimum_distance` in meters.
pub fn measure(motion: &Motion, ts: &[f64], graphs: [&Adjacency; 2], minimum_distance: f64) -> (Measures, Curves) {
    let distortion_curve = Distortion::new(motion, graphs).curve(motion, ts);
    let closeness = closeness(motion, minimum_distance - DISTANCE_TOLERANCE);
    let walk = walk(motion);
    let radii = rms_radii(motion);
    let measures = Measures {
        distortion: extreme(&distortion_curve),
        turning: extreme(&walk.turning),
        clearance: closeness.nearest().map(|Approach { distance, time, agents }| Clearance { distance, time, agents }),
        near_collisions: closeness.near_count,
        path_length: extreme(&walk.path_length),
        top_speed: walk.top_speed,
        rms_radius: radii,
    };
    let mut clearance: Vec<f64> = closeness.approaches.iter().map(|approach| approach.distance).collect();
    clearance.resize(motion.times().len(), clearance.last().copied().unwrap_or(f64::INFINITY));
    let curves = Curves {
        clearance,
        distortion: distortion_curve,
        turning: walk.turning_curve,
        top_speed: walk.speed_curve,
        path_length: walk.path_curve,
    };
    (measures, curves)
}

fn extreme(values: &[f64]) -> Extreme {
    let count = values.len().max(1) as f64;
    // A sum of nothing would be −0.
    Extreme { mean: (0.0 + values.iter().sum::<f64>()) / count, max: values.iter().copied().fold(0.0, f64::max) }
}

fn rms_radii(motion: &Motion) -> Range {
    let count = motion.agent_count().max(1) as f64;
    let radius = |k: usize| {
        let center = motion.places(k).barycenter();
        // A sum of nothing would be −0.
        ((0.0 + motion.places(k).iter().map(|p| p.distance_squared(center)).sum::<f64>()) / count).sqrt()
    };
    let none = Range { min: f64::INFINITY, max: 0.0 };
    (0..motion.times().len()).map(radius).fold(none, |range, r| Range { min: range.min.min(r), max: range.max.max(r) })
}

/// What the agents' ways come to, agent by agent and sample by sample.
struct Walk {
    turning: Vec<f64>,
    path_length: Vec<f64>,
    top_speed: TopSpeed,
    turning_curve: Vec<f64>,
    speed_curve: Vec<f64>,
    path_curve: Vec<f64>,
}

fn walk(motion: &Motion) -> Walk {
    let agent_count = motion.agent_count();
    let times = motion.times();
    let mut headings = Headings::new(agent_count, motion.extent());
    let mut path_length = vec![0.0; agent_count];
    let mut top_speed = TopSpeed { speed: 0.0, time: times[0], agent: 0 };
    let (mut turning_curve, mut speed_curve, mut path_curve) = (vec![0.0], vec![0.0], vec![0.0]);
    for k in 1..times.len() {
        let seconds = times[k] - times[k - 1];
        let (mut turned, mut fastest, mut walked) = (0.0, 0.0, 0.0);
        for (agent, (from, to)) in motion.places(k - 1).iter().zip(motion.places(k).iter()).enumerate() {
            let step = to - from;
            let length = step.length();
            turned += headings.step(agent, step, length);
            path_length[agent] += length;
            walked += length;
            if length / seconds > fastest {
                fastest = length / seconds;
                if fastest > top_speed.speed {
                    top_speed = TopSpeed { speed: fastest, time: f64::midpoint(times[k - 1], times[k]), agent: agent as u32 };
                }
            }
        }
        let count = agent_count.max(1) as f64;
        turning_curve.push(turned / count / seconds);
        speed_curve.push(fastest);
        path_curve.push(path_curve[k - 1] + walked / count);
    }
    if let Some(&first) = speed_curve.get(1) {
        speed_curve[0] = first;
    }
    Walk { turning: headings.into_turning(), path_length, top_speed, turning_curve, speed_curve, path_curve }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::{FRAC_PI_2, PI};

    use glam::DVec2;

    use super::*;
    use crate::adjacency::Tie;

    /// One agent a list; a sample a second.
    fn motion(ways: &[&[(f64, f64)]]) -> Motion {
        let count = ways[0].len();
        let positions = (0..count).flat_map(|k| ways.iter().map(move |way| DVec2::from(way[k]))).collect();
        Motion::new((0..count).map(|k| k as f64).collect(), ways.len(), positions)
    }

    fn evenly(count: usize) -> Vec<f64> {
        (0..count).map(|k| k as f64 / (count - 1) as f64).collect()
    }

    fn tied(agent_count: usize, pairs: &[(u32, u32)]) -> Adjacency {
        Adjacency::new(agent_count, pairs.iter().map(|&(a, b)| Tie { a, b, factor: 1.0, weight: 1.0 }).collect())
    }

    fn measured(motion: &Motion, graph: &Adjacency, minimum_distance: f64) -> (Measures, Curves) {
        measure(motion, &evenly(motion.times().len()), [graph, graph], minimum_distance)
    }

    #[test]
    fn a_square_corner_is_a_quarter_turn_for_the_one_who_walks_it() {
        let motion = motion(&[&[(0.0, 0.0), (1.0, 0.0), (1.0, 2.0)], &[(9.0, 0.0), (9.0, 0.0), (9.0, 0.0)]]);
        let (measures, curves) = measured(&motion, &tied(2, &[]), 0.0);
        assert_eq!(measures.turning, Extreme { mean: FRAC_PI_2 / 2.0, max: FRAC_PI_2 });
        assert_eq!(measures.path_length, Extreme { mean: 1.5, max: 3.0 });
        assert_eq!(measures.top_speed, TopSpeed { speed: 2.0, time: 1.5, agent: 0 });
        assert_eq!(curves.path_length, [0.0, 0.5, 1.5]);
    }

    #[test]
    fn climbing_is_a_turn_and_a_way_as_any() {
        let plan = [(0.0, 0.0), (3.0, 0.0), (3.0, 0.0)].map(DVec2::from).to_vec();
        let motion = Motion::spatial(vec![0.0, 1.0, 2.0], 1, plan, vec![0.0, 4.0, 9.0]);
        let measures = measured(&motion, &tied(1, &[]), 0.0).0;
        assert_eq!(measures.path_length.max, 10.0);
        // From 4 in 5 upward to straight up.
        assert!((measures.turning.max - (0.8_f64).acos()).abs() < 1e-15);
    }

    #[test]
    fn standing_still_between_two_steps_is_no_turn_of_its_own() {
        let motion = motion(&[&[(0.0, 0.0), (1.0, 0.0), (1.0, 0.0), (0.0, 0.0)]]);
        assert_eq!(measured(&motion, &tied(1, &[]), 0.0).0.turning.max, PI);
    }

    #[test]
    fn a_tie_that_shrinks_to_half_of_what_is_due_is_distorted_by_half() {
        let motion = motion(&[&[(0.0, 0.0), (0.0, 0.0), (0.0, 0.0)], &[(2.0, 0.0), (1.0, 0.0), (2.0, 0.0)]]);
        let (measures, curves) = measured(&motion, &tied(2, &[(0, 1)]), 1.5);
        assert_eq!(curves.distortion, [0.0, 0.5, 0.0]);
        assert_eq!(measures.distortion.max, 0.5);
        assert_eq!(measures.clearance, Some(Clearance { distance: 1.0, time: 1.0, agents: (0, 1) }));
        assert_eq!(measures.near_collisions, 1);
    }

    #[test]
    fn nobody_and_one_agent_have_numbers_too() {
        for count in [0, 1] {
            let motion = Motion::new(vec![0.0, 1.0], count, vec![DVec2::ZERO; 2 * count]);
            let (measures, curves) = measured(&motion, &tied(count, &[]), 0.5);
            assert_eq!(measures.clearance, None);
            // Debug text tells −0 from 0, which equality does not.
            assert_eq!(format!("{:?}", measures.rms_radius), format!("{:?}", Range { min: 0.0, max: 0.0 }));
            let all = [&curves.distortion, &curves.turning, &curves.top_speed, &curves.path_length];
            assert!(all.iter().all(|curve| **curve == [0.0, 0.0]));
        }
    }
}
