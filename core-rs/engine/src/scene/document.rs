//! The scene between the engine and the page: out in the shape of [`Scene`] itself, tracks included, and in as a scene file.
//!
//! Formations travel beside the text on the way in, as numbers the page holds anyway, and inside it on the way out,
//! as flat numbers: `xy` x0, y0, x1, y1, … and in space `heights` z0, z1, …

use std::sync::Arc;

use glam::DVec2;
use serde::{Serialize, Serializer};

use super::Scene;
use super::json::read_rest;
use crate::assignment::AssignmentSpec;
use crate::choice::Choice;
use crate::error::Error;
use crate::formation::Formation;
use crate::text::json;

/// The scene with its positions.
pub fn write(scene: &Scene) -> String {
    json(scene)
}

/// The scene of a scene file whose keyframes have no positions, which needs no head and is complete otherwise, and of the formations of
/// its keyframes in order, shared and not copied.
pub fn read(rest: &str, formations: Vec<Arc<Formation>>) -> Result<Scene, Error> {
    read_rest(rest, formations)
}

/// Methods with their options as the page holds them, one a segment or null.
pub fn read_choices(text: &str) -> Result<Vec<Option<Choice>>, Error> {
    super::json::read_choices(text)
}

/// How an assignment is to be found, as the page holds it.
pub fn read_assignment(text: &str) -> Result<AssignmentSpec, Error> {
    super::json::read_assignment(text)
}

/// A formation as the page reads it.
#[derive(Serialize)]
struct Flat<'f> {
    xy: Vec<f64>,
    heights: Option<&'f [f64]>,
}

/// Positions as flat numbers.
pub(super) fn flat<S: Serializer>(formation: &Formation, serializer: S) -> Result<S::Ok, S::Error> {
    let xy = formation.positions().iter().flat_map(DVec2::to_array).collect();
    Flat { xy, heights: formation.heights() }.serialize(serializer)
}
