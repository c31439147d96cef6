//! What holds at the ends, that there is an answer in between, and how small a formation may get.

use eigenform::choice::MethodName;
use eigenform::formation::Formation;
use eigenform::transition::Planner;
use glam::DVec3;

use super::cases::{block, center, chain, choices, farthest, formation, helix, motion, scattered, sphere};

fn pairs() -> Vec<(&'static str, Vec<DVec3>, Vec<DVec3>)> {
    let reversed = |points: Vec<DVec3>| points.into_iter().rev().collect();
    let wall = |points: Vec<DVec3>| -> Vec<DVec3> { points.into_iter().map(|point| DVec3::new(point.x, 0.0, point.y)).collect() };
    let here = DVec3::new(3.0, -2.0, 7.0);
    let mut twins = scattered(9, 11);
    twins[4] = twins[2];
    vec![
        ("nobody", vec![], vec![]),
        ("one agent", vec![here], vec![-here]),
        ("two agents change places", vec![here, -here], vec![-here, here]),
        ("all in one place", vec![here; 6], vec![-here; 6]),
        ("from one place", vec![here; 7], scattered(7, 16)),
        ("scattered", scattered(20, 1), scattered(20, 2)),
        ("twins", twins, scattered(9, 18)),
        ("from the ground", block(5, 4, 1), scattered(20, 3)),
        ("a block stands up", block(5, 4, 1), wall(block(5, 4, 1))),
        ("a block to a sphere", block(3, 3, 3), sphere(27, 4.0)),
        ("a sphere to its reverse", sphere(20, 4.0), reversed(sphere(20, 4.0))),
        ("a helix", helix(16), reversed(helix(16))),
        ("a line stands up", (0..7).map(|i| DVec3::X * f64::from(i)).collect(), (0..7).map(|i| DVec3::Z * f64::from(i)).collect()),
        ("a line to its reverse", (0..7).map(|i| DVec3::Z * f64::from(i)).collect(), (0..7).map(|i| DVec3::Z * f64::from(-i)).collect()),
        ("a mirror image", scattered(12, 20), scattered(12, 20).iter().map(|p| DVec3::new(p.x, p.y, -p.z)).collect()),
        ("very large", scattered(10, 21).iter().map(|p| *p * 1e4).collect(), scattered(10, 22).iter().map(|p| *p * 1e4).collect()),
        ("very small", scattered(10, 21).iter().map(|p| *p * 1e-6).collect(), scattered(10, 22).iter().map(|p| *p * 1e-6).collect()),
        ("hardly lifted", block(4, 4, 1).iter().map(|p| p.with_z(1e-9 * p.x * p.y)).collect(), block(4, 4, 1)),
    ]
}

fn radius(points: &[DVec3]) -> f64 {
    let center = center(points);
    points.iter().map(|point| point.distance_squared(center)).sum::<f64>().sqrt()
}

#[test]
fn every_method_leaves_and_arrives_exactly_and_is_finite_in_between() {
    for (name, source, target) in pairs() {
        let [from, to] = [&source, &target].map(|points| formation(points));
        let tolerance = 1e-9 * f64::max(1.0, from.extent().max(to.extent()));
        let (mut planner, chain) = (Planner::default(), chain(&from, &to));
        for choice in choices() {
            for keep_size in [false, true] {
                let frames = motion(&mut planner, &chain, &choice, keep_size, &[0.0, 0.3, 0.5, 1.0]);
                assert!(farthest(&frames[0], &source) <= tolerance, "{name}: {choice:?} leaves from elsewhere");
                assert!(farthest(&frames[3], &target) <= tolerance, "{name}: {choice:?} arrives elsewhere");
                assert!(frames.iter().flatten().all(|place| place.is_finite()), "{name}: {choice:?}");
            }
        }
    }
}

#[test]
fn the_barycenter_goes_straight() {
    for (name, source, target) in pairs().into_iter().filter(|(_, source, _)| !source.is_empty()) {
        let [from, to] = [&source, &target].map(|points| formation(points));
        let (mut planner, chain) = (Planner::default(), chain(&from, &to));
        for choice in choices().into_iter().filter(|choice| choice.method != MethodName::Polar) {
            let middle = &motion(&mut planner, &chain, &choice, false, &[0.3])[0];
            let due = center(&source).lerp(center(&target), 0.3);
            let tolerance = 1e-9 * f64::max(1.0, from.extent().max(to.extent()));
            assert!(center(middle).distance(due) <= tolerance, "{name}: {choice:?}");
        }
    }
}

/// The squared radius is at least (1 − t)² times that of the source plus t² times that of the target: nothing but the lengths of
/// coefficients shrinks a formation.
#[test]
fn a_formation_never_shrinks_below_its_share_of_both_ends() {
    for (name, source, target) in pairs().into_iter().filter(|(_, source, _)| !source.is_empty()) {
        let [from, to] = [&source, &target].map(|points| formation(points));
        let (mut planner, chain) = (Planner::default(), chain(&from, &to));
        let is_bound = |method| matches!(method, MethodName::Spectral | MethodName::Shared);
        for choice in choices().into_iter().filter(|choice| is_bound(choice.method)) {
            for (frame, t) in motion(&mut planner, &chain, &choice, false, &[0.25, 0.5, 0.8]).iter().zip([0.25, 0.5, 0.8]) {
                let least = ((1.0 - t) * radius(&source)).hypot(t * radius(&target));
                // Residuals of what has no direction are 1e-7 of the greatest coefficient.
                assert!(radius(frame) >= least * (1.0 - 1e-6), "{name}: {choice:?} at {t}");
            }
        }
    }
}

#[test]
fn keeping_the_size_lets_it_run_straight() {
    let [from, to] = [formation(&scattered(20, 1)), formation(&scattered(20, 2))];
    let (mut planner, chain) = (Planner::default(), chain(&from, &to));
    for choice in choices().into_iter().filter(|choice| matches!(choice.method, MethodName::Spectral | MethodName::Shared)) {
        let middle = &motion(&mut planner, &chain, &choice, true, &[0.5])[0];
        let due = f64::midpoint(radius(&scattered(20, 1)), radius(&scattered(20, 2)));
        assert!((radius(middle) - due).abs() < 1e-9 * due, "{choice:?}");
    }
}

#[test]
fn a_formation_from_the_plane_and_one_in_space_are_the_same_to_a_method() {
    let plan = Formation::new(block(4, 4, 1).iter().map(|point| point.truncate()).collect());
    let [level, to] = [formation(&block(4, 4, 1)), formation(&scattered(16, 4))];
    for choice in choices() {
        let [one, other] = [&plan, &level].map(|from| motion(&mut Planner::default(), &chain(from, &to), &choice, false, &[0.4]));
        assert_eq!(one, other, "{choice:?}");
    }
}
