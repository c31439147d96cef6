//! Which way each target mode points: eigenvectors come with arbitrary signs.

use glam::DVec2;

use super::matching::Pairing;
use super::pair::Pair;
use crate::formation::Formation;

/// Inner products below this have no sign of their own: symmetric formations make them exactly zero up to round-off.
pub(super) const NO_SIGN: f64 = 1e-9;

/// Coefficients are good to this, relative to the greatest: eps over the least gap that the tie-break lets pass.
const COEFFICIENT_ERROR: f64 = 1e-10;

/// Which target modes are reversed before they are matched, one entry a source mode; `turn` (radians) is taken out of the target.
///
/// Modes that resemble each other point the same way. Where an inner product is zero their coefficients do, and where that says
/// nothing either, the places of the agents, weighted by both modes. Only then does the turn matter: alignments that reverse the
/// same modes share one rotation.
pub(crate) fn reversals(pair: &Pair, pairing: &Pairing, formations: [&Formation; 2], turn: f64) -> Vec<bool> {
    let back = DVec2::from_angle(-turn);
    let [source_coefficients, target_coefficients] = [pair.source_coefficients(), pair.target_coefficients()];
    let greatest = source_coefficients.iter().chain(target_coefficients).map(|c| c.length()).fold(0.0, f64::max);
    let is_reversed = |(source, &target): (usize, &usize)| {
        let likeness = pair.likeness()[(source, target)];
        if likeness.abs() >= NO_SIGN {
            return likeness < 0.0;
        }
        let (from, to) = (source_coefficients[source], target_coefficients[target]);
        let together = from.dot(back.rotate(to));
        if together.abs() > COEFFICIENT_ERROR * greatest * (from.length() + to.length()) {
            return together < 0.0;
        }
        let weights = pair.source_modes().col(source).iter().zip(pair.target_modes().col(target).iter()).map(|(e, f)| e * f);
        let centers = formations.map(Formation::barycenter);
        let places = formations[0].positions().iter().zip(formations[1].positions());
        weights.zip(places).map(|(weight, (p, q))| weight * (*p - centers[0]).dot(back.rotate(*q - centers[1]))).sum::<f64>() < 0.0
    };
    pairing.targets().iter().enumerate().map(is_reversed).collect()
}
