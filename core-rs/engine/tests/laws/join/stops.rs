//! Where the agents stop, and what a stop keeps apart.

use eigenform::choice::{Join, Timing};
use eigenform::scene::Scene;
use glam::DVec2;

use super::meeting::velocities;
use super::show::{blocks, choices, extent, generic, performed, positions, show, with_timing};
use crate::transition::cases::farthest;

const FRACTIONS: [f64; 5] = [0.0, 0.2, 0.5, 0.83, 1.0];

fn same(one: &Scene, segment: usize, other: &Scene, of_other: usize) -> bool {
    positions(&performed(one), segment, &FRACTIONS) == positions(&performed(other), of_other, &FRACTIONS)
}

#[test]
fn between_two_stops_every_join_is_a_separate_segment() {
    let two = &blocks()[..2];
    for choice in choices() {
        for join in [Join::Smooth, Join::Product] {
            assert!(same(&show(two, join, choice), 0, &show(two, Join::Separate, choice), 0), "{join:?} {choice:?}");
            let mut cornered = show(&blocks(), join, choice);
            cornered.tracks[0].keyframes[1].corner = true;
            cornered.tracks[0].keyframes[2].corner = true;
            assert!(same(&cornered, 1, &show(&blocks(), Join::Separate, choice), 1), "{join:?} {choice:?}");
        }
    }
}

#[test]
fn corners_holds_and_both_ends_of_the_show_are_stops() {
    for choice in choices() {
        let mut scene = show(&generic(9), Join::Smooth, choice);
        scene.tracks[0].keyframes[1].corner = true;
        scene.tracks[0].keyframes[3].hold = 0.25;
        let performance = performed(&scene);
        let stands = |velocities: &[DVec2]| farthest(velocities, &[DVec2::ZERO; 9]) < 1e-6 * extent(&scene);
        let sides: Vec<[bool; 2]> = (0..4).map(|index| velocities(&scene, &performance, index).map(|v| stands(&v))).collect();
        assert_eq!(sides, [[true, true], [true, false], [false, true], [true, true]], "{choice:?}");
    }
}

#[test]
fn nothing_beyond_a_stop_matters() {
    for choice in choices() {
        let mut formations = generic(9);
        let mut scene = show(&formations, Join::Smooth, choice);
        formations[4] = blocks()[4][..9].to_vec();
        let mut other = show(&formations, Join::Smooth, choice);
        for scene in [&mut scene, &mut other] {
            scene.tracks[0].keyframes[3].corner = true;
        }
        for segment in 0..3 {
            assert!(same(&scene, segment, &other, segment), "{choice:?}, segment {segment}");
        }
    }
}

#[test]
fn a_show_of_stops_moves_with_the_timing_asked_for() {
    let scene = show(&generic(6)[..2], Join::Smooth, choices()[0]);
    let [eased, linear] = [Timing::Smooth, Timing::Linear].map(|timing| performed(&with_timing(scene.clone(), timing)));
    // 3t² − 2t³ at a quarter.
    assert!(farthest(&positions(&eased, 0, &[0.25])[0], &positions(&linear, 0, &[0.15625])[0]) < 1e-12);
}
