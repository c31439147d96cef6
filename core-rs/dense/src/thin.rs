//! The product of a matrix and a few columns, for the browser: the matrix is read once a column, and nothing is packed.

use faer::prelude::ReborrowMut;
use faer::{MatMut, MatRef};

use super::columns::{dot, whole, whole_mut};

/// Columns that are added at a time.
const TOGETHER: usize = 4;

/// Whether a product can be made here: columns lie in one piece, or the rows of the left.
pub(crate) fn is_possible(left: MatRef<'_, f64>, right: MatRef<'_, f64>) -> bool {
    right.row_stride() == 1 && (left.row_stride() == 1 || left.col_stride() == 1)
}

/// out = left · right.
pub(crate) fn product_into(mut out: MatMut<'_, f64>, left: MatRef<'_, f64>, right: MatRef<'_, f64>) {
    for (out, right) in out.rb_mut().col_iter_mut().zip(right.col_iter()) {
        let (out, right) = (whole_mut(out), whole(right));
        if left.row_stride() == 1 {
            add_columns(out, left, right);
        } else {
            for (entry, row) in out.iter_mut().zip(left.row_iter()) {
                *entry = dot(whole(row.transpose()), right);
            }
        }
    }
}

fn add_columns(out: &mut [f64], left: MatRef<'_, f64>, right: &[f64]) {
    out.fill(0.0);
    let (groups, rest) = right.as_chunks::<TOGETHER>();
    for (group, by) in groups.iter().enumerate() {
        let [a, b, c, d]: [&[f64]; TOGETHER] = std::array::from_fn(|column| whole(left.col(TOGETHER * group + column)));
        for (((entry, a), b), (c, d)) in out.iter_mut().zip(a).zip(b).zip(c.iter().zip(d)) {
            *entry += (a * by[0] + b * by[1]) + (c * by[2] + d * by[3]);
        }
    }
    for (column, by) in left.col_iter().skip(right.len() - rest.len()).zip(rest) {
        out.iter_mut().zip(whole(column)).for_each(|(entry, value)| *entry += value * by);
    }
}

#[cfg(test)]
mod tests {
    use faer::Mat;

    use super::*;
    use crate::tests::numbers;

    #[test]
    fn columns_make_the_product_whatever_its_shape_and_strides() {
        let mut next = numbers();
        let mut random = |rows, columns| Mat::from_fn(rows, columns, |_, _| next());
        for (rows, depth, columns) in [(1, 1, 1), (3, 5, 2), (9, 300, 7), (101, 34, 3), (2, 65, 1), (65, 2, 2), (0, 3, 2), (3, 0, 2)] {
            let (left, right) = (random(rows, depth), random(depth, columns));
            let lying = left.transpose().to_owned();
            for left in [left.as_ref(), lying.transpose()] {
                let mut out = random(rows, columns);
                product_into(out.as_mut(), left, right.as_ref());
                // Sums of `depth` products of numbers up to one half.
                assert!((out - left * &right).norm_max() <= f64::EPSILON * (1 + depth) as f64, "{rows} × {depth} × {columns}");
            }
        }
    }
}
