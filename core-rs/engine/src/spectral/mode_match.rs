//! What there is to see of two bases before one turns into the other (paper A, figure 7). No motion is made from it.

use faer::Mat;

use super::eigenbasis::Spectrum;
use super::matching::Pairing;
use super::pair::Pair;
use crate::choice::Order;

/// How alike the modes of both ends of a transition are, and which ones each order pairs.
#[derive(Clone, Debug)]
pub struct ModeMatch {
    /// How many modes there are beside the constant one.
    pub mode_count: usize,
    /// |SᵀT|: `amounts[source * mode_count + target]`, 0–1 up to round-off.
    pub amounts: Vec<f64>,
    /// The target mode of each source mode, one list an order of [`ModeMatch::ORDERS`].
    pub targets: [Vec<usize>; 4],
}

impl ModeMatch {
    /// The orders compared.
    pub const ORDERS: [Order; 4] = [Order::Eigenvalue, Order::Greedy, Order::Maxmin, Order::Hungarian];

    /// In O(n³), and O(n³) exchanges at worst for max-min.
    pub(crate) fn of(pair: &Pair) -> Self {
        let likeness = pair.likeness();
        let mode_count = pair.mode_count();
        let amounts = (0..mode_count * mode_count).map(|k| likeness[(k / mode_count, k % mode_count)].abs()).collect();
        Self { mode_count, amounts, targets: Self::ORDERS.map(|order| Pairing::of(pair, order).targets().to_vec()) }
    }
}

/// Eigenvalues of (1 − t) · source + t · target at t = 0, 1/steps, …, 1: a list of all of them, ascending, for every t.
///
/// The paper leaves open whose eigenvalues its figure shows between the keyframes. Those of the mixed graph are continuous and exact at
/// both ends, whereas the neighbors that agents happen to have on their way come and go in jumps.
pub(crate) fn eigenvalues_between(source: &Mat<f64>, target: &Mat<f64>, steps: usize) -> Vec<Vec<f64>> {
    let at =
        |t: f64| Mat::from_fn(source.nrows(), source.ncols(), |row, column| (1.0 - t) * source[(row, column)] + t * target[(row, column)]);
    (0..=steps).map(|step| Spectrum::of(at(step as f64 / steps as f64).as_ref()).eigenvalues().to_vec()).collect()
}
