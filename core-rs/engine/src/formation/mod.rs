//! A formation: where every agent stands at one instant.
//!
//! Geometry only: it knows positions by agent index, never ties, names or times.

mod axes;
mod neighbors;
mod spacing;

pub use axes::{PrincipalAxes, principal_axes};
pub use neighbors::{PairSearch, near_pair};

use glam::DVec2;
use serde::{Deserialize, Serialize};

/// The positions of all agents at one keyframe, by agent index; meters, x to the right, y away from the audience.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(from = "Vec<[f64; 2]>", into = "Vec<[f64; 2]>")]
pub struct Formation(Vec<DVec2>);

impl Formation {
    /// A formation of the given positions.
    pub fn new(positions: Vec<DVec2>) -> Self {
        Self(positions)
    }

    /// Positions by agent index.
    pub fn positions(&self) -> &[DVec2] {
        &self.0
    }

    /// How many agents stand in it.
    pub fn agent_count(&self) -> usize {
        self.0.len()
    }

    /// The mean position; the origin for no agents.
    pub fn barycenter(&self) -> DVec2 {
        if self.0.is_empty() { DVec2::ZERO } else { self.0.iter().sum::<DVec2>() / self.0.len() as f64 }
    }

    /// Opposite corners of the bounding box, lower left and upper right; both the origin for no agents.
    pub fn bounds(&self) -> (DVec2, DVec2) {
        bounds(&self.0)
    }

    /// The diagonal of the bounding box, meters: the scale of every relative tolerance.
    pub fn extent(&self) -> f64 {
        let (low, high) = self.bounds();
        low.distance(high)
    }
}

impl From<Vec<[f64; 2]>> for Formation {
    fn from(points: Vec<[f64; 2]>) -> Self {
        Self(points.into_iter().map(DVec2::from_array).collect())
    }
}

impl From<Formation> for Vec<[f64; 2]> {
    fn from(formation: Formation) -> Self {
        formation.0.into_iter().map(|p| p.to_array()).collect()
    }
}

fn bounds(points: &[DVec2]) -> (DVec2, DVec2) {
    let first = points.first().copied().unwrap_or_default();
    points.iter().fold((first, first), |(low, high), p| (low.min(*p), high.max(*p)))
}
