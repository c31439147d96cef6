//! Which way each target mode points: eigenvectors come with arbitrary signs.

use super::matching::Pairing;
use super::pair::Pair;
use super::turn::Turn;
use crate::formation::Formation;

/// Inner products below this have no sign of their own: symmetric formations make them exactly zero up to round-off.
pub(super) const NO_SIGN: f64 = 1e-9;

/// Coefficients are good to this, relative to the greatest: eps over the least gap that the tie-break lets pass.
const COEFFICIENT_ERROR: f64 = 1e-10;

/// Which target modes are reversed before they are matched, one entry a source mode; `turn` is taken out of the target.
///
/// Modes that resemble each other point the same way. Where an inner product is zero their coefficients do, and where that says
/// nothing either, the places of the agents, weighted by both modes. Only then does the turn matter: alignments that reverse the
/// same modes share one rotation.
pub(crate) fn reversals(pair: &Pair, pairing: &Pairing, formations: [&Formation; 2], turn: Turn) -> Vec<bool> {
    let [source_coefficients, target_coefficients] = [pair.source_coefficients(), pair.target_coefficients()];
    let greatest = source_coefficients.iter().chain(target_coefficients).map(|c| c.length()).fold(0.0, f64::max);
    let places = formations.map(|formation| formation.places().about_barycenter());
    let is_reversed = |(source, &target): (usize, &usize)| {
        let likeness = pair.likeness()[(source, target)];
        if likeness.abs() >= NO_SIGN {
            return likeness < 0.0;
        }
        let (from, to) = (source_coefficients[source], target_coefficients[target]);
        let together = from.dot(turn.back(to));
        if together.abs() > COEFFICIENT_ERROR * greatest * (from.length() + to.length()) {
            return together < 0.0;
        }
        let weights = pair.source_modes().col(source).iter().zip(pair.target_modes().col(target).iter()).map(|(e, f)| e * f);
        weights.zip(places[0].iter().zip(&places[1])).map(|(weight, (p, q))| weight * p.dot(turn.back(*q))).sum::<f64>() < 0.0
    };
    pairing.targets().iter().enumerate().map(is_reversed).collect()
}
