//! Obstacles as `dodgy_2d` knows them: closed polygons, solid on the left of their sides.

use dodgy_2d::{Obstacle, Vec2};
use eigenform_apart::Outline;

/// Corners of the polygon about a circle: it is larger by 0.5 % at the most.
const CORNERS: usize = 32;

/// An outline's polygon, counterclockwise, and the outline itself.
pub struct Wall {
    outline: Outline,
    corners: Vec<[f64; 2]>,
}

impl Wall {
    pub fn new(outline: &Outline) -> Self {
        let corners = match &outline.points[..] {
            [center] => around(*center, outline.radius),
            points if doubled_area(points) < 0.0 => points.iter().rev().copied().collect(),
            points => points.to_vec(),
        };
        Self { outline: outline.clone(), corners }
    }

    /// Whether it is nearer to a place than so far.
    pub fn is_within(&self, distance: f64, at: [f64; 2]) -> bool {
        self.outline.clearance(at).0 < distance
    }

    /// As seen from a place.
    pub fn seen(&self, from: [f64; 2]) -> Obstacle {
        let vertices = self.corners.iter().map(|corner| Vec2::new((corner[0] - from[0]) as f32, (corner[1] - from[1]) as f32));
        Obstacle::Closed { vertices: vertices.collect() }
    }
}

/// A polygon whose sides touch the circle.
fn around([x, y]: [f64; 2], radius: f64) -> Vec<[f64; 2]> {
    let half = std::f64::consts::PI / CORNERS as f64;
    let reach = radius / half.cos();
    (0..CORNERS).map(|k| (2.0 * half * k as f64).sin_cos()).map(|(sin, cos)| [x + reach * cos, y + reach * sin]).collect()
}

/// Positive for counterclockwise.
fn doubled_area(points: &[[f64; 2]]) -> f64 {
    let next = points.iter().cycle().skip(1);
    points.iter().zip(next).map(|(a, b)| a[0] * b[1] - b[0] * a[1]).sum()
}
