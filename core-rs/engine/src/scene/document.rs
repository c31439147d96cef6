//! The scene between the engine and the page: the shape of [`Scene`] itself, tracks included.
//!
//! Formations travel beside the text on the way in, as numbers the page holds anyway, and inside it on the way out,
//! as flat numbers: `xy` x0, y0, x1, y1, … and in space `heights` z0, z1, …

use std::sync::Arc;

use glam::DVec2;
use serde::{Serialize, Serializer};

use super::normalize::{normalize_adjacency, normalize_groups};
use super::{Scene, limits, validate};
use crate::error::Error;
use crate::formation::Formation;

/// The scene with its positions.
///
/// # Panics
/// When the scene is not plain data: a bug, not input.
pub fn write(scene: &Scene) -> String {
    serde_json::to_string(scene).expect("a scene is plain data")
}

/// A scene of `rest`, which has no positions, and the formations of its keyframes in order, shared and not copied.
pub fn read(rest: &str, formations: Vec<Arc<Formation>>) -> Result<Scene, Error> {
    if rest.len() > limits::FILE_BYTES {
        return Err(Error::FileTooLarge { bytes: rest.len(), limit: limits::FILE_BYTES });
    }
    let mut scene: Scene = serde_json::from_str(rest).map_err(|error| Error::InvalidJson {
        message: error.to_string(),
        place: format!("line {} column {}", error.line(), error.column()),
    })?;
    let found = formations.len();
    let keyframes: Vec<_> = scene.tracks.iter_mut().flat_map(|track| &mut track.keyframes).collect();
    if found != keyframes.len() {
        return Err(Error::WrongCount { what: "formations", found, expected: keyframes.len(), place: "keyframes".to_owned() });
    }
    for (keyframe, formation) in keyframes.into_iter().zip(formations) {
        keyframe.positions = formation;
        if let Some(own) = &mut keyframe.adjacency {
            normalize_adjacency(Arc::make_mut(own));
        }
    }
    normalize_adjacency(Arc::make_mut(&mut scene.adjacency));
    normalize_groups(Arc::make_mut(&mut scene.groups).as_mut_slice());
    validate(&scene)?;
    Ok(scene)
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
