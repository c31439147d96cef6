//! The modes of the least eigenvalues, without solving for all.
//!
//! Few agents have their dense eigenproblem. Of many, a small block of vectors is taken through the inverse Laplacian again and again
//! (sparse, by conjugate gradients), and the best vectors within the block are its modes. The block starts from the positions: a graph
//! of neighbors comes apart where the formation is long.

use eigenform_dense::symmetric_eigen;
use faer::Mat;
use glam::DVec2;

use super::graph::Graph;
use crate::formation::Formation;
use crate::spectral::Eigenbasis;

/// Up to here the dense eigenproblem takes a millisecond.
const DENSE_LIMIT: usize = 64;

/// Vectors in the block: what is sought, and neighbors that make it converge.
const BLOCK: usize = 6;

/// An eigenvector this true, relative to its eigenvalue, lines the agents up.
const RESIDUAL: f64 = 1e-5;

/// Rounds through the inverse; a few suffice unless many eigenvalues crowd at the second.
const MOST_ROUNDS: usize = 40;

/// A solution this true is as good as the block needs from one round.
const SOLVED: f64 = 1e-7;

/// A vector that loses all but this of its length to those before it is none of its own.
const SPENT: f64 = 1e-9;

/// An eigenvector of unit length.
pub(super) struct LowMode {
    pub(super) eigenvalue: f64,
    /// One a local agent.
    pub(super) values: Vec<f64>,
}

/// Modes beside the constant by ascending eigenvalue, at least one; of a connected graph of at least two agents.
pub(super) fn low_modes(graph: &Graph, formation: &Formation) -> Vec<LowMode> {
    if graph.agent_count() <= DENSE_LIMIT {
        return dense(graph);
    }
    let mut block = orthonormal(start(graph, formation));
    let mut modes = best_within(graph, &block);
    for _ in 0..MOST_ROUNDS {
        if modes[0].residual <= RESIDUAL * modes[0].mode.eigenvalue {
            break;
        }
        block = orthonormal(modes.iter().map(|best| solve(graph, &best.mode)).collect());
        modes = best_within(graph, &block);
    }
    modes.into_iter().map(|best| best.mode).collect()
}

fn dense(graph: &Graph) -> Vec<LowMode> {
    let count = graph.agent_count();
    let mut laplacian = Mat::zeros(count, count);
    for agent in 0..count {
        for &(other, weight) in graph.neighbors(agent as u32) {
            laplacian[(agent, other as usize)] -= weight;
            laplacian[(agent, agent)] += weight;
        }
    }
    let basis = Eigenbasis::of(laplacian.as_ref());
    let values = |mode: usize| basis.modes().col(mode).iter().copied().collect();
    (0..count - 1).map(|mode| LowMode { eigenvalue: basis.eigenvalues()[mode + 1], values: values(mode) }).collect()
}

/// Low polynomials of the positions; what the formation lacks (a line has no y) is made up.
fn start(graph: &Graph, formation: &Formation) -> Vec<Vec<f64>> {
    let center = formation.barycenter();
    let at = |agent: &u32| formation.positions()[*agent as usize] - center;
    let shapes: [fn(DVec2) -> f64; 5] = [|p| p.x, |p| p.y, |p| p.x * p.y, |p| p.x * p.x - p.y * p.y, |p| p.x * p.x + p.y * p.y];
    let mut block: Vec<Vec<f64>> = shapes.iter().map(|shape| graph.agents.iter().map(|agent| shape(at(agent))).collect()).collect();
    // The golden ratio's multiples leave no two agents alike and no pattern.
    let strewn =
        |round: f64| (0..graph.agent_count()).map(|agent| ((agent as f64 + 1.0) * 0.618_033_988_749_894_9 * round).fract() - 0.5).collect();
    block.extend((1..=BLOCK).map(|round| strewn(round as f64)));
    block
}

/// At most [`BLOCK`] vectors of unit length, orthogonal to the constant and to one another.
fn orthonormal(vectors: Vec<Vec<f64>>) -> Vec<Vec<f64>> {
    let mut block: Vec<Vec<f64>> = Vec::with_capacity(BLOCK);
    for mut vector in vectors {
        let length = dot(&vector, &vector).sqrt();
        // Twice is enough: what round-off left of the others the first time is gone.
        for _ in 0..2 {
            center(&mut vector);
            for other in &block {
                let shared = dot(&vector, other);
                vector.iter_mut().zip(other).for_each(|(entry, other)| *entry -= shared * other);
            }
        }
        let left = dot(&vector, &vector).sqrt();
        if left > SPENT * length && block.len() < BLOCK {
            block.push(vector.iter().map(|entry| entry / left).collect());
        }
    }
    block
}

struct Best {
    mode: LowMode,
    residual: f64,
}

