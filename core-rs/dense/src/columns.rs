//! Columns that lie in one piece, as slices.

use faer::{ColMut, ColRef};

/// Sums of so many terms are kept apart, so that they become vector instructions.
const LANES: usize = 8;

/// # Panics
/// When the column does not lie in one piece: a bug.
pub(crate) fn whole(column: ColRef<'_, f64>) -> &[f64] {
    column.try_as_col_major().expect("columns lie in one piece").as_slice()
}

/// # Panics
/// As [`whole`].
pub(crate) fn whole_mut(column: ColMut<'_, f64>) -> &mut [f64] {
    column.try_as_col_major_mut().expect("columns lie in one piece").as_slice_mut()
}

/// Of two columns of equal length.
pub(crate) fn dot(left: &[f64], right: &[f64]) -> f64 {
    let mut sums = [0.0; LANES];
    let (left, last_left) = left.as_chunks::<LANES>();
    let (right, last_right) = right.as_chunks::<LANES>();
    for (left, right) in left.iter().zip(right) {
        for lane in 0..LANES {
            sums[lane] += left[lane] * right[lane];
        }
    }
    sums.iter().sum::<f64>() + last_left.iter().zip(last_right).map(|(a, b)| a * b).sum::<f64>()
}
