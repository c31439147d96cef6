//! `eigenform shape`: a formation of exactly so many agents from a picture, a drawing or text.

use std::path::Path;
use std::sync::Arc;

use eigenform::scene::{Agent, Keyframe, Scene, limits, validate, write_json};
use eigenform::shape::{Request, Room, SlotJob, Style};

use crate::arguments::Shape;
use crate::failure::Failure;
use crate::input::{whole_within, within};
use crate::{output, picture};

/// How much of the stage a shape takes each way.
const SHARE: f64 = 0.8;

pub fn run(arguments: &Shape) -> Result<Vec<String>, Failure> {
    let count = whole_within(arguments.agents, &(1..=limits::AGENTS), "--agents")?;
    let seed = whole_within(arguments.seed, &(0..=u32::MAX as usize), "--seed")? as u32;
    let mut scene = Scene { title: title(arguments), seed, ..Scene::default() };
    scene.minimum_distance = within(arguments.minimum_distance, &limits::LENGTH, "--minimum-distance")?;
    let room = match arguments.width {
        Some(width) => Room { width: within(width, &limits::STAGE_SIDE, "--width")?, depth: f64::INFINITY },
        None => Room { width: SHARE * scene.stage.width, depth: SHARE * scene.stage.depth },
    };
    let request = Request {
        count,
        least_distance: scene.minimum_distance,
        style: if arguments.outline { Style::Outline } else { Style::Filled },
        seed,
    };
    let formation = SlotJob::new(picture::region(arguments, room)?, request)?.finish()?;
    let (low, high) = formation.bounds();
    scene.stage.width = scene.stage.width.max((high.x - low.x) / SHARE);
    scene.stage.depth = scene.stage.depth.max((high.y - low.y) / SHARE);
    let track = &mut scene.tracks[0];
    track.agents = Arc::new(vec![Agent::default(); formation.agent_count()]);
    track.keyframes = vec![Keyframe { positions: Arc::new(formation), ..Keyframe::default() }];
    validate(&scene)?;
    output::print(&write_json(&scene))?;
    Ok(Vec::new())
}

/// The text itself, or the file's name without its ending.
fn title(arguments: &Shape) -> String {
    let input = arguments.input.as_str();
    let name = match input {
        "-" => "",
        _ if picture::is_file(arguments) => Path::new(input).file_stem().and_then(|stem| stem.to_str()).unwrap_or_default(),
        _ => input,
    };
    let line = name.chars().map(|c| if c.is_control() { ' ' } else { c });
    line.take(limits::TITLE_CHARACTERS).collect()
}
