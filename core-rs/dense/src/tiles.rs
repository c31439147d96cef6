//! The product of two matrices in tiles of 4 × 4 sums, for the browser.
//!
//! The sums of a tile, what they are made of and room to multiply fit the registers that a browser has for vectors of two numbers.
//! Those of the crates that faer calls do not, and go by memory: a third slower.

use std::ops::Range;

use faer::prelude::ReborrowMut;
use faer::{MatMut, MatRef};

use super::columns::{whole, whole_mut};

/// Rows and columns of a tile.
const SIDE: usize = 4;

/// How many terms of a tile's sums are added in one go: two panels of them fit the nearest cache.
const DEPTH: usize = 256;

/// Rows of the left matrix that are packed at a time, and columns of the right: they fit the caches beyond.
const ROWS: usize = 24 * SIDE;
const COLUMNS: usize = 128 * SIDE;

/// out += factor · left · right.
pub(crate) fn add_product(mut out: MatMut<'_, f64>, left: MatRef<'_, f64>, right: MatRef<'_, f64>, factor: f64) {
    let (mut lefts, mut rights) = (Vec::new(), Vec::new());
    for columns in parts(right.ncols(), COLUMNS) {
        for depth in parts(left.ncols(), DEPTH) {
            pack(&mut rights, right.subrows(depth.start, depth.len()).subcols(columns.start, columns.len()).transpose(), factor);
            for rows in parts(left.nrows(), ROWS) {
                pack(&mut lefts, left.subrows(rows.start, rows.len()).subcols(depth.start, depth.len()), 1.0);
                let block = out.rb_mut().subrows_mut(rows.start, rows.len()).subcols_mut(columns.start, columns.len());
                add_block(block, &lefts, &rights, depth.len());
            }
        }
    }
}

fn parts(count: usize, most: usize) -> impl Iterator<Item = Range<usize>> {
    (0..count).step_by(most).map(move |start| start..count.min(start + most))
}

/// Rows of a matrix, times a factor, in panels of [`SIDE`] rows: column by column, the last filled up with zeros.
fn pack(panels: &mut Vec<[f64; SIDE]>, matrix: MatRef<'_, f64>, factor: f64) {
    panels.clear();
    if matrix.row_stride() == 1 {
        for rows in parts(matrix.nrows(), SIDE) {
            panels.extend(matrix.subrows(rows.start, rows.len()).col_iter().map(|column| {
                let mut entries = [0.0; SIDE];
                entries.iter_mut().zip(whole(column)).for_each(|(entry, value)| *entry = factor * value);
                entries
            }));
        }
    } else {
        for rows in parts(matrix.nrows(), SIDE) {
            let own = panels.len();
            panels.resize(own + matrix.ncols(), [0.0; SIDE]);
            for (place, row) in matrix.subrows(rows.start, rows.len()).row_iter().enumerate() {
                panels[own..].iter_mut().zip(row.iter()).for_each(|(entries, value)| entries[place] = factor * value);
            }
        }
    }
}

fn add_block(mut out: MatMut<'_, f64>, lefts: &[[f64; SIDE]], rights: &[[f64; SIDE]], depth: usize) {
    for (columns, right) in parts(out.ncols(), SIDE).zip(rights.chunks_exact(depth)) {
        for (rows, left) in parts(out.nrows(), SIDE).zip(lefts.chunks_exact(depth)) {
            let sums = tile(left, right);
            for (column, sums) in columns.clone().zip(&sums) {
                let column = whole_mut(out.rb_mut().col_mut(column));
                column[rows.clone()].iter_mut().zip(sums).for_each(|(entry, sum)| *entry += sum);
            }
        }
    }
}

/// By column of the right, row of the left.
fn tile(left: &[[f64; SIDE]], right: &[[f64; SIDE]]) -> [[f64; SIDE]; SIDE] {
    let mut sums = [[0.0; SIDE]; SIDE];
    for (left, right) in left.iter().zip(right) {
        for (sums, right) in sums.iter_mut().zip(right) {
            for (sum, left) in sums.iter_mut().zip(left) {
                *sum += left * right;
            }
        }
    }
    sums
}

#[cfg(test)]
mod tests {
    use faer::Mat;

    use super::*;
    use crate::tests::numbers;

    #[test]
    fn tiles_make_the_product_whatever_its_shape_and_strides() {
        let mut next = numbers();
        let mut random = |rows, columns| Mat::from_fn(rows, columns, |_, _| next());
        for (rows, depth, columns) in [(1, 1, 1), (3, 5, 2), (4, 4, 4), (9, 300, 7), (101, 33, 515), (98, 257, 6), (0, 3, 2), (3, 0, 2)] {
            let (left, right, before) = (random(rows, depth), random(depth, columns), random(rows, columns));
            let (left_lying, right_lying) = (left.transpose().to_owned(), right.transpose().to_owned());
            let expected = &before - faer::Scale(0.5) * (&left * &right);
            for left in [left.as_ref(), left_lying.transpose()] {
                for right in [right.as_ref(), right_lying.transpose()] {
                    let mut out = before.clone();
                    add_product(out.as_mut(), left, right, -0.5);
                    // Sums of `depth` products of numbers up to one half.
                    assert!((out - &expected).norm_max() <= f64::EPSILON * (1 + depth) as f64, "{rows} × {depth} × {columns}");
                }
            }
        }
    }
}
