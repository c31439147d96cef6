//! Straight lines.

use std::sync::Arc;

use glam::DVec2;

use super::Transition;
use super::chain::Couple;
use crate::formation::Formation;

/// Every agent goes straight to its target.
#[derive(Clone, Debug)]
pub(super) struct Linear {
    source: Arc<Formation>,
    target: Arc<Formation>,
}

impl Linear {
    /// Plans it; ties do not matter.
    pub(super) fn new(ends: &Couple) -> Self {
        Self { source: ends.source.formation.clone(), target: ends.target.formation.clone() }
    }
}

impl Transition for Linear {
    fn agent_count(&self) -> usize {
        self.source.agent_count()
    }

    fn evaluate_into(&self, ts: &[f64], plan: &mut [DVec2], heights: Option<&mut [f64]>) {
        assert_eq!(plan.len(), ts.len() * self.agent_count(), "a place for every agent at every t");
        let ends = || self.source.positions().iter().zip(self.target.positions());
        let ways = ts.iter().flat_map(|t| ends().map(move |(from, to)| *from * (1.0 - t) + *to * *t));
        plan.iter_mut().zip(ways).for_each(|(place, way)| *place = way);
        if let Some(heights) = heights {
            let ends = |agent: usize| (self.source.height(agent), self.target.height(agent));
            let rises = ts.iter().flat_map(|t| (0..self.agent_count()).map(ends).map(move |(from, to)| from * (1.0 - t) + to * *t));
            heights.iter_mut().zip(rises).for_each(|(height, rise)| *height = rise);
        }
    }
}
