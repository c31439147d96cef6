//! What holds at the ends, and that there is an answer in between.

use eigenform::transition::Planner;

use super::cases::{all_cases, choices, farthest, motion};

#[test]
fn both_ends_are_exact_and_no_answer_is_nan() {
    for case in all_cases() {
        let mut planner = Planner::new(case.ends());
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
}
