//! The modes at both ends of a transition, side by side.

use std::sync::Arc;

use faer::{Mat, MatRef};
use glam::DVec3;

use super::degenerate::turned_to;
use super::eigenbasis::Eigenbasis;
use crate::formation::Formation;
use eigenform_dense::product;

/// The eigenbases of a source and a target, how alike their modes are, and both formations in their own modes.
///
/// Nothing here depends on order, alignment or sharing: every spectral candidate of a segment starts from the same pair.
#[derive(Clone, Debug)]
pub(crate) struct Pair {
    source: Arc<Eigenbasis>,
    target: Arc<Eigenbasis>,
    likeness: Mat<f64>,
    source_coefficients: Vec<DVec3>,
    target_coefficients: Vec<DVec3>,
}

impl Pair {
    /// From bases that differ in every eigenvalue.
    pub(crate) fn of_simple(formations: [&Formation; 2], source: Arc<Eigenbasis>, target: Arc<Eigenbasis>) -> Self {
        let likeness = product(source.modes().transpose(), target.modes());
        let source_coefficients = source.coefficients(formations[0]);
        let target_coefficients = target.coefficients(formations[1]);
        Self { source, target, likeness, source_coefficients, target_coefficients }
    }

    /// From bases of graphs with the tie-break mixed in: blocks equal even then are turned to fit the source.
    pub(crate) fn of_tie_broken(formations: [&Formation; 2], source: Arc<Eigenbasis>, target: &Eigenbasis) -> Self {
        let target = turned_to(&source, target);
        Self::of_simple(formations, source, Arc::new(target))
    }

    /// How many modes there are beside the constant one.
    pub(crate) fn mode_count(&self) -> usize {
        self.likeness.nrows()
    }

    /// The source modes, agents × modes.
    pub(crate) fn source_modes(&self) -> MatRef<'_, f64> {
        self.source.modes()
    }

    /// The target modes as they come, agents × modes.
    pub(super) fn target_modes(&self) -> MatRef<'_, f64> {
        self.target.modes()
    }

    /// Inner products: row = source mode, column = target mode.
    pub(super) fn likeness(&self) -> MatRef<'_, f64> {
        self.likeness.as_ref()
    }

    /// The source formation about its barycenter, in source modes.
    pub(super) fn source_coefficients(&self) -> &[DVec3] {
        &self.source_coefficients
    }

    /// The target formation about its barycenter, in target modes as they come.
    pub(super) fn target_coefficients(&self) -> &[DVec3] {
        &self.target_coefficients
    }
}
