//! The eigenvalues of a symmetric tridiagonal matrix, in O(n²), and its eigenvectors where it is small.

use faer::MatMut;
use faer::prelude::ReborrowMut;

use super::conquer::rotate;

/// Sweeps that one eigenvalue may take; two are usual.
const SWEEPS: usize = 60;

/// The eigenvalues, ascending, of entries near 1 at most: `diagonal` and, as many, `beside`: each with the one below it, the last 0.
///
/// QL sweeps on the squares of the entries beside the diagonal, without a root (Pal, Walker and Kahan; LAPACK's `dsterf`).
///
/// # Panics
/// When an entry is not finite: a bug.
pub(crate) fn eigenvalues(diagonal: &[f64], beside: &[f64]) -> Vec<f64> {
    let mut values = diagonal.to_vec();
    let mut squares: Vec<f64> = beside.iter().map(|entry| entry * entry).collect();
    for first in 0..values.len() {
        let mut left = SWEEPS;
        loop {
            let last = part_end(&values, &mut squares, first);
            if last == first {
                break;
            }
            assert!(left > 0, "a finite symmetric matrix has eigenvalues");
            left -= 1;
            sweep(&mut values[first..=last], &mut squares[first..=last]);
        }
    }
    values.sort_by(f64::total_cmp);
    values
}

/// Where the part that starts at `first` ends: the entry beside it is round-off, and made 0.
fn part_end(values: &[f64], squares: &mut [f64], first: usize) -> usize {
    const TINY: f64 = f64::EPSILON * f64::EPSILON;
    let is_tiny = |at: &usize| *at + 1 == values.len() || squares[*at] <= TINY * (values[*at] * values[*at + 1]).abs().max(TINY);
    let end = (first..values.len()).find(is_tiny).expect("the last has none below it");
    squares[end] = 0.0;
    end
}

/// One sweep, by Wilkinson's shift, over a part in which no square is 0 save the last.
fn sweep(values: &mut [f64], squares: &mut [f64]) {
    let last = values.len() - 1;
    let root = squares[0].sqrt();
    let ratio = (values[1] - values[0]) / (2.0 * root);
    let shift = values[0] - root / (ratio + (ratio * ratio + 1.0).sqrt().copysign(ratio));
    let (mut cosine, mut sine) = (1.0, 0.0);
    let mut gamma = values[last] - shift;
    let mut p = gamma * gamma;
    for at in (0..last).rev() {
        let square = squares[at];
        let sum = p + square;
        if at + 1 < last {
            squares[at + 1] = sine * sum;
        }
        let (old_cosine, old_gamma) = (cosine, gamma);
        cosine = p / sum;
        sine = square / sum;
        gamma = cosine * (values[at] - shift) - sine * old_gamma;
        values[at + 1] = old_gamma + (values[at] - gamma);
        p = if cosine == 0.0 { old_cosine * square } else { gamma * gamma / cosine };
    }
    squares[0] = sine * p;
    values[0] = shift + gamma;
}

/// The eigenvalues, ascending, and the eigenvectors into the columns of `vectors`, which are zeros; some 10 n³.
///
/// Implicit QL sweeps (EISPACK's `tql2`).
///
/// # Panics
/// As [`eigenvalues`].
pub(crate) fn decompose(diagonal: &[f64], beside: &[f64], mut vectors: MatMut<'_, f64>) -> Vec<f64> {
    let mut values = diagonal.to_vec();
    let mut beside = beside.to_vec();
    for k in 0..values.len() {
        vectors[(k, k)] = 1.0;
    }
    for first in 0..values.len() {
        let mut left = SWEEPS;
        loop {
            let is_tiny = |at: &usize| {
                let size = values[*at].abs() + values.get(at + 1).copied().unwrap_or(0.0).abs();
                at + 1 == values.len() || beside[*at].abs() <= f64::EPSILON * size.max(f64::EPSILON)
            };
            let last = (first..values.len()).find(is_tiny).expect("the last has none below it");
            if last == first {
                break;
            }
            assert!(left > 0, "a finite symmetric matrix has eigenvectors");
            left -= 1;
            turning_sweep(&mut values, &mut beside, vectors.rb_mut(), first, last);
        }
    }
    // Selection: the fewest exchanges of columns.
    for place in 0..values.len() {
        let least = (place..values.len()).min_by(|a, b| values[*a].total_cmp(&values[*b])).unwrap_or(place);
        if least != place {
            values.swap(place, least);
            rotate(vectors.rb_mut(), place, least, 0.0, 1.0);
        }
    }
    values
}

/// One sweep over the part from `first` to `last`, which turns the vectors along.
fn turning_sweep(values: &mut [f64], beside: &mut [f64], mut vectors: MatMut<'_, f64>, first: usize, last: usize) {
    let ratio = (values[first + 1] - values[first]) / (2.0 * beside[first]);
    let mut g = values[last] - values[first] + beside[first] / (ratio + ratio.hypot(1.0).copysign(ratio));
    let (mut sine, mut cosine, mut p) = (1.0, 1.0, 0.0);
    for at in (first..last).rev() {
        let (f, b) = (sine * beside[at], cosine * beside[at]);
        let length = f.hypot(g);
        beside[at + 1] = length;
        if length == 0.0 {
            // Underflow: the part falls into two.
            values[at + 1] -= p;
            beside[last] = 0.0;
            return;
        }
        (sine, cosine) = (f / length, g / length);
        g = values[at + 1] - p;
        let change = (values[at] - g) * sine + 2.0 * cosine * b;
        p = sine * change;
        values[at + 1] = g + p;
        g = cosine * change - b;
        rotate(vectors.rb_mut(), at, at + 1, cosine, -sine);
    }
    values[first] -= p;
    beside[first] = g;
    beside[last] = 0.0;
}

