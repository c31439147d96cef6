//! How finely an edit looks at a guide.

use glam::DVec3;

/// Guides are rounded to this, meters: machines that differ in a guide's last bits then edit it the same way.
const GRAIN: f64 = 1.0 / (1 << 20) as f64;

pub(super) fn rounded(p: DVec3) -> DVec3 {
    (p / GRAIN).round() * GRAIN
}

/// The same of one coordinate. Half a grain is rounded away from zero, without the call that `round` is in the browser's build.
pub(super) fn rounded_along(along: f64) -> f64 {
    let grains = along / GRAIN;
    // The largest number below a half: a half itself would lift what lies just below it.
    let half = (0.5 - 0.25 * f64::EPSILON).copysign(grains);
    (grains + half).trunc() * GRAIN
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_coordinate_is_rounded_as_three_are() {
        let halves = (-9..=9).map(|k| 0.5 * f64::from(k) * GRAIN);
        let near = |along: f64| [along, along.next_down(), along.next_up()];
        for along in halves.chain([1e3 / 3.0, -1e5 / 7.0, 1e12, -1e300]).flat_map(near) {
            assert_eq!(rounded_along(along), rounded(DVec3::splat(along)).x, "{along}");
        }
    }
}
