//! The modes of one formation: the eigenvectors of its Laplacian.

use faer::{Mat, MatRef};
use glam::DVec3;

use crate::formation::Formation;
use eigenform_dense::Reduced;

/// The eigenvalues of a Laplacian, and half of the work toward its modes: what is enough to see whether eigenvalues repeat.
#[derive(Clone, Debug)]
pub(crate) struct Spectrum {
    eigenvalues: Vec<f64>,
    reduced: Reduced,
}

impl Spectrum {
    /// The spectrum of an n × n Laplacian (symmetric, rows summing to zero), in O(n³).
    pub(crate) fn of(laplacian: MatRef<'_, f64>) -> Self {
        let reduced = Reduced::of(without_constant(laplacian).as_ref());
        let eigenvalues = with_constant(laplacian.nrows(), &reduced.eigenvalues());
        Self { eigenvalues, reduced }
    }

    /// As those of [`Eigenbasis::eigenvalues`].
    pub(crate) fn eigenvalues(&self) -> &[f64] {
        &self.eigenvalues
    }

    /// The other half, in O(n³).
    pub(crate) fn basis(&self) -> Eigenbasis {
        let eigen = self.reduced.eigen();
        let modes = if self.eigenvalues.is_empty() { eigen.vectors } else { over_agents(eigen.vectors.as_ref()) };
        Eigenbasis { eigenvalues: with_constant(self.eigenvalues.len(), &eigen.values), modes }
    }
}

/// The constant mode's 0 and the eigenvalues beside it; none for nobody.
fn with_constant(agent_count: usize, others: &[f64]) -> Vec<f64> {
    // The Laplacian is positive semidefinite; what round-off leaves below zero is zero.
    std::iter::once(0.0).chain(others.iter().map(|value| value.max(0.0))).take(agent_count).collect()
}

/// A row's sum below this, of its diagonal, is round-off: 5,000 terms leave less than a thousandth of it.
const ROUND_OFF: f64 = 1e-9;

/// The eigenvalues of a Laplacian and an orthonormal basis of its modes (paper A, section 3.1).
///
/// The constant mode is split off exactly before anything is solved, so a graph in several pieces is no special case.
#[derive(Clone, Debug)]
pub struct Eigenbasis {
    eigenvalues: Vec<f64>,
    modes: Mat<f64>,
}

impl Eigenbasis {
    /// The eigenbasis of an n × n Laplacian (symmetric, rows summing to zero or above) on the complement of the constant, in O(n³).
    pub fn of(laplacian: MatRef<'_, f64>) -> Self {
        Spectrum::of(laplacian).basis()
    }

    /// How many agents it spans.
    pub fn agent_count(&self) -> usize {
        self.eigenvalues.len()
    }

    /// Eigenvalues, ascending; the first is the constant mode's 0.
    pub fn eigenvalues(&self) -> &[f64] {
        &self.eigenvalues
    }

    /// Unit modes orthogonal to the constant, agents × (agents − 1): column k belongs to eigenvalue k + 1. Signs are arbitrary.
    pub fn modes(&self) -> MatRef<'_, f64> {
        self.modes.as_ref()
    }

    /// One row (α, β, γ) a mode, meters, of the formation about its barycenter (paper A, equation 1); γ is 0 where it stands level.
    ///
    /// # Panics
    /// When they are not the same agents: a bug.
    pub fn coefficients(&self, formation: &Formation) -> Vec<DVec3> {
        let places = formation.places().about_barycenter();
        assert_eq!(places.len(), self.agent_count(), "a basis is of its formation's agents");
        self.modes.col_iter().map(|mode| places.iter().zip(mode.iter()).map(|(p, e)| *p * *e).sum()).collect()
    }

    pub(super) fn with_modes(&self, modes: Mat<f64>) -> Self {
        Self { eigenvalues: self.eigenvalues.clone(), modes }
    }
}

// Both directions use the reflection P = 1 − u uᵀ/(1 + h) with h = 1/√n and u = (1 + h, h, …, h), which takes the first axis
// to minus the unit constant vector. It is never formed: that would cost two n³ products.

/// P L P without its first row and column.
///
/// L u is the first column of L and h times the sums of the rows: zero, save where an agent is tied to what does not move.
fn without_constant(laplacian: MatRef<'_, f64>) -> Mat<f64> {
    let agent_count = laplacian.nrows();
    if agent_count == 0 {
        return Mat::zeros(0, 0);
    }
    let h = 1.0 / (agent_count as f64).sqrt();
    let scale = 1.0 / (1.0 + h);
    let sums = row_sums(laplacian);
    let through = laplacian[(0, 0)] + h * (2.0 * sums[0] + h * sums.iter().sum::<f64>());
    let shift = 0.5 * scale * scale * through * h;
    let update: Vec<f64> = (1..agent_count).map(|row| h * (scale * (laplacian[(row, 0)] + h * sums[row]) - shift)).collect();
    Mat::from_fn(agent_count - 1, agent_count - 1, |row, column| laplacian[(row + 1, column + 1)] - (update[row] + update[column]))
}

