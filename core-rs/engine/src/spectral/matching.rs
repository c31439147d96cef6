//! Which target mode each source mode becomes (paper A, section 4.2).

use faer::MatRef;

use super::hungarian::hungarian;
use super::maxmin::exchange;
use super::pair::Pair;
use crate::choice::Order;

/// Inner products nearer than this count as equal; the lower index is taken then, so that round-off decides nothing.
pub(super) const EQUAL_LIKENESS: f64 = 1e-12;

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
