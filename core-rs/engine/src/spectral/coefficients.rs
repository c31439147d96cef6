//! How the coefficients of the modes, or the places of agents about their barycenter, run between two ends.

use crate::trig;
use glam::DVec2;

use super::angle::{HALF_TURN_SNAP, wrap};

/// Radii at most this, relative to the greatest, have no direction.
pub(super) const TINY_RADIUS: f64 = 1e-7;

/// Round-off of a coefficient, relative to the greatest radius: the angle of a small one is uncertain by this over its own radius.
pub(super) const ROUND_OFF: f64 = 1e-13;

/// One curve a mode in polar coordinates: radii linear, angles along the shorter way once the common turn is taken out
/// (paper A, equation 4).
#[derive(Clone, Debug)]
pub(crate) struct Coefficients {
    curves: Vec<Curve>,
    sizes: Option<[f64; 2]>,
}

#[derive(Clone, Debug)]
struct Curve {
    radii: [f64; 2],
    angle: f64,
    turn: f64,
    residuals: [DVec2; 2],
}

impl Coefficients {
    /// Curves from `source` to `target`, of equal length, with the common `turn` in radians.
    pub(crate) fn between(source: &[DVec2], target: &[DVec2], turn: f64) -> Self {
        assert_eq!(source.len(), target.len(), "both ends have the same modes");
        let greatest = greatest_radius(source.iter().chain(target));
        let curves = source.iter().zip(target).map(|(from, to)| Curve::between(*from, *to, turn, greatest)).collect();
        Self { curves, sizes: None }
    }

    /// The same, scaled at every t so that the root of the summed squares runs linearly too.
    pub(crate) fn keeping_size(self) -> Self {
        let size = |t: f64| self.curves.iter().map(|curve| curve.at(t).length_squared()).sum::<f64>().sqrt();
        Self { sizes: Some([size(0.0), size(1.0)]), ..self }
    }

    /// Writes the coefficients at every `t` in 0..1: for each t a column of all x, then a column of all y.
    pub(crate) fn write_columns(&self, ts: &[f64], columns: &mut [f64]) {
        let mode_count = self.curves.len();
        assert_eq!(columns.len(), 2 * mode_count * ts.len(), "two columns for every t");
        for (t, columns) in ts.iter().zip(columns.chunks_exact_mut((2 * mode_count).max(1))) {
            let size = self.sizes.map(|[from, to]| (1.0 - t) * from + t * to);
            write_pair(self.curves.iter().map(|curve| curve.at(*t)), size, columns);
        }
    }
}

/// Writes a column of all x, then one of all y; scaled so that the root of the summed squares is `size` where one is given.
pub(super) fn write_pair(coefficients: impl Iterator<Item = DVec2>, size: Option<f64>, columns: &mut [f64]) {
    let (x, y) = columns.split_at_mut(columns.len() / 2);
    let mut squares = 0.0;
    for ((at, x), y) in coefficients.zip(x.iter_mut()).zip(y.iter_mut()) {
        squares += at.length_squared();
        (*x, *y) = (at.x, at.y);
    }
    if let Some(size) = size
        && squares > 0.0
    {
        let scale = size / squares.sqrt();
        x.iter_mut().chain(y).for_each(|entry| *entry *= scale);
    }
}

/// The angle at `from` and the turn to `to`, radians: along the shorter way once the `common` turn is out. What is tiny beside
/// `greatest` has no direction of its own and follows the common turn.
pub(super) fn bearing(from: DVec2, to: DVec2, common: f64, greatest: f64) -> (f64, f64) {
    let radii = [from.length(), to.length()];
    let least = radii[0].min(radii[1]);
    let (angle, end) = (trig::bearing(from), trig::bearing(to));
    if least > TINY_RADIUS * greatest {
        (angle, common + wrap(end - angle - common, f64::max(HALF_TURN_SNAP, ROUND_OFF * greatest / least)))
    } else if radii[0] <= TINY_RADIUS * greatest {
        (end - common, common)
    } else {
        (angle, common)
    }
}

/// The greatest radius of all.
pub(super) fn greatest_radius<'a>(coefficients: impl Iterator<Item = &'a DVec2>) -> f64 {
    coefficients.map(|c| c.length()).fold(0.0, f64::max)
}

impl Curve {
    fn between(from: DVec2, to: DVec2, common: f64, greatest: f64) -> Self {
        let (angle, turn) = bearing(from, to, common, greatest);
        let mut curve = Self { radii: [from.length(), to.length()], angle, turn, residuals: [DVec2::ZERO; 2] };
        // What a direction of noise leaves open at the ends; round-off elsewhere.
        curve.residuals = [from - curve.at(0.0), to - curve.at(1.0)];
        curve
    }

    fn at(&self, t: f64) -> DVec2 {
        let radius = (1.0 - t) * self.radii[0] + t * self.radii[1];
        radius * trig::direction(self.angle + t * self.turn) + (1.0 - t) * self.residuals[0] + t * self.residuals[1]
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use super::*;

    fn at(coefficients: &Coefficients, t: f64) -> Vec<DVec2> {
        let count = coefficients.curves.len();
        let mut columns = vec![f64::NAN; 2 * count];
        coefficients.write_columns(&[t], &mut columns);
        (0..count).map(|k| DVec2::new(columns[k], columns[count + k])).collect()
    }

    fn check(from: DVec2, to: DVec2, common: f64, halfway: DVec2) {
        let coefficients = Coefficients::between(&[from, DVec2::X], &[to, DVec2::X], common);
        let found = at(&coefficients, 0.5)[0];
        assert!(found.distance(halfway) < 1e-12, "{from} to {to}: {found} for {halfway}");
        assert!(at(&coefficients, 0.0)[0].distance(from) < 1e-15 && at(&coefficients, 1.0)[0].distance(to) < 1e-15);
    }

    #[test]
    fn an_angle_takes_the_shorter_way_once_the_common_turn_is_out() {
        let polar = |radius: f64, angle: f64| DVec2::from_angle(angle) * radius;
        check(polar(1.0, 0.2), polar(3.0, 1.2), 0.0, polar(2.0, 0.7));
        check(polar(1.0, 3.0), polar(1.0, -3.0), 0.0, polar(1.0, PI));
        check(polar(1.0, 0.0), polar(1.0, -0.5), 2.8, polar(1.0, PI - 0.25));
    }

    #[test]
    fn a_half_turn_is_counterclockwise_whatever_the_sign_of_zero() {
        check(DVec2::new(1.0, 0.0), DVec2::new(-1.0, -0.0), 0.0, DVec2::Y);
        check(DVec2::new(1.0, 0.0), DVec2::new(-1.0, 0.0), 0.0, DVec2::Y);
    }

    #[test]
    fn what_has_no_direction_follows_the_common_turn() {
        check(DVec2::new(0.0, 1e-13), DVec2::new(2.0, 0.0), 1.0, DVec2::from_angle(-0.5));
        check(DVec2::new(2.0, 0.0), DVec2::ZERO, 1.0, DVec2::from_angle(0.5));
        check(DVec2::ZERO, DVec2::ZERO, 1.0, DVec2::ZERO);
    }
}
