//! The eigenvectors of a symmetric tridiagonal matrix: divided, and conquered by rank-one updates.
//!
//! After Cuppen (1981) and Gu and Eisenstat (1994), with the deflation of LAPACK's `dlaed2`: columns that a merge leaves as they are cost
//! nothing, and halves of columns that are zero are not multiplied.

use faer::prelude::ReborrowMut;
use faer::{Mat, MatMut};

use super::columns::whole_mut;
use super::product_into;
use super::secular::{Root, root};
use super::tridiagonal::decompose;

/// Smaller parts are not divided.
const LEAST: usize = 32;

/// The eigenvalues, ascending, of `diagonal` and, as many, `beside` (each with the one below it, the last 0), entries near 1 at most;
/// their eigenvectors into the columns of `vectors`, which are zeros.
///
/// # Panics
/// When an entry is not finite: a bug.
pub(crate) fn eigen(diagonal: &[f64], beside: &[f64], mut vectors: MatMut<'_, f64>) -> Vec<f64> {
    let size = diagonal.len();
    if size <= LEAST {
        return decompose(diagonal, beside, vectors);
    }
    let half = size / 2;
    let bridge = beside[half - 1];
    let (mut upper, mut lower) = (diagonal[..half].to_vec(), diagonal[half..].to_vec());
    upper[half - 1] -= bridge.abs();
    lower[0] -= bridge.abs();
    let upper_beside: Vec<f64> = beside[..half - 1].iter().copied().chain([0.0]).collect();
    let mut values = eigen(&upper, &upper_beside, vectors.rb_mut().submatrix_mut(0, 0, half, half));
    let rest = vectors.rb_mut().submatrix_mut(half, half, size - half, size - half);
    values.extend(eigen(&lower, &beside[half..], rest));
    Merge::new(values, bridge, half, vectors.rb_mut()).finish(vectors)
}

/// Which halves of a column are not zero.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Reach {
    Upper,
    Both,
    Lower,
}

/// The eigenvalues and vectors of two halves, of which some take part in the update that joins them.
struct Merge {
    half: usize,
    values: Vec<f64>,
    reach: Vec<Reach>,
    /// Columns that take part, by rising value, and how much each of them does, squared: all together with their factor.
    taking_part: Vec<usize>,
    amounts: Vec<f64>,
    factor: f64,
}

impl Merge {
    /// Turns columns of one value into one another, until only one of them takes part.
    fn new(mut values: Vec<f64>, bridge: f64, half: usize, mut vectors: MatMut<'_, f64>) -> Self {
        let size = values.len();
        let norm = std::f64::consts::FRAC_1_SQRT_2;
        let amount = |column: usize| {
            if column < half { norm * vectors[(half - 1, column)] } else { norm * bridge.signum() * vectors[(half, column)] }
        };
        let mut amounts: Vec<f64> = (0..size).map(amount).collect();
        let mut reach: Vec<Reach> = (0..size).map(|column| if column < half { Reach::Upper } else { Reach::Lower }).collect();
        let factor = 2.0 * bridge.abs();
        let greatest = |values: &[f64]| values.iter().fold(0.0, |most: f64, value| most.max(value.abs()));
        let tolerance = 8.0 * f64::EPSILON * greatest(&values).max(greatest(&amounts));
        let mut order: Vec<usize> = (0..size).collect();
        order.sort_by(|a, b| values[*a].total_cmp(&values[*b]));
        let mut taking_part: Vec<usize> = Vec::new();
        for column in order {
            if factor * amounts[column].abs() <= tolerance {
                continue;
            }
            if let Some(last) = taking_part.last_mut() {
                let (own, before) = (amounts[column], amounts[*last]);
                let together = own.hypot(before);
                let (cosine, sine) = (own / together, -before / together);
                if ((values[column] - values[*last]) * cosine * sine).abs() <= tolerance {
                    rotate(vectors.rb_mut(), *last, column, cosine, sine);
                    let (lesser, greater) = (values[*last], values[column]);
                    values[*last] = lesser * cosine * cosine + greater * sine * sine;
                    values[column] = lesser * sine * sine + greater * cosine * cosine;
                    amounts[column] = together;
                    if reach[*last] != reach[column] {
                        (reach[*last], reach[column]) = (Reach::Both, Reach::Both);
                    }
                    *last = column;
                    continue;
                }
            }
            taking_part.push(column);
        }
        let amounts = taking_part.iter().map(|column| amounts[*column]).collect();
        Self { half, values, reach, taking_part, amounts, factor }
    }

