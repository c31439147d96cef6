//! What is asked of a scene again and again.

use std::collections::BTreeSet;

use super::{Scene, Track};
use crate::error::Error;
use crate::formation::Formation;
use crate::obstacle::ObstacleShape;

/// Round-off allowed when a duration is a whole number of frames.
const FRAME_TOLERANCE: f64 = 1e-9;

impl Scene {
    /// The track of all agents: version 1 has no other.
    pub fn main_track(&self) -> &Track {
        &self.tracks[0]
    }

    /// A keyframe's formation and the next one; of the last keyframe the one before and itself.
    pub fn way_at(&self, keyframe: usize) -> Result<[&Formation; 2], Error> {
        let keyframes = &self.main_track().keyframes;
        let from = keyframe.min(keyframes.len().saturating_sub(2));
        match &keyframes[from..] {
            [source, target, ..] => Ok([&source.positions, &target.positions]),
            _ => Err(Error::OneKeyframe),
        }
    }

    /// The outlines of what stands on the stage.
    pub fn obstacle_shapes(&self) -> Vec<ObstacleShape> {
        self.obstacles.iter().map(|obstacle| obstacle.shape.clone()).collect()
    }

    /// When the last hold ends, seconds.
    pub fn duration(&self) -> f64 {
        self.main_track().keyframes.last().map_or(0.0, |last| last.time + last.hold)
    }

    /// Frames of the whole show: f / frame rate for f = 0 … up to its duration.
    pub fn frame_count(&self) -> usize {
        (self.duration() * self.frame_rate + FRAME_TOLERANCE) as usize + 1
    }

    /// What to call the agents in files: their names where all are there and distinct, else their numbers from 0.
    pub fn agent_ids(&self) -> Vec<String> {
        let agents = &self.main_track().agents;
        let mut names = BTreeSet::new();
        for name in agents.iter().map(|agent| agent.name.as_str()).filter(|name| !name.is_empty()) {
            names.insert(name);
        }
        if names.len() == agents.len() {
            agents.iter().map(|agent| agent.name.clone()).collect()
        } else {
            (0..agents.len()).map(|agent| agent.to_string()).collect()
        }
    }
}
