//! Where a guide is, at its samples and between.

use glam::DVec2;

use super::row::Row;
use crate::edits::grain::rounded;
use crate::motion::Motion;

/// A guide in the units of a crowd.
pub(super) struct Guide {
    motion: Motion,
    unit: f64,
    /// The samples last asked for, an even and an odd one: a crowd asks for them in order.
    rows: [Row; 2],
}

impl Guide {
    pub(super) fn new(motion: Motion, unit: f64) -> Self {
        let rows = [Row::new(motion.agent_count()), Row::new(motion.agent_count())];
        Self { motion, unit, rows }
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
    pub(super) fn top_speed(&mut self) -> f64 {
        let mut top: f64 = 0.0;
        for k in 1..self.motion.times().len() {
            let [from, to] = self.rows_at(k - 1);
            let farthest = from.greatest_distance(to);
            top = top.max(farthest / (self.motion.times()[k] - self.motion.times()[k - 1]));
        }
        top
    }

    /// Where an agent is at a sample, meters, as edits see it.
    pub(super) fn sample(&self, k: usize, agent: usize) -> DVec2 {
        rounded(self.motion.sample(k)[agent].extend(0.0)).truncate()
    }

    /// Where everybody is at a time, units; straight between samples, at the ends beyond them.
    pub(super) fn places_into(&mut self, time: f64, places: [&mut [f64]; 2]) {
        let times = self.motion.times();
        let at = times.partition_point(|known| *known <= time).clamp(1, times.len() - 1) - 1;
        let share = ((time - times[at]) / (times[at + 1] - times[at])).clamp(0.0, 1.0);
        let [from, to] = self.rows_at(at);
        from.toward(to, share, places);
    }

    /// A sample and the next.
    fn rows_at(&mut self, k: usize) -> [&Row; 2] {
        for sample in [k, k + 1] {
            self.rows[sample % 2].read(&self.motion, sample, self.unit);
        }
        [&self.rows[k % 2], &self.rows[(k + 1) % 2]]
    }
}
