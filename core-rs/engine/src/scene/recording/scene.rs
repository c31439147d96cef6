//! Some frames of a recording as the keyframes of a scene.

use std::sync::Arc;

use super::Recording;
use crate::error::{Error, RecordingError};
use crate::formation::Formation;
use crate::order;
use crate::scene::csv::{Read, checked, fitted_stage, is_whole_number};
use crate::scene::{Agent, Keyframe, Scene, Segment, Track, limits};

impl Recording {
    /// A scene whose keyframes are these frames, the first of them at 0 s, of the agents that are there at all of them.
    ///
    /// Agents are called by their ids, unless all ids are whole numbers. What no recording says has its default, except the stage,
    /// which is fitted, and the frame rate.
    ///
    /// # Panics
    /// When a frame is none of the recording: a bug, not input.
    pub fn scene(&self, frames: &[usize]) -> Result<Read, Error> {
        let mut frames = frames.to_vec();
        order::sort_by_key(&mut frames, |frame| *frame as u128);
        frames.dedup();
        let agents = self.agents_at(&frames);
        if agents.is_empty() {
            return Err(RecordingError::NobodyThere.into());
        }
        let mut notes = self.notes.clone();
        let left_out = self.agents.len() - agents.len();
        if left_out > 0 {
            notes.push(format!("{left_out} of {} agents are not there at all of these frames and are left out.", self.agents.len()));
        }
        let keyframes: Vec<Keyframe> = frames
            .iter()
            .map(|&frame| Keyframe {
                time: (frame - frames[0]) as f64 / self.frame_rate,
                positions: Arc::new(self.formation(frame, &agents)),
                ..Keyframe::default()
            })
            .collect();
        let scene = Scene {
            stage: fitted_stage(&keyframes),
            frame_rate: self.frame_rate.clamp(*limits::FRAME_RATE.start(), *limits::FRAME_RATE.end()),
            tracks: vec![Track {
                agents: Arc::new(self.cast(&agents)),
                segments: vec![Segment::default(); keyframes.len().saturating_sub(1)],
                keyframes,
            }],
            ..Scene::default()
        };
        checked(scene, notes)
    }

    /// Where these agents, all there, stand at a frame.
    fn formation(&self, frame: usize, agents: &[u32]) -> Formation {
        let positions = agents.iter().filter_map(|&agent| self.position(frame, agent as usize)).collect();
        if !self.is_spatial() {
            return Formation::new(positions);
        }
        Formation::spatial(positions, agents.iter().map(|&agent| self.height(frame, agent as usize)).collect())
    }

    fn cast(&self, agents: &[u32]) -> Vec<Agent> {
        let are_numbered = self.agents.iter().all(|id| is_whole_number(id));
        let called = |agent: u32| if are_numbered { String::new() } else { self.agents[agent as usize].clone() };
        agents.iter().map(|&agent| Agent { name: called(agent), ..Agent::default() }).collect()
    }
}
