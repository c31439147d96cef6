//! Which sector of a full turn a direction is in (paper D, equation 14).

use std::f64::consts::TAU;

/// So near before a border a direction is beyond it: along an axis, or halfway between two, rounding would tell agents apart who all
/// head the same way. As [`turn`] counts; rounding is a hundredth of it.
const ON_BORDER: f64 = 1e-10;

/// Of a whole turn.
const WHOLE: f64 = 4.0;

/// K sectors, the first from x toward y.
#[derive(Clone, Debug)]
pub struct Sectors {
    /// Where each but the first begins, by [`turn`].
    borders: Vec<f64>,
}

impl Sectors {
    /// So many; at least one.
    pub fn new(count: u32) -> Self {
        let border = |k: u32| TAU * f64::from(k) / f64::from(count);
        Self { borders: (1..count).map(|k| turn(libm::cos(border(k)), libm::sin(border(k)))).collect() }
    }

    /// How many classes of directions there are: the sectors, and at last rest.
    pub fn class_count(&self) -> u32 {
        self.borders.len() as u32 + 2
    }

    /// The sector of each direction; rest for whoever is slower than `rest`.
    pub fn classes_into(&self, vx: &[f64], vy: &[f64], rest: f64, classes: &mut [u32]) {
        for (class, (vx, vy)) in classes.iter_mut().zip(vx.iter().zip(vy)) {
            let turn = turn(*vx, *vy) + ON_BORDER;
            let turn = if turn < WHOLE { turn } else { turn - WHOLE };
            let sector = self.borders.iter().map(|border| u32::from(turn >= *border)).sum();
            *class = if vx * vx + vy * vy < rest * rest { self.class_count() - 1 } else { sector };
        }
    }
}

/// A number in 0..=[`WHOLE`] that grows with the angle of a direction, a quarter turn by one: no arc is needed to tell directions apart.
fn turn(x: f64, y: f64) -> f64 {
    let share = y.abs() / (x.abs() + y.abs());
    let above = if x < 0.0 { 2.0 - share } else { share };
    if y < 0.0 { 4.0 - above } else { above }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn check(count: u32, directions: &[(f64, f64)], expected: &[u32]) {
        let (vx, vy): (Vec<f64>, Vec<f64>) = directions.iter().copied().unzip();
        let mut classes = vec![99; expected.len()];
        Sectors::new(count).classes_into(&vx, &vy, 1e-3, &mut classes);
        assert_eq!(classes, expected, "{count}");
    }

    #[test]
    fn directions_have_sectors_and_rest_has_its_own() {
        check(4, &[(1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0), (1.0, -1e-9), (-1e-9, 0.0), (0.0, 0.0)], &[0, 1, 2, 3, 3, 4, 4]);
        check(1, &[(-0.3, 0.4), (0.0, 0.0)], &[0, 1]);
    }

    #[test]
    fn rounding_tells_nobody_apart_along_a_border() {
        for k in 0..8_u32 {
            let angle = TAU * f64::from(k) / 8.0;
            let directions: Vec<(f64, f64)> = [-4e-12, 0.0, 4e-12].map(|off| ((angle + off).cos(), (angle + off).sin())).to_vec();
            check(8, &directions, &[k; 3]);
        }
    }

    #[test]
    fn they_are_those_of_the_angle() {
        for count in [2, 3, 7, 8, 64] {
            // In the middle of each third of a sector, far from every border.
            let angles: Vec<f64> = (0..3 * count).map(|k| TAU * (f64::from(k) + 0.5) / f64::from(3 * count)).collect();
            let directions: Vec<(f64, f64)> = angles.iter().map(|angle| (angle.cos(), angle.sin())).collect();
            check(count, &directions, &(0..3 * count).map(|k| k / 3).collect::<Vec<_>>());
        }
    }
}
