//! What the person says about who belongs with whom.

use serde::{Deserialize, Serialize};

/// Who belongs with whom, as the person says it; an [`super::Adjacency`] is what it comes to at one formation.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
#[serde(rename_all = "camelCase")]
pub struct AdjacencySpec {
    /// Where the ties start from.
    pub base: Base,
    /// How a factor becomes a weight.
    pub weights: Weights,
    /// Ties by hand: two agents and a factor.
    pub ties: Vec<(u32, u32, f64)>,
    /// Pairs that are not tied, whatever came before.
    pub cuts: Vec<(u32, u32)>,
    /// Agents that keep their clearance to an obstacle: agent, obstacle and a factor.
    pub obstacle_ties: Vec<(u32, u32, f64)>,
}

/// Where the ties start from.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
#[serde(rename_all = "lowercase")]
pub enum Base {
    /// The Delaunay subdivision of the positions.
    #[default]
    Delaunay,
    /// No ties.
    None,
}

/// How a factor becomes a weight.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
#[serde(rename_all = "lowercase")]
pub enum Weights {
    /// Factor over distance.
    #[default]
    Inverse,
    /// The factor itself.
    Unit,
}
