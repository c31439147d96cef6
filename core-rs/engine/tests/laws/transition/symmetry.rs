//! A motion follows its formations: new labels, another place on the stage, another scale, a mirror.

use eigenform::choice::{Choice, MethodName, Order};
use glam::DVec2;

use super::cases::{Case, choices, farthest, generic, motion, symmetric, symmetric_in_step};

const TS: [f64; 4] = [0.1, 0.5, 0.77, 1.0];

/// Checks that the motion of `changed` is the motion of `case` with every frame through `through`.
fn check(case: &Case, changed: &Case, tolerance: f64, through: impl Fn(&[DVec2]) -> Vec<DVec2>) {
    let (mut planner, mut other) = (case.planned(), changed.planned());
    let is_lawful = |choice: &Choice| !case.is_in_step || choice.method != MethodName::Spectral || choice.order != Order::Eigenvalue;
    for choice in choices().into_iter().filter(is_lawful) {
        let frames = motion(&mut planner, &choice, false, &TS);
        let others = motion(&mut other, &choice, false, &TS);
        for ((frame, other), t) in frames.iter().zip(&others).zip(TS) {
            let off = farthest(&through(frame), other);
            assert!(off <= tolerance, "{} {}: {choice:?} is off by {off:e} at t = {t}", case.name, changed.name);
        }
    }
}

/// Visits cases with their tolerance. Paths through simple spectra lose eps over the least gap that needs no tie-break, 1e-6; with
/// the tie-break, modes a thousand times as near and coefficients a millionth of the formation decide.
fn for_each(cases: Vec<Vec<Case>>, law: impl Fn(&Case, f64)) {
    for case in cases.into_iter().flatten() {
        law(&case, if case.is_symmetric { 1e-7 } else { 1e-9 } * case.extent());
    }
}

fn changed(case: &Case, how: &str, through: impl Fn(&[DVec2]) -> Vec<DVec2>) -> Case {
    Case { name: how.into(), source: through(&case.source), target: through(&case.target), ..case.clone() }
}

#[test]
fn new_labels_relabel_the_paths_and_nothing_else() {
    for_each(vec![generic(), symmetric(), symmetric_in_step()], |case, tolerance| {
        for step in [5, 7, 11, 13] {
            let count = case.source.len();
            // A stride without a common factor visits every agent once.
            if (1..=count).filter(|d| count % d == 0 && step % d == 0).count() > 1 {
                continue;
            }
            let relabel = |points: &[DVec2]| (0..count).map(|i| points[(i * step + 1) % count]).collect();
            check(case, &changed(case, "relabeled", relabel), tolerance, relabel);
        }
    });
}

#[test]
fn a_common_rigid_motion_moves_the_paths() {
    for_each(vec![generic(), symmetric(), symmetric_in_step()], |case, tolerance| {
        for (angle, shift) in [(0.4, DVec2::new(30.0, -7.0)), (2.9, DVec2::ZERO), (-1.7, DVec2::new(-100.0, 250.0))] {
            let moved = |points: &[DVec2]| points.iter().map(|p| DVec2::from_angle(angle).rotate(*p) + shift).collect();
            check(case, &changed(case, "moved", moved), tolerance, moved);
        }
    });
}

#[test]
fn a_common_scale_scales_the_paths() {
    for_each(vec![generic(), symmetric(), symmetric_in_step()], |case, tolerance| {
        for scale in [1e-3, 0.3, 70.0] {
            let scaled = |points: &[DVec2]| points.iter().map(|p| *p * scale).collect();
            check(case, &changed(case, "scaled", scaled), tolerance * scale, scaled);
        }
    });
}

#[test]
fn a_mirror_mirrors_the_paths() {
    for_each(vec![generic(), symmetric()], |case, tolerance| {
        let mirrored = |points: &[DVec2]| points.iter().map(|p| DVec2::new(-p.x, p.y)).collect();
        check(case, &changed(case, "mirrored", mirrored), tolerance, mirrored);
    });
}
