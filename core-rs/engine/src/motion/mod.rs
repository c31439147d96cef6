//! Where everybody is over time.
//!
//! A [`Motion`] is samples and nothing else: it knows neither scenes nor methods, and between samples agents move straight.

mod clashes;
mod closest;
mod pair_list;

use glam::DVec2;

use crate::formation::{Formation, Places, rise};

pub use clashes::clashes;
pub use closest::{Approach, Closeness, closeness};

/// Sample times nearer than this are one, seconds: round-off of frame / frame rate, far below any frame.
const SAME_INSTANT: f64 = 1e-9;

/// The least that counts as the agents' spacing, meters.
const LEAST_SPACING: f64 = 0.1;

/// Positions of all agents at rising times.
#[derive(Clone, Debug, PartialEq)]
pub struct Motion {
    times: Vec<f64>,
    agent_count: usize,
    positions: Vec<DVec2>,
    /// None on the plane.
    heights: Option<Vec<f64>>,
}

impl Motion {
    /// On the plane: `positions[k * agent_count + i]` is agent i at `times[k]`; seconds, meters.
    ///
    /// # Panics
    /// When times do not ascend or the positions are not so many: a bug, not input.
    pub fn new(times: Vec<f64>, agent_count: usize, positions: Vec<DVec2>) -> Self {
        assert!(times.is_sorted_by(|a, b| a < b), "samples ascend in time");
        assert_eq!(positions.len(), times.len() * agent_count, "every agent has a position at every sample");
        Self { times, agent_count, positions, heights: None }
    }

    /// In space: heights z as the positions are laid out.
    ///
    /// # Panics
    /// As [`Self::new`], and when there are not as many heights as positions.
    pub fn spatial(times: Vec<f64>, agent_count: usize, positions: Vec<DVec2>, heights: Vec<f64>) -> Self {
        assert_eq!(heights.len(), positions.len(), "every position has a height");
        Self { heights: Some(heights), ..Self::new(times, agent_count, positions) }
    }

    /// In space where there are heights, else on the plane.
    ///
    /// # Panics
    /// As [`Self::spatial`].
    pub fn sampled(times: Vec<f64>, agent_count: usize, positions: Vec<DVec2>, heights: Option<Vec<f64>>) -> Self {
        match heights {
            Some(heights) => Self::spatial(times, agent_count, positions, heights),
            None => Self::new(times, agent_count, positions),
        }
    }

    /// Sample times, seconds, ascending.
    pub fn times(&self) -> &[f64] {
        &self.times
    }

    /// How many agents move.
    pub fn agent_count(&self) -> usize {
        self.agent_count
    }

    /// All positions, sample by sample, as seen from above.
    pub fn positions(&self) -> &[DVec2] {
        &self.positions
    }

    /// All heights, sample by sample; none on the plane.
    pub fn heights(&self) -> Option<&[f64]> {
        self.heights.as_deref()
    }

    /// Positions by agent at sample `k`, as seen from above.
    pub fn sample(&self, k: usize) -> &[DVec2] {
        &self.positions[k * self.agent_count..(k + 1) * self.agent_count]
    }

    /// Heights by agent at sample `k`; none on the plane.
    pub fn sample_heights(&self, k: usize) -> Option<&[f64]> {
        self.heights.as_ref().map(|heights| &heights[k * self.agent_count..(k + 1) * self.agent_count])
    }

    /// Where everybody is at sample `k`.
    pub fn places(&self, k: usize) -> Places<'_> {
        Places::new(self.sample(k), self.sample_heights(k))
    }

    /// The formation at sample `k`.
    pub fn formation(&self, k: usize) -> Formation {
        let plan = self.sample(k).to_vec();
        match self.sample_heights(k) {
            Some(heights) => Formation::spatial(plan, heights.to_vec()),
            None => Formation::new(plan),
        }
    }

    /// The motion of some of its agents, in the order given.
    #[must_use]
    pub fn only(&self, agents: &[u32]) -> Self {
        let mut plan = Vec::with_capacity(self.times.len() * agents.len());
        let mut heights = self.heights.as_ref().map(|_| Vec::with_capacity(plan.capacity()));
        for k in 0..self.times.len() {
            plan.extend(agents.iter().map(|agent| self.sample(k)[*agent as usize]));
            if let (Some(heights), Some(sample)) = (&mut heights, self.sample_heights(k)) {
                heights.extend(agents.iter().map(|agent| sample[*agent as usize]));
            }
        }
        Self::sampled(self.times.clone(), agents.len(), plan, heights)
    }

    /// The mean of the median spacings at both ends, meters: at least a decimeter, since nobody is meant to stand nearer, and one
    /// meter for one agent alone.
    pub fn spacing(&self) -> f64 {
        let ends = [0, self.times.len() - 1].map(|k| self.formation(k).median_spacing());
        ends.map(|spacing| 0.5 * spacing.unwrap_or(1.0)).iter().sum::<f64>().max(LEAST_SPACING)
    }

    /// The fastest that anybody goes from one sample to the next, meters a second.
    pub fn top_speed(&self) -> f64 {
        let fastest = |k: usize| {
            let steps = self.places(k - 1).iter().zip(self.places(k).iter());
            steps.map(|(from, to)| from.distance(to)).fold(0.0, f64::max) / (self.times[k] - self.times[k - 1])
        };
        (1..self.times.len()).map(fastest).fold(0.0, f64::max)
    }

    /// The diagonal of the box that holds every sample, meters.
    pub fn extent(&self) -> f64 {
        let Some(&first) = self.positions.first() else { return 0.0 };
        let (low, high) = self.positions.iter().fold((first, first), |(low, high), p| (low.min(*p), high.max(*p)));
        low.distance(high).hypot(rise(self.heights()))
    }
}

/// When a segment is sampled: its departure, every frame f / `frame_rate` strictly inside, its arrival; seconds.
pub fn sample_times(start: f64, end: f64, frame_rate: f64) -> Vec<f64> {
    let mut times = vec![start];
    let mut frame = (start * frame_rate).floor().max(0.0);
    while frame / frame_rate < end - SAME_INSTANT {
        let time = frame / frame_rate;
        if time > start + SAME_INSTANT {
            times.push(time);
        }
        frame += 1.0;
    }
    times.push(end);
    times
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_segment_is_sampled_at_its_ends_and_at_the_frames_inside() {
        let check = |start, end, rate, expected: &[f64]| assert_eq!(sample_times(start, end, rate), expected, "{start} to {end} at {rate}");
        check(0.0, 1.0, 4.0, &[0.0, 0.25, 0.5, 0.75, 1.0]);
        check(0.3, 0.9, 4.0, &[0.3, 0.5, 0.75, 0.9]);
        check(0.3, 0.4, 4.0, &[0.3, 0.4]);
    }

    #[test]
    fn a_departure_that_is_a_frame_up_to_round_off_is_one_sample() {
        for frame in 0..200 {
            let start = f64::from(frame) * 0.1;
            let times = sample_times(start, start + 1.0, 10.0);
            assert_eq!(times.len(), 11, "from {start}");
        }
    }
}
