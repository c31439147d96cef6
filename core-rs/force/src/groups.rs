//! Attraction within subgroups (paper D, equation 21).
//!
//! As printed it grows as e^d without bound, and a sum over all members would cost their square. Here it is A′(1 − e^{−d/B′}) toward
//! the barycenter of the subgroup: one term an agent, and never more than A′.

use crate::constants::Constants;
use crate::exponential::exp;

/// The subgroup of whoever has none.
pub const NO_GROUP: u32 = u32::MAX;

/// Who belongs to which subgroup, and where those are.
#[derive(Clone, Debug)]
pub struct Groups {
    of_agent: Vec<u32>,
    count: Vec<f64>,
    x: Vec<f64>,
    y: Vec<f64>,
}

impl Groups {
    /// By agent: a number from 0, or [`NO_GROUP`].
    pub fn new(of_agent: Vec<u32>) -> Self {
        let most = of_agent.iter().filter(|group| **group != NO_GROUP).max().map_or(0, |group| *group as usize + 1);
        Self { of_agent, count: vec![0.0; most], x: vec![0.0; most], y: vec![0.0; most] }
    }

    /// Whether anybody belongs to one.
    pub fn are_there(&self) -> bool {
        !self.count.is_empty()
    }

    /// By agent; who differs in it pushes each other as strangers.
    pub fn of_agent(&self) -> &[u32] {
        &self.of_agent
    }

    /// Adds the attraction to forces.
    pub fn attract(&mut self, constants: &Constants, [x, y]: [&[f64]; 2], [fx, fy]: [&mut [f64]; 2]) {
        if !self.are_there() || constants.group_strength == 0.0 {
            return;
        }
        self.find_barycenters(x, y);
        for (agent, group) in self.of_agent.iter().enumerate().filter(|(_, group)| **group != NO_GROUP) {
            let group = *group as usize;
            let way = [self.x[group] - x[agent], self.y[group] - y[agent]];
            let distance = (way[0] * way[0] + way[1] * way[1]).sqrt();
            if distance > 0.0 {
                let pull = constants.group_strength * (1.0 - exp(-distance / constants.group_reach)) / distance;
                fx[agent] += pull * way[0];
                fy[agent] += pull * way[1];
            }
        }
    }

    fn find_barycenters(&mut self, x: &[f64], y: &[f64]) {
        for sums in [&mut self.count, &mut self.x, &mut self.y] {
            sums.fill(0.0);
        }
        for (agent, group) in self.of_agent.iter().enumerate().filter(|(_, group)| **group != NO_GROUP) {
            let group = *group as usize;
            self.count[group] += 1.0;
            self.x[group] += x[agent];
            self.y[group] += y[agent];
        }
        for (group, count) in self.count.iter().enumerate().filter(|(_, count)| **count > 0.0) {
            self.x[group] /= count;
            self.y[group] /= count;
        }
    }
}
