//! The principal axes of a set of points.

use glam::DVec2;

/// How a set of points spreads about its mean.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PrincipalAxes {
    /// Direction of the greatest spread, radians in (−π/2, π/2], counterclockwise from x; 0 when there is none.
    pub angle: f64,
    /// Variance along it, m².
    pub major: f64,
    /// Variance across it, m²; 0 ≤ minor ≤ major.
    pub minor: f64,
}

/// Principal axes of `points` (covariance over n): the angle is ½ atan2(2 Cxy, Cxx − Cyy).
pub fn principal_axes(points: &[DVec2]) -> PrincipalAxes {
    if points.is_empty() {
        return PrincipalAxes { angle: 0.0, major: 0.0, minor: 0.0 };
    }
    let count = points.len() as f64;
    let mean = points.iter().sum::<DVec2>() / count;
    let (mut xx, mut xy, mut yy) = (0.0, 0.0, 0.0);
    for &point in points {
        let d = point - mean;
        xx += d.x * d.x;
        xy += d.x * d.y;
        yy += d.y * d.y;
    }
    let (xx, xy, yy) = (xx / count, xy / count, yy / count);
    let (middle, half_gap) = (f64::midpoint(xx, yy), ((xx - yy) / 2.0).hypot(xy));
    // The difference of two near equals can come out a hair below zero.
    PrincipalAxes { angle: 0.5 * libm::atan2(2.0 * xy, xx - yy), major: middle + half_gap, minor: (middle - half_gap).max(0.0) }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::{FRAC_PI_2, FRAC_PI_4};

    use super::*;

    fn check(points: &[[f64; 2]], angle: f64, major: f64, minor: f64) {
        let axes = principal_axes(&points.iter().copied().map(DVec2::from_array).collect::<Vec<_>>());
        assert!((axes.angle - angle).abs() < 1e-15, "{axes:?}");
        assert!((axes.major - major).abs() < 1e-15 && (axes.minor - minor).abs() < 1e-15, "{axes:?}");
    }

    #[test]
    fn axes_lie_along_the_greatest_spread() {
        check(&[], 0.0, 0.0, 0.0);
        check(&[[7.0, 7.0]], 0.0, 0.0, 0.0);
        check(&[[-1.0, 0.0], [1.0, 0.0]], 0.0, 1.0, 0.0);
        check(&[[0.0, -1.0], [0.0, 1.0]], FRAC_PI_2, 1.0, 0.0);
        check(&[[4.0, 4.0], [6.0, 6.0]], FRAC_PI_4, 2.0, 0.0);
        check(&[[-2.0, 1.0], [2.0, 1.0], [2.0, -1.0], [-2.0, -1.0]], 0.0, 4.0, 1.0);
    }
}
