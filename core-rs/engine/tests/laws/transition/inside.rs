//! What holds between the ends: where the formation is, and how large.

use eigenform::choice::MethodName;
use glam::DVec2;

use super::cases::{all_cases, choices, motion};

const TS: [f64; 6] = [0.0, 0.2, 0.5, 0.6, 0.9, 1.0];

fn barycenter(points: &[DVec2]) -> DVec2 {
    points.iter().sum::<DVec2>() / (points.len().max(1)) as f64
}

fn size(points: &[DVec2]) -> f64 {
    let center = barycenter(points);
    points.iter().map(|p| p.distance_squared(center)).sum::<f64>().sqrt()
}

#[test]
fn the_barycenter_goes_straight_and_evenly() {
    for case in all_cases() {
        let mut planner = case.planned();
        let tolerance = 1e-9 * case.extent().max(1.0);
        for choice in choices().into_iter().filter(|choice| choice.method != MethodName::Polar) {
            for (frame, t) in motion(&mut planner, &choice, false, &TS).iter().zip(TS) {
                let off = barycenter(frame).distance(barycenter(&case.source).lerp(barycenter(&case.target), t));
                assert!(off <= tolerance, "{}: {choice:?} is off by {off:e} at t = {t}", case.name);
            }
        }
    }
}

#[test]
fn a_formation_never_shrinks_below_the_root_of_its_ends() {
    for case in all_cases() {
        let mut planner = case.planned();
        let [from, to] = [size(&case.source), size(&case.target)];
        // Modes too small to have a direction (1e-7 of the greatest) enter with their residuals: squares of 1e-14.
        let tolerance = 1e-9 * (from + to).max(1.0);
        for choice in choices().into_iter().filter(|choice| matches!(choice.method, MethodName::Spectral | MethodName::Shared)) {
            for (frame, t) in motion(&mut planner, &choice, false, &TS).iter().zip(TS) {
                let least = ((1.0 - t) * from).hypot(t * to);
                assert!(size(frame) >= least - tolerance, "{}: {choice:?} shrinks to {} of {least} at t = {t}", case.name, size(frame));
            }
        }
    }
}

#[test]
fn a_formation_that_keeps_its_size_has_it_at_every_instant() {
    for case in all_cases() {
        let mut planner = case.planned();
        let [from, to] = [size(&case.source), size(&case.target)];
        // Barycenters are known to eps of the distance from the origin.
        let tolerance = 1e-9 * (from + to).max(1.0);
        for choice in choices().into_iter().filter(|choice| matches!(choice.method, MethodName::Spectral | MethodName::Shared)) {
            for (frame, t) in motion(&mut planner, &choice, true, &TS).iter().zip(TS) {
                let expected = (1.0 - t) * from + t * to;
                assert!(
                    (size(frame) - expected).abs() <= tolerance,
                    "{}: {choice:?} has {} for {expected} at t = {t}",
                    case.name,
                    size(frame)
                );
            }
        }
    }
}
