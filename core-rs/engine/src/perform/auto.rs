//! What `auto` tries, and how it decides.

use super::performed::Candidate;
use crate::choice::{Alignment, Choice, DEFAULT_SHARING, MethodName, Order};
use crate::measure::Score;

/// Above this many agents fewer spectral candidates are tried: each costs a dense eigenproblem.
pub(super) const FULL_TRIAL_LIMIT: usize = 400;

/// Frames that a candidate is judged on: t = 0, 1/16, …, 1.
pub(super) const TRIAL_FRAMES: usize = 17;

/// The ways to try, in the order in which the first of equals wins.
pub(super) fn choices(agent_count: usize) -> Vec<Choice> {
    let plain = |method| choice(method, Order::Greedy, Alignment::Procrustes, DEFAULT_SHARING);
    let mut tried = vec![plain(MethodName::Linear), plain(MethodName::Polar), plain(MethodName::Shared)];
    let is_large = agent_count > FULL_TRIAL_LIMIT;
    let alignments: &[Alignment] = if is_large { &[Alignment::Procrustes] } else { &[Alignment::None, Alignment::Procrustes] };
    let sharings: &[f64] = if is_large { &[DEFAULT_SHARING] } else { &[0.0, DEFAULT_SHARING] };
    for order in [Order::Greedy, Order::Hungarian] {
        for &alignment in alignments {
            for &sharing in sharings {
                tried.push(choice(MethodName::Spectral, order, alignment, sharing));
            }
        }
    }
    tried
}

fn choice(method: MethodName, order: Order, alignment: Alignment, sharing: f64) -> Choice {
    Choice { method, order, alignment, sharing }
}

/// The instants that a candidate is judged at.
pub(super) fn trial_parameters() -> Vec<f64> {
    (0..TRIAL_FRAMES).map(|frame| frame as f64 / (TRIAL_FRAMES - 1) as f64).collect()
}

/// The table with the least score marked, the first of equals.
pub(super) fn decide(tried: Vec<(Choice, Score)>) -> Vec<Candidate> {
    let mut best = 0;
    for (index, (_, score)) in tried.iter().enumerate() {
        if score.total < tried[best].1.total {
            best = index;
        }
    }
    tried.into_iter().enumerate().map(|(index, (choice, score))| candidate(choice, &score, index == best)).collect()
}

/// A row of the table.
pub(super) fn candidate(choice: Choice, score: &Score, is_chosen: bool) -> Candidate {
    let Score { distortion, turning, clearance, total } = *score;
    Candidate { choice, distortion, turning, clearance, score: total, is_chosen }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn scored(total: f64) -> Score {
        Score { distortion: 0.0, turning: 0.0, clearance: None, total }
    }

    #[test]
    fn the_first_of_equals_is_kept() {
        let tried = choices(25).into_iter().zip([0.3, 0.2, 0.2]).map(|(choice, total)| (choice, scored(total))).collect();
        let kept: Vec<bool> = decide(tried).iter().map(|candidate| candidate.is_chosen).collect();
        assert_eq!(kept, [false, true, false]);
    }

    #[test]
    fn many_agents_are_tried_fewer_ways() {
        assert_eq!(choices(FULL_TRIAL_LIMIT).len(), 11);
        assert_eq!(choices(FULL_TRIAL_LIMIT + 1).len(), 5);
    }
}
