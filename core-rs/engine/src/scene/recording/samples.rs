//! The rows of a recording, in any order, put in a grid of frames × agents.

use std::collections::BTreeMap;

use glam::DVec2;

use super::{Numbering, Recording};
use crate::error::{Counted, Error, RecordingError};
use crate::order;
use crate::scene::validate::{at_most, length};
use crate::scene::{limits, shown};

/// One agent at one frame.
#[derive(Clone, Copy)]
pub(super) struct Sample {
    pub(super) frame: i64,
    /// Given by [`Samples::add`].
    pub(super) agent: u32,
    /// Where it stands in the text.
    pub(super) row: u64,
    pub(super) position: DVec2,
    pub(super) height: f64,
}

/// The rows met so far.
#[derive(Default)]
pub(super) struct Samples {
    agents: Vec<String>,
    numbers: BTreeMap<String, usize>,
    rows: Vec<Sample>,
}

impl Samples {
    /// One more row, of the agent with this id.
    pub(super) fn add(&mut self, id: &str, sample: Sample) -> Result<(), Error> {
        let agent = match self.numbers.get(id) {
            Some(&number) => number as u32,
            None => self.newcomer(id, sample.row)?,
        };
        at_most(self.rows.len() + 1, limits::RECORDING_ROWS, Counted::Rows, format_args!("row {}", sample.row))?;
        self.rows.push(Sample { agent, ..sample });
        Ok(())
    }

    /// The recording of all rows.
    pub(super) fn finish(mut self, frame_rate: f64, mut notes: Vec<String>) -> Result<Recording, Error> {
        // Rows of equal frame and agent stay in the order of the text.
        order::sort_by_key(&mut self.rows, |sample| order::key_of_two(order::of_integer(sample.frame), u64::from(sample.agent)));
        self.once_each()?;
        let numbering = self.numbering()?;
        let Numbering { first, step, last } = numbering;
        let frame_count = ((last - first) / step) as usize + 1;
        let agent_count = self.agents.len();
        if agent_count.saturating_mul(frame_count) > limits::SAMPLES {
            return Err(RecordingError::TooManySamples { agent_count, frames: frame_count, limit: limits::SAMPLES }.into());
        }
        let at = |sample: &Sample| ((sample.frame - first) / step) as usize;
        self.without_gaps(at)?;
        if self.rows.len() < agent_count * frame_count {
            notes.push("Not everybody is there all the time.".to_owned());
        }
        let mut positions = vec![DVec2::NAN; agent_count * frame_count];
        let is_spatial = self.rows.iter().any(|sample| sample.height != 0.0);
        let mut heights = vec![0.0; if is_spatial { positions.len() } else { 0 }];
        for sample in &self.rows {
            let place = at(sample) * agent_count + sample.agent as usize;
            positions[place] = sample.position;
            if is_spatial {
                heights[place] = sample.height;
            }
        }
        // As a scene has it: frames are one step apart.
        let frame_rate = frame_rate / step as f64;
        let heights = is_spatial.then_some(heights);
        Ok(Recording { frame_rate, agents: self.agents, frame_count, notes, numbering, positions, heights })
    }

    fn newcomer(&mut self, id: &str, row: u64) -> Result<u32, Error> {
        at_most(self.agents.len() + 1, limits::AGENTS, Counted::Agents, format_args!("row {row}"))?;
        length(id, limits::NAME_CHARACTERS, format_args!("row {row}, the agent"))?;
        let number = self.agents.len();
        self.numbers.insert(id.to_owned(), number);
        self.agents.push(id.to_owned());
        Ok(number as u32)
    }

    fn once_each(&self) -> Result<(), Error> {
        match self.rows.windows(2).find(|two| (two[0].frame, two[0].agent) == (two[1].frame, two[1].agent)) {
            Some(two) => Err(RecordingError::RepeatedSample { row: two[1].row, agent: self.name(&two[1]), frame: two[1].frame }.into()),
            None => Ok(()),
        }
    }

    fn numbering(&self) -> Result<Numbering, Error> {
        let (Some(first), Some(last)) = (self.rows.first(), self.rows.last()) else { return Err(RecordingError::OneFrame.into()) };
        let step = self.rows.windows(2).map(|two| two[1].frame - two[0].frame).fold(0, greatest_common_divisor);
        if step == 0 {
            return Err(RecordingError::OneFrame.into());
        }
        Ok(Numbering { first: first.frame, step, last: last.frame })
    }

    /// Every agent enters once and leaves once.
    fn without_gaps(&self, at: impl Fn(&Sample) -> usize) -> Result<(), Error> {
        let mut last: Vec<Option<&Sample>> = vec![None; self.agents.len()];
        for sample in &self.rows {
            match last[sample.agent as usize].replace(sample) {
                Some(before) if at(sample) > at(before) + 1 => {
                    let (agent, frame, back) = (self.name(sample), before.frame, sample.frame);
                    return Err(RecordingError::Gap { agent, frame, back, row: sample.row }.into());
                }
                _ => {}
            }
        }
        Ok(())
    }

    fn name(&self, sample: &Sample) -> String {
        shown(&self.agents[sample.agent as usize])
    }
}

fn greatest_common_divisor(a: i64, b: i64) -> i64 {
    if b == 0 { a } else { greatest_common_divisor(b, a % b) }
}