/// The sums of the rows; exactly zero where they are round-off.
fn row_sums(laplacian: MatRef<'_, f64>) -> Vec<f64> {
    let sum = |row: usize| -> f64 {
        let sum = laplacian.row(row).iter().sum();
        if sum > ROUND_OFF * laplacian[(row, row)] { sum } else { 0.0 }
    };
    (0..laplacian.nrows()).map(sum).collect()
}

/// P applied to vectors that lack the first coordinate.
fn over_agents(reduced: MatRef<'_, f64>) -> Mat<f64> {
    let agent_count = reduced.nrows() + 1;
    let h = 1.0 / (agent_count as f64).sqrt();
    let mut modes = Mat::zeros(agent_count, reduced.ncols());
    for column in 0..reduced.ncols() {
        let sum: f64 = reduced.col(column).iter().sum();
        let shift = h * h / (1.0 + h) * sum;
        modes[(0, column)] = -h * sum;
        for row in 1..agent_count {
            modes[(row, column)] = reduced[(row - 1, column)] - shift;
        }
    }
    modes
}

#[cfg(test)]
mod tests {
    use super::*;

    fn cycle(agent_count: usize) -> Mat<f64> {
        let mut laplacian = Mat::zeros(agent_count, agent_count);
        for a in 0..agent_count {
            let b = (a + 1) % agent_count;
            for (row, column, value) in [(a, a, 1.0), (b, b, 1.0), (a, b, -1.0), (b, a, -1.0)] {
                laplacian[(row, column)] += value;
            }
        }
        laplacian
    }

    fn check(laplacian: &Mat<f64>, expected: &[f64]) {
        let basis = Eigenbasis::of(laplacian.as_ref());
        let n = laplacian.nrows();
        assert_eq!(basis.eigenvalues().len(), n);
        // A backward stable solver: a small multiple of eps · λ_max.
        let tolerance = 1e-14 * n as f64 * expected.last().copied().unwrap_or(0.0).max(1.0);
        for (value, expected) in basis.eigenvalues().iter().zip(expected) {
            assert!((value - expected).abs() < tolerance, "{value} {expected}");
        }
        let modes = basis.modes();
        let residual = laplacian * modes - modes * Mat::from_fn(n - 1, n - 1, |r, c| if r == c { expected[r + 1] } else { 0.0 });
        assert!(residual.norm_max() < tolerance);
        assert!((modes.transpose() * modes - Mat::<f64>::identity(n - 1, n - 1)).norm_max() < 1e-13);
        for column in 0..n - 1 {
            assert!(modes.col(column).iter().sum::<f64>().abs() < 1e-13 * n as f64);
        }
    }

    #[test]
    fn a_cycle_has_the_eigenvalues_of_the_textbook() {
        for n in [3, 4, 7, 40] {
            let mut expected: Vec<f64> = (0..n).map(|k| 2.0 - 2.0 * (std::f64::consts::TAU * f64::from(k) / f64::from(n)).cos()).collect();
            expected.sort_by(f64::total_cmp);
            check(&cycle(n as usize), &expected);
        }
    }

    #[test]
    fn one_two_and_no_agents_have_a_basis() {
        assert_eq!(Eigenbasis::of(Mat::zeros(0, 0).as_ref()).agent_count(), 0);
        let one = Eigenbasis::of(Mat::zeros(1, 1).as_ref());
        assert_eq!((one.eigenvalues(), one.modes().nrows(), one.modes().ncols()), (&[0.0][..], 1, 0));
        check(&Mat::from_fn(2, 2, |r, c| if r == c { 3.0 } else { -3.0 }), &[0.0, 6.0]);
    }

    #[test]
    fn a_tie_to_what_does_not_move_counts_beside_the_constant() {
        let mut laplacian = cycle(7);
        laplacian[(0, 0)] += 3.0;
        laplacian[(4, 4)] += 0.5;
        let basis = Eigenbasis::of(laplacian.as_ref());
        let modes = basis.modes();
        // Within the complement of the constant the modes are those of the matrix.
        let within = modes.transpose() * &laplacian * modes;
        for row in 0..6 {
            for column in 0..6 {
                let expected = if row == column { basis.eigenvalues()[row + 1] } else { 0.0 };
                assert!((within[(row, column)] - expected).abs() < 1e-13, "{row} {column}");
            }
        }
        assert!((basis.eigenvalues()[6] - 5.0).abs() < 1.0, "the firmly tied agent is nearly a mode of its own");
    }

    #[test]
    fn a_cut_graph_has_a_zero_for_every_piece() {
        let mut laplacian: Mat<f64> = Mat::zeros(6, 6);
        laplacian.submatrix_mut(0, 0, 3, 3).copy_from(cycle(3));
        laplacian.submatrix_mut(3, 3, 3, 3).copy_from(cycle(3));
        check(&laplacian, &[0.0, 0.0, 3.0, 3.0, 3.0, 3.0]);
    }
}
