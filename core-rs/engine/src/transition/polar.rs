//! Polar coordinates about the barycenter, agent by agent: the paper's simple polar interpolation (paper A, section 3.3).

use glam::DVec2;

use super::Transition;
use super::modal::{Barycenters, evaluate_places};
use crate::choice::Alignment;
use crate::formation::Formation;
use crate::spectral::{Coefficients, turn_between};

/// Every agent turns about the barycenter while its distance from it runs linearly.
#[derive(Clone, Debug)]
pub(super) struct Polar {
    agent_count: usize,
    places: Coefficients,
    barycenters: Barycenters,
}

impl Polar {
    /// Plans it; ties do not matter.
    pub(super) fn new(formations: [&Formation; 2], alignment: Alignment) -> Self {
        let turn = turn_between(formations[0], formations[1], alignment);
        let [source, target] = formations.map(about_barycenter);
        Self {
            agent_count: formations[0].agent_count(),
            places: Coefficients::between(&source, &target, turn),
            barycenters: Barycenters::of(formations),
        }
    }
}

impl Transition for Polar {
    fn agent_count(&self) -> usize {
        self.agent_count
    }

    fn evaluate_into(&self, ts: &[f64], out: &mut [DVec2]) {
        let center_at = |t| self.barycenters.at(t);
        evaluate_places(self.agent_count, center_at, ts, out, |ts, columns| self.places.write_columns(ts, columns));
    }
}

/// Places about their barycenter.
pub(super) fn about_barycenter(formation: &Formation) -> Vec<DVec2> {
    let center = formation.barycenter();
    formation.positions().iter().map(|p| *p - center).collect()
}
