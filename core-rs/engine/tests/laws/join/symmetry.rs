//! A joined motion follows its formations: new labels, another place, another scale, a mirror, the way back.

use eigenform::choice::{Choice, Join, MethodName};
use glam::DVec2;

use super::show::{blocks, choices, generic, performed, positions, show, symmetric};
use crate::transition::cases::farthest;

const TS: [f64; 4] = [0.1, 0.5, 0.77, 1.0];

/// Checks that the motion of the changed formations is the motion with every frame through `through`, to `tolerance`.
fn check(how: &str, scale: f64, is_lawful: impl Fn(&Choice) -> bool, through: impl Fn(&[DVec2]) -> Vec<DVec2>) {
    // As for one segment: eps over the least gap, and the tie-break where eigenvalues repeat.
    for (formations, tolerance) in [(generic(9), 1e-9), (generic(20), 1e-9), (blocks(), 1e-9), (symmetric(), 1e-7)] {
        let changed: Vec<Vec<DVec2>> = formations.iter().map(|formation| through(formation)).collect();
        for choice in choices().into_iter().filter(&is_lawful) {
            let one = performed(&show(&formations, Join::Smooth, choice));
            let other = performed(&show(&changed, Join::Smooth, choice));
            for segment in 0..4 {
                for (frame, changed) in positions(&one, segment, &TS).iter().zip(positions(&other, segment, &TS)) {
                    let off = farthest(&through(frame), &changed);
                    let tolerance = 30.0 * scale * tolerance;
                    assert!(off <= tolerance, "{how}, {} agents, {choice:?}, segment {segment}: off by {off:e}", frame.len());
                }
            }
        }
    }
}

#[test]
fn new_labels_relabel_the_paths_and_nothing_else() {
    check("relabeled", 1.0, |_| true, |points| (0..points.len()).map(|i| points[(7 * i + 1) % points.len()]).collect());
}

#[test]
fn a_common_rigid_motion_moves_the_paths() {
    check("moved", 1.0, |_| true, |points| points.iter().map(|p| DVec2::from_angle(2.9).rotate(*p) + DVec2::new(30.0, -7.0)).collect());
}

#[test]
fn a_common_scale_scales_the_paths() {
    check("scaled", 70.0, |_| true, |points| points.iter().map(|p| *p * 70.0).collect());
}

#[test]
fn a_mirror_mirrors_the_paths() {
    check("mirrored", 1.0, |_| true, |points| points.iter().map(|p| DVec2::new(-p.x, p.y)).collect());
}

/// The spectral way takes its rotations one after another, and these do not commute: it has no way back.
#[test]
fn played_backwards_the_way_there_is_the_way_back_where_modes_do_not_turn() {
    for (formations, tolerance) in [(generic(9), 1e-9), (blocks(), 1e-9), (symmetric(), 1e-7)] {
        for choice in choices().into_iter().filter(|choice| choice.method != MethodName::Spectral) {
            let scene = show(&formations, Join::Smooth, choice);
            let mut back = scene.clone();
            let end = scene.duration() + 1.0;
            back.tracks[0].keyframes.reverse();
            back.tracks[0].keyframes.iter_mut().for_each(|keyframe| keyframe.time = end - keyframe.time);
            let [there, back] = [&scene, &back].map(performed);
            for segment in 0..4 {
                let reversed = positions(&back, 3 - segment, &TS.map(|t| 1.0 - t));
                for (frame, other) in positions(&there, segment, &TS).iter().zip(reversed) {
                    let off = farthest(frame, &other);
                    assert!(off <= 30.0 * tolerance, "{} agents, {choice:?}, segment {segment}: off by {off:e}", frame.len());
                }
            }
        }
    }
}
