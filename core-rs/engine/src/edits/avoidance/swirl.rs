//! A roundabout for whoever is stuck: each keeps to its own right on the way, so that a crowd that meets in one point turns about it.

use std::f64::consts::PI;

use eigenform_apart::Paths;
use glam::DVec2;

use crate::motion::{Approach, Motion};

/// Beyond this a detour looks like another show: of the minimum distance, and at least so many meters.
const WIDEST: f64 = 3.0;
const WIDEST_METERS: f64 = 2.0;

/// Nobody may have to run: of the guide's top speed.
const FASTEST: f64 = 1.5;

/// Agents in a clash that is left, and whom they clash with on the guide.
pub(super) fn stuck(left: &[Approach], on_guide: &[Approach], agent_count: usize) -> Vec<bool> {
    let mut is_left = vec![false; agent_count];
    let pair = |clash: &Approach| [clash.agents.0 as usize, clash.agents.1 as usize];
    left.iter().flat_map(pair).for_each(|agent| is_left[agent] = true);
    let mut is_stuck = is_left.clone();
    for [a, b] in on_guide.iter().map(pair) {
        if is_left[a] || is_left[b] {
            (is_stuck[a], is_stuck[b]) = (true, true);
        }
    }
    is_stuck
}

/// Moves the stuck ones up to `width` meters to the right of the line from their start to their end, gently at both.
pub(super) fn swirl(paths: &mut Paths, is_stuck: &[bool], width: f64) {
    let last = paths.knot_count() - 1;
    for agent in (0..paths.agent_count()).filter(|agent| is_stuck[*agent]) {
        let [start, end] = [0, last].map(|knot| paths.place(agent, knot));
        let way = DVec2::new(end[0] - start[0], end[1] - start[1]).normalize_or_zero();
        for knot in 1..last {
            let wave = libm::sin(PI * knot as f64 / last as f64);
            let aside = width * wave * wave;
            paths.path_mut(0, agent)[knot] += aside * way.y;
            paths.path_mut(1, agent)[knot] -= aside * way.x;
        }
    }
}

/// Whether a detour of so many meters at most, and the motion with it, can be shown.
pub(super) fn is_sane(widest: f64, motion: &Motion, guide: &Motion, minimum_distance: f64) -> bool {
    widest <= WIDEST_METERS.max(WIDEST * minimum_distance) && top_speed(motion) <= FASTEST * top_speed(guide)
}

fn top_speed(motion: &Motion) -> f64 {
    let times = motion.times();
    let fastest = |k: usize| {
        let steps = motion.places(k - 1).iter().zip(motion.places(k).iter());
        steps.map(|(from, to)| from.distance(to)).fold(0.0, f64::max) / (times[k] - times[k - 1])
    };
    (1..times.len()).map(fastest).fold(0.0, f64::max)
}
