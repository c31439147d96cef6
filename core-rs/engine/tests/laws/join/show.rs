//! Shows of several keyframes, written as briefly as the laws need.

use std::sync::Arc;

use eigenform::choice::{Alignment, Choice, Join, MethodName, Order, Timing};
use eigenform::formation::Formation;
use eigenform::perform::{Performance, perform};
use eigenform::scene::{Agent, Keyframe, Scene, Segment, Track, TransitionSpec};
use glam::DVec2;

use crate::transition::cases::{grid, line, ring, scattered, shuffled, turned};

/// Uneven on purpose: no law needs equal times.
pub const DURATIONS: [f64; 5] = [2.0, 1.25, 3.5, 1.0, 2.25];

pub fn choice(method: MethodName, order: Order, alignment: Alignment, sharing: f64) -> Choice {
    Choice { method, order, alignment, sharing }
}

/// Every method, and the options that change what joins.
pub fn choices() -> Vec<Choice> {
    use MethodName::{Linear, Polar, Shared, Spectral};
    let plain = |method, alignment| choice(method, Order::Greedy, alignment, 0.5);
    let mut all = vec![plain(Linear, Alignment::None)];
    for alignment in [Alignment::None, Alignment::Procrustes] {
        all.extend([plain(Polar, alignment), plain(Shared, alignment)]);
        for order in [Order::Eigenvalue, Order::Greedy, Order::Hungarian] {
            all.extend([0.0, 0.5].map(|sharing| choice(Spectral, order, alignment, sharing)));
        }
    }
    all
}

/// A scene of formations, each `DURATIONS` after the one before, all segments alike.
pub fn show(formations: &[Vec<DVec2>], join: Join, choice: Choice) -> Scene {
    let mut time = 0.5;
    let mut keyframes = Vec::new();
    for (k, positions) in formations.iter().enumerate() {
        keyframes.push(Keyframe { time, positions: Arc::new(Formation::new(positions.clone())), ..Keyframe::default() });
        time += DURATIONS[k % DURATIONS.len()];
    }
    let agents = Arc::new(vec![Agent::default(); formations[0].len()]);
    let segments = vec![segment(choice); formations.len() - 1];
    Scene { frame_rate: 10.0, join, tracks: vec![Track { agents, keyframes, segments }], ..Scene::default() }
}

pub fn segment(choice: Choice) -> Segment {
    let Choice { method, order, alignment, sharing } = choice;
    Segment::Transition(TransitionSpec { method, order, alignment, sharing, ..TransitionSpec::default() })
}

pub fn spec(scene: &mut Scene, segment: usize) -> &mut TransitionSpec {
    let Segment::Transition(spec) = &mut scene.tracks[0].segments[segment];
    spec
}

pub fn with_timing(mut scene: Scene, timing: Timing) -> Scene {
    for segment in 0..scene.tracks[0].segments.len() {
        spec(&mut scene, segment).timing = timing;
    }
    scene
}

pub fn performed(scene: &Scene) -> Performance {
    perform(scene).expect("the show can be performed")
}

pub fn extent(scene: &Scene) -> f64 {
    scene.tracks[0].keyframes.iter().map(|keyframe| keyframe.positions.extent()).fold(0.0, f64::max)
}

/// Positions in a segment at fractions of its time.
pub fn positions(performance: &Performance, segment: usize, fractions: &[f64]) -> Vec<Vec<DVec2>> {
    let motion = &performance.segments()[segment].motion;
    let (start, end) = (motion.times()[0], motion.times()[motion.times().len() - 1]);
    let times: Vec<f64> = fractions.iter().map(|fraction| start + fraction * (end - start)).collect();
    let mut out = vec![DVec2::NAN; motion.agent_count() * times.len()];
    performance.segments()[segment].places_into(&times, &mut out, None);
    out.chunks(motion.agent_count().max(1)).map(<[DVec2]>::to_vec).collect()
}

/// Nothing repeats, nothing is symmetric: five formations of as many agents.
pub fn generic(count: usize) -> Vec<Vec<DVec2>> {
    (0..5).map(|k| scattered(count, 41 + k)).collect()
}

/// Subgroups that change places and turn a little at every keyframe.
pub fn blocks() -> Vec<Vec<DVec2>> {
    let centers = [DVec2::new(0.0, 0.0), DVec2::new(12.0, 2.0), DVec2::new(5.0, 11.0)];
    let block = |seed: u64, at: DVec2, angle: f64| turned(&scattered(5, seed), angle).into_iter().map(move |p| at + 0.2 * p);
    (0..5_usize).map(|k| (0..3).flat_map(|b| block(60 + b as u64, centers[(b + k) % 3], 0.5 * k as f64 * b as f64)).collect()).collect()
}

/// Eigenvalues repeat at every keyframe but the last: bases belong to pairs, not to keyframes.
pub fn symmetric() -> Vec<Vec<DVec2>> {
    vec![ring(12, 5.0, 0.1), shuffled(&grid(4, 3)), ring(12, 4.0, 1.0), shuffled(&line(12, DVec2::new(1.0, 0.3))), scattered(12, 9)]
}

/// What people do by accident.
pub fn degenerate() -> Vec<Vec<Vec<DVec2>>> {
    let here = DVec2::new(3.0, -2.0);
    let mut twins = scattered(7, 11);
    twins[4] = twins[2];
    vec![
        vec![vec![]; 4],
        vec![vec![here], vec![-here], vec![DVec2::ZERO], vec![here]],
        vec![vec![here, -here], vec![-here, here], vec![here, -here], vec![here, DVec2::ZERO]],
        vec![scattered(7, 1), vec![here; 7], vec![-here; 7], scattered(7, 2)],
        vec![vec![here; 7], scattered(7, 1), scattered(7, 2), vec![DVec2::ZERO; 7]],
        vec![twins.clone(), scattered(7, 3), twins, scattered(7, 3)],
        vec![grid(3, 3); 4],
        (0..4).map(|k| turned(&grid(3, 3), std::f64::consts::PI * f64::from(k))).collect(),
        vec![line(6, DVec2::X), line(6, DVec2::Y), line(6, DVec2::X).into_iter().rev().collect(), line(6, DVec2::X)],
    ]
}
