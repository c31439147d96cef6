//! A path that somebody drew, for a formation to travel along.

use glam::DVec3;
use serde::{Serialize, Serializer};

/// The points of a path, in the order in which they are passed; meters.
#[derive(Clone, Debug, PartialEq)]
pub struct PathSpec {
    /// At least two of them apart; z is 0 on the plane.
    pub points: Vec<DVec3>,
    /// Whether points have heights, and so three numbers: only where positions have. Else the path climbs evenly.
    pub is_spatial: bool,
}

impl PathSpec {
    /// The numbers of a point.
    pub(super) fn numbers<'p>(&self, point: &'p DVec3) -> &'p [f64] {
        &point.as_ref()[..if self.is_spatial { 3 } else { 2 }]
    }
}

impl Serialize for PathSpec {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_seq(self.points.iter().map(|point| self.numbers(point)))
    }
}
