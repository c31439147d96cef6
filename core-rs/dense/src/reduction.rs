//! A symmetric matrix made tridiagonal by reflections.

use faer::prelude::{Reborrow, ReborrowMut};
use faer::{Mat, MatMut, MatRef};

use super::columns::{dot, whole, whole_mut};
use super::{TRIANGLE_WIDTH, subtract_product};

/// Columns that are reduced before the rest of the matrix hears of it: the matrix is read once a column, and written once a panel.
const PANEL: usize = 24;

/// Columns of a matrix times a vector are taken so many at a time, by so many rows: they fit the registers of a browser, or of a
/// processor with wider ones.
const TOGETHER: usize = 4;
const LANES: usize = if cfg!(target_arch = "wasm32") { 4 } else { 8 };

/// What a symmetric matrix becomes.
pub(crate) struct Tridiagonal {
    pub(crate) diagonal: Vec<f64>,
    /// Each with the one below it; the last 0.
    pub(crate) beside: Vec<f64>,
}

/// Reduces a symmetric matrix, of which only the lower triangle is read.
///
/// Below the diagonal of column k it leaves the vector v of the reflection I − 2 v vᵀ / vᵀv, zeros where there is none (LAPACK's
/// `dsytrd`).
pub(crate) fn reduce(mut matrix: MatMut<'_, f64>) -> Tridiagonal {
    let size = matrix.nrows();
    let (mut diagonal, mut beside) = (vec![0.0; size], vec![0.0; size]);
    for start in (0..size.saturating_sub(1)).step_by(PANEL) {
        let width = PANEL.min(size - 1 - start);
        let mut panel = Panel { start, partners: Mat::zeros(size, width), spare: vec![0.0; size] };
        for column in start..start + width {
            panel.bring_up_to_date(matrix.rb_mut(), column);
            diagonal[column] = matrix[(column, column)];
            beside[column] = reflect(below(matrix.rb_mut(), column, column + 1));
            panel.find_partner(matrix.as_ref(), column);
        }
        panel.bring_rest_up_to_date(matrix.rb_mut());
    }
    if size > 0 {
        diagonal[size - 1] = matrix[(size - 1, size - 1)];
    }
    Tridiagonal { diagonal, beside }
}

/// Turns a vector into that of the reflection which leaves only its first entry; answers that entry.
fn reflect(vector: &mut [f64]) -> f64 {
    let (first, rest) = vector.split_first_mut().expect("a column has a row below its diagonal");
    let before = *first;
    let length = rest.iter().map(|entry| entry * entry).sum::<f64>();
    if length == 0.0 {
        *first = 0.0;
        return before;
    }
    let after = -(before * before + length).sqrt().copysign(before);
    *first = 1.0;
    let scale = (before - after).recip();
    for entry in rest {
        *entry *= scale;
    }
    after
}

/// Reflections that the rest of the matrix A has not heard of: it is A − V Wᵀ − W Vᵀ by now.
struct Panel {
    start: usize,
    /// W: a column each, beside the vectors V that stand in the matrix.
    partners: Mat<f64>,
    spare: Vec<f64>,
}

impl Panel {
    fn bring_up_to_date(&self, matrix: MatMut<'_, f64>, column: usize) {
        let (before, mut own) = matrix.split_at_col_mut(column);
        let own = below(own.rb_mut(), 0, column);
        for (number, vector) in (self.start..column).enumerate() {
            let (vector, partner) = (whole(before.rb().col(vector)), whole(self.partners.col(number)));
            let (by_partner, by_vector) = (partner[column], vector[column]);
            for (entry, (v, w)) in own.iter_mut().zip(vector[column..].iter().zip(&partner[column..])) {
                *entry -= v * by_partner + w * by_vector;
            }
        }
    }

    /// w = τ (A v − V Wᵀv − W Vᵀv) less its half along v.
    fn find_partner(&mut self, matrix: MatRef<'_, f64>, column: usize) {
        let from = column + 1;
        let vector = &whole(matrix.col(column))[from..];
        let square = dot(vector, vector);
        if square == 0.0 {
            return;
        }
        let factor = 2.0 / square;
        let own = &mut self.spare[from..];
        symmetric_times(matrix.submatrix(from, from, vector.len(), vector.len()), vector, own);
        for (number, earlier) in (self.start..column).enumerate() {
            let (earlier, partner) = (&whole(matrix.col(earlier))[from..], &whole(self.partners.col(number))[from..]);
            let (along_partner, along_vector) = (dot(partner, vector), dot(earlier, vector));
            for (entry, (v, w)) in own.iter_mut().zip(earlier.iter().zip(partner)) {
                *entry -= v * along_partner + w * along_vector;
            }
        }
        let half = 0.5 * factor * factor * dot(own, vector);
        let partner = &mut below(self.partners.as_mut(), column - self.start, from)[..];
        for (to, (entry, v)) in partner.iter_mut().zip(own.iter().zip(vector)) {
            *to = factor * entry - half * v;
        }
    }

