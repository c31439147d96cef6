//! What version 1 names and this program does not do yet.
//!
//! A function a value, so that building a value is deleting its function.

use std::fmt::Display;

use super::place::Place;
use super::{Scene, Segment, TransitionSpec};
use crate::error::Error;

/// The first such value of a scene that is right otherwise.
pub(super) fn check(scene: &Scene) -> Result<(), Error> {
    avoidance(scene)?;
    obstacles(scene)?;
    space(scene)
}

fn avoidance(scene: &Scene) -> Result<(), Error> {
    no_segment(scene, |transition| transition.avoidance, "true", "false", "avoidance")
}

fn obstacles(scene: &Scene) -> Result<(), Error> {
    let top = Place::Top;
    if !scene.adjacency.obstacle_ties.is_empty() {
        return refuse("a list with entries", "[]", top.field("adjacency").field("obstacleTies"));
    }
    if scene.obstacles.is_empty() { Ok(()) } else { refuse("a list with entries", "[]", top.field("obstacles")) }
}

fn space(scene: &Scene) -> Result<(), Error> {
    match scene.main_track().keyframes.iter().position(|keyframe| keyframe.positions.heights().is_some()) {
        Some(index) => refuse("[x, y, z]", "[x, y]", Place::Top.field("keyframes").item(index).field("positions")),
        None => Ok(()),
    }
}

fn no_segment(scene: &Scene, is_so: fn(&TransitionSpec) -> bool, value: &str, supported: &str, field: &str) -> Result<(), Error> {
    match scene.main_track().segments.iter().position(|Segment::Transition(transition)| is_so(transition)) {
        Some(index) => refuse(value, supported, Place::Top.field("segments").item(index).field(field)),
        None => Ok(()),
    }
}

fn refuse(value: &str, supported: &str, place: impl Display) -> Result<(), Error> {
    Err(Error::Unsupported { value: value.to_owned(), supported: supported.to_owned(), place: place.to_string() })
}
