//! Where a guide is, at its samples and between.

use glam::DVec2;

use crate::edits::grain::rounded;
use crate::motion::Motion;

/// A guide in the units of a crowd.
pub(super) struct Guide {
    motion: Motion,
    unit: f64,
}

impl Guide {
    pub(super) fn new(motion: Motion, unit: f64) -> Self {
        Self { motion, unit }
    }

    pub(super) fn motion(&self) -> &Motion {
        &self.motion
    }

    /// First and last sample time, seconds.
    pub(super) fn span(&self) -> [f64; 2] {
        let times = self.motion.times();
        [times[0], times[times.len() - 1]]
    }

    /// Of the fastest between two samples, units a second.
    pub(super) fn top_speed(&self) -> f64 {
        let times = self.motion.times();
        let fastest = |k: usize| {
            let steps = (0..self.motion.agent_count()).map(|agent| self.sample(k - 1, agent).distance(self.sample(k, agent)));
            steps.fold(0.0, f64::max) / (times[k] - times[k - 1])
        };
        (1..times.len()).map(fastest).fold(0.0, f64::max) / self.unit
    }

    /// Where an agent is at a sample, meters, as edits see it.
    pub(super) fn sample(&self, k: usize, agent: usize) -> DVec2 {
        rounded(self.motion.sample(k)[agent].extend(0.0)).truncate()
    }

    /// Where everybody is at a time, units; straight between samples, at the ends beyond them.
    pub(super) fn places_into(&self, time: f64, [x, y]: [&mut [f64]; 2]) {
        let times = self.motion.times();
        let at = times.partition_point(|known| *known <= time).clamp(1, times.len() - 1) - 1;
        let w = ((time - times[at]) / (times[at + 1] - times[at])).clamp(0.0, 1.0);
        for agent in 0..self.motion.agent_count() {
            let place = (self.sample(at, agent) * (1.0 - w) + self.sample(at + 1, agent) * w) / self.unit;
            (x[agent], y[agent]) = (place.x, place.y);
        }
    }
}