    fn bring_rest_up_to_date(&self, matrix: MatMut<'_, f64>) {
        let width = self.partners.ncols();
        let from = self.start + width;
        let (before, mut rest) = matrix.split_at_col_mut(from);
        let count = rest.ncols();
        let vectors = before.rb().submatrix(from, self.start, count, width);
        let partners = self.partners.as_ref().subrows(from, count);
        let (mut left, mut right) = (Mat::zeros(count, 2 * width), Mat::zeros(count, 2 * width));
        left.subcols_mut(0, width).copy_from(vectors);
        left.subcols_mut(width, width).copy_from(partners);
        right.subcols_mut(0, width).copy_from(partners);
        right.subcols_mut(width, width).copy_from(vectors);
        for first in (0..count).step_by(TRIANGLE_WIDTH) {
            let columns = TRIANGLE_WIDTH.min(count - first);
            let out = rest.rb_mut().submatrix_mut(from + first, first, count - first, columns);
            subtract_product(out, left.as_ref().subrows(first, count - first), right.as_ref().subrows(first, columns).transpose());
        }
    }
}

/// out = matrix · vector, of a symmetric matrix whose lower triangle is read, once.
fn symmetric_times(matrix: MatRef<'_, f64>, vector: &[f64], out: &mut [f64]) {
    out.fill(0.0);
    let size = vector.len();
    let mut first = 0;
    while first + TOGETHER <= size {
        let columns: [&[f64]; TOGETHER] = std::array::from_fn(|column| &whole(matrix.col(first + column))[first..]);
        let (corner, rest) = vector[first..].split_at(TOGETHER);
        let (own, out) = out[first..].split_at_mut(TOGETHER);
        for column in 0..TOGETHER {
            own[column] += columns[column][column] * corner[column];
            for row in column + 1..TOGETHER {
                own[row] += columns[column][row] * corner[column];
                own[column] += columns[column][row] * corner[row];
            }
        }
        let corner: [f64; TOGETHER] = std::array::from_fn(|column| corner[column]);
        let sums = columns_times(columns.map(|column| &column[TOGETHER..]), corner, rest, out);
        own.iter_mut().zip(sums).for_each(|(entry, sum)| *entry += sum);
        first += TOGETHER;
    }
    for column in first..size {
        let own = &whole(matrix.col(column))[column..];
        out[column] += own[0] * vector[column] + dot(&own[1..], &vector[column + 1..]);
        let by = vector[column];
        out[column + 1..].iter_mut().zip(&own[1..]).for_each(|(entry, value)| *entry += value * by);
    }
}

/// Adds the columns times `corner` to `out`, and answers their products with `vector`.
fn columns_times(columns: [&[f64]; TOGETHER], corner: [f64; TOGETHER], vector: &[f64], out: &mut [f64]) -> [f64; TOGETHER] {
    let mut sums = [[0.0; LANES]; TOGETHER];
    let parts = columns.map(|column| column.as_chunks::<LANES>());
    let (vectors, last_vectors) = vector.as_chunks::<LANES>();
    let (outs, last_outs) = out.as_chunks_mut::<LANES>();
    let chunks = parts.map(|(chunks, _)| &chunks[..vectors.len()]);
    for (row, (out, vector)) in outs.iter_mut().zip(vectors).enumerate() {
        // Copies, so that they become vectors of the processor.
        let (vector, mut sum) = (*vector, *out);
        for column in 0..TOGETHER {
            let entries = chunks[column][row];
            for lane in 0..LANES {
                sums[column][lane] += entries[lane] * vector[lane];
                sum[lane] += entries[lane] * corner[column];
            }
        }
        *out = sum;
    }
    for (row, (out, vector)) in last_outs.iter_mut().zip(last_vectors).enumerate() {
        for column in 0..TOGETHER {
            let entry = parts[column].1[row];
            sums[column][0] += entry * vector;
            *out += entry * corner[column];
        }
    }
    sums.map(|lanes| lanes.iter().sum())
}

fn below(matrix: MatMut<'_, f64>, column: usize, row: usize) -> &mut [f64] {
    &mut whole_mut(matrix.col_mut(column))[row..]
}
