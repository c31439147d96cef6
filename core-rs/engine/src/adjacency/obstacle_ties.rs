//! Ties to what stands still.

use glam::DVec2;

use super::build::weights_by_distance;
use super::{AdjacencySpec, Weights};
use crate::formation::Formation;

/// An agent that keeps its clearance to an obstacle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ObstacleTie {
    /// The agent.
    pub agent: u32,
    /// The obstacle, by number.
    pub obstacle: u32,
    /// As the person says; from 1 on the clearance is kept, below it that share of it.
    pub factor: f64,
    /// The weight in the Laplacian, > 0.
    pub weight: f64,
}

/// The ties of `spec` to obstacles with these centers, at one formation. A weight is made of its factor as that of a tie between
/// agents is, by the distance to the obstacle's center as seen from above.
///
/// # Panics
/// When a tie names an agent or an obstacle that is not there: a bug, not input.
pub fn obstacle_ties(formation: &Formation, spec: &AdjacencySpec, centers: &[DVec2]) -> Vec<ObstacleTie> {
    let distance = |&(agent, obstacle, _): &(u32, u32, f64)| formation.positions()[agent as usize].distance(centers[obstacle as usize]);
    let factors: Vec<f64> = spec.obstacle_ties.iter().map(|tie| tie.2).collect();
    let weights = match spec.weights {
        Weights::Unit => factors,
        Weights::Inverse => weights_by_distance(factors, &spec.obstacle_ties.iter().map(distance).collect::<Vec<_>>()),
    };
    let ties = spec.obstacle_ties.iter().zip(weights);
    ties.map(|(&(agent, obstacle, factor), weight)| ObstacleTie { agent, obstacle, factor, weight }).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_weight_is_the_factor_over_the_distance_to_the_center() {
        let formation = Formation::from(vec![[0.0, 0.0], [4.0, 0.0], [2.0, 0.0]]);
        let centers = [DVec2::new(0.0, 8.0), DVec2::new(2.0, 0.0)];
        let spec = AdjacencySpec { obstacle_ties: vec![(0, 0, 4.0), (1, 1, 1.0), (2, 1, 0.5)], ..AdjacencySpec::default() };
        let weights = |spec: &AdjacencySpec| obstacle_ties(&formation, spec, &centers).iter().map(|tie| tie.weight).collect::<Vec<_>>();
        // Who stands at the center is a thousandth of the median away, that of 2 and 8.
        assert_eq!(weights(&spec), [0.5, 0.5, 100.0]);
        assert_eq!(weights(&AdjacencySpec { weights: Weights::Unit, ..spec }), [4.0, 1.0, 0.5]);
    }
}
