//! Paper A's method: the source's eigenbasis turns into the target's while the coefficients run in polar coordinates.

use std::sync::Arc;

use faer::{MatMut, MatRef};
use glam::DVec2;

use super::Transition;
use super::modal::{Barycenters, evaluate_modes};
use crate::choice::Alignment;
use crate::formation::Formation;
use crate::spectral::{Coefficients, Matched, product_into, turn_between};

/// X(t) = S Q^(ρ/2 + (1 − ρ) t) C(t) + b(t): with sharing ρ both ends are taken apart in bases that have already met part of the
/// way, so that less is left to turn; ρ = 0 is the paper's M(t) = Rᵗ S (equation 3).
#[derive(Clone, Debug)]
pub(super) struct Spectral {
    matched: Arc<Matched>,
    sharing: f64,
    coefficients: Coefficients,
    barycenters: Barycenters,
}

impl Spectral {
    /// Plans it from matched modes; `sharing` in 0..1.
    pub(super) fn new(formations: [&Formation; 2], matched: Arc<Matched>, alignment: Alignment, sharing: f64, keep_size: bool) -> Self {
        let turn = turn_between(formations[0], formations[1], alignment);
        let [source, target] = matched.coefficients_shared(0.5 * sharing);
        let coefficients = Coefficients::between(&source, &target, turn);
        let coefficients = if keep_size { coefficients.keeping_size() } else { coefficients };
        Self { matched, sharing, coefficients, barycenters: Barycenters::of(formations) }
    }
}

impl Transition for Spectral {
    fn agent_count(&self) -> usize {
        self.matched.modes_in_planes().nrows()
    }

    fn evaluate_into(&self, ts: &[f64], out: &mut [DVec2]) {
        let planes = self.matched.planes();
        let mode_count = planes.basis().ncols();
        let mut in_modes = Vec::new();
        evaluate_modes(
            self.matched.modes_in_planes(),
            |t| self.barycenters.at(t),
            ts,
            out,
            |ts, columns| {
                in_modes.resize(columns.len(), 0.0);
                self.coefficients.write_columns(ts, &mut in_modes);
                product_into(
                    MatMut::from_column_major_slice_mut(columns, mode_count, 2 * ts.len()),
                    planes.basis().transpose(),
                    MatRef::from_column_major_slice(&in_modes, mode_count, 2 * ts.len()),
                );
                for (t, columns) in ts.iter().zip(columns.chunks_exact_mut(2 * mode_count)) {
                    planes.turn(0.5 * self.sharing + (1.0 - self.sharing) * t, columns);
                }
            },
        );
    }
}
