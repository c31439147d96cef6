//! A scene as a link: `#s=1.` and a payload that never reaches a server.
//!
//! The payload is base64url of a head (how long the rest is, and its CRC-32) and the range-coded document.
//! The head is what tells a cut link from a damaged one; everything else about a link is decided in `document`.

mod absences;
mod additions;
mod basics;
mod betweens;
mod crowds;
mod document;
mod fields;
mod graph;
mod models;
mod names;
mod paths;
mod positions;
mod range;
mod recipes;
mod round;
mod route;
mod step;
mod text;

use std::sync::Arc;

use basics::code_document;
use document::Document;
use range::{Reader, Writer};
pub use round::{Precision, onto_grid};
use route::Cell;
use step::Step;

use super::normalize::{normalize_adjacency, normalize_groups, normalize_segments};
use super::{Group, Scene, validate};
use crate::error::Error;

/// A scene as a link, and what that took.
#[derive(Clone, Debug, PartialEq)]
pub struct Link {
    /// `#s=1.` and the payload.
    pub fragment: String,
    /// Every coordinate in the link is an integer times this, meters.
    pub step: f64,
    /// The farthest that rounding moved an agent, meters; 0 when the link is exact (each coordinate within 1e-6 m).
    pub rounding: f64,
    /// Keyframes, by index, that keep the minimum distance in the scene and break it in the link.
    pub broken_keyframes: Vec<usize>,
}

/// A valid scene as a link. The same scene gives the same link, and [`decode`] then `encode` gives the link again.
///
/// # Panics
/// When the scene is not valid: a bug, not input.
pub fn encode(scene: &Scene, precision: Precision) -> Link {
    let rounded = round::round(scene, precision);
    let mut document = Document { scene: scene.clone(), step: rounded.step, cells: rounded.cells, heights: rounded.heights };
    for keyframe in &mut document.scene.tracks[0].keyframes {
        keyframe.positions = Arc::default();
    }
    let mut writer = Writer::default();
    let written = code_document(&mut writer, &mut document);
    assert!(written.is_ok(), "a valid scene can be written");
    Link {
        fragment: text::wrap(&writer.finish()),
        step: rounded.step.meters(),
        rounding: rounded.farthest,
        broken_keyframes: rounded.broken_keyframes,
    }
}

/// The scene of a link: a whole address, its fragment, either with what a pasted link brings along (spaces, brackets, quotes, a full stop).
///
/// # Errors
/// Text that is no link, a link that is cut, damaged, newer or too large, or a scene that is not valid.
pub fn decode(text: &str) -> Result<Scene, Error> {
    let body = text::unwrap(text)?;
    let mut document = blank(Vec::new());
    code_document(&mut Reader::new(&body), &mut document)?;
    let Document { mut scene, step, cells, heights } = document;
    for (index, (keyframe, cells)) in scene.tracks[0].keyframes.iter_mut().zip(&cells).enumerate() {
        keyframe.positions = round::formation(step, cells, heights.get(index).map(Vec::as_slice));
    }
    normalize_groups(Arc::<Vec<Group>>::make_mut(&mut scene.groups));
    normalize_adjacency(Arc::make_mut(&mut scene.adjacency));
    let own = scene.tracks[0].keyframes.iter_mut().filter_map(|keyframe| keyframe.adjacency.as_mut());
    own.for_each(|adjacency| normalize_adjacency(Arc::make_mut(adjacency)));
    validate(&scene)?;
    normalize_segments(&mut scene.tracks[0]);
    Ok(scene)
}

/// What a reader starts from.
fn blank(cells: Vec<Vec<Cell>>) -> Document {
    Document { scene: Scene::default(), step: Step::Binary { exponent: 0 }, cells, heights: Vec::new() }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_link_of_too_many_agents_is_refused_before_there_is_room_for_them() {
        for (agents, keyframes) in [(5_001, 1), (8_191, 255), (1, 201), (5_000, 41), (1_001, 200)] {
            let mut document = blank(vec![vec![[0; 2]; agents]; keyframes]);
            let mut writer = Writer::default();
            assert!(code_document(&mut writer, &mut document).is_err(), "a writer stops there too");
            assert_eq!(decode(&text::wrap(&writer.finish())), Err(Error::LinkTooLarge), "{agents} × {keyframes}");
        }
    }
}
