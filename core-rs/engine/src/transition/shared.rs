//! One basis for both ends: the eigenbasis of the mean Laplacian.
//!
//! It asks nothing about order, signs or rotation: a robust method to compare the paper's with.

use std::sync::Arc;

use glam::DVec2;

use super::Transition;
use super::modal::{Barycenters, Modes};
use crate::choice::Alignment;
use crate::formation::Formation;
use crate::spectral::{Courses, Eigenbasis, Turn};

/// The coefficients move, the modes stay.
#[derive(Clone, Debug)]
pub(super) struct Shared {
    basis: Arc<Eigenbasis>,
    courses: Courses,
    barycenters: Barycenters,
}

impl Shared {
    /// Plans it in a basis of the mean Laplacian.
    pub(super) fn new(formations: [&Formation; 2], basis: Arc<Eigenbasis>, alignment: Alignment, keep_size: bool) -> Self {
        let [source, target] = formations.map(|formation| basis.coefficients(formation));
        let courses = Courses::between(&source, &target, Turn::between(formations, alignment));
        let courses = if keep_size { courses.keeping_size() } else { courses };
        Self { basis, courses, barycenters: Barycenters::of(formations) }
    }
}

impl Transition for Shared {
    fn agent_count(&self) -> usize {
        self.basis.agent_count()
    }

    fn matrix_count(&self) -> usize {
        1
    }

    fn evaluate_into(&self, ts: &[f64], plan: &mut [DVec2], heights: Option<&mut [f64]>) {
        let modes = Modes { dimensions: self.courses.dimensions(), ..Modes::level(self.basis.modes()) };
        modes.evaluate(&|t| self.barycenters.at(t), ts, (plan, heights), &mut |ts, columns| self.courses.write_columns(ts, columns));
    }
}
