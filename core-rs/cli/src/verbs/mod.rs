//! A file a verb: read, ask the engine, print.

pub mod assign;
pub mod check;
pub mod compare;
pub mod convert;
pub mod groups;
pub mod link;
pub mod measure;
pub mod modes;
pub mod motion;
pub mod open;
pub mod shape;
pub mod spread;

use eigenform::scene::Scene;

/// What to say of a scene in which nothing moves.
fn stillness(scene: &Scene) -> Option<String> {
    let is_still = scene.main_track().segments.is_empty();
    is_still.then(|| "the scene has one keyframe, so nothing moves: add another".to_owned())
}
