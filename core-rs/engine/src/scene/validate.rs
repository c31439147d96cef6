//! What makes a scene valid: every limit and every reference, whichever way it came.

mod groups;
mod nodes;
mod obstacles;
mod paths;
mod ties;

use std::fmt::Display;
use std::ops::RangeInclusive;

use super::limits;
use super::place::Place;
use super::unsupported;
use super::{Agent, CrowdSpec, Keyframe, Scene, Segment, Track};
use crate::assignment::check_locks;
use crate::choice::MethodName;
use crate::error::{Counted, Error};
use crate::text::json;

/// Checks everything that a type cannot promise; the first refusal, with its place in the words of the scene file.
pub fn validate(scene: &Scene) -> Result<(), Error> {
    let top = Place::Top;
    exactly(scene.tracks.len(), 1, "tracks", top.field("tracks"))?;
    let track = scene.main_track();
    counts(track)?;
    length(&scene.title, limits::TITLE_CHARACTERS, top.field("title"))?;
    surroundings(scene)?;
    for (index, agent) in track.agents.iter().enumerate() {
        check_agent(agent, top.field("agents").item(index))?;
    }
    for (index, keyframe) in track.keyframes.iter().enumerate() {
        check_keyframe(keyframe, top.field("keyframes").item(index))?;
    }
    alike(&track.keyframes)?;
    times_rise(&track.keyframes)?;
    frames(scene)?;
    groups::check(&scene.groups, track.agents.len())?;
    obstacles::check(&scene.obstacles)?;
    ties::check(scene)?;
    for (index, segment) in track.segments.iter().enumerate() {
        check_segment(segment, scene, &top.field("segments").item(index))?;
    }
    unsupported::check(scene)
}

/// At most `limit` of something.
pub(super) fn at_most(count: usize, limit: usize, what: Counted, place: impl Display) -> Result<(), Error> {
    if count <= limit { Ok(()) } else { Err(Error::TooMany { what, count, limit, place: place.to_string() }) }
}

/// As many as another list has.
pub(super) fn exactly(found: usize, expected: usize, what: &'static str, place: impl Display) -> Result<(), Error> {
    if found == expected { Ok(()) } else { Err(Error::WrongCount { what, found, expected, place: place.to_string() }) }
}

/// A finite number within its limits.
pub(super) fn within(value: f64, range: &RangeInclusive<f64>, place: impl Display) -> Result<(), Error> {
    if range.contains(&value) {
        Ok(())
    } else if value.is_finite() {
        Err(Error::OutOfRange { value, low: *range.start(), high: *range.end(), place: place.to_string() })
    } else {
        Err(Error::NotFinite { place: place.to_string() })
    }
}

/// A text of at most `limit` characters.
pub(super) fn length(text: &str, limit: usize, place: impl Display) -> Result<(), Error> {
    // A character has at least one byte, so short texts need no count.
    let length = if text.len() <= limit { 0 } else { text.chars().count() };
    if length <= limit { Ok(()) } else { Err(Error::TooLong { length, limit, place: place.to_string() }) }
}

/// `#rrggbb` or empty.
pub(super) fn color(text: &str, place: impl Display) -> Result<(), Error> {
    let is_color = text.strip_prefix('#').is_some_and(|digits| digits.len() == 6 && digits.bytes().all(|b| b.is_ascii_hexdigit()));
    if text.is_empty() || is_color { Ok(()) } else { Err(Error::InvalidColor { value: super::shown(text), place: place.to_string() }) }
}

fn counts(track: &Track) -> Result<(), Error> {
    let top = Place::Top;
    let (agents, keyframes) = (track.agents.len(), track.keyframes.len());
    at_most(agents, limits::AGENTS, Counted::Agents, top.field("agents"))?;
    at_most(keyframes, limits::KEYFRAMES, Counted::Keyframes, top.field("keyframes"))?;
    if keyframes == 0 {
        return Err(Error::NoKeyframes);
    }
    at_most(agents * keyframes, limits::POSITIONS, Counted::Positions, top.field("keyframes"))?;
    exactly(track.segments.len(), keyframes - 1, "segments", top.field("segments"))?;
    track.keyframes.iter().enumerate().try_for_each(|(index, keyframe)| {
        exactly(keyframe.positions.agent_count(), agents, "positions", top.field("keyframes").item(index).field("positions"))
    })
}

fn surroundings(scene: &Scene) -> Result<(), Error> {
    let top = Place::Top;
    let (stage, tempo) = (top.field("stage"), top.field("tempo"));
    within(scene.stage.width, &limits::STAGE_SIDE, stage.field("width"))?;
    within(scene.stage.depth, &limits::STAGE_SIDE, stage.field("depth"))?;
    within(scene.stage.height, &limits::LENGTH, stage.field("height"))?;
    within(scene.tempo.beats_per_minute, &limits::BEATS_PER_MINUTE, tempo.field("beatsPerMinute"))?;
    within(f64::from(scene.tempo.beats_per_bar), &limits::BEATS_PER_BAR, tempo.field("beatsPerBar"))?;
    within(scene.tempo.start, &limits::TEMPO_START, tempo.field("start"))?;
    within(scene.frame_rate, &limits::FRAME_RATE, top.field("frameRate"))?;
    within(scene.minimum_distance, &limits::LENGTH, top.field("minimumDistance"))?;
    within(scene.tension, &limits::TENSION, top.field("tension"))
}

