//! What version 1 names and this program does not do yet.
//!
//! A function a value, so that building a value is deleting its function.

use std::fmt::Display;

use super::Scene;
use super::place::Place;
use crate::choice::Join;
use crate::error::Error;

/// The first such value of a scene that is right otherwise.
pub(super) fn check(scene: &Scene) -> Result<(), Error> {
    product_in_space(scene)
}

/// The paper's product of powers is printed for the plane: it weighs the angles of coefficients, unwrapped from keyframe to keyframe.
/// Directions in space have no such angles; a product of their turns would be a formula of ours under the paper's name.
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
