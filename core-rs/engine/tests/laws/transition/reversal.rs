//! Played backwards, the way there is the way back; where the order of modes does not depend on who chooses first.

use eigenform::choice::{MethodName, Order};

use super::cases::{Case, choices, farthest, generic, motion, symmetric};

const TS: [f64; 5] = [0.0, 0.2, 0.5, 0.9, 1.0];

fn check(case: &Case, tolerance: f64) {
    let back = Case { name: "back".into(), source: case.target.clone(), target: case.source.clone(), ..case.clone() };
    let (mut there, mut back) = (case.planned(), back.planned());
    let reversed = TS.map(|t| 1.0 - t);
    // Greedy lets the source choose first, and maxmin starts from greedy.
    let is_even = |order| matches!(order, Order::Eigenvalue | Order::Hungarian);
    for choice in choices().into_iter().filter(|choice| choice.method != MethodName::Spectral || is_even(choice.order)) {
        let frames = motion(&mut there, &choice, false, &TS);
        let others = motion(&mut back, &choice, false, &reversed);
        for ((frame, other), t) in frames.iter().zip(&others).zip(TS) {
            let off = farthest(frame, other);
            assert!(off <= tolerance, "{}: {choice:?} is off by {off:e} at t = {t}", case.name);
        }
    }
}

#[test]
fn the_way_back_is_the_way_there_reversed() {
    for case in [generic(), symmetric()].concat() {
        // As for the other laws: eps over the least gap, and the tie-break where eigenvalues repeat.
        check(&case, if case.is_symmetric { 1e-7 } else { 1e-9 } * case.extent());
    }
}
