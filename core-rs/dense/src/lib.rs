//! Dense linear algebra on one thread: the only place that calls faer's kernels.
//!
//! A crate of its own because faer is generic: its kernels are compiled where they are called, and here they are compiled for speed
//! while the rest of the browser's engine is compiled for size.

#![forbid(unsafe_code)]

pub mod messages;
mod reduced;

use faer::linalg::matmul::matmul;
use faer::{Accum, ColRef, Mat, MatMut, MatRef, Par};

pub use reduced::Reduced;

/// Where only the lower triangle is wanted, so many columns are made at a time, from the diagonal down.
const TRIANGLE_WIDTH: usize = 64;

/// A symmetric matrix as eigenvalues, ascending, and orthonormal eigenvectors, a column each.
pub struct SymmetricEigen {
    /// Ascending.
    pub values: Vec<f64>,
    /// Orthonormal, a column each.
    pub vectors: Mat<f64>,
}

/// The eigendecomposition of a symmetric matrix, of which only the lower triangle is read.
///
/// # Panics
/// When an entry is not finite: a bug, since the document refuses such numbers.
pub fn symmetric_eigen(matrix: MatRef<'_, f64>) -> SymmetricEigen {
    Reduced::of(matrix).eigen()
}

/// left · right.
pub fn product(left: MatRef<'_, f64>, right: MatRef<'_, f64>) -> Mat<f64> {
    let mut out = Mat::zeros(left.nrows(), right.ncols());
    product_into(out.as_mut(), left, right);
    out
}

/// out = left · right.
fn product_into(out: MatMut<'_, f64>, left: MatRef<'_, f64>, right: MatRef<'_, f64>) {
    matmul(out, Accum::Replace, left, right, 1.0, Par::Seq);
}

/// out = left · columns, which lie one after the other as those of `out` do.
pub fn product_into_columns(out: &mut [f64], left: MatRef<'_, f64>, columns: &[f64]) {
    let count = out.len() / left.nrows().max(1);
    let out = MatMut::from_column_major_slice_mut(out, left.nrows(), count);
    product_into(out, left, MatRef::from_column_major_slice(columns, left.ncols(), count));
}

/// The lower triangle of matrixᵀ · matrix, for little more than half of the product; what is above it means nothing.
pub fn lower_square(matrix: MatRef<'_, f64>) -> Mat<f64> {
    let size = matrix.ncols();
    let mut out = Mat::zeros(size, size);
    for first in (0..size).step_by(TRIANGLE_WIDTH) {
        let (rows, width) = (size - first, TRIANGLE_WIDTH.min(size - first));
        let right = matrix.subcols(first, width);
        product_into(out.as_mut().submatrix_mut(first, first, rows, width), matrix.subcols(first, rows).transpose(), right);
    }
    out
}

/// The columns with these numbers, in their order.
pub fn columns(matrix: MatRef<'_, f64>, numbers: &[usize]) -> Mat<f64> {
    let mut out = Mat::zeros(matrix.nrows(), numbers.len());
    for (mut column, number) in out.col_iter_mut().zip(numbers) {
        column.copy_from(matrix.col(*number));
    }
    out
}

/// The largest absolute entry; 0 of an empty matrix.
pub fn largest(matrix: MatRef<'_, f64>) -> f64 {
    matrix.col_iter().flat_map(ColRef::iter).fold(0.0, |largest, entry| if entry.abs() > largest { entry.abs() } else { largest })
}

/// The root of the sum of squares of all entries, which are neither so large nor so small that their squares are lost.
pub fn norm(matrix: MatRef<'_, f64>) -> f64 {
    matrix.col_iter().flat_map(ColRef::iter).map(|entry| entry * entry).sum::<f64>().sqrt()
}

/// a · left + b · right, entry by entry.
pub fn combination(a: f64, left: MatRef<'_, f64>, b: f64, right: MatRef<'_, f64>) -> Mat<f64> {
    let mut out = Mat::zeros(left.nrows(), left.ncols());
    for column in 0..left.ncols() {
        for row in 0..left.nrows() {
            out[(row, column)] = a * left[(row, column)] + b * right[(row, column)];
        }
    }
    out
}

/// The determinant of a square matrix.
pub fn determinant(matrix: MatRef<'_, f64>) -> f64 {
    matrix.determinant()
}

/// The symmetric part (matrix + matrixᵀ)/2.
pub fn symmetric_part(matrix: MatRef<'_, f64>) -> Mat<f64> {
    Mat::from_fn(matrix.nrows(), matrix.ncols(), |row, column| f64::midpoint(matrix[(row, column)], matrix[(column, row)]))
}

/// The skew part (matrix − matrixᵀ)/2.
pub fn skew_part(matrix: MatRef<'_, f64>) -> Mat<f64> {
    Mat::from_fn(matrix.nrows(), matrix.ncols(), |row, column| 0.5 * (matrix[(row, column)] - matrix[(column, row)]))
}

#[cfg(test)]
mod tests {
    use faer::Scale;

    use super::*;

    /// Entries from −½ to ½.
    pub(crate) fn random_symmetric(size: usize) -> Mat<f64> {
        let mut state = 1_u64;
        let mut next = || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (state >> 11) as f64 / (1_u64 << 53) as f64 - 0.5
        };
        symmetric_part(Mat::from_fn(size, size, |_, _| next()).as_ref())
    }

    #[test]
    fn eigenvectors_are_as_good_at_every_scale() {
        // 200 is above the size where faer divides and conquers.
        for size in [1, 2, 3, 40, 200] {
            let random = random_symmetric(size);
            for scale in [1e-160, 1e-30, 1e-10, 1e-3, 1.0, 1e5, 1e150] {
                let matrix = &random * Scale(scale);
                let SymmetricEigen { values, vectors } = symmetric_eigen(matrix.as_ref());
                let stretched = Mat::from_fn(size, size, |row, column| vectors[(row, column)] * values[column]);
                // Backward stability: a small multiple of eps times the norm, which grows with the size.
                let tolerance = 4.0 * f64::EPSILON * size as f64;
                assert!((&matrix * &vectors - stretched).norm_max() <= tolerance * scale, "size {size}, scale {scale:e}");
                assert!((vectors.transpose() * &vectors - Mat::<f64>::identity(size, size)).norm_max() <= tolerance);
            }
        }
    }

    #[test]
    fn a_matrix_of_zeros_has_the_axes() {
        let eigen = symmetric_eigen(Mat::zeros(150, 150).as_ref());
        assert!(eigen.values.iter().all(|value| *value == 0.0));
        assert!((eigen.vectors.transpose() * &eigen.vectors - Mat::<f64>::identity(150, 150)).norm_max() < 1e-15);
    }
}
