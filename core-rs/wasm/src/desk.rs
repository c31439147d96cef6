//! Decoding and encoding, so that the door itself is only calls.

use std::sync::Arc;

use eigenform::adjacency::Adjacency;
use eigenform::assignment::{self, Question};
use eigenform::choice::Choice;
use eigenform::error::Error;
use eigenform::formation::Formation;
use eigenform::grouping::{self, AffinityJob, Metric, Preference, Way};
use eigenform::perform::{Counterpart, Performed, Performer, SegmentJob};
use eigenform::scene::recording::{Recording, read_recording};
use eigenform::scene::{self, Scene, Source};
use eigenform::spectral::{Eigenbasis, ModeMatch};
use eigenform::text;
use glam::DVec2;
use serde_json::json;
use wasm_bindgen::JsValue;

/// Input the engine refuses, as the page reads it: JSON `{code, what, where}`.
pub struct Refusal(String);

impl From<Error> for Refusal {
    fn from(error: Error) -> Self {
        Self(encode(&json!({ "code": error.code(), "what": error.to_string(), "where": error.place() })))
    }
}

impl From<Refusal> for JsValue {
    fn from(refusal: Refusal) -> Self {
        Self::from_str(&refusal.0)
    }
}

/// A panic reaches the page as an error with its message instead of a bare trap.
pub fn keep_panic_messages() {
    std::panic::set_hook(Box::new(|panic| wasm_bindgen::throw_str(&panic.to_string())));
}

/// Choices, or none, that this page's own client wrote: one a segment.
pub fn choices(text: &str) -> Vec<Option<Choice>> {
    scene::document::read_choices(text).unwrap_or_else(|_| panic!("the client writes what the protocol says"))
}

pub fn encode<T: serde::Serialize>(value: &T) -> String {
    text::json(value)
}

pub fn formation(xy: &[f64], heights: Option<Vec<f64>>) -> Formation {
    let positions = xy.chunks_exact(2).map(|p| DVec2::new(p[0], p[1])).collect();
    match heights {
        Some(heights) => Formation::spatial(positions, heights),
        None => Formation::new(positions),
    }
}

pub fn scene(rest: &str, formations: Vec<Arc<Formation>>) -> Result<Scene, Refusal> {
    Ok(scene::document::read(rest, formations)?)
}

pub fn open(text: &str) -> Result<String, Refusal> {
    let opened = scene::open(text)?;
    let source = match opened.source {
        Source::Scene => "scene",
        Source::Csv => "csv",
        Source::Link => "link",
    };
    Ok(encode(&json!({ "scene": scene::document::write(&opened.scene), "source": source, "notes": opened.notes })))
}

pub fn recording(text: &str) -> Result<Recording, Refusal> {
    Ok(read_recording(text)?)
}

pub fn head(recording: &Recording) -> String {
    let Recording { frame_rate, frame_count, agents, notes, .. } = recording;
    encode(&json!({ "frameRate": frame_rate, "frameCount": frame_count, "agents": agents, "notes": notes }))
}

pub fn positions(recording: &Recording) -> Vec<f32> {
    let places = (0..recording.frame_count).flat_map(|frame| (0..recording.agents.len()).map(move |agent| (frame, agent)));
    places.flat_map(|(frame, agent)| recording.position(frame, agent).unwrap_or(DVec2::NAN).to_array()).map(|x| x as f32).collect()
}

pub fn keyframes(scene: &Scene) -> String {
    let written = scene::write_csv(scene);
    encode(&json!({ "text": written.text, "notes": written.notes }))
}

pub fn link(scene: &Scene, is_short: bool) -> String {
    let precision = if is_short { scene::link::Precision::Short } else { scene::link::Precision::Exact };
    let link = scene::link::encode(scene, precision);
    encode(&json!({ "fragment": link.fragment, "rounding": link.rounding, "brokenKeyframes": link.broken_keyframes }))
}

pub fn begin(performer: &mut Performer, scene: &Scene, segment: usize, held: Option<&str>, counterpart: Option<&str>) -> SegmentJob {
    let held = held.map_or_else(Vec::new, choices);
    performer.begin_compared(scene, segment, &held, counterpart.and_then(Counterpart::named), false)
}

pub fn movement(performed: &Performed) -> String {
    encode(&performed.movement())
}

pub fn curves(performed: &Performed) -> Vec<f32> {
    let curves = &performed.curves;
    [&curves.clearance, &curves.distortion, &curves.turning, &curves.top_speed, &curves.path_length]
        .into_iter()
        .flat_map(|curve| curve.iter().map(|value| *value as f32))
        .collect()
}

pub fn motion(performer: &mut Performer, scene: &Scene, format: &str) -> Result<String, Refusal> {
    let performance = performer.perform(scene)?;
    Ok(if format == "csv" { performance.to_csv() } else { performance.to_json() })
}

pub fn modes(basis: &Eigenbasis, most: usize) -> Vec<f64> {
    let modes = basis.modes().col_iter().take(most).flat_map(|mode| mode.iter().copied());
    basis.eigenvalues().iter().copied().chain(modes).collect()
}

pub fn mode_match(matched: &ModeMatch, most: usize) -> Vec<f32> {
    let shown = matched.mode_count.min(most);
    let amounts = matched.amounts[..shown * matched.mode_count].iter().map(|amount| *amount as f32);
    let targets = matched.targets.iter().flat_map(|targets| targets[..shown].iter().map(|target| *target as f32));
    amounts.chain(targets).collect()
}

pub fn way(name: &str, amount: f64) -> Way {
    match name {
        "bisect" => Way::Bisect { levels: amount as u32 },
        "parts" => Way::Parts { count: amount as u32 },
        _ => Way::Connected { factor: amount },
    }
}

pub fn groups(scene: &Scene, keyframe: usize, graph: &Adjacency, agents: &[u32], way: Way) -> String {
    encode(&grouping::propose(&scene.main_track().keyframes[keyframe].positions, graph, agents, way))
}

pub fn assign(source: &Formation, target: &Formation) -> Vec<u32> {
    assignment::squared(source, target).targets().to_vec()
}

/// Long work for one answer.
pub enum Errand {
    Assignment(assignment::Job),
    Affinity(AffinityJob),
}

impl Errand {
    pub fn step(&mut self) -> f64 {
        match self {
            Self::Assignment(job) => job.step(),
            Self::Affinity(job) => job.step(),
        }
    }

    pub fn result(self) -> String {
        match self {
            Self::Assignment(job) => encode(&job.into_assignment().targets()),
            Self::Affinity(job) => encode(&job.groups()),
        }
    }
}

pub fn assignment(scene: &Scene, segment: usize, recipe: &str, is_flipped: bool, is_predicted: bool) -> Result<Errand, Refusal> {
    let spec = &scene::document::read_assignment(recipe)?;
    let [source, target] = scene.way_at(segment)?;
    let sections = &scene::group_levels(&scene.groups, source.agent_count());
    let question = Question { source, target, spec, sections, is_flipped, is_predicted };
    Ok(Errand::Assignment(assignment::Job::new(&question)?))
}

pub fn affinity(scene: &Scene, keyframe: usize, agents: &[u32], metric: &str, times: f64) -> Result<Errand, Refusal> {
    let metric = if metric == "manhattan" { Metric::Manhattan } else { Metric::Euclidean };
    let [source, target] = scene.way_at(keyframe)?;
    Ok(Errand::Affinity(AffinityJob::new(source, target, agents, metric, Preference::OfMedian(times))))
}
