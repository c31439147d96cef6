//! What a link carries.

use super::route::Cell;
use super::step::Step;
use crate::scene::Scene;

/// A scene without its positions, which go as cells of a step's grid.
pub struct Document {
    /// Positions are empty.
    pub scene: Scene,
    /// The step of the cells.
    pub step: Step,
    /// By keyframe, then by agent.
    pub cells: Vec<Vec<Cell>>,
    /// Heights in steps, by keyframe, then by agent; no keyframes on the plane.
    pub heights: Vec<Vec<i64>>,
}