    /// The eigenvalues of the whole, ascending, and its vectors in their order.
    fn finish(mut self, mut vectors: MatMut<'_, f64>) -> Vec<f64> {
        let size = self.values.len();
        let (updated, joined) = self.update(vectors.rb_mut());
        for (column, value) in self.taking_part.iter().zip(updated) {
            self.values[*column] = value;
        }
        let mut place = vec![None; size];
        for (number, column) in self.taking_part.iter().enumerate() {
            place[*column] = Some(number);
        }
        let mut order: Vec<usize> = (0..size).collect();
        order.sort_by(|a, b| self.values[*a].total_cmp(&self.values[*b]));
        let mut sorted = Mat::zeros(size, size);
        for (mut to, column) in sorted.col_iter_mut().zip(&order) {
            match place[*column] {
                Some(number) => to.copy_from(joined.col(number)),
                None => to.copy_from(vectors.rb_mut().col(*column)),
            }
        }
        vectors.copy_from(&sorted);
        order.iter().map(|column| self.values[*column]).collect()
    }

    /// The new values of those who take part, and their new vectors.
    fn update(&self, mut vectors: MatMut<'_, f64>) -> (Vec<f64>, Mat<f64>) {
        let (size, count) = (self.values.len(), self.taking_part.len());
        let poles: Vec<f64> = self.taking_part.iter().map(|column| self.values[*column]).collect();
        let weights: Vec<f64> = self.amounts.iter().map(|amount| self.factor * amount * amount).collect();
        let roots: Vec<Root> = (0..count).map(|at| root(&poles, &weights, at)).collect();
        let amounts = exact_amounts(&poles, &roots, &self.amounts);
        // Rows by reach, so that the halves of columns that are zero can be left out.
        let mut rows: Vec<usize> = (0..count).collect();
        rows.sort_by_key(|number| self.reach[self.taking_part[*number]] as u8);
        let sorted = |values: &[f64]| rows.iter().map(|number| values[*number]).collect::<Vec<f64>>();
        let (sorted_poles, sorted_amounts) = (sorted(&poles), sorted(&amounts));
        let mut inner = Mat::zeros(count, count);
        for (column, root) in inner.col_iter_mut().zip(&roots) {
            write_vector(whole_mut(column), &sorted_poles, &sorted_amounts, poles[root.pole], root.offset);
        }
        let reaches = |wanted: Reach| rows.iter().filter(|number| self.reach[self.taking_part[**number]] == wanted).count();
        let (upper, lower) = (reaches(Reach::Upper), reaches(Reach::Lower));
        let mut joined = Mat::zeros(size, count);
        let halves = [(0..self.half, 0..count - lower), (self.half..size, upper..count)];
        for (range, taken) in halves {
            let mut own = Mat::zeros(range.len(), taken.len());
            for (mut column, number) in own.col_iter_mut().zip(&rows[taken.clone()]) {
                column.copy_from(vectors.rb_mut().col(self.taking_part[*number]).subrows(range.start, range.len()));
            }
            let out = joined.as_mut().subrows_mut(range.start, range.len());
            product_into(out, own.as_ref(), inner.as_ref().subrows(taken.start, taken.len()));
        }
        (roots.iter().map(|root| poles[root.pole] + root.offset).collect(), joined)
    }
}

/// The amounts of which the roots found are the exact ones, so that the vectors are orthogonal (Gu and Eisenstat).
fn exact_amounts(poles: &[f64], roots: &[Root], amounts: &[f64]) -> Vec<f64> {
    let mut products = vec![1.0; poles.len()];
    for (at, root) in roots.iter().enumerate() {
        let (origin, offset, own) = (poles[root.pole], root.offset, poles[at]);
        let mut multiply = |range: std::ops::Range<usize>| {
            for (product, pole) in products[range.clone()].iter_mut().zip(&poles[range]) {
                *product *= ((pole - origin) - offset) / (pole - own);
            }
        };
        multiply(0..at);
        multiply(at + 1..poles.len());
        products[at] *= (own - origin) - offset;
    }
    products.iter().zip(amounts).map(|(product, amount)| product.abs().sqrt().copysign(*amount)).collect()
}

/// The unit vector along zᵢ/(dᵢ − λ).
fn write_vector(out: &mut [f64], poles: &[f64], amounts: &[f64], origin: f64, offset: f64) {
    for (entry, (pole, amount)) in out.iter_mut().zip(poles.iter().zip(amounts)) {
        *entry = amount / ((pole - origin) - offset);
    }
    let length = out.iter().map(|entry| entry * entry).sum::<f64>().sqrt();
    for entry in out {
        *entry /= length;
    }
}

/// Columns x and y become cx + sy and cy − sx.
pub(crate) fn rotate(matrix: MatMut<'_, f64>, x: usize, y: usize, cosine: f64, sine: f64) {
    let (before, after) = matrix.split_at_col_mut(x.max(y));
    let (low, high) = (whole_mut(before.col_mut(x.min(y))), whole_mut(after.col_mut(0)));
    let (first, second) = if x < y { (low, high) } else { (high, low) };
    for (x, y) in first.iter_mut().zip(second) {
        (*x, *y) = (cosine * *x + sine * *y, cosine * *y - sine * *x);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tridiagonal::tests::{check_vectors, hard_cases};

    #[test]
    fn large_matrices_are_taken_apart() {
        hard_cases(|name, diagonal, beside| check_vectors(name, diagonal, beside, eigen));
    }
}
