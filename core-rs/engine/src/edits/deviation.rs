//! How far an edit takes agents from where the method has them, at any instant.

use std::sync::OnceLock;

use eigenform_apart::Paths;
use glam::DVec2;

use crate::spline::Spline;

/// What an edit adds to a motion: exact at its samples, a C² spline between them.
#[derive(Debug)]
pub struct Deviation {
    spline: Spline,
    /// Only those that are moved at all, ascending.
    agents: Vec<u32>,
    /// By place in `agents`, a knot a sample.
    samples: Paths,
    bends: OnceLock<Paths>,
}

impl Deviation {
    /// `samples` holds everybody's deviation, a knot a sample time; `is_clamped`: it starts, ends without velocity.
    pub(super) fn new(times: Vec<f64>, samples: &Paths, is_clamped: [bool; 2]) -> Self {
        let is_moved = |agent: usize| (0..samples.axis_count()).any(|axis| samples.path(axis, agent).iter().any(|u| *u != 0.0));
        let agents: Vec<u32> = (0..samples.agent_count()).filter(|agent| is_moved(*agent)).map(|agent| agent as u32).collect();
        let mut kept = Paths::new(agents.len(), samples.knot_count(), samples.axis_count());
        for axis in 0..samples.axis_count() {
            for (place, agent) in agents.iter().enumerate() {
                kept.path_mut(axis, place).copy_from_slice(samples.path(axis, *agent as usize));
            }
        }
        Self { spline: Spline::new(times, is_clamped), agents, samples: kept, bends: OnceLock::new() }
    }

    /// The same of agents that are `numbers` by their places now, ascending.
    pub(crate) fn number(&mut self, numbers: &[u32]) {
        self.agents.iter_mut().for_each(|agent| *agent = numbers[*agent as usize]);
    }

    /// What it takes to keep, bytes.
    pub fn byte_count(&self) -> usize {
        2 * self.samples.axis_count() * size_of_val(self.samples.axis(0))
    }

    /// Adds the deviation at `time` (seconds) to positions and heights by agent.
    pub fn add_to(&self, time: f64, positions: &mut [DVec2], mut heights: Option<&mut [f64]>) {
        let bends = self.bends.get_or_init(|| self.find_bends());
        let weights = self.spline.weights(time);
        for (place, agent) in self.agents.iter().enumerate() {
            let [x, y] = [0, 1].map(|axis| weights.of(self.samples.path(axis, place), bends.path(axis, place)));
            positions[*agent as usize] += DVec2::new(x, y);
        }
        for (place, agent) in self.agents.iter().enumerate() {
            if let (Some(heights), 3) = (&mut heights, self.samples.axis_count()) {
                heights[*agent as usize] += weights.of(self.samples.path(2, place), bends.path(2, place));
            }
        }
    }

    fn find_bends(&self) -> Paths {
        let mut bends = Paths::new(self.agents.len(), self.samples.knot_count(), self.samples.axis_count());
        for axis in 0..bends.axis_count() {
            for place in 0..self.agents.len() {
                self.spline.bends_into(self.samples.path(axis, place), bends.path_mut(axis, place));
            }
        }
        bends
    }
}
