//! Which eigenvectors to take where eigenvalues repeat.
//!
//! Equal eigenvalues, common in symmetric formations, leave the eigenvectors to the solver, and then the paths would change with
//! the agents' labels. The other end's graph and the distances at both ends, mixed in faintly, decide instead; what is equal even
//! then is turned to fit the source.

use faer::Mat;

use super::dense::product;
use super::eigenbasis::Eigenbasis;
use super::polar_factor::polar_factor;
use super::runs::runs;
use crate::formation::Formation;

/// Neighboring eigenvalues this near, relative to the largest, count as equal.
///
/// An eigenvector's round-off is eps over this gap, so what passes as simple is good to 1e-9.
const EQUAL_EIGENVALUES: f64 = 1e-6;

/// How strongly the tie-break is mixed in, relative to the trace: far above [`EQUAL_EIGENVALUES`], far below the graph.
const TIE_BREAK_STRENGTH: f64 = 1e-4;

/// Distances below this, relative to the mean distance, are raised to it: coincident agents have no nearness otherwise.
const LEAST_DISTANCE: f64 = 0.01;

/// Whether two neighboring eigenvalues beside the constant mode's are too near to tell their modes apart.
pub(crate) fn is_degenerate(eigenvalues: &[f64]) -> bool {
    equal_runs(eigenvalues).iter().any(|run| run.len() > 1)
}

/// Mode indices (0 is the first beside the constant) in runs of equal eigenvalues.
fn equal_runs(eigenvalues: &[f64]) -> Vec<std::ops::Range<usize>> {
    let largest = eigenvalues.last().copied().unwrap_or(0.0);
    runs(eigenvalues.get(1..).unwrap_or(&[]), EQUAL_EIGENVALUES * largest)
}

/// The complete graph that ties agents the more the nearer they stand, at both ends together: its Laplacian, of trace 1.
pub(crate) fn nearness(source: &Formation, target: &Formation) -> Mat<f64> {
    let agent_count = source.agent_count();
    let (source, target) = (relative_distances(source), relative_distances(target));
    let mut laplacian = Mat::zeros(agent_count, agent_count);
    for b in 0..agent_count {
        for a in 0..b {
            let weight = (source[(a, b)] + target[(a, b)]).powi(-2);
            laplacian[(a, b)] = -weight;
            laplacian[(b, a)] = -weight;
            laplacian[(a, a)] += weight;
            laplacian[(b, b)] += weight;
        }
    }
    let scale = trace(&laplacian).recip();
    if scale.is_finite() {
        laplacian *= faer::Scale(scale);
    }
    laplacian
}

/// Distances over their mean, at least [`LEAST_DISTANCE`], above the diagonal.
fn relative_distances(formation: &Formation) -> Mat<f64> {
    let positions = formation.positions();
    let mut distances = Mat::zeros(positions.len(), positions.len());
    let mut sum = 0.0;
    for b in 0..positions.len() {
        for a in 0..b {
            let distance = positions[a].distance(positions[b]);
            distances[(a, b)] = distance;
            sum += distance;
        }
    }
    let pair_count = (positions.len() * positions.len().saturating_sub(1) / 2) as f64;
    let unit = if sum > 0.0 { pair_count / sum } else { 0.0 };
    for b in 0..positions.len() {
        for a in 0..b {
            distances[(a, b)] = f64::max(distances[(a, b)] * unit, LEAST_DISTANCE);
        }
    }
    distances
}

/// own + ε tr own (other/tr other + nearness/2). A graph without ties counts as one of trace 1: the tie-break alone decides then.
pub(crate) fn with_tie_break(own: &Mat<f64>, other: Option<&Mat<f64>>, nearness: &Mat<f64>) -> Mat<f64> {
    let strength = TIE_BREAK_STRENGTH * Some(trace(own)).filter(|trace| *trace > 0.0).unwrap_or(1.0);
    let other = other.map(|matrix| (matrix, trace(matrix))).filter(|(_, trace)| *trace > 0.0);
    Mat::from_fn(own.nrows(), own.ncols(), |row, column| {
        let elsewhere = other.map_or(0.0, |(matrix, trace)| matrix[(row, column)] / trace);
        own[(row, column)] + strength * (elsewhere + 0.5 * nearness[(row, column)])
    })
}

fn trace(matrix: &Mat<f64>) -> f64 {
    (0..matrix.nrows()).map(|index| matrix[(index, index)]).sum()
}

/// The target basis with every block of equal eigenvalues turned to the source block of equal size that it shares most with.
pub(super) fn turned_to(source: &Eigenbasis, target: &Eigenbasis) -> Eigenbasis {
    let mut modes = target.modes().to_owned();
    let source_runs = equal_runs(source.eigenvalues());
    for run in equal_runs(target.eigenvalues()).into_iter().filter(|run| run.len() > 1) {
        let block = target.modes().subcols(run.start, run.len());
        let mut best: Option<(f64, Mat<f64>)> = None;
        for candidate in source_runs.iter().filter(|candidate| candidate.len() == run.len()) {
            let shared = product(source.modes().subcols(candidate.start, run.len()).transpose(), block);
            let amount = shared.norm_l2();
            if best.as_ref().is_none_or(|(most, _)| amount > most + 1e-12) {
                best = Some((amount, shared));
            }
        }
        if let Some(turn) = best.and_then(|(_, shared)| polar_factor(shared.as_ref())) {
            modes.subcols_mut(run.start, run.len()).copy_from(product(block, turn.transpose()));
        }
    }
    target.with_modes(modes)
}
