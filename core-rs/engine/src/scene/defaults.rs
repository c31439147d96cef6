//! What an absent field means, for ever.

use std::sync::Arc;

use super::{Agent, Keyframe, Scene, Segment, Stage, Tempo, Track, TransitionSpec};
use crate::choice::Join;

/// Frames per second where none are given.
pub const DEFAULT_FRAME_RATE: f64 = 30.0;

/// Tension where none is given.
pub const DEFAULT_TENSION: f64 = 0.5;

/// Body radius where none is given, meters.
pub const DEFAULT_RADIUS: f64 = 0.25;

impl Default for Scene {
    /// No agents, standing at time 0.
    fn default() -> Self {
        Self {
            title: String::new(),
            seed: 0,
            stage: Stage::default(),
            tempo: Tempo::default(),
            frame_rate: DEFAULT_FRAME_RATE,
            minimum_distance: 0.0,
            join: Join::default(),
            tension: DEFAULT_TENSION,
            groups: Arc::default(),
            adjacency: Arc::default(),
            tracks: vec![Track { agents: Arc::default(), keyframes: vec![Keyframe::default()], segments: Vec::new() }],
            obstacles: Arc::default(),
        }
    }
}

impl Default for Stage {
    fn default() -> Self {
        Self { width: 100.0, depth: 60.0, height: 0.0, backdrop: super::Backdrop::default(), units: super::Units::default() }
    }
}

impl Default for Tempo {
    fn default() -> Self {
        Self { beats_per_minute: 120.0, beats_per_bar: 4, start: 0.0 }
    }
}

impl Default for Agent {
    fn default() -> Self {
        Self { name: String::new(), color: String::new(), radius: DEFAULT_RADIUS, max_speed: None }
    }
}

impl Default for Keyframe {
    fn default() -> Self {
        Self {
            name: String::new(),
            time: 0.0,
            hold: 0.0,
            corner: false,
            between: 0,
            positions: Arc::default(),
            absent: Vec::new(),
            adjacency: None,
        }
    }
}

impl Default for Segment {
    fn default() -> Self {
        Self::Transition(TransitionSpec::default())
    }
}
