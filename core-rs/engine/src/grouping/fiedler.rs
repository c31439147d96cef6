//! The second eigenvector of a connected graph: its weakest mode of coming apart.

use super::graph::Graph;
use super::low_modes::{LowMode, dot, low_modes};
use crate::formation::Formation;

/// Eigenvalues this near to the second, relative to it, share its place: the line of the agents on the stage decides among their modes.
const SAME_EIGENVALUE: f64 = 1e-3;

/// A direction less visible in the modes than this has nothing to say.
const UNSEEN: f64 = 1e-6;

/// One value a local agent, orthogonal to the constant, of any length but zero; agents of a symmetric formation part along x first.
///
/// Its sign and, where eigenvalues repeat, its direction come from the positions, so that labels do not matter.
///
/// # Panics
/// When the graph has fewer than two agents or is not connected: a bug.
pub(super) fn fiedler(graph: &Graph, formation: &Formation) -> Vec<f64> {
    let modes = low_modes(graph, formation);
    let second = modes[0].eigenvalue;
    let equal: Vec<&LowMode> = modes.iter().take_while(|mode| mode.eigenvalue <= second * (1.0 + SAME_EIGENVALUE)).collect();
    let center = formation.barycenter();
    for axis in 0..2 {
        let coordinate: Vec<f64> = graph.agents.iter().map(|&agent| (formation.positions()[agent as usize] - center)[axis]).collect();
        let seen: Vec<f64> = equal.iter().map(|mode| dot(&mode.values, &coordinate)).collect();
        if dot(&seen, &seen).sqrt() > UNSEEN * dot(&coordinate, &coordinate).sqrt() {
            let value = |agent: usize| equal.iter().zip(&seen).map(|(mode, seen)| mode.values[agent] * seen).sum();
            return (0..graph.agent_count()).map(value).collect();
        }
    }
    modes[0].values.clone()
}
