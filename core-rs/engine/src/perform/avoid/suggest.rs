//! What may help where avoidance did not: who takes whose place, another guide, less distance, a keyframe between.

use super::super::outcome::Suggestion;
use crate::choice::{Choice, MethodName};
use crate::edits::AvoidanceReport;
use crate::motion::{Approach, Motion};

/// Distances are offered in whole centimeters.
const CENTIMETERS: f64 = 100.0;

/// A smaller distance than this is no help, meters.
const LEAST_DISTANCE: f64 = 0.1;

/// The likeliest first; none where nothing is unsolved or a keyframe alone is to blame.
pub(super) fn suggestions(report: &AvoidanceReport, motion: &Motion, choice: &Choice, minimum_distance: f64) -> Vec<Suggestion> {
    let distances = report.unsolved.iter().map(|clash| clash.distance).chain(report.blocked_on_the_way().map(|at| at.distance));
    let nearest = distances.fold(f64::INFINITY, f64::min);
    let on_the_way = || report.unsolved_on_the_way(motion);
    let meetings = on_the_way().map(|clash| (clash.distance, clash.time));
    let all = meetings.chain(report.blocked_on_the_way().map(|at| (at.distance, at.time)));
    let Some((_, time)) = all.min_by(|a, b| a.0.total_cmp(&b.0)) else { return Vec::new() };
    let mut suggestions = Vec::new();
    let swap = on_the_way().filter(|clash| swap_gain(motion, clash) > 0.0).min_by(|a, b| a.distance.total_cmp(&b.distance));
    suggestions.extend(swap.map(|clash| Suggestion::Swap { agents: clash.agents }));
    if on_the_way().next().is_some() {
        suggestions.push(Suggestion::Assign);
    }
    if choice.method != MethodName::Linear {
        suggestions.push(Suggestion::Straight);
    }
    if choice.method == MethodName::Spectral && choice.sharing < 1.0 {
        suggestions.push(Suggestion::Sharing { sharing: 1.0 });
    }
    let kept = (nearest * CENTIMETERS).floor() / CENTIMETERS;
    if (LEAST_DISTANCE..minimum_distance).contains(&kept) {
        suggestions.push(Suggestion::Distance { distance: kept });
    }
    suggestions.push(Suggestion::Keyframe { time });
    suggestions
}

/// By how much the sum of squared ways shrinks when two swap their places in the target, m².
fn swap_gain(motion: &Motion, clash: &Approach) -> f64 {
    let [source, target] = [motion.places(0), motion.places(motion.times().len() - 1)];
    let (a, b) = (clash.agents.0 as usize, clash.agents.1 as usize);
    let way = |from: usize, to: usize| source.at(from).distance_squared(target.at(to));
    way(a, a) + way(b, b) - way(a, b) - way(b, a)
}

#[cfg(test)]
mod tests {
    use glam::DVec2;

    use super::*;
    use crate::choice::{Alignment, Order};
    use crate::edits::{Blocked, Breach, Other, ShutOff};

    #[test]
    fn two_who_cross_are_offered_to_swap_before_anything_else() {
        let [west, east] = [DVec2::new(-3.0, 0.0), DVec2::new(3.0, 0.0)];
        let motion = Motion::new(vec![0.0, 1.0], 2, vec![west, east, east, west]);
        let clash = Approach { distance: 0.237, time: 0.5, agents: (0, 1) };
        let report = AvoidanceReport { unsolved: vec![clash], ..AvoidanceReport::default() };
        let choice = Choice { method: MethodName::Spectral, order: Order::Greedy, alignment: Alignment::Pca, sharing: 0.5 };
        let expected = [
            Suggestion::Swap { agents: (0, 1) },
            Suggestion::Assign,
            Suggestion::Straight,
            Suggestion::Sharing { sharing: 1.0 },
            Suggestion::Distance { distance: 0.23 },
            Suggestion::Keyframe { time: 0.5 },
        ];
        assert_eq!(suggestions(&report, &motion, &choice, 0.5), expected);
        assert_eq!(suggestions(&AvoidanceReport::default(), &motion, &choice, 0.5), []);
        // The two stand too near in a keyframe: nothing on the way mends that, but where they cross before it.
        let breaches = vec![Breach { end: 1, agent: 0, other: Other::Agent(1), distance: 0.3 }];
        let report = AvoidanceReport { breaches, ..report };
        assert_eq!(suggestions(&report, &motion, &choice, 0.5), expected);
        let unsolved = vec![Approach { time: 1.0, ..clash }];
        assert_eq!(suggestions(&AvoidanceReport { unsolved, ..report }, &motion, &choice, 0.5), []);
        // In both keyframes: nothing between mends that, save where they come nearer yet.
        let breaches = [0, 1].map(|end| Breach { end, agent: 0, other: Other::Agent(1), distance: 0.3 }).to_vec();
        let report = AvoidanceReport { breaches, ..AvoidanceReport::default() };
        assert_eq!(suggestions(&AvoidanceReport { unsolved: vec![clash], ..report.clone() }, &motion, &choice, 0.5), expected);
        let side_by_side = vec![Approach { distance: 0.3, ..clash }];
        assert_eq!(suggestions(&AvoidanceReport { unsolved: side_by_side, ..report }, &motion, &choice, 0.5), []);
        // An obstacle in the way: a swap and other places are no help, a keyframe where it is nearest is.
        let blocked = vec![Blocked { distance: -0.2, time: 0.7, agent: 1, obstacle: 0 }];
        let report = AvoidanceReport { blocked, ..AvoidanceReport::default() };
        let expected = [Suggestion::Straight, Suggestion::Sharing { sharing: 1.0 }, Suggestion::Keyframe { time: 0.7 }];
        assert_eq!(suggestions(&report, &motion, &choice, 0.5), expected);
        let shut_off = vec![ShutOff { agent: 1, obstacle: 0, distance: 0.5 }];
        assert_eq!(suggestions(&AvoidanceReport { shut_off, ..report }, &motion, &choice, 0.5), []);
    }
}
