//! Angles and directions, rounded the same on every machine; and the browser loads one set of these functions instead of two.

use glam::DVec2;

/// The unit vector at an angle from the x axis, radians.
pub(crate) fn direction(angle: f64) -> DVec2 {
    DVec2::new(libm::cos(angle), libm::sin(angle))
}

/// The angle of a vector from the x axis in (−π, π], radians; 0 without a length.
pub(crate) fn bearing(vector: DVec2) -> f64 {
    libm::atan2(vector.y, vector.x)
}

/// The angle from one vector to another in (−π, π], radians.
pub(crate) fn turn(from: DVec2, to: DVec2) -> f64 {
    libm::atan2(from.perp_dot(to), from.dot(to))
}

/// What is left of a way around something, in whole rounds of `length`.
pub(crate) fn around(way: f64, length: f64) -> f64 {
    way - length * (way / length).floor()
}
