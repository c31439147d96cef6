//! Every keyframe is reached exactly, and passed with one velocity.

use eigenform::choice::{Alignment, Choice, Join, MethodName, Order, Timing};
use eigenform::scene::Scene;
use glam::DVec2;

use super::show::{blocks, choice, choices, degenerate, extent, generic, performed, positions, segment, show, spec, symmetric};
use crate::transition::cases::farthest;

fn check_ends(name: &str, scene: &Scene) {
    let performance = performed(scene);
    let tolerance = 1e-9 * extent(scene).max(1.0);
    for (index, segment) in performance.segments().iter().enumerate() {
        let motion = &segment.motion;
        for (sample, keyframe) in [(0, index), (motion.times().len() - 1, index + 1)] {
            let expected = scene.tracks[0].keyframes[keyframe].positions.positions();
            let off = farthest(motion.sample(sample), expected);
            assert!(off <= tolerance, "{name}: segment {index} misses keyframe {keyframe} by {off:e}");
        }
        assert!(motion.positions().iter().all(|p| p.is_finite()), "{name}");
    }
}

/// The one-sided difference of third order has an error of step³ times a fourth derivative: turns of up to three half turns
/// give (3π)⁴/4 · 8e-12, 2e-8 of the extent in a segment's time; round-off over the step is below.
const STEP: f64 = 2e-4;

fn velocity(values: [&[DVec2]; 4], step: f64) -> Vec<DVec2> {
    (0..values[0].len())
        .map(|i| (18.0 * values[1][i] - 11.0 * values[0][i] - 9.0 * values[2][i] + 2.0 * values[3][i]) / (6.0 * step))
        .collect()
}

/// Velocities at the start and at the end of a segment, meters a second.
pub fn velocities(scene: &Scene, performance: &eigenform::perform::Performance, segment: usize) -> [Vec<DVec2>; 2] {
    let keyframes = &scene.tracks[0].keyframes;
    let duration = keyframes[segment + 1].time - keyframes[segment].time - keyframes[segment].hold;
    let side = |from: f64, way: f64| {
        let at = positions(performance, segment, &[0.0, 1.0, 2.0, 3.0].map(|k| from + way * k * STEP));
        velocity([&at[0], &at[1], &at[2], &at[3]], way * STEP * duration)
    };
    [side(0.0, 1.0), side(1.0, -1.0)]
}

pub fn check_velocities(name: &str, scene: &Scene) {
    check_ends(name, scene);
    let performance = performed(scene);
    let sides: Vec<[Vec<DVec2>; 2]> = (0..performance.segments().len()).map(|index| velocities(scene, &performance, index)).collect();
    // Over the shortest segment, one second.
    let tolerance = 1e-7 * extent(scene).max(1e-6);
    for (index, pair) in sides.windows(2).enumerate() {
        let off = farthest(&pair[0][1], &pair[1][0]);
        assert!(off <= tolerance, "{name}: velocities at keyframe {} differ by {off:e}", index + 1);
    }
}

#[test]
fn every_method_passes_every_keyframe_with_one_velocity() {
    for (name, formations) in [("generic 9", generic(9)), ("generic 20", generic(20)), ("blocks", blocks()), ("symmetric", symmetric())] {
        for choice in choices() {
            for keeps_size in [false, true] {
                let mut scene = show(&formations, Join::Smooth, choice);
                (0..4).for_each(|index| spec(&mut scene, index).keep_size = keeps_size);
                check_velocities(&format!("{name}, {choice:?}, keeps size: {keeps_size}"), &scene);
            }
        }
    }
}

#[test]
fn segments_with_different_methods_and_options_meet_with_one_velocity() {
    use MethodName::{Linear, Polar, Shared, Spectral};
    let one = |method, sharing| choice(method, Order::Greedy, Alignment::Procrustes, sharing);
    let other = choice(Spectral, Order::Hungarian, Alignment::None, 0.0);
    let mixtures: [[Choice; 4]; 4] = [
        [one(Linear, 0.0), one(Spectral, 0.5), one(Polar, 0.0), one(Shared, 0.0)],
        [one(Spectral, 0.0), one(Spectral, 0.5), other, one(Spectral, 1.0)],
        [one(Spectral, 0.5), one(Linear, 0.0), one(Spectral, 0.3), one(Linear, 0.0)],
        [one(Shared, 0.0), one(Shared, 0.0), one(Spectral, 0.5), one(Polar, 0.0)],
    ];
    for (name, formations) in [("generic", generic(12)), ("blocks", blocks()), ("symmetric", symmetric())] {
        for choices in &mixtures {
            let mut scene = show(&formations, Join::Smooth, choices[0]);
            scene.tracks[0].segments = choices.iter().copied().map(segment).collect();
            spec(&mut scene, 1).keep_size = true;
            check_velocities(&format!("{name}, {choices:?}"), &scene);
        }
    }
}

#[test]
fn what_auto_chooses_meets_with_one_velocity() {
    for formations in [generic(8), blocks()] {
        let scene = show(&formations, Join::Smooth, choice(MethodName::Auto, Order::Greedy, Alignment::Pca, 0.5));
        check_velocities("auto", &scene);
    }
}

#[test]
fn linear_timing_and_any_tension_meet_with_one_velocity() {
    for tension in [0.0, 0.2, 1.0] {
        for choice in choices() {
            let mut scene = show(&generic(9), Join::Smooth, choice);
            scene.tension = tension;
            spec(&mut scene, 1).timing = Timing::Linear;
            check_velocities(&format!("{choice:?}, tension {tension}"), &scene);
        }
    }
}

#[test]
fn no_answer_is_nan_and_every_join_is_exact() {
    for formations in degenerate().into_iter().chain([symmetric(), generic(12)]) {
        for join in [Join::Separate, Join::Smooth, Join::Product] {
            for choice in choices() {
                let mut scene = show(&formations, join, choice);
                check_ends(&format!("{} agents, {join:?}, {choice:?}", formations[0].len()), &scene);
                (0..3).for_each(|index| spec(&mut scene, index).keep_size = true);
                check_ends(&format!("{} agents keep their size, {join:?}, {choice:?}", formations[0].len()), &scene);
            }
        }
    }
}
