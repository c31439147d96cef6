//! Which eigenvectors to take where eigenvalues repeat.
//!
//! Equal eigenvalues, common in symmetric formations, leave the eigenvectors to the solver, and then the paths would change with
//! the agents' labels. The other end's graph and the distances at both ends, mixed in faintly, decide instead; what is equal even
//! then is turned to fit the source.

use faer::Mat;
use glam::DVec3;

use super::eigenbasis::Eigenbasis;
use super::polar_factor::polar_factor;
use super::runs::runs;
use crate::formation::Formation;
use eigenform_dense::{norm, product};

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
    let positions: Vec<DVec3> = formation.places().iter().collect();
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
            let amount = norm(shared.as_ref());
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

#[cfg(test)]
mod tests {
    use glam::DVec2;

    use super::*;

    fn ring(count: usize, radius: f64) -> Formation {
        Formation::new((0..count).map(|i| DVec2::from_angle(std::f64::consts::TAU * i as f64 / count as f64) * radius).collect())
    }

    fn line(count: usize) -> Formation {
        Formation::new((0..count).map(|i| DVec2::new(i as f64, 0.0)).collect())
    }

    fn cycle(count: usize) -> Mat<f64> {
        Mat::from_fn(count, count, |row, column| match (row + count - column) % count {
            0 => 2.0,
            1 => -1.0,
            step if step == count - 1 => -1.0,
            _ => 0.0,
        })
    }

    #[test]
    fn equal_means_near_relative_to_the_largest() {
        for (eigenvalues, expected) in [
            (&[0.0, 1.0, 2.0, 3.0][..], false),
            (&[0.0, 1.0, 1.0 + 2e-6, 3.0], true),
            (&[0.0, 1.0, 1.0 + 4e-6, 3.0], false),
            // Two zeros are one piece more than one; three zeros are two modes that nothing tells apart.
            (&[0.0, 0.0, 2.0, 3.0], false),
            (&[0.0, 0.0, 0.0, 3.0], true),
            (&[0.0, 0.0, 0.0], true),
            (&[0.0, 0.0], false),
            (&[0.0], false),
            (&[], false),
        ] {
            assert_eq!(is_degenerate(eigenvalues), expected, "{eigenvalues:?}");
        }
    }

    #[test]
    fn nearness_is_a_laplacian_of_trace_one_even_where_agents_coincide() {
        let twins = Formation::new(vec![DVec2::ZERO, DVec2::ZERO, DVec2::X, DVec2::Y]);
        for (source, target) in [(ring(4, 3.0), line(4)), (twins.clone(), twins), (Formation::new(vec![DVec2::ONE; 4]), line(4))] {
            let laplacian = nearness(&source, &target);
            assert!((trace(&laplacian) - 1.0).abs() < 1e-14);
            for row in 0..4 {
                assert!((0..4).map(|column| laplacian[(row, column)]).sum::<f64>().abs() < 1e-15);
            }
        }
    }

    #[test]
    fn the_other_end_tells_the_modes_of_a_ring_apart() {
        let ring_graph = cycle(12);
        assert!(is_degenerate(Eigenbasis::of(ring_graph.as_ref()).eigenvalues()));
        let broken = with_tie_break(&ring_graph, None, &nearness(&ring(12, 5.0), &line(12)));
        assert!(!is_degenerate(Eigenbasis::of(broken.as_ref()).eigenvalues()));
        // Faint: eigenvalues move by at most ε tr L (Weyl), here 1e-4 · 24 · 1/2.
        assert!((&broken - &ring_graph).norm_l2() <= 1e-4 * 12.0);
    }

    #[test]
    fn without_ties_the_tie_break_alone_decides() {
        let none = Mat::zeros(6, 6);
        let broken = with_tie_break(&none, Some(&none), &nearness(&line(6), &line(6)));
        assert!(!is_degenerate(Eigenbasis::of(broken.as_ref()).eigenvalues()));
    }

    #[test]
    fn what_is_equal_even_then_is_turned_to_fit_the_source() {
        let basis = Eigenbasis::of(cycle(12).as_ref());
        // The same eigenspaces in other bases: every pair of columns turned by an angle of its own.
        let turned = Mat::from_fn(12, 11, |row, column| {
            let pair = column - column % 2;
            if pair == 10 {
                return basis.modes()[(row, 10)];
            }
            let (sin, cos) = (0.3 + pair as f64).sin_cos();
            let weights = if column == pair { (cos, sin) } else { (-sin, cos) };
            weights.0 * basis.modes()[(row, pair)] + weights.1 * basis.modes()[(row, pair + 1)]
        });
        let fitted = turned_to(&basis, &basis.with_modes(turned));
        assert!((fitted.modes() - basis.modes()).norm_max() < 1e-13);
    }
}
