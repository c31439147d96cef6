//! How much agents change their heading.

use glam::DVec3;

/// A step shorter than this, relative to the extent, has no heading.
const NO_HEADING: f64 = 1e-6;

/// Every agent's last heading and what it has turned so far.
pub(super) struct Headings {
    last: Vec<Option<DVec3>>,
    turning: Vec<f64>,
    least_step: f64,
}

impl Headings {
    pub(super) fn new(agent_count: usize, extent: f64) -> Self {
        Self { last: vec![None; agent_count], turning: vec![0.0; agent_count], least_step: NO_HEADING * extent }
    }

    /// Takes the agent's next step; answers by how much its heading changed, radians ≥ 0. A step without a heading leaves the last.
    pub(super) fn step(&mut self, agent: usize, step: DVec3, length: f64) -> f64 {
        if length <= self.least_step {
            return 0.0;
        }
        let change = self.last[agent].map_or(0.0, |last| libm::atan2(last.cross(step).length(), last.dot(step)));
        self.last[agent] = Some(step);
        self.turning[agent] += change;
        change
    }

    /// What every agent turned in all, radians.
    pub(super) fn into_turning(self) -> Vec<f64> {
        self.turning
    }
}
