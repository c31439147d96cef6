//! What the joins are where a formula says it.

use eigenform::choice::{Alignment, Join, MethodName, Order, Timing};
use eigenform::scene::Scene;
use glam::DVec2;

use super::show::{choice, extent, generic, performed, positions, show, with_timing};
use crate::transition::cases::{farthest, scattered, turned};

const TS: [f64; 5] = [0.0, 0.2, 0.5, 0.83, 1.0];

fn with_equal_times(mut scene: Scene) -> Scene {
    for (k, keyframe) in scene.tracks[0].keyframes.iter_mut().enumerate() {
        keyframe.time = 2.0 * k as f64;
    }
    scene
}

/// Paper A's equation 5.
fn catmull_rom(p: [DVec2; 4], t: f64, tension: f64) -> DVec2 {
    let (t2, t3) = (t * t, t * t * t);
    p[0] * tension * (-t + 2.0 * t2 - t3)
        + p[1] * (1.0 - 3.0 * t2 + 2.0 * t3 + tension * (t2 - t3))
        + p[2] * (3.0 * t2 - 2.0 * t3 + tension * (t - 2.0 * t2 + t3))
        + p[3] * tension * (t3 - t2)
}

#[test]
fn straight_ways_at_equal_times_are_catmull_roms() {
    let formations = generic(6);
    for tension in [0.5, 0.8] {
        for join in [Join::Smooth, Join::Product] {
            let linear = choice(MethodName::Linear, Order::Greedy, Alignment::None, 0.0);
            let scene = Scene { tension, ..with_equal_times(show(&formations, join, linear)) };
            let performance = performed(&with_timing(scene, Timing::Linear));
            for segment in 0..4_usize {
                let near = [segment.saturating_sub(1), segment, segment + 1, (segment + 2).min(4)].map(|k| &formations[k]);
                for (at, t) in positions(&performance, segment, &TS).iter().zip(TS) {
                    let expected: Vec<DVec2> = (0..6).map(|i| catmull_rom(near.map(|f| f[i]), t, tension)).collect();
                    assert!(farthest(at, &expected) < 1e-12 * 30.0, "{join:?}, segment {segment} at {t}");
                }
            }
        }
    }
}

/// Three agents have two modes, whose rotations commute: then the cumulative cubic is the paper's product, as long as no logarithm of
/// a product passes a half turn.
#[test]
fn turns_that_commute_and_stay_small_make_the_papers_product() {
    let triangle = [DVec2::new(0.0, 0.0), DVec2::new(6.0, 1.0), DVec2::new(2.5, 3.0)];
    let change = |k: f64| triangle.map(|p| p + 0.4 * k * DVec2::new(p.y - 2.0, 1.5 - p.x * p.x / 6.0)).to_vec();
    let formations: Vec<Vec<DVec2>> = (0..5).map(|k| turned(&change(f64::from(k)), 0.1 * f64::from(k))).collect();
    let spectral = choice(MethodName::Spectral, Order::Eigenvalue, Alignment::Procrustes, 0.0);
    let scenes = [Join::Smooth, Join::Product].map(|join| with_equal_times(show(&formations, join, spectral)));
    let [smooth, product] = scenes.each_ref().map(performed);
    let linear =
        performed(&with_equal_times(show(&formations, Join::Smooth, choice(MethodName::Linear, Order::Greedy, Alignment::None, 0.0))));
    let mut differs = 0.0_f64;
    for segment in 0..4 {
        let [one, other, straight] = [&smooth, &product, &linear].map(|performance| positions(performance, segment, &TS));
        for (k, t) in TS.into_iter().enumerate() {
            let off = farthest(&one[k], &other[k]);
            assert!(off < 1e-9 * extent(&scenes[0]), "segment {segment} at {t}: off by {off:e}");
            differs = differs.max(farthest(&one[k], &straight[k]));
        }
    }
    assert!(differs > 0.003, "the rotations turn something: {differs}");
}

/// The law of section 4.1's product that makes it a comparison: the velocity jumps.
#[test]
fn the_papers_product_reaches_keyframes_but_jumps_in_velocity() {
    let spectral = choice(MethodName::Spectral, Order::Greedy, Alignment::Procrustes, 0.0);
    let scene = with_equal_times(show(&generic(12), Join::Product, spectral));
    let performance = performed(&scene);
    let sides: Vec<[Vec<DVec2>; 2]> = (0..4).map(|segment| super::meeting::velocities(&scene, &performance, segment)).collect();
    let jump = sides.windows(2).map(|pair| farthest(&pair[0][1], &pair[1][0])).fold(0.0, f64::max);
    assert!(jump > 0.1, "{jump}");
}

