//! What version 1 names and this program does not do yet.
//!
//! A function a value, so that building a value is deleting its function.

use std::fmt::Display;

use super::Scene;
use super::place::Place;
use crate::adjacency::AdjacencySpec;
use crate::choice::Join;
use crate::error::Error;

/// The first such value of a scene that is right otherwise.
pub(super) fn check(scene: &Scene) -> Result<(), Error> {
    obstacle_ties(scene)?;
    product_in_space(scene)
}

fn obstacle_ties(scene: &Scene) -> Result<(), Error> {
    no_ties(&scene.adjacency, Place::Top.field("adjacency").field("obstacleTies"))?;
    for (index, keyframe) in scene.main_track().keyframes.iter().enumerate() {
        if let Some(own) = &keyframe.adjacency {
            no_ties(own, Place::Top.field("keyframes").item(index).field("adjacency").field("obstacleTies"))?;
        }
    }
    Ok(())
}

fn no_ties(adjacency: &AdjacencySpec, place: impl Display) -> Result<(), Error> {
    if adjacency.obstacle_ties.is_empty() { Ok(()) } else { refuse("a list with entries", "[]", place) }
}

/// The paper's product of powers is printed for the plane.
fn product_in_space(scene: &Scene) -> Result<(), Error> {
    let is_in_space = scene.main_track().keyframes.iter().any(|keyframe| !keyframe.positions.places().is_level());
    match scene.join {
        Join::Product if is_in_space => {
            refuse("\"product\" of positions with different heights", "\"smooth\" or \"separate\"", Place::Top.field("join"))
        }
        _ => Ok(()),
    }
}

fn refuse(value: &str, supported: &str, place: impl Display) -> Result<(), Error> {
    Err(Error::Unsupported { value: value.to_owned(), supported: supported.to_owned(), place: place.to_string() })
}
