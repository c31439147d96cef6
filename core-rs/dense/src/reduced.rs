//! A symmetric matrix in tridiagonal form: from there its eigenvalues cost n², its eigenvectors n³.

use faer::diag::Diag;
use faer::dyn_stack::{MemBuffer, MemStack};
use faer::linalg::evd::tridiag::tridiag_in_place;
use faer::linalg::evd::{ComputeEigenvectors, self_adjoint_evd_scratch, tridiagonal_self_adjoint_evd};
use faer::linalg::householder::apply_block_householder_sequence_on_the_left_in_place_with_conj as reflect;
use faer::linalg::qr::no_pivoting::factor::recommended_block_size;
use faer::prelude::default;
use faer::{Conj, Mat, MatRef, Par, Scale};

use super::{SymmetricEigen, largest};

/// Where half of the work toward eigenvectors is done and the eigenvalues are at hand.
#[derive(Clone, Debug)]
pub struct Reduced {
    /// The matrix over this has entries near 1.
    unit: f64,
    diagonal: Diag<f64>,
    /// One entry shorter, with a zero at the end.
    beside: Diag<f64>,
    /// Below the diagonal: the reflections that reduced the matrix.
    reflections: Mat<f64>,
    factors: Mat<f64>,
}

impl Reduced {
    /// Reduces a symmetric matrix, of which only the lower triangle is read.
    pub fn of(matrix: MatRef<'_, f64>) -> Self {
        let size = matrix.nrows();
        // faer's divide and conquer compares entries of the matrix with those of unit vectors, so a matrix far from 1 loses digits
        // (all of them below 1e-16). A power of two changes no digit itself.
        let unit = power_of_two_near(largest(matrix));
        let mut reflections = matrix * Scale(unit.recip());
        let mut factors = Mat::zeros(recommended_block_size::<f64>(size, size), size.saturating_sub(1));
        // Fewer than two rows are reduced as they are.
        if size > 1 {
            with_memory(size, |memory| tridiag_in_place(reflections.as_mut(), factors.as_mut(), Par::Seq, memory, default()));
        }
        let mut diagonal = Diag::zeros(size);
        let mut beside = Diag::zeros(size);
        for k in 0..size {
            diagonal[k] = reflections[(k, k)];
            beside[k] = if k + 1 < size { reflections[(k + 1, k)] } else { 0.0 };
        }
        Self { unit, diagonal, beside, reflections, factors }
    }

    /// How many rows.
    pub fn size(&self) -> usize {
        self.reflections.nrows()
    }

    /// The eigenvalues, ascending, in O(n²).
    ///
    /// # Panics
    /// When an entry is not finite: a bug, since the document refuses such numbers.
    pub fn eigenvalues(&self) -> Vec<f64> {
        self.solve(None)
    }

    /// Eigenvalues and eigenvectors, in O(n³).
    ///
    /// # Panics
    /// When an entry is not finite: a bug.
    pub fn eigen(&self) -> SymmetricEigen {
        let size = self.size();
        let mut vectors = Mat::zeros(size, size);
        let values = self.solve(Some(&mut vectors));
        if size > 1 {
            let reflections = self.reflections.submatrix(1, 0, size - 1, size - 1);
            let below = vectors.as_mut().subrows_mut(1, size - 1);
            with_memory(size, |memory| reflect(reflections, self.factors.as_ref(), Conj::No, below, Par::Seq, memory));
        }
        SymmetricEigen { values, vectors }
    }

    fn solve(&self, vectors: Option<&mut Mat<f64>>) -> Vec<f64> {
        if self.size() == 0 {
            return Vec::new();
        }
        let mut values = Diag::zeros(self.size());
        let vectors = vectors.map(Mat::as_mut);
        with_memory(self.size(), |memory| {
            tridiagonal_self_adjoint_evd(
                self.diagonal.as_ref(),
                self.beside.as_ref(),
                values.as_mut(),
                vectors,
                Par::Seq,
                memory,
                default(),
            )
            .expect("a finite symmetric matrix has an eigendecomposition");
        });
        values.column_vector().iter().map(|value| value * self.unit).collect()
    }
}

/// Enough for any of the steps.
fn with_memory(size: usize, work: impl FnOnce(&mut MemStack)) {
    let mut memory = MemBuffer::new(self_adjoint_evd_scratch::<f64>(size, ComputeEigenvectors::Yes, Par::Seq, default()));
    work(MemStack::new(&mut memory));
}

/// Not above a positive value and more than half of it; 1 for zero.
fn power_of_two_near(value: f64) -> f64 {
    const MANTISSA_BITS: u32 = f64::MANTISSA_DIGITS - 1;
    const SMALLEST: u64 = 0x3ff - 1000;
    const GREATEST: u64 = 0x3ff + 1000;
    if value == 0.0 { 1.0 } else { f64::from_bits((value.to_bits() >> MANTISSA_BITS).clamp(SMALLEST, GREATEST) << MANTISSA_BITS) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tests::random_symmetric;

    #[test]
    fn the_eigenvalues_alone_are_those_beside_the_vectors() {
        for size in [0, 1, 2, 3, 40, 200] {
            let matrix = random_symmetric(size);
            let reduced = Reduced::of(matrix.as_ref());
            let alone = reduced.eigenvalues();
            assert_eq!(alone.len(), size);
            assert!(alone.is_sorted());
            // Both are backward stable: each is within a small multiple of eps times the norm, which grows with the size.
            let tolerance = 8.0 * f64::EPSILON * size as f64;
            for (one, other) in alone.iter().zip(reduced.eigen().values) {
                assert!((one - other).abs() <= tolerance, "size {size}: {one} and {other}");
            }
        }
    }
}
