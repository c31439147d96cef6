//! Which agents keep their relative position to which.
//!
//! An [`Adjacency`] is topology and weight only: it knows agent indices, never coordinates. [`propose`] suggests ties from
//! positions, and [`build`] applies to them what the person says.

mod build;
mod coincidence;
mod components;
mod delaunay;
mod facets;
mod joining;
mod laplacian;
mod obstacle_ties;
mod spec;
mod subdivision;
mod triangulation;

pub(crate) use components::Components;

pub use build::{COMPLETE_GROUP_LIMIT, GroupTie, TIE_LIMIT, TooManyTies, build, expanded_tie_count};
pub use delaunay::{COINCIDENCE_TOLERANCE, propose};
pub use obstacle_ties::{ObstacleTie, obstacle_ties};
pub use spec::{AdjacencySpec, Base, Weights};

/// Two agents, lower first.
type Edge = (u32, u32);

/// One tie of the graph.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tie {
    /// The lower agent index.
    pub a: u32,
    /// The higher agent index.
    pub b: u32,
    /// What the person and the groups made of it; 1 for a proposed tie.
    pub factor: f64,
    /// The weight in the Laplacian, > 0.
    pub weight: f64,
}

/// A weighted graph of agents.
#[derive(Clone, Debug, PartialEq)]
pub struct Adjacency {
    agent_count: usize,
    ties: Vec<Tie>,
    obstacle_ties: Vec<ObstacleTie>,
}

impl Adjacency {
    /// A graph of `agent_count` agents; ties must have a < b, ascend by (a, b) and occur once.
    ///
    /// # Panics
    /// When they do not: a bug, not input.
    pub fn new(agent_count: usize, ties: Vec<Tie>) -> Self {
        assert!(ties.iter().all(|tie| tie.a < tie.b && (tie.b as usize) < agent_count), "a tie joins two agents, lower first");
        assert!(ties.is_sorted_by(|p, q| (p.a, p.b) < (q.a, q.b)), "ties ascend and occur once");
        Self { agent_count, ties, obstacle_ties: Vec::new() }
    }

    /// The same graph with ties to obstacles.
    #[must_use]
    pub fn with_obstacle_ties(self, obstacle_ties: Vec<ObstacleTie>) -> Self {
        Self { obstacle_ties, ..self }
    }

    /// How many agents it spans, tied or not.
    pub fn agent_count(&self) -> usize {
        self.agent_count
    }

    /// Ties, ascending by (a, b).
    pub fn ties(&self) -> &[Tie] {
        &self.ties
    }

    /// Ties to obstacles, as the person listed them.
    pub fn obstacle_ties(&self) -> &[ObstacleTie] {
        &self.obstacle_ties
    }
}
