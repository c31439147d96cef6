//! A transition evaluated at many t, some at a time.

use std::sync::Arc;

use glam::DVec2;

use crate::transition::Transition;

/// Positions evaluated in one step; about 10 ms.
const POSITIONS_PER_STEP: usize = 60_000;

/// Samples as far as they are known.
pub(super) struct Sampling {
    pub(super) transition: Arc<dyn Transition>,
    pub(super) ts: Vec<f64>,
    pub(super) positions: Vec<DVec2>,
    /// None on the plane.
    pub(super) heights: Option<Vec<f64>>,
}

impl Sampling {
    /// At `ts`, with heights or without; nothing is known yet.
    pub(super) fn new(transition: Arc<dyn Transition>, ts: Vec<f64>, has_heights: bool) -> Self {
        Self { transition, ts, positions: Vec::new(), heights: has_heights.then(Vec::new) }
    }

    /// Evaluates some more samples; false when there were none left.
    pub(super) fn step(&mut self) -> bool {
        let agent_count = self.transition.agent_count();
        let done = self.positions.len() / agent_count.max(1);
        let next = (done + (POSITIONS_PER_STEP / agent_count.max(1)).max(1)).min(self.ts.len());
        if agent_count == 0 || done == self.ts.len() {
            return false;
        }
        self.positions.resize(next * agent_count, DVec2::ZERO);
        let heights = self.heights.as_mut().map(|heights| {
            heights.resize(next * agent_count, 0.0);
            &mut heights[done * agent_count..]
        });
        self.transition.evaluate_into(&self.ts[done..next], &mut self.positions[done * agent_count..], heights);
        true
    }

    /// How much is known, 0–1.
    pub(super) fn progress(&self) -> f64 {
        self.positions.len() as f64 / (self.ts.len() * self.transition.agent_count()).max(1) as f64
    }
}
