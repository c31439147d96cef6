//! Where auto's way cannot be kept apart: other guides, the likeliest first.
//!
//! Straight ways, and bases that meet halfway so that nothing is left to turn, keep lanes open that a turning formation closes.
//! Only for segments between two stops: elsewhere the neighbors were planned to meet the way that auto chose.

use super::auto;
use super::avoid::Kept;
use super::brief::Brief;
use super::clock::Clock;
use super::plan::Plan;
use super::sampling::Sampling;
use crate::choice::{Alignment, Choice, MethodName, Order};

/// A segment moved one way and kept apart as far as it goes.
pub(super) struct Attempt {
    pub(super) plan: Plan,
    pub(super) clock: Clock,
    pub(super) samples: Sampling,
    pub(super) kept: Kept,
}

/// Ways still to try, and the best so far.
#[derive(Default)]
pub(super) struct Resorts {
    /// None: nothing failed yet.
    left: Option<Vec<Choice>>,
    best: Option<Box<Attempt>>,
}

/// What follows an attempt.
pub(super) enum Next {
    /// Another way.
    Try(Box<Plan>),
    /// There is no better one.
    Keep(Box<Attempt>),
}

impl Resorts {
    /// Takes an attempt in; fewest meetings too near is best, the first of equals.
    pub(super) fn after(&mut self, attempt: Attempt, brief: &Brief) -> Next {
        let left = self.left.get_or_insert_with(|| ways(&attempt, brief));
        let is_better = self.best.as_ref().is_none_or(|best| attempt.kept.unsolved_count() < best.kept.unsolved_count());
        let attempt = if is_better { Box::new(attempt) } else { self.best.take().expect("what is not better has a best before it") };
        match left.pop() {
            Some(choice) if attempt.kept.unsolved_count() > 0 => {
                let plan = attempt.plan.by(choice, brief.own.transition.keep_size);
                self.best = Some(attempt);
                Next::Try(Box::new(plan))
            }
            _ => Next::Keep(attempt),
        }
    }

    /// Whether the first way failed.
    pub(super) fn are_needed(&self) -> bool {
        self.best.is_some()
    }
}

/// Last first.
fn ways(attempt: &Attempt, brief: &Brief) -> Vec<Choice> {
    let is_fixed = brief.own.given().is_some() || brief.own.transition.hierarchy || brief.stops() != [true, true];
    let is_large = attempt.plan.chain.agent_count() > auto::FULL_TRIAL_LIMIT;
    if is_fixed || is_large || attempt.kept.has_breaches() {
        return Vec::new();
    }
    let halfway = |order, alignment| Choice { method: MethodName::Spectral, order, alignment, sharing: 1.0 };
    let straight = Choice { method: MethodName::Linear, ..halfway(Order::Greedy, Alignment::Procrustes) };
    let mut ways = vec![
        halfway(Order::Greedy, Alignment::Pca),
        halfway(Order::Hungarian, Alignment::None),
        halfway(Order::Hungarian, Alignment::Procrustes),
    ];
    if attempt.plan.ways.own.choice.method != MethodName::Linear {
        ways.push(straight);
    }
    ways
}
