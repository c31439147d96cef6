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

    fn evaluate_into(&self, ts: &[f64], out: &mut [DVec2]) {
        assert_eq!(out.len(), ts.len() * self.agent_count(), "a place for every agent at every t");
        let ends = || self.source.positions().iter().zip(self.target.positions());
        let ways = ts.iter().flat_map(|t| ends().map(move |(from, to)| *from * (1.0 - t) + *to * *t));
        out.iter_mut().zip(ways).for_each(|(place, way)| *place = way);
    }
}
