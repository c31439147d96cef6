//! Formations and scenes to time the engine on; seeded, so that every run times the same.

pub mod crowds;

use std::sync::Arc;

use eigenform::choice::{Alignment, Join, MethodName, Order};
use eigenform::formation::Formation;
use eigenform::perform::Performer;
use eigenform::scene::{Agent, Group, Keyframe, Scene, Segment, Track, TransitionSpec, read_json};
use glam::DVec2;

/// A small generator of numbers in 0..1 (Numerical Recipes' linear congruential constants).
struct Numbers(u32);

impl Numbers {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        f64::from(self.0) / f64::from(u32::MAX)
    }
}

/// Agents strewn over a square that leaves each about a square meter.
pub fn strewn(agent_count: usize, seed: u32) -> Formation {
    let mut numbers = Numbers(seed);
    let side = (agent_count as f64).sqrt();
    Formation::new((0..agent_count).map(|_| DVec2::new(numbers.next() * side, numbers.next() * side)).collect())
}

/// A show whose agents are strewn anew at every keyframe, `seconds` apart, at 30 frames a second.
pub fn show(agent_count: usize, keyframe_count: usize, seconds: f64, method: MethodName) -> Scene {
    let keyframes = (0..keyframe_count)
        .map(|k| Keyframe { time: k as f64 * seconds, positions: Arc::new(strewn(agent_count, k as u32 + 1)), ..Keyframe::default() })
        .collect();
    let spec = TransitionSpec { method, order: Order::Greedy, alignment: Alignment::Procrustes, ..TransitionSpec::default() };
    let segments = vec![Segment::Transition(spec); keyframe_count.saturating_sub(1)];
    let agents = Arc::new(vec![Agent::default(); agent_count]);
    Scene { minimum_distance: 0.5, tracks: vec![Track { agents, keyframes, segments }], ..Scene::default() }
}

/// Two blocks of 44 × 22 agents that go through each other in 20 s and keep half a meter apart.
pub fn crossing_blocks() -> Scene {
    let [source, target] = crowds::blocks(44, 22, 1.143).map(|places| Arc::new(Formation::new(places)));
    let agents = Arc::new(vec![Agent::default(); source.agent_count()]);
    let keyframe = |time, positions| Keyframe { time, positions, ..Keyframe::default() };
    let spec = TransitionSpec { method: MethodName::Linear, avoidance: true, ..TransitionSpec::default() };
    let keyframes = vec![keyframe(0.0, source), keyframe(20.0, target)];
    Scene {
        minimum_distance: 0.5,
        tracks: vec![Track { agents, keyframes, segments: vec![Segment::Transition(spec)] }],
        ..Scene::default()
    }
}

/// A block of so many agents in four groups that turns upside down while it moves on for 10 s, by forces: 300 steps at 30 a second.
pub fn crowd(agent_count: usize, method: MethodName) -> Scene {
    let columns = (agent_count as f64).sqrt().ceil() as usize;
    let at = |agent: usize| DVec2::new((agent % columns) as f64, (agent / columns) as f64);
    let source: Vec<DVec2> = (0..agent_count).map(at).collect();
    let target = source.iter().map(|place| DVec2::new(place.x + 20.0, columns as f64 - place.y)).collect();
    let mut scene = show(agent_count, 2, 10.0, method);
    for (keyframe, places) in scene.tracks[0].keyframes.iter_mut().zip([source, target]) {
        keyframe.positions = Arc::new(Formation::new(places));
    }
    let quarter = |quarter: usize| (0..agent_count as u32).filter(|agent| *agent as usize * 4 / agent_count == quarter).collect();
    scene.groups = Arc::new((0..4).map(|part| Group { members: quarter(part), ..Group::default() }).collect());
    scene
}

/// Until the first segment's motion is settled; its numbers are not waited for.
///
/// # Panics
/// When the show cannot be performed: a bug.
pub fn move_first(performer: &mut Performer, scene: &Scene) {
    let mut job = performer.begin(scene, 0, &[]);
    while job.motion().is_none() {
        job.step(performer).expect("the show can be performed");
    }
}

/// The example after figure 11: 1,260 agents in groups of 36 and of 6, with four keyframes, moved by groups and not yet kept apart.
///
/// # Panics
/// When the example is no scene: a bug.
pub fn thousand() -> Scene {
    let mut scene = read_json(include_str!("../../../public/examples/thousand.eigenform.json")).expect("the example is a scene");
    for Segment::Transition(transition) in &mut scene.tracks[0].segments {
        let by_groups = TransitionSpec { method: MethodName::Spectral, hierarchy: true, ..TransitionSpec::default() };
        *transition = TransitionSpec { alignment: transition.alignment, ..by_groups };
    }
    scene
}

/// A show through whose keyframes the agents pass without a stop.
pub fn joined(agent_count: usize, keyframe_count: usize, seconds: f64, method: MethodName) -> Scene {
    Scene { join: Join::Smooth, ..show(agent_count, keyframe_count, seconds, method) }
}
