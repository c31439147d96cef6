//! Paper A's method: the source's eigenbasis turns into the target's while the coefficients run in polar coordinates.

use std::sync::Arc;

use glam::DVec2;

use super::Transition;
use super::modal::{Barycenters, Modes};
use crate::choice::Alignment;
use crate::formation::Formation;
use crate::spectral::{Courses, Matched, Turn};

/// X(t) = S Q^(ρ/2 + (1 − ρ) t) C(t) + b(t): with sharing ρ both ends are taken apart in bases that have already met part of the
/// way, so that less is left to turn; ρ = 0 is the paper's M(t) = Rᵗ S (equation 3).
#[derive(Clone, Debug)]
pub(super) struct Spectral {
    matched: Arc<Matched>,
    sharing: f64,
    courses: Courses,
    barycenters: Barycenters,
}

impl Spectral {
    /// Plans it from matched modes; `sharing` in 0..1.
    pub(super) fn new(formations: [&Formation; 2], matched: Arc<Matched>, alignment: Alignment, sharing: f64, keep_size: bool) -> Self {
        let [source, target] = matched.coefficients_shared(0.5 * sharing);
        let courses = Courses::between(&source, &target, Turn::between(formations, alignment));
        let courses = if keep_size { courses.keeping_size() } else { courses };
        Self { matched, sharing, courses, barycenters: Barycenters::of(formations) }
    }
}

impl Transition for Spectral {
    fn agent_count(&self) -> usize {
        self.matched.source_modes().nrows()
    }

    fn matrix_count(&self) -> usize {
        4
    }

    fn evaluate_into(&self, ts: &[f64], plan: &mut [DVec2], heights: Option<&mut [f64]>) {
        let modes = Modes { dimensions: self.courses.dimensions(), ..Modes::level(self.matched.source_modes()) };
        modes.evaluate(&|t| self.barycenters.at(t), ts, (plan, heights), &mut |ts, columns| {
            self.courses.write_columns(ts, columns);
            let powers: Vec<f64> = ts.iter().map(|t| 0.5 * self.sharing + (1.0 - self.sharing) * t).collect();
            self.matched.planes().turn_columns(&powers, columns);
        });
    }
}
