//! Which target mode each source mode becomes (paper A, section 4.2).

use faer::{Mat, MatRef};

use super::maxmin::{EQUAL_LIKENESS, exchange};
use super::pair::Pair;
use crate::assignment::maximize;
use crate::choice::Order;

/// A bijection from source modes to target modes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Pairing(Vec<usize>);

impl Pairing {
    /// Pairs the modes in the given order; eigenvalue and greedy O(n²), hungarian O(n³).
    pub(crate) fn of(pair: &Pair, order: Order) -> Self {
        let likeness = pair.likeness();
        Self(match order {
            Order::Eigenvalue => (0..pair.mode_count()).collect(),
            Order::Greedy => greedy(likeness),
            Order::Maxmin => exchange(likeness, greedy(likeness)),
            Order::Hungarian => hungarian(likeness),
        })
    }

    /// `targets()[source]` is the target mode.
    pub(crate) fn targets(&self) -> &[usize] {
        &self.0
    }
}

/// In source order, each takes the free target mode most like it.
fn greedy(likeness: MatRef<'_, f64>) -> Vec<usize> {
    let mut free: Vec<usize> = (0..likeness.ncols()).collect();
    (0..likeness.nrows())
        .map(|source| {
            let most = free.iter().map(|target| likeness[(source, *target)].abs()).fold(0.0, f64::max);
            let taken = free.iter().position(|target| likeness[(source, *target)].abs() >= most - EQUAL_LIKENESS);
            free.remove(taken.expect("as many target modes as source modes"))
        })
        .collect()
}

/// The greatest sum of squared inner products. Squares are rounded to 2⁻⁴⁰: what symmetry makes equal is equal then, sums are exact,
/// and of equal pairings the lowest indices win.
fn hungarian(likeness: MatRef<'_, f64>) -> Vec<usize> {
    const UNIT: f64 = (1_u64 << 40) as f64;
    let size = likeness.nrows();
    // One column a source: the solver reads all targets of a source in a row.
    let gains = Mat::from_fn(size, size, |target, source| (likeness[(source, target)].powi(2) * UNIT).round() / UNIT);
    maximize(size, |source, target| gains[(target, source)]).targets().iter().map(|target| *target as usize).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn greedy_takes_the_most_alike_whatever_its_sign_and_the_first_of_equals() {
        let rows = [[0.1, -0.9, 0.2], [0.5, 0.95, -0.5 - 1e-13], [0.0, 0.0, 0.0]];
        assert_eq!(greedy(Mat::from_fn(3, 3, |row, column| rows[row][column]).as_ref()), [1, 0, 2]);
    }

    #[test]
    fn hungarian_weighs_all_pairs_together() {
        // Greedy takes 0.9 and is left with 0.1.
        let rows = [[0.9, 0.8], [0.85, 0.1]];
        let likeness = Mat::from_fn(2, 2, |row, column| rows[row][column]);
        assert_eq!(greedy(likeness.as_ref()), [0, 1]);
        assert_eq!(hungarian(likeness.as_ref()), [1, 0]);
    }
}