#[cfg(test)]
pub(crate) mod tests {
    use faer::Mat;

    use super::*;
    use crate::tests::numbers;

    /// How many eigenvalues are below `bound`: the negative pivots of the shifted matrix (Sylvester), a zero taken as round-off.
    fn count_below(diagonal: &[f64], beside: &[f64], bound: f64) -> usize {
        let mut pivot = 1.0;
        let above = |at: usize| if at == 0 { 0.0 } else { beside[at - 1] };
        let pivots = (0..diagonal.len()).map(|at| {
            pivot = diagonal[at] - bound - above(at) * above(at) / pivot;
            if pivot == 0.0 {
                pivot = f64::EPSILON * f64::EPSILON;
            }
            pivot
        });
        pivots.filter(|pivot| *pivot < 0.0).count()
    }

    fn check(name: &str, diagonal: &[f64], beside: &[f64]) {
        let values = eigenvalues(diagonal, beside);
        assert_eq!(values.len(), diagonal.len(), "{name}");
        assert!(values.is_sorted(), "{name}");
        // Backward stable: a small multiple of eps times the norm, at most 3, which grows with the size. Counting is good to eps.
        let tolerance = 8.0 * f64::EPSILON * 3.0 * diagonal.len() as f64;
        for (index, value) in values.iter().enumerate() {
            assert!(count_below(diagonal, beside, value - tolerance) <= index, "{name}: {value} is too great");
            assert!(count_below(diagonal, beside, value + tolerance) > index, "{name}: {value} is too small");
        }
    }

    /// Matrices with entries up to 1 that are hard in one way or another: a name, the diagonal and, as many, what is beside it.
    pub(crate) fn hard_cases(mut check: impl FnMut(&str, &[f64], &[f64])) {
        let mut next = numbers();
        let mut check = |name: &str, diagonal: &[f64], beside: &dyn Fn(usize) -> f64| {
            let last = diagonal.len() - 1;
            let beside: Vec<f64> = (0..last).map(beside).chain([0.0]).collect();
            check(&format!("{name}, n = {}", diagonal.len()), diagonal, &beside);
        };
        for size in [1, 2, 3, 8, 33, 61, 300] {
            let (own, other): (Vec<f64>, Vec<f64>) = (0..size).map(|_| (next(), next())).unzip();
            check("random", &own, &|k| other[k]);
            check("no diagonal", &vec![0.0; size], &|_| 1.0);
            check("nothing", &vec![0.0; size], &|_| 0.0);
            check("all alike", &vec![1.0; size], &|_| 1.0);
            check("parts", &vec![0.5; size], &|k| if k % 4 == 3 { 0.0 } else { 0.25 });
            check("parts that hardly touch", &own, &|k| if k % 20 == 19 { 1e-15 } else { other[k] });
            let middle = size as f64 / 2.0;
            let wilkinson: Vec<f64> = (0..size).map(|k| (k as f64 - middle).abs() / middle).collect();
            check("pairs that nearly agree", &wilkinson, &|_| 1.0 / middle);
            let glued: Vec<f64> = (0..size).map(|k| ((k % 21) as f64 - 10.0).abs() / 10.0).collect();
            check("the same many times", &glued, &|k| if k % 21 == 20 { 1e-8 } else { 0.1 });
            let falling: Vec<f64> = (0..size).map(|k| 10_f64.powf(-(k as f64))).collect();
            check("falling", &falling, &|k| falling[k + 1]);
            let rising: Vec<f64> = falling.iter().rev().copied().collect();
            check("rising", &rising, &|k| rising[k]);
        }
    }

    #[test]
    fn as_many_eigenvalues_are_below_as_sylvester_counts() {
        hard_cases(check);
    }

    #[test]
    fn small_matrices_are_taken_apart() {
        hard_cases(|name, diagonal, beside| check_vectors(name, diagonal, beside, decompose));
    }

    pub(crate) fn check_vectors(name: &str, diagonal: &[f64], beside: &[f64], eigen: impl Fn(&[f64], &[f64], MatMut<'_, f64>) -> Vec<f64>) {
        let size = diagonal.len();
        let mut vectors = Mat::zeros(size, size);
        let values = eigen(diagonal, beside, vectors.as_mut());
        assert!(values.is_sorted(), "{name}");
        let matrix = Mat::from_fn(size, size, |row, column| match row.abs_diff(column) {
            0 => diagonal[row],
            1 => beside[row.min(column)],
            _ => 0.0,
        });
        // Backward stable: a small multiple of eps times the norm, at most 3, which grows with the size.
        let tolerance = 4.0 * f64::EPSILON * 3.0 * size as f64;
        let stretched = Mat::from_fn(size, size, |row, column| vectors[(row, column)] * values[column]);
        let error = (&matrix * &vectors - stretched).norm_max();
        assert!(error <= tolerance, "{name}: off by {error:e}");
        let error = (vectors.transpose() * &vectors - Mat::<f64>::identity(size, size)).norm_max();
        assert!(error <= tolerance, "{name}: askew by {error:e}");
    }
}