#[test]
fn a_copy_that_keeps_turning_turns_evenly_under_every_method_but_linear() {
    let shape = scattered(9, 5);
    let center = shape.iter().sum::<DVec2>() / 9.0;
    let about: Vec<DVec2> = shape.iter().map(|p| *p - center).collect();
    let formations: Vec<Vec<DVec2>> = (0..5).map(|k| turned(&about, 0.7 * f64::from(k))).collect();
    for choice in super::show::choices().into_iter().filter(|choice| choice.method != MethodName::Linear) {
        let performance = performed(&with_equal_times(show(&formations, Join::Smooth, choice)));
        for (at, t) in positions(&performance, 2, &TS).iter().zip(TS) {
            let off = farthest(at, &turned(&about, 0.7 * (2.0 + t)));
            assert!(off < 1e-9 * 30.0, "{choice:?}: off by {off:e} at {t}");
        }
    }
}

#[test]
fn a_little_later_is_a_little_different() {
    let shift = 1e-6;
    for choice in super::show::choices() {
        let scene = show(&generic(9), Join::Smooth, choice);
        let mut later = scene.clone();
        later.tracks[0].keyframes[2].time += shift;
        let [one, other] = [&scene, &later].map(performed);
        for segment in 0..4 {
            for (p, q) in positions(&one, segment, &TS).iter().zip(positions(&other, segment, &TS)) {
                // A velocity of some extents a second changes in proportion to the times.
                assert!(farthest(p, &q) < 100.0 * shift * extent(&scene), "{choice:?}, segment {segment}");
            }
        }
    }
}

fn with_durations(mut scene: Scene, durations: [f64; 4]) -> Scene {
    let mut time = 0.0;
    for (keyframe, duration) in scene.tracks[0].keyframes.iter_mut().zip(durations.into_iter().chain([0.0])) {
        keyframe.time = time;
        time += duration;
    }
    scene
}

/// Between short and long ones, and the other way round.
const UNEVEN: [[f64; 4]; 3] = [[60.0, 0.5, 40.0, 1.0], [0.2, 20.0, 0.2, 100.0], [1.0, 3.1, 30.0, 1.0]];

#[test]
fn who_moves_evenly_does_so_at_the_most_uneven_times() {
    let start = scattered(7, 3);
    let step = DVec2::new(0.3, -0.1);
    for durations in UNEVEN {
        let times = durations.iter().scan(0.0, |time, duration| Some(std::mem::replace(time, *time + duration)));
        let mut formations: Vec<Vec<DVec2>> = times.map(|time| start.iter().map(|p| *p + step * time).collect()).collect();
        let whole: f64 = durations.iter().sum();
        formations.push(start.iter().map(|p| *p + step * whole).collect());
        for choice in super::show::choices() {
            let scene = with_timing(with_durations(show(&formations, Join::Smooth, choice), durations), Timing::Linear);
            let performance = performed(&scene);
            // The outer segments start and stop by half the velocity, as Catmull and Rom have it; the inner ones know no stop.
            for segment in 1..3 {
                for (at, t) in positions(&performance, segment, &TS).iter().zip(TS) {
                    let passed: f64 = durations[..segment].iter().sum::<f64>() + t * durations[segment];
                    let expected: Vec<DVec2> = start.iter().map(|p| *p + step * passed).collect();
                    let off = farthest(at, &expected);
                    assert!(off < 1e-9 * extent(&scene).max(30.0), "{choice:?}, {durations:?}, segment {segment} at {t}: {off:e}");
                }
            }
        }
    }
}

/// A cubic leaves the way between its ends by at most 4/27 of what the velocities at both would make in its time. A keyframe's velocity
/// makes at most 9/4 of the shorter neighbor's way and 1 of the longer's (or less of both), so 2 · 4/27 · 13/4 < 1 of the longest way.
#[test]
fn nobody_runs_far_past_a_keyframe_however_uneven_the_times() {
    let formations = generic(9);
    let linear = choice(MethodName::Linear, Order::Greedy, Alignment::None, 0.0);
    for durations in UNEVEN {
        let performance = performed(&with_durations(show(&formations, Join::Smooth, linear), durations));
        for segment in 0..4 {
            for (agent, (p, q)) in formations[segment].iter().zip(&formations[segment + 1]).enumerate() {
                let near = segment.saturating_sub(1)..(segment + 2).min(4);
                let longest = near.map(|k| formations[k][agent].distance(formations[k + 1][agent])).fold(0.0, f64::max);
                for at in positions(&performance, segment, &TS) {
                    let along = ((at[agent] - *p).dot(*q - *p) / p.distance_squared(*q)).clamp(0.0, 1.0);
                    let off = at[agent].distance(p.lerp(*q, along));
                    assert!(off < longest, "{durations:?}, segment {segment}, agent {agent}: {off} m off, ways of {longest} m");
                }
            }
        }
    }
}
