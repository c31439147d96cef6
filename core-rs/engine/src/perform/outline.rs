//! Obstacles as the rooms that edit motion know them.

use glam::DVec2;

use crate::edits::Outline;
use crate::obstacle::ObstacleShape;

pub(super) fn outline(shape: &ObstacleShape) -> Outline {
    match shape {
        ObstacleShape::Circle { center, radius } => Outline { points: vec![center.to_array()], radius: *radius },
        ObstacleShape::Polygon { points } => Outline { points: points.iter().map(DVec2::to_array).collect(), radius: 0.0 },
    }
}
