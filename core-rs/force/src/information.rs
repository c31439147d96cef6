//! How much where agents are tells of what they do: mutual information, in bits (paper D, equations 11–17).
//!
//! It is the plug-in estimate, which few agents in many bins raise: numbers compare only at equal N, R and K.

use crate::slots::{Slots, bin};

/// V: classes of equal width from rest to the top speed of the moment.
pub const SPEED_CLASSES: u32 = 8;

/// Counts agents; its buffers serve every call.
#[derive(Clone, Debug)]
pub struct Information {
    columns: Slots,
    /// By column, then by class.
    joint: Vec<u32>,
    of_column: Vec<u32>,
    of_class: Vec<u32>,
    class_count: usize,
    /// n log₂ n by n.
    terms: Vec<f64>,
}

impl Information {
    /// Of so many agents in at most so many classes.
    pub fn new(agent_count: usize, class_count: u32) -> Self {
        let class_count = class_count as usize;
        Self {
            columns: Slots::new(agent_count),
            joint: vec![0; agent_count * class_count],
            of_column: vec![0; agent_count],
            of_class: vec![0; class_count],
            class_count,
            terms: (0..=agent_count).map(|n| n as f64 * libm::log2(n.max(1) as f64)).collect(),
        }
    }

    /// The mean of I(X, class) and I(Y, class), places in bins of `bin_size` along each axis.
    pub fn of(&mut self, x: &[f64], y: &[f64], classes: &[u32], bin_size: f64) -> f64 {
        0.5 * (self.along(x, classes, bin_size) + self.along(y, classes, bin_size))
    }

    /// Σ p(i, j) log₂ (p(i, j) / p(i) p(j)), by counts.
    fn along(&mut self, places: &[f64], classes: &[u32], bin_size: f64) -> f64 {
        self.columns.clear();
        self.of_class.fill(0);
        for (place, class) in places.iter().zip(classes) {
            let known = self.columns.count();
            let column = self.columns.number(bin(*place, bin_size));
            if column == known {
                self.of_column[column] = 0;
                self.joint[column * self.class_count..(column + 1) * self.class_count].fill(0);
            }
            self.of_column[column] += 1;
            self.of_class[*class as usize] += 1;
            self.joint[column * self.class_count + *class as usize] += 1;
        }
        let count = places.len();
        let sum = |counts: &[u32]| counts.iter().map(|n| self.terms[*n as usize]).sum::<f64>();
        let columns = self.columns.count();
        let bits = sum(&self.joint[..columns * self.class_count]) - sum(&self.of_column[..columns]) - sum(&self.of_class);
        // Round-off may leave a hair below zero.
        ((bits + self.terms[count]) / count.max(1) as f64).max(0.0)
    }
}

/// The sector of each direction, of `sectors`; `sectors` itself for whoever is slower than `rest`.
pub fn directions_into(vx: &[f64], vy: &[f64], sectors: u32, rest: f64, classes: &mut [u32]) {
    for (class, (vx, vy)) in classes.iter_mut().zip(vx.iter().zip(vy)) {
        *class = if vx * vx + vy * vy < rest * rest {
            sectors
        } else {
            let turn = libm::atan2(*vy, *vx) / std::f64::consts::TAU;
            let share = if turn < 0.0 { turn + 1.0 } else { turn };
            ((share * f64::from(sectors)) as u32).min(sectors - 1)
        };
    }
}

/// The class of each speed, of [`SPEED_CLASSES`].
pub fn speeds_into(vx: &[f64], vy: &[f64], classes: &mut [u32]) {
    let square = |agent: usize| vx[agent] * vx[agent] + vy[agent] * vy[agent];
    let top = (0..vx.len()).map(square).fold(0.0, f64::max).sqrt();
    let per_class = if top > 0.0 { f64::from(SPEED_CLASSES) / top } else { 0.0 };
    for (agent, class) in classes.iter_mut().enumerate() {
        *class = ((square(agent).sqrt() * per_class) as u32).min(SPEED_CLASSES - 1);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn check(x: &[f64], classes: &[u32], expected: f64) {
        let y = vec![0.0; x.len()];
        let found = Information::new(x.len(), 4).of(x, &y, classes, 1.0);
        // Half the sum of I(X, class) and of nothing, for all have one y; three sums of a few terms of at most 8.
        assert!((found - expected / 2.0).abs() < 1e-14, "{x:?} {classes:?}: {found}");
    }

    #[test]
    fn it_is_the_bits_that_a_place_tells_of_a_class() {
        check(&[0.5, 1.5, 2.5, 3.5], &[0, 1, 2, 3], 2.0);
        check(&[0.5, 0.5, 1.5, 1.5], &[0, 0, 1, 1], 1.0);
        check(&[0.5, 0.5, 1.5, 1.5], &[0, 1, 0, 1], 0.0);
        check(&[0.5, 0.5, 1.5, -7.5], &[2, 2, 2, 2], 0.0);
        // Three of four tell: H(class) − H(class | place) = 0.8113 − 0.5.
        check(&[0.5, 0.5, 1.5, 1.5], &[0, 0, 0, 1], 0.811_278_124_459_132_8 - 0.5);
        check(&[], &[], 0.0);
    }

    #[test]
    fn directions_have_sectors_and_rest_has_its_own() {
        let (vx, vy) = ([1.0, 0.0, -1.0, 0.0, 1.0, 0.0], [0.0, 1.0, 0.0, -1.0, -1e-9, 0.0]);
        let mut classes = [9; 6];
        directions_into(&vx, &vy, 4, 1e-3, &mut classes);
        assert_eq!(classes, [0, 1, 2, 3, 3, 4]);
        speeds_into(&[4.0, 0.0, 1.9], &[0.0, 2.0, 0.0], &mut classes[..3]);
        assert_eq!(classes[..3], [7, 4, 3]);
    }
}
