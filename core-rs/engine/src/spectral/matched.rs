//! Two bases with every mode paired and every sign fixed, and the rotation between them taken apart.

use std::sync::Arc;

use faer::{Mat, MatRef};
use glam::DVec3;

use super::matching::Pairing;
use super::maxmin::EQUAL_LIKENESS;
use super::pair::Pair;
use super::planes::Planes;
use super::signs::NO_SIGN;
use eigenform_dense::{determinant, product};

/// The rotation R of paper A, equation 2, ready to be taken to any power.
#[derive(Clone, Debug)]
pub(crate) struct Matched {
    pair: Arc<Pair>,
    planes: Planes,
    target_coefficients: Vec<DVec3>,
}

impl Matched {
    /// Matches the bases and finds the rotation planes, in O(n³). `reversals` come from [`super::reversals`].
    ///
    /// A rotation by degrees needs determinant +1: where it is −1 the target mode least like its source is reversed once more.
    pub(crate) fn new(pair: Arc<Pair>, pairing: &Pairing, mut reversals: Vec<bool>) -> Self {
        let mut rotation = paired(pair.likeness(), pairing.targets(), &reversals);
        if !reversals.is_empty() && determinant(rotation.as_ref()) < 0.0 {
            let mode = least_like(pair.likeness(), pairing.targets());
            reversals[mode] = !reversals[mode];
            rotation.col_mut(mode).iter_mut().for_each(|entry| *entry = -*entry);
        }
        let planes = Planes::of(rotation.as_ref());
        let target_coefficients = pairing
            .targets()
            .iter()
            .zip(&reversals)
            .map(
                |(&target, &is_reversed)| {
                    if is_reversed { -pair.target_coefficients()[target] } else { pair.target_coefficients()[target] }
                },
            )
            .collect();
        Self { pair, planes, target_coefficients }
    }

    /// The planes in which the source modes turn into the target modes.
    pub(crate) fn planes(&self) -> &Planes {
        &self.planes
    }

    /// The rotation of all agents that takes the source modes into the target modes; the constant stays.
    pub(crate) fn turn_of_agents(&self) -> Planes {
        self.planes.over_agents(product(self.source_modes(), self.planes.basis()).as_ref())
    }

    /// The source modes, agents × modes.
    pub(crate) fn source_modes(&self) -> MatRef<'_, f64> {
        self.pair.source_modes()
    }

    /// The source in its modes turned by `fraction` of the rotation, and the target in the same share of the way back.
    ///
    /// With fraction ρ/2 only the power 1 − ρ remains between the two bases.
    pub(crate) fn coefficients_shared(&self, fraction: f64) -> [Vec<DVec3>; 2] {
        [
            self.planes.turned_in_space(self.pair.source_coefficients(), -fraction),
            self.planes.turned_in_space(&self.target_coefficients, fraction),
        ]
    }
}

fn paired(likeness: MatRef<'_, f64>, targets: &[usize], reversals: &[bool]) -> Mat<f64> {
    Mat::from_fn(targets.len(), targets.len(), |row, column| {
        let entry = likeness[(row, targets[column])];
        if reversals[column] { -entry } else { entry }
    })
}

/// Of equals the lowest index. Inner products without a sign are all zero, else round-off would choose among them.
fn least_like(likeness: MatRef<'_, f64>, targets: &[usize]) -> usize {
    let amount = |(source, &target): (usize, &usize)| likeness[(source, target)].abs();
    let amounts: Vec<f64> = targets.iter().enumerate().map(amount).map(|a| if a < NO_SIGN { 0.0 } else { a }).collect();
    let least = amounts.iter().copied().fold(f64::INFINITY, f64::min);
    amounts.iter().position(|amount| *amount <= least + EQUAL_LIKENESS).unwrap_or(0)
}