fn check_agent(agent: &Agent, place: Place) -> Result<(), Error> {
    length(&agent.name, limits::NAME_CHARACTERS, place.field("name"))?;
    color(&agent.color, place.field("color"))?;
    within(agent.radius, &limits::LENGTH, place.field("radius"))?;
    agent.max_speed.map_or(Ok(()), |speed| within(speed, &limits::MAX_SPEED, place.field("maxSpeed")))
}

fn check_keyframe(keyframe: &Keyframe, place: Place) -> Result<(), Error> {
    length(&keyframe.name, limits::NAME_CHARACTERS, place.field("name"))?;
    within(keyframe.time, &limits::TIME, place.field("time"))?;
    within(keyframe.hold, &(0.0..=limits::TIME.end() - keyframe.time), place.field("hold"))?;
    within(f64::from(keyframe.between), &(0.0..=limits::KEYFRAMES as f64), place.field("between"))?;
    check_absent(&keyframe.absent, keyframe.positions.agent_count(), &place.field("absent"))?;
    let positions = place.field("positions");
    keyframe.positions.positions().iter().enumerate().try_for_each(|(agent, position)| {
        within(position.x, &limits::COORDINATE, positions.item(agent))?;
        within(position.y, &limits::COORDINATE, positions.item(agent))
    })?;
    let heights = keyframe.positions.heights().unwrap_or_default();
    heights.iter().enumerate().try_for_each(|(agent, height)| within(*height, &limits::COORDINATE, positions.item(agent)))
}

/// Agents of the scene, each once; they ascend wherever they come from.
fn check_absent(absent: &[u32], agent_count: usize, place: &Place) -> Result<(), Error> {
    for (index, &agent) in absent.iter().enumerate() {
        if agent as usize >= agent_count {
            return Err(Error::UnknownAgent { agent, agent_count, place: place.item(index).to_string() });
        }
        if index > 0 && absent[index - 1] >= agent {
            return Err(Error::RepeatedMember { agent, place: place.to_string() });
        }
    }
    Ok(())
}

/// All on the plane or all in space.
fn alike(keyframes: &[Keyframe]) -> Result<(), Error> {
    let dimensions = |keyframe: &Keyframe| if keyframe.positions.heights().is_some() { 3 } else { 2 };
    let expected = keyframes.first().map_or(2, dimensions);
    let mut found = keyframes.iter().map(dimensions).enumerate();
    match found.find(|(_, found)| *found != expected) {
        Some((index, found)) => {
            let place = Place::Top.field("keyframes").item(index).field("positions").to_string();
            Err(Error::MixedDimensions { found, expected, place })
        }
        None => Ok(()),
    }
}

fn times_rise(keyframes: &[Keyframe]) -> Result<(), Error> {
    let ends = keyframes.iter().map(|keyframe| keyframe.time + keyframe.hold);
    for ((index, keyframe), end) in keyframes.iter().enumerate().skip(1).zip(ends) {
        if keyframe.time - end < limits::SHORTEST_SEGMENT {
            let place = Place::Top.field("keyframes").item(index).field("time").to_string();
            return Err(Error::TimesDoNotRise { time: keyframe.time, end, place });
        }
    }
    Ok(())
}

fn frames(scene: &Scene) -> Result<(), Error> {
    let (agent_count, frames) = (scene.main_track().agents.len().max(1), scene.frame_count());
    if agent_count * frames <= limits::SAMPLES {
        return Ok(());
    }
    // Within the limits of agents and time, one frame per second always fits: 5,000 × 3,601 samples.
    let fitting_frames = (limits::SAMPLES / agent_count) as f64;
    let fitting_rate = (((fitting_frames - 1e-9) / scene.duration()).ceil() - 1.0) as u32;
    Err(Error::TooManyFrames { agent_count, frames, limit: limits::SAMPLES, fitting_rate })
}

fn check_segment(segment: &Segment, scene: &Scene, place: &Place) -> Result<(), Error> {
    let Segment::Transition(transition) = segment;
    within(transition.sharing, &limits::SHARING, place.field("sharing"))?;
    if let Some(chosen) = transition.chosen {
        let place = place.field("chosen");
        within(chosen.sharing, &limits::SHARING, place.field("sharing"))?;
        certain(chosen.method, place.field("method"))?;
    }
    check_crowd(transition.crowd, &place.field("crowd"))?;
    if let Some(spec) = &transition.assignment {
        let place = place.field("assignment");
        within(spec.lambda, &limits::LAMBDA, place.field("lambda"))?;
        check_locks(&spec.locks, scene.main_track().agents.len(), |index| place.field("locks").item(index).to_string())?;
    }
    paths::check(transition.path.as_ref(), scene.main_track(), &place.field("path"))?;
    nodes::check(&transition.nodes, &scene.groups, &place.field("nodes"))
}

fn check_crowd(mut crowd: CrowdSpec, place: &Place) -> Result<(), Error> {
    certain(crowd.guide, place.field("guide"))?;
    for ((name, value), (_, range)) in crowd.numbers_mut().into_iter().zip(&limits::CROWD) {
        within(*value, range, place.field(name))?;
    }
    within(f64::from(crowd.constants.sectors), &limits::SECTORS, place.field("sectors"))
}

/// A method that needs no choosing and no guide.
fn certain(method: MethodName, place: impl Display) -> Result<(), Error> {
    if !matches!(method, MethodName::Auto | MethodName::Crowd) {
        return Ok(());
    }
    let admissible = &["spectral", "shared", "polar", "linear"];
    Err(Error::UnknownValue { value: json(&method), admissible, place: place.to_string() })
}