/// The eigenvectors of the Laplacian as seen by the block (Rayleigh and Ritz), and how far each is from being one.
fn best_within(graph: &Graph, block: &[Vec<f64>]) -> Vec<Best> {
    let images: Vec<Vec<f64>> = block.iter().map(|vector| graph.laplacian_times(vector)).collect();
    let seen = Mat::from_fn(block.len(), block.len(), |row, column| dot(&block[row], &images[column]));
    let eigen = symmetric_eigen(seen.as_ref());
    let mixed = |vectors: &[Vec<f64>], mode: usize| -> Vec<f64> {
        let mut sum = vec![0.0; graph.agent_count()];
        for (row, vector) in vectors.iter().enumerate() {
            let amount = eigen.vectors[(row, mode)];
            sum.iter_mut().zip(vector).for_each(|(sum, entry)| *sum += amount * entry);
        }
        sum
    };
    let best = |(mode, &eigenvalue): (usize, &f64)| {
        let (values, image) = (mixed(block, mode), mixed(&images, mode));
        let residual = image.iter().zip(&values).map(|(image, value)| (image - eigenvalue * value).powi(2)).sum::<f64>().sqrt();
        Best { mode: LowMode { eigenvalue, values }, residual }
    };
    eigen.values.iter().enumerate().map(best).collect()
}

/// The Laplacian's inverse times a mode, on vectors that sum to zero: conjugate gradients, preconditioned by the degrees.
fn solve(graph: &Graph, mode: &LowMode) -> Vec<f64> {
    let count = graph.agent_count();
    let degrees: Vec<f64> = (0..count as u32).map(|agent| graph.degree(agent)).collect();
    let preconditioned = |residual: &[f64]| -> Vec<f64> { residual.iter().zip(&degrees).map(|(r, degree)| r / degree).collect() };
    // A true mode is answered at once. Where weights differ so much that round-off hides the eigenvalue, nothing is known yet.
    let scale = if mode.eigenvalue > 0.0 { mode.eigenvalue.recip() } else { 0.0 };
    let mut solution: Vec<f64> = mode.values.iter().map(|value| scale * value).collect();
    let image = graph.laplacian_times(&solution);
    let mut residual: Vec<f64> = mode.values.iter().zip(&image).map(|(value, image)| value - image).collect();
    let mut direction = preconditioned(&residual);
    let mut progress = dot(&residual, &direction);
    for _ in 0..count {
        if dot(&residual, &residual).sqrt() <= SOLVED {
            break;
        }
        let image = graph.laplacian_times(&direction);
        let curvature = dot(&direction, &image);
        if curvature <= 0.0 {
            break;
        }
        let step = progress / curvature;
        for agent in 0..count {
            solution[agent] += step * direction[agent];
            residual[agent] -= step * image[agent];
        }
        let next = preconditioned(&residual);
        let gained = dot(&residual, &next);
        direction.iter_mut().zip(&next).for_each(|(direction, next)| *direction = next + gained / progress * *direction);
        progress = gained;
    }
    solution
}

fn center(vector: &mut [f64]) {
    let mean = vector.iter().sum::<f64>() / vector.len() as f64;
    for entry in vector {
        *entry -= mean;
    }
}

pub(super) fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::adjacency::{AdjacencySpec, GroupTie, build};

    fn check(name: &str, positions: Vec<DVec2>, group_ties: &[GroupTie]) {
        let formation = Formation::new(positions);
        let adjacency = build(&formation, &AdjacencySpec::default(), group_ties).expect("few ties");
        let everyone: Vec<u32> = (0..formation.agent_count() as u32).collect();
        let graph = Graph::of(&adjacency, &everyone);
        let (sparse, all) = (low_modes(&graph, &formation), dense(&graph));
        assert!(graph.agent_count() > DENSE_LIMIT, "{name} is sought in a block");
        // A residual r leaves the eigenvalue r²/gap off, far below the relative residual itself.
        let off = (sparse[0].eigenvalue / all[0].eigenvalue - 1.0).abs();
        assert!(off <= RESIDUAL, "{name}: {} for {}", sparse[0].eigenvalue, all[0].eigenvalue);
        // What it shares with the modes that are far from the second is at most residual / gap.
        let strays: f64 = all
            .iter()
            .filter(|mode| mode.eigenvalue > 1.1 * all[0].eigenvalue)
            .map(|mode| dot(&mode.values, &sparse[0].values).powi(2))
            .sum();
        assert!(strays.sqrt() <= RESIDUAL / 0.1, "{name}: {:e} elsewhere", strays.sqrt());
    }

    #[test]
    fn the_second_mode_of_many_is_that_of_the_dense_eigenproblem() {
        let grid = |columns: usize, rows: usize| {
            (0..columns * rows).map(move |i| DVec2::new((i % columns) as f64, (i / columns) as f64)).collect::<Vec<_>>()
        };
        let ring =
            |count: usize| (0..count).map(|i| DVec2::from_angle(std::f64::consts::TAU * i as f64 / count as f64) * 9.0).collect::<Vec<_>>();
        let spiral: Vec<DVec2> = (0..150).map(|i| DVec2::from_angle(f64::from(i) * 2.4) * f64::from(i).sqrt()).collect();
        let line: Vec<DVec2> = (0..100).map(|i| DVec2::new(f64::from(i * i), 0.0)).collect();
        let block = GroupTie { members: (0..40).collect(), factor: 100.0 };
        let twins: Vec<DVec2> = spiral.iter().flat_map(|p| [*p; 2]).collect();
        check("a grid", grid(12, 9), &[]);
        check("a square grid", grid(10, 10), &[]);
        check("a ring", ring(90), &[]);
        check("a spiral", spiral.clone(), &[]);
        check("a firm block", spiral, &[block]);
        check("a line that spreads", line, &[]);
        check("twins", twins, &[]);
        check("all in one place", vec![DVec2::ONE; 80], &[]);
    }
}
