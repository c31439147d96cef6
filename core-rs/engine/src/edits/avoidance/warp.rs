//! Guides bent before anybody is pushed, for whoever is stuck: a roundabout, or more room about the middle.

use std::f64::consts::PI;

use eigenform_apart::Paths;
use glam::DVec2;

use super::attempt::Attempt;
use super::problem::Problem;
use super::rungs::Ways;
use crate::motion::Approach;

/// Beyond this a detour looks like another show: of the minimum distance, and at least so many meters.
const WIDEST: f64 = 3.0;
const WIDEST_METERS: f64 = 2.0;

/// Who has far to go may go around others by so much of it.
const SHARE_OF_WAY: f64 = 0.25;

/// Nobody may have to run: of the guide's top speed.
const FASTEST: f64 = 1.5;

/// So many times as fast is no way to go at all; but not what anybody walks, in meters a second.
const FLUNG: f64 = 3.0;
const BRISK: f64 = 2.0;

/// Agents in a clash that is left, and whom they clash with on the guide.
pub(super) fn stuck(left: &[Approach], on_guide: &[Approach], agent_count: usize) -> Vec<bool> {
    let mut is_left = vec![false; agent_count];
    left.iter().flat_map(pair).for_each(|agent| is_left[agent] = true);
    let mut is_stuck = is_left.clone();
    for [a, b] in on_guide.iter().map(pair) {
        if is_left[a] || is_left[b] {
            (is_stuck[a], is_stuck[b]) = (true, true);
        }
    }
    is_stuck
}

/// Moves the stuck ones up to `width` meters to the right of the line from their start to their end, gently at both: a crowd that
/// meets in one point turns about it.
pub(super) fn swirl(paths: &mut Paths, is_stuck: &[bool], width: f64) {
    let last = paths.knot_count() - 1;
    for agent in (0..paths.agent_count()).filter(|agent| is_stuck[*agent]) {
        let [start, end] = [0, last].map(|knot| paths.place(agent, knot));
        let way = DVec2::new(end[0] - start[0], end[1] - start[1]).normalize_or_zero();
        for knot in 1..last {
            let aside = width * wave(knot, last);
            paths.path_mut(0, agent)[knot] += aside * way.y;
            paths.path_mut(1, agent)[knot] -= aside * way.x;
        }
    }
}

/// Moves the stuck ones away from the middle of those they clash with, directly or through others, by up to `growth` times how far
/// from it they are; gently at both ends.
pub(super) fn dilate(paths: &mut Paths, is_stuck: &[bool], on_guide: &[Approach], growth: f64) {
    let last = paths.knot_count() - 1;
    for members in clusters(is_stuck, on_guide) {
        for knot in 1..last {
            let place = |agent: usize| DVec2::new(paths.path(0, agent)[knot], paths.path(1, agent)[knot]);
            let middle = members.iter().map(|agent| place(*agent)).sum::<DVec2>() / members.len() as f64;
            let aside = growth * wave(knot, last);
            for &agent in &members {
                let shift = (DVec2::new(paths.path(0, agent)[knot], paths.path(1, agent)[knot]) - middle) * aside;
                paths.path_mut(0, agent)[knot] += shift.x;
                paths.path_mut(1, agent)[knot] += shift.y;
            }
        }
    }
}

/// Whether a detour of so many meters at most, at so many times the guide's top speed, still looks like the guide.
pub fn is_modest(widest: f64, speed_ratio: f64, minimum_distance: f64) -> bool {
    widest <= WIDEST_METERS.max(WIDEST * minimum_distance) && speed_ratio <= FASTEST
}

/// Whether an attempt can be shown without being asked for.
pub(super) fn is_sane(attempt: &Attempt, problem: &Problem) -> bool {
    let [_, widest] = attempt.deviation_lengths();
    let speed_ratio = attempt.motion.top_speed() / problem.guide.top_speed();
    speed_ratio <= FASTEST && !is_astray(widest, problem.ways, problem.avoidance.minimum_distance)
}

/// Whether somebody runs many times as fast as the guide, for as much farther as they may have to go around obstacles.
pub(super) fn is_flung(attempt: &Attempt, problem: &Problem) -> bool {
    let stretch = (problem.longest_way / problem.ways.longest).max(1.0);
    attempt.motion.top_speed() > (FLUNG * stretch * problem.guide.top_speed()).max(BRISK)
}

/// Whether a detour of so many meters is too wide for ways so long.
pub(super) fn is_astray(widest: f64, ways: Ways, minimum_distance: f64) -> bool {
    widest > SHARE_OF_WAY * ways.longest && !is_modest(widest, 1.0, minimum_distance)
}

/// The stuck ones, in sets that clashes on the guide connect.
fn clusters(is_stuck: &[bool], on_guide: &[Approach]) -> Vec<Vec<usize>> {
    let mut leader: Vec<usize> = (0..is_stuck.len()).collect();
    // Whoever clashes takes the lower leader of both, until nobody changes.
    let mut has_changed = true;
    while has_changed {
        has_changed = false;
        for [a, b] in on_guide.iter().map(pair).filter(|[a, b]| is_stuck[*a] && is_stuck[*b]) {
            let lower = leader[a].min(leader[b]);
            has_changed |= leader[a] != leader[b];
            (leader[a], leader[b]) = (lower, lower);
        }
    }
    let mut clusters = vec![Vec::new(); is_stuck.len()];
    (0..is_stuck.len()).filter(|agent| is_stuck[*agent]).for_each(|agent| clusters[leader[agent]].push(agent));
    clusters.retain(|members| members.len() > 1);
    clusters
}

fn wave(knot: usize, last: usize) -> f64 {
    let wave = libm::sin(PI * knot as f64 / last as f64);
    wave * wave
}

fn pair(clash: &Approach) -> [usize; 2] {
    [clash.agents.0 as usize, clash.agents.1 as usize]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn clash(a: u32, b: u32) -> Approach {
        Approach { distance: 0.1, time: 0.5, agents: (a, b) }
    }

    #[test]
    fn stuck_are_those_who_are_left_and_whom_they_meet() {
        let on_guide = [clash(0, 1), clash(1, 2), clash(3, 4)];
        assert_eq!(stuck(&[clash(0, 1)], &on_guide, 6), [true, true, true, false, false, false]);
    }

    #[test]
    fn each_cluster_grows_about_its_own_middle_and_its_ends_stay() {
        // Two pairs a kilometer apart; the last agent is not stuck.
        let xs = [0.0, 1.0, 1000.0, 1002.0, 1.5];
        let mut paths = Paths::new(5, 5, 2);
        for (agent, x) in xs.into_iter().enumerate() {
            paths.path_mut(0, agent).fill(x);
        }
        dilate(&mut paths, &[true, true, true, true, false], &[clash(0, 1), clash(2, 3), clash(3, 4)], 0.5);
        let at = |knot: usize| (0..5).map(|agent| paths.place(agent, knot)[0]).collect::<Vec<_>>();
        assert_eq!(at(2), [-0.25, 1.25, 999.5, 1002.5, 1.5]);
        assert_eq!((at(0), at(4)), (xs.to_vec(), xs.to_vec()));
    }
}
