//! Motion that was recorded elsewhere: trajectories in, formations out.
//!
//! Two kinds of text: motion CSV as this program writes it, and the text format of `JuPedSim` and `PedPy`. Agents may enter once and leave
//! once; where a recording says less or more than that, it is refused with the row.

mod csv;
mod samples;
mod scene;
mod text;

use glam::DVec2;

use super::limits;
use crate::error::{Error, RecordingError};

/// Where agents were, frame by frame.
#[derive(Clone, Debug, PartialEq)]
pub struct Recording {
    /// Frames per second.
    pub frame_rate: f64,
    /// What the agents are called, in order of first appearance.
    pub agents: Vec<String>,
    /// How many frames there are, from the first to the last with anybody in it; at least two.
    pub frame_count: usize,
    /// What the text says that the recording leaves out, a sentence each.
    pub notes: Vec<String>,
    numbering: Numbering,
    /// By frame, then by agent; not finite where the agent is absent.
    positions: Vec<DVec2>,
    /// Laid out as positions; none on the plane.
    heights: Option<Vec<f64>>,
}

/// How the text numbers its frames.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Numbering {
    first: i64,
    /// By how much each frame is higher than the one before.
    step: i64,
    last: i64,
}

impl Recording {
    /// Where an agent is at a frame, as seen from above; none while it is absent.
    pub fn position(&self, frame: usize, agent: usize) -> Option<DVec2> {
        Some(self.positions[frame * self.agents.len() + agent]).filter(|position| position.is_finite())
    }

    /// Its height then; 0 on the plane.
    pub fn height(&self, frame: usize, agent: usize) -> f64 {
        self.heights.as_ref().map_or(0.0, |heights| heights[frame * self.agents.len() + agent])
    }

    /// Whether agents have heights.
    pub fn is_spatial(&self) -> bool {
        self.heights.is_some()
    }

    /// The frame that has this number in the text.
    pub fn frame_numbered(&self, number: i64) -> Option<usize> {
        let Numbering { first, step, .. } = self.numbering;
        let ahead = number.checked_sub(first).filter(|ahead| ahead % step == 0)?;
        usize::try_from(ahead / step).ok().filter(|frame| *frame < self.frame_count)
    }

    /// The numbers of the first and the last frame in the text.
    pub fn numbers(&self) -> (i64, i64) {
        (self.numbering.first, self.numbering.last)
    }

    /// The agents that are there at all of these frames, ascending.
    pub fn agents_at(&self, frames: &[usize]) -> Vec<u32> {
        let is_there = |agent: &usize| frames.iter().all(|frame| self.position(*frame, *agent).is_some());
        (0..self.agents.len()).filter(is_there).map(|agent| agent as u32).collect()
    }
}

/// The recording of a text of either kind.
pub fn read_recording(text: &str) -> Result<Recording, Error> {
    if text.len() > limits::FILE_BYTES {
        return Err(Error::FileTooLarge { bytes: text.len(), limit: limits::FILE_BYTES });
    }
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    if text.trim().is_empty() {
        return Err(Error::Empty);
    }
    if csv::has_header(text) {
        csv::read(text)
    } else if text::has_head(text) {
        text::read(text)
    } else {
        Err(RecordingError::Unrecognized.into())
    }
}

/// Whether a text is a recording rather than a scene, by how it begins.
pub fn is_recording(text: &str) -> bool {
    let text = text.trim_start_matches('\u{feff}');
    csv::has_header(text) || text::has_head(text)
}
