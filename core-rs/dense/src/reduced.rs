//! A symmetric matrix in tridiagonal form: from there its eigenvalues cost n², its eigenvectors n³.

use faer::linalg::triangular_solve::solve_upper_triangular_in_place;
use faer::prelude::{Reborrow, ReborrowMut};
use faer::{Mat, MatMut, MatRef, Par, Scale};

use super::reduction::{Tridiagonal, reduce};
use super::tridiagonal::eigenvalues;
use super::{SymmetricEigen, conquer, largest, product, subtract_product};

/// So many reflections are applied in one go.
const BLOCK: usize = 32;

/// Where half of the work toward eigenvectors is done and the eigenvalues are at hand.
#[derive(Clone, Debug)]
pub struct Reduced {
    /// The matrix over this has entries near 1.
    unit: f64,
    diagonal: Vec<f64>,
    /// Each with the one below it; the last 0.
    beside: Vec<f64>,
    /// Below the diagonal: the vectors of the reflections that reduced the matrix.
    reflections: Mat<f64>,
}

impl Reduced {
    /// Reduces a symmetric matrix, of which only the lower triangle is read.
    pub fn of(matrix: MatRef<'_, f64>) -> Self {
        // Squares of entries stay far from the ends of the range, and entries can be compared with those of unit vectors. A power of
        // two changes no digit itself.
        let unit = power_of_two_near(largest(matrix));
        let mut reflections = matrix * Scale(unit.recip());
        let Tridiagonal { diagonal, beside } = reduce(reflections.as_mut());
        Self { unit, diagonal, beside, reflections }
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
        eigenvalues(&self.diagonal, &self.beside).into_iter().map(|value| value * self.unit).collect()
    }

    /// Eigenvalues and eigenvectors, in O(n³).
    ///
    /// # Panics
    /// When an entry is not finite: a bug.
    pub fn eigen(&self) -> SymmetricEigen {
        let size = self.size();
        let mut vectors = Mat::zeros(size, size);
        if size == 0 {
            return SymmetricEigen { values: Vec::new(), vectors };
        }
        let values = conquer::eigen(&self.diagonal, &self.beside, vectors.as_mut());
        self.reflect(vectors.as_mut());
        SymmetricEigen { values: values.into_iter().map(|value| value * self.unit).collect(), vectors }
    }

    /// Takes vectors of the tridiagonal matrix to those of the matrix: block by block, (I − V T⁻¹ Vᵀ) X, where T is the upper triangle
    /// of `VᵀV`, its diagonal halved (Puglisi 1992).
    fn reflect(&self, vectors: MatMut<'_, f64>) {
        let count = self.size() - 1;
        let mut below = vectors.subrows_mut(1, count);
        for start in (0..count).step_by(BLOCK).rev() {
            let width = BLOCK.min(count - start);
            let kept = self.reflections.submatrix(1 + start, start, count - start, width);
            let own = Mat::from_fn(kept.nrows(), width, |row, column| if row < column { 0.0 } else { kept[(row, column)] });
            let mut triangle = product(own.transpose(), own.as_ref());
            for column in 0..width {
                // Where there is no reflection any number but 0 will do.
                triangle[(column, column)] = if own[(column, column)] == 0.0 { 1.0 } else { 0.5 * triangle[(column, column)] };
            }
            let mut inverse = Mat::identity(width, width);
            solve_upper_triangular_in_place(triangle.as_ref(), inverse.as_mut(), Par::Seq);
            let rest = below.rb_mut().subrows_mut(start, kept.nrows());
            let along = product(own.transpose(), rest.rb());
            subtract_product(rest, product(own.as_ref(), inverse.as_ref()).as_ref(), along.as_ref());
        }
    }
}

/// 1 for zero.
fn power_of_two_near(value: f64) -> f64 {
    if value == 0.0 { 1.0 } else { value.log2().round().clamp(-1000.0, 1000.0).exp2() }
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
