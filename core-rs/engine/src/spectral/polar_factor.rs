//! The orthogonal matrix nearest to a square one.

use faer::{Mat, MatRef};

use eigenform_dense::symmetric_eigen;

/// Singular values at most this, where 1 is the largest a block of inner products can have, leave the factor undecided.
const SINGULAR: f64 = 1e-9;

/// The orthogonal factor W of matrix = W · (symmetric, positive); `None` where the matrix is singular and has no single one.
///
/// Read off the symmetric matrix [0 M; Mᵀ 0], whose positive eigenvalues are the singular values of M: the square of M would
/// lose half the digits.
pub(super) fn polar_factor(matrix: MatRef<'_, f64>) -> Option<Mat<f64>> {
    let size = matrix.nrows();
    let mut doubled = Mat::zeros(2 * size, 2 * size);
    doubled.submatrix_mut(size, 0, size, size).copy_from(matrix.transpose());
    doubled.submatrix_mut(0, size, size, size).copy_from(matrix);
    let eigen = symmetric_eigen(doubled.as_ref());
    if eigen.values[size..].iter().any(|value| *value <= SINGULAR) {
        return None;
    }
    let left = eigen.vectors.submatrix(0, size, size, size);
    let right = eigen.vectors.submatrix(size, size, size, size);
    Some(faer::Scale(2.0) * eigenform_dense::product(left, right.transpose()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_rotation_times_a_stretch_gives_back_the_rotation() {
        let (cos, sin) = (0.6, 0.8);
        let rotation = Mat::from_fn(2, 2, |r, c| [[cos, -sin], [sin, cos]][r][c]);
        let stretch = Mat::from_fn(2, 2, |r, c| [[2.0, 0.3], [0.3, 0.5]][r][c]);
        let factor = polar_factor((&rotation * &stretch).as_ref()).expect("regular");
        assert!((factor - rotation).norm_max() < 1e-14);
    }

    #[test]
    fn a_singular_matrix_has_none() {
        assert!(polar_factor(Mat::zeros(2, 2).as_ref()).is_none());
    }
}
