//! One basis for both ends: the eigenbasis of the mean Laplacian.
//!
//! It asks nothing about order, signs or rotation: a robust method to compare the paper's with.

use std::sync::Arc;

use super::Transition;
use super::modal::{Barycenters, evaluate_modes};
use crate::choice::Alignment;
use crate::formation::Formation;
use crate::spectral::{Coefficients, Eigenbasis, turn_between};

/// The coefficients move, the modes stay.
#[derive(Clone, Debug)]
pub(super) struct Shared {
    basis: Arc<Eigenbasis>,
    coefficients: Coefficients,
    barycenters: Barycenters,
}

impl Shared {
    /// Plans it in a basis of the mean Laplacian.
    pub(super) fn new(formations: [&Formation; 2], basis: Arc<Eigenbasis>, alignment: Alignment, keep_size: bool) -> Self {
        let turn = turn_between(formations[0], formations[1], alignment);
        let [source, target] = formations.map(|formation| basis.coefficients(formation));
        let coefficients = Coefficients::between(&source, &target, turn);
        let coefficients = if keep_size { coefficients.keeping_size() } else { coefficients };
        Self { basis, coefficients, barycenters: Barycenters::of(formations) }
    }
}

impl Transition for Shared {
    fn agent_count(&self) -> usize {
        self.basis.agent_count()
    }

    fn evaluate_into(&self, ts: &[f64], out: &mut [glam::DVec2]) {
        evaluate_modes(self.basis.modes(), |t| self.barycenters.at(t), ts, out, |ts, columns| self.coefficients.write_columns(ts, columns));
    }
}
