//! What holds at the ends, and that there is an answer in between.

use glam::DVec2;
use proptest::prelude::*;

use super::cases::{Case, all_cases, choices, farthest, motion};
use crate::formations::any_formation;

fn check(case: &Case) {
    let mut planner = case.planned();
    let tolerance = 1e-9 * case.extent().max(1.0);
    for choice in choices() {
        for keep_size in [false, true] {
            let frames = motion(&mut planner, &choice, keep_size, &[0.0, 0.25, 0.5, 0.75, 1.0]);
            let off = farthest(&frames[0], &case.source).max(farthest(&frames[4], &case.target));
            assert!(off <= tolerance, "{}: {choice:?} misses an end by {off:e}", case.name);
            assert!(frames.iter().flatten().all(|p| p.is_finite()), "{}: {choice:?}", case.name);
        }
    }
}

#[test]
fn both_ends_are_exact_and_no_answer_is_nan() {
    for case in all_cases() {
        check(&case);
    }
}

/// Twins, lines, far clusters, grids and rings against one another.
fn any_pair() -> impl Strategy<Value = (Vec<DVec2>, Vec<DVec2>)> {
    (any_formation(), any_formation()).prop_map(|(mut source, mut target)| {
        let count = source.len().min(target.len());
        source.truncate(count);
        target.truncate(count);
        (source, target)
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(60))]

    #[test]
    fn any_two_formations_have_exact_ends((source, target) in any_pair()) {
        check(&Case::new("any pair", source, target));
    }
}
