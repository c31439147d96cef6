//! A transition that keyframes lie in is performed as a whole.
//!
//! A keyframe between others begins no transition: the scene without it is the whole, and what it asks for beside that motion bends the
//! parts around it. Keyframes that lie deeper bend what the others have made.

use crate::choice::Choice;
use crate::scene::{Keyframe, Scene};

/// A scene without the keyframes that lie in transitions, and one of its segments.
pub(super) struct Whole {
    pub(super) scene: Scene,
    pub(super) index: usize,
    pub(super) held: Vec<Option<Choice>>,
    /// The keyframes it runs between, as they are numbered with the others.
    pub(super) ends: [usize; 2],
}

impl Whole {
    /// The transition that segment `index` is, or is a part of. None where each segment of the scene is one.
    pub(super) fn of(scene: &Scene, index: usize, held: &[Option<Choice>]) -> Option<Self> {
        Self::less_deep_than(1, scene, index, held)
    }

    /// The same with all keyframes but the deepest.
    pub(super) fn above(scene: &Scene, index: usize, held: &[Option<Choice>]) -> Option<Self> {
        let deepest = scene.main_track().depths().into_iter().max().unwrap_or_default();
        Self::less_deep_than(deepest.max(1), scene, index, held)
    }

    fn less_deep_than(limit: u32, scene: &Scene, index: usize, held: &[Option<Choice>]) -> Option<Self> {
        let track = scene.main_track();
        let depths = track.depths();
        let kept: Vec<usize> = (0..depths.len()).filter(|keyframe| depths[*keyframe] < limit).collect();
        if kept.len() == depths.len() {
            return None;
        }
        let at = kept.partition_point(|keyframe| *keyframe <= index) - 1;
        let departures = &kept[..kept.len() - 1];
        let mut whole = scene.clone();
        let keyframe = |keyframe: usize| Keyframe { between: depths[keyframe], ..track.keyframes[keyframe].clone() };
        whole.tracks[0].keyframes = kept.iter().copied().map(keyframe).collect();
        whole.tracks[0].segments = departures.iter().map(|departure| track.segments[*departure].clone()).collect();
        let held = departures.iter().map(|departure| held.get(*departure).copied().flatten()).collect();
        Some(Self { scene: whole, index: at, held, ends: [kept[at], kept[at + 1]] })
    }

    /// Whether other keyframes lie in it.
    pub(super) fn has_parts(&self) -> bool {
        self.ends[1] - self.ends[0] > 1
    }
}
