//! Decoding and encoding, so that the door itself is only calls.

use std::sync::Arc;

use eigenform::assignment;
use eigenform::choice::Choice;
use eigenform::error::Error;
use eigenform::formation::Formation;
use eigenform::perform::{Aside, Counterpart, Performed, Performer, SegmentJob};
use eigenform::scene::{self, Opened, Scene, Source};
use eigenform::text;
use glam::DVec2;
use serde::Serialize;
use wasm_bindgen::JsValue;

/// Input the engine refuses, as the page reads it: JSON `{code, what, where}`; of a way that obstacles shut off also `noWay`, so that the
/// page can call who and what by their names.
pub struct Refusal(String);

// Written out: `json!` makes maps of such answers, whose code is 3 kB of what a visitor loads.
#[derive(Serialize)]
#[serde(rename_all = "camelCase")]
struct Refused {
    code: &'static str,
    what: String,
    r#where: String,
    #[serde(skip_serializing_if = "Option::is_none")]
    no_way: Option<NoWay>,
}

#[derive(Serialize)]
struct NoWay {
    agent: u32,
    obstacle: u32,
    distance: f64,
}

impl From<Error> for Refusal {
    fn from(error: Error) -> Self {
        let no_way = match error {
            Error::NoWay { agent, obstacle, distance } => Some(NoWay { agent, obstacle, distance }),
            _ => None,
        };
        Self(encode(&Refused { code: error.code(), what: error.to_string(), r#where: error.place(), no_way }))
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

pub fn encode<T: Serialize>(value: &T) -> String {
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

pub fn open(text: &str) -> Result<Option<String>, Refusal> {
    scene::open_own(text).map(|opened| Ok(told(&opened?))).transpose()
}

#[derive(Serialize)]
struct Told<'a> {
    scene: String,
    source: &'static str,
    notes: &'a [String],
}

/// A scene that was opened: JSON `{scene, source, notes}`.
pub fn told(opened: &Opened) -> String {
    let source = match opened.source {
        Source::Scene => "scene",
        Source::Csv => "csv",
        Source::Link => "link",
    };
    encode(&Told { scene: scene::document::write(&opened.scene), source, notes: &opened.notes })
}

#[derive(Serialize)]
#[serde(rename_all = "camelCase")]
struct Linked<'a> {
    fragment: &'a str,
    rounding: f64,
    broken_keyframes: &'a [usize],
}

pub fn link(scene: &Scene, is_short: bool) -> String {
    let precision = if is_short { scene::link::Precision::Short } else { scene::link::Precision::Exact };
    let link = scene::link::encode(scene, precision);
    encode(&Linked { fragment: &link.fragment, rounding: link.rounding, broken_keyframes: &link.broken_keyframes })
}

pub fn begin(performer: &mut Performer, scene: &Scene, segment: usize, held: Option<&str>, counterpart: Option<&str>) -> SegmentJob {
    let held = held.map_or_else(Vec::new, choices);
    performer.begin_compared(scene, segment, &held, Aside { counterpart: counterpart.and_then(Counterpart::named), ..Aside::default() })
}

/// x, y an agent, then in space their heights.
pub fn places(performed: &Performed, time: f64) -> Vec<f64> {
    let mut plan = vec![DVec2::ZERO; performed.motion.agent_count()];
    let mut heights = performed.motion.heights().map(|_| vec![0.0; plan.len()]);
    performed.places_into(&[time], &mut plan, heights.as_deref_mut());
    let mut places = Vec::new();
    for place in plan {
        places.extend([place.x, place.y]);
    }
    places.extend(heights.unwrap_or_default());
    places
}

pub fn curves(performed: &Performed) -> Vec<f32> {
    let curves = &performed.curves;
    [&curves.clearance, &curves.distortion, &curves.turning, &curves.top_speed, &curves.path_length]
        .into_iter()
        .flat_map(|curve| curve.iter().map(|value| *value as f32))
        .collect()
}

pub fn assign(source: &Formation, target: &Formation) -> Vec<u32> {
    assignment::squared(source, target).targets().to_vec()
}
