//! Polar coordinates about the barycenter, agent by agent: the paper's simple polar interpolation (paper A, section 3.3).

use glam::DVec2;

use super::Transition;
use super::modal::{Barycenters, Modes};
use crate::choice::Alignment;
use crate::formation::Formation;
use crate::spectral::{Courses, Turn};

/// Every agent turns about the barycenter while its distance from it runs linearly.
#[derive(Clone, Debug)]
pub(super) struct Polar {
    agent_count: usize,
    courses: Courses,
    barycenters: Barycenters,
}

impl Polar {
    /// Plans it; ties do not matter.
    pub(super) fn new(formations: [&Formation; 2], alignment: Alignment) -> Self {
        let [source, target] = formations.map(|formation| formation.places().about_barycenter());
        Self {
            agent_count: formations[0].agent_count(),
            courses: Courses::between(&source, &target, Turn::between(formations, alignment)),
            barycenters: Barycenters::of(formations),
        }
    }
}

impl Transition for Polar {
    fn agent_count(&self) -> usize {
        self.agent_count
    }

    fn evaluate_into(&self, ts: &[f64], plan: &mut [DVec2], heights: Option<&mut [f64]>) {
        let agents = Modes { agent_count: self.agent_count, basis: None, dimensions: self.courses.dimensions() };
        agents.evaluate(&|t| self.barycenters.at(t), ts, (plan, heights), &mut |ts, columns| self.courses.write_columns(ts, columns));
    }
}

/// Places about their barycenter, as seen from above.
pub(super) fn about_barycenter(formation: &Formation) -> Vec<DVec2> {
    let center = formation.barycenter();
    formation.positions().iter().map(|p| *p - center).collect()
}
