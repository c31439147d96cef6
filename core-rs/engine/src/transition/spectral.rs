//! Paper A's method: the source's eigenbasis turns into the target's while the coefficients run in polar coordinates.

use std::sync::Arc;

use faer::{MatMut, MatRef};
use glam::DVec2;

use super::Transition;
use super::modal::{Barycenters, Modes};
use crate::choice::Alignment;
use crate::formation::Formation;
use crate::spectral::{Courses, Matched, Turn, product_into};

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
        self.matched.modes_in_planes().nrows()
    }

    fn evaluate_into(&self, ts: &[f64], plan: &mut [DVec2], heights: Option<&mut [f64]>) {
        let planes = self.matched.planes();
        let mode_count = planes.basis().ncols();
        let mut in_modes = Vec::new();
        let modes = Modes { dimensions: self.courses.dimensions(), ..Modes::level(self.matched.modes_in_planes()) };
        modes.evaluate(&|t| self.barycenters.at(t), ts, (plan, heights), &mut |ts, columns| {
            in_modes.resize(columns.len(), 0.0);
            self.courses.write_columns(ts, &mut in_modes);
            product_into(
                MatMut::from_column_major_slice_mut(columns, mode_count, modes.dimensions * ts.len()),
                planes.basis().transpose(),
                MatRef::from_column_major_slice(&in_modes, mode_count, modes.dimensions * ts.len()),
            );
            for (t, columns) in ts.iter().zip(columns.chunks_exact_mut(modes.dimensions * mode_count)) {
                planes.turn(0.5 * self.sharing + (1.0 - self.sharing) * t, columns);
            }
        });
    }
}
