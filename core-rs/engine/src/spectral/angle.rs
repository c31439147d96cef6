//! Angles and their one representative turn.

use std::f64::consts::{PI, TAU};

/// Turns this near to −π count as +π.
///
/// A half turn comes out of `atan2` as −π or +π by the sign of a zero; without the snap round-off would choose the direction.
pub(super) const HALF_TURN_SNAP: f64 = 1e-9;

/// The angle equal to `angle` in (−π, π], in radians; what is within `snap` of −π becomes +π.
pub(super) fn wrap(angle: f64, snap: f64) -> f64 {
    let turn = angle - TAU * (angle / TAU).round();
    if turn <= snap - PI { turn + TAU } else { turn }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_angle_wraps_into_the_half_open_turn() {
        for (angle, expected) in [(0.0, 0.0), (3.0 * PI, PI), (-PI, PI), (PI, PI), (-PI / 2.0, -PI / 2.0), (1.5 * PI, -PI / 2.0)] {
            assert!((wrap(angle, HALF_TURN_SNAP) - expected).abs() < 1e-14, "{angle}");
        }
    }

    #[test]
    fn a_half_turn_is_positive_whatever_its_zero_was() {
        assert!(wrap((-0.0_f64).atan2(-1.0), HALF_TURN_SNAP) > 3.0);
        assert!(wrap(-PI + 5e-10, HALF_TURN_SNAP) > 3.0);
        assert!(wrap(-PI + 2e-9, HALF_TURN_SNAP) < -3.0);
    }
}
