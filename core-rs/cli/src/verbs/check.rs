//! `eigenform check`: whether a scene is sound.

use eigenform::perform::Performer;
use eigenform::scene::{Opened, cautions};

use crate::arguments::Check;
use crate::failure::Failure;
use crate::{input, output};

pub fn run(arguments: &Check) -> Result<Vec<String>, Failure> {
    let Opened { scene, mut notes, .. } = input::read(&arguments.source)?;
    let track = scene.main_track();
    // Ties of large groups are known only once their formations are.
    let mut performer = Performer::default();
    for keyframe in 0..track.keyframes.len() {
        performer.graph(&scene, keyframe)?;
    }
    let is_in_space = track.keyframes.iter().any(|keyframe| keyframe.positions.heights().is_some());
    let space = if is_in_space { ", 3D" } else { "" };
    output::print(&format!("ok: {} agents, {} keyframes{space}", track.agents.len(), track.keyframes.len()))?;
    notes.extend(cautions(&scene));
    Ok(notes)
}
