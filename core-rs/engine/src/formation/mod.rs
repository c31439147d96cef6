//! A formation: where every agent stands at one instant.
//!
//! Geometry only: it knows positions by agent index, never ties, names or times.

mod axes;
mod neighbors;
mod places;
mod spacing;

pub use axes::{PrincipalAxes, principal_axes};
pub use neighbors::{PairSearch, near_pair};
pub use places::Places;

use glam::DVec2;

/// The positions of all agents at one keyframe, by agent index; meters, x to the right, y away from the audience, z up.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Formation {
    positions: Vec<DVec2>,
    /// None on the plane.
    heights: Option<Vec<f64>>,
}

impl Formation {
    /// A formation on the plane.
    pub fn new(positions: Vec<DVec2>) -> Self {
        Self { positions, heights: None }
    }

    /// A formation in space: x, y and z an agent. Without agents it is the one on the plane.
    ///
    /// # Panics
    /// When there are not as many heights as positions: a bug, not input.
    pub fn spatial(positions: Vec<DVec2>, heights: Vec<f64>) -> Self {
        assert_eq!(positions.len(), heights.len(), "every agent has a height");
        Self { heights: if positions.is_empty() { None } else { Some(heights) }, positions }
    }

    /// Positions by agent index, as seen from above.
    pub fn positions(&self) -> &[DVec2] {
        &self.positions
    }

    /// Heights z by agent index; none on the plane.
    pub fn heights(&self) -> Option<&[f64]> {
        self.heights.as_deref()
    }

    /// The height of an agent; 0 on the plane.
    pub fn height(&self, agent: usize) -> f64 {
        self.heights.as_ref().map_or(0.0, |heights| heights[agent])
    }

    /// How many agents stand in it.
    pub fn agent_count(&self) -> usize {
        self.positions.len()
    }

    /// The mean position as seen from above; the origin for no agents.
    pub fn barycenter(&self) -> DVec2 {
        if self.positions.is_empty() { DVec2::ZERO } else { self.positions.iter().sum::<DVec2>() / self.positions.len() as f64 }
    }

    /// Opposite corners of the bounding box as seen from above, lower left and upper right; both the origin for no agents.
    pub fn bounds(&self) -> (DVec2, DVec2) {
        bounds(&self.positions)
    }

    /// The diagonal of the bounding box, meters: the scale of every relative tolerance.
    pub fn extent(&self) -> f64 {
        let (low, high) = self.bounds();
        low.distance(high).hypot(rise(self.heights()))
    }
}

/// From the lowest to the highest, meters.
pub(crate) fn rise(heights: Option<&[f64]>) -> f64 {
    let heights = heights.unwrap_or_default();
    let Some(&first) = heights.first() else { return 0.0 };
    let (low, high) = heights.iter().fold((first, first), |(low, high), &z| (z.min(low), z.max(high)));
    high - low
}

impl From<Vec<[f64; 2]>> for Formation {
    fn from(points: Vec<[f64; 2]>) -> Self {
        Self::new(points.into_iter().map(DVec2::from_array).collect())
    }
}

fn bounds(points: &[DVec2]) -> (DVec2, DVec2) {
    let first = points.first().copied().unwrap_or_default();
    points.iter().fold((first, first), |(low, high), p| (low.min(*p), high.max(*p)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn heights_count_in_the_extent() {
        let plan = vec![DVec2::ZERO, DVec2::new(2.0, 3.0)];
        let flat = Formation::new(plan.clone());
        assert_eq!((flat.heights(), flat.height(1), flat.extent()), (None, 0.0, 13.0_f64.sqrt()));
        // 2² + 3² + 6² = 7².
        let spatial = Formation::spatial(plan.clone(), vec![-1.0, 5.0]);
        assert_eq!((spatial.heights(), spatial.height(1), spatial.extent()), (Some(&[-1.0, 5.0][..]), 5.0, 7.0));
        assert_eq!(Formation::spatial(plan, vec![4.0; 2]).extent().to_bits(), flat.extent().to_bits());
        assert_eq!(Formation::spatial(Vec::new(), Vec::new()), Formation::default());
    }
}
