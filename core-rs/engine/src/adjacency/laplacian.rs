//! The matrix of a graph.

use faer::Mat;

use super::Adjacency;

impl Adjacency {
    /// The Laplacian L = D − W, agents × agents: symmetric, rows sum to zero (paper A, section 3) or, where an agent is tied to an
    /// obstacle, to the weight of that tie: an obstacle is a vertex that does not move, so it has no row of its own.
    pub fn laplacian(&self) -> Mat<f64> {
        let mut laplacian = Mat::zeros(self.agent_count(), self.agent_count());
        for tie in self.ties() {
            let (a, b) = (tie.a as usize, tie.b as usize);
            laplacian[(a, b)] -= tie.weight;
            laplacian[(b, a)] -= tie.weight;
            laplacian[(a, a)] += tie.weight;
            laplacian[(b, b)] += tie.weight;
        }
        for tie in self.obstacle_ties() {
            laplacian[(tie.agent as usize, tie.agent as usize)] += tie.weight;
        }
        laplacian
    }
}
