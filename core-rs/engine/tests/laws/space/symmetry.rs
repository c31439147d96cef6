//! A motion follows its formations: new labels, another place and attitude, another scale.

use eigenform::choice::Choice;
use eigenform::transition::Planner;
use glam::DVec3;

use super::cases::{Rigid, block, chain, choices, farthest, formation, helix, motion, scattered, sphere};

const TS: [f64; 4] = [0.1, 0.5, 0.77, 1.0];

/// Pairs without a symmetry that takes both ends to themselves; with how near laws hold, relative to the extent.
fn pairs() -> Vec<(&'static str, Vec<DVec3>, Vec<DVec3>, f64)> {
    let from = scattered(20, 3);
    let turned = Rigid::new([1.0, -1.0, 2.0], 0.8, [0.0; 3]).apply(&from);
    let shaken = turned.iter().zip(scattered(20, 4)).map(|(p, q)| *p + 0.05 * q).collect();
    vec![
        ("scattered 5", scattered(5, 1), scattered(5, 2), 1e-9),
        ("scattered 25", scattered(25, 1), scattered(25, 2), 1e-9),
        ("a turned copy, shaken", from, shaken, 1e-9),
        ("from the ground", scattered(16, 5).iter().map(|p| p.with_z(0.0)).collect(), scattered(16, 6), 1e-9),
        // Where eigenvalues repeat, the tie-break decides.
        ("block to a scatter", block(3, 3, 2), scattered(18, 7), 1e-7),
        ("sphere to a scatter", sphere(14, 5.0), scattered(14, 8), 1e-7),
        ("helix to a scatter", helix(14), scattered(14, 9), 1e-7),
    ]
}

fn check(through: &dyn Fn(&[DVec3]) -> Vec<DVec3>, scale: f64, is_lawful: &dyn Fn(&Choice) -> bool) {
    for (name, source, target, relative) in pairs() {
        let [from, to, from_changed, to_changed] =
            [source.clone(), target.clone(), through(&source), through(&target)].map(|points| formation(&points));
        let tolerance = relative * scale * from.extent().max(to.extent());
        let (mut planner, mut other) = (Planner::default(), Planner::default());
        let (chain, chain_changed) = (chain(&from, &to), chain(&from_changed, &to_changed));
        for choice in choices().into_iter().filter(|choice| is_lawful(choice)) {
            let frames = motion(&mut planner, &chain, &choice, false, &TS);
            let others = motion(&mut other, &chain_changed, &choice, false, &TS);
            for ((frame, other), t) in frames.iter().zip(&others).zip(TS) {
                let off = farthest(&through(frame), other);
                assert!(off <= tolerance, "{name}: {choice:?} is off by {off:e} at t = {t}");
            }
        }
    }
}

#[test]
fn new_labels_relabel_the_paths_and_nothing_else() {
    let relabel = |points: &[DVec3]| {
        let count = points.len();
        // A stride without a common factor visits every agent once.
        let step = [7, 11, 13].into_iter().find(|step| !count.is_multiple_of(*step)).unwrap_or(1);
        (0..count).map(|i| points[(i * step + 1) % count]).collect()
    };
    check(&relabel, 1.0, &|_| true);
}

#[test]
fn a_common_rigid_motion_moves_the_paths() {
    for rigid in [
        Rigid::new([0.0, 0.0, 1.0], 0.4, [30.0, -7.0, 2.0]),
        Rigid::new([1.0, 0.5, -0.3], 2.9, [0.0; 3]),
        Rigid::new([-1.0, 2.0, 0.0], 1.7, [-100.0, 250.0, 30.0]),
    ] {
        check(&|points: &[DVec3]| rigid.apply(points), 1.0, &|_| true);
    }
}

#[test]
fn a_common_scale_scales_the_paths() {
    for scale in [1e-3, 0.3, 70.0] {
        check(&|points: &[DVec3]| points.iter().map(|p| *p * scale).collect(), scale, &|_| true);
    }
}

#[test]
fn a_mirror_mirrors_the_paths() {
    check(&|points: &[DVec3]| points.iter().map(|p| DVec3::new(p.x, p.y, -p.z)).collect(), 1.0, &|_| true);
}
