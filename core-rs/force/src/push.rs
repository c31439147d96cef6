//! How hard agents push each other at a distance (paper D, equations 10 and 22).
//!
//! In single precision, of which twice as many go side by side: a push is known to six digits, and the same on every machine.

use crate::exponential::exp_single;

/// 1/d is taken no nearer than this: one step must not throw anybody.
const NEAREST: f32 = 0.1;

/// A e^{−d/B}/d, zero from `range` on.
#[derive(Clone, Copy, Debug)]
pub struct Push {
    /// Where it ends.
    pub range: f64,
    strength: f32,
    per_reach: f32,
    end: f32,
    /// What is taken off throughout, so that it ends at zero.
    rest: f32,
}

impl Push {
    /// Of strength A and reach B, ending after so many reaches.
    pub fn new(strength: f64, reach: f64, reaches: f64) -> Self {
        let range = reaches * reach;
        let rest = strength * libm::exp(-reaches) / range;
        Self { range, strength: strength as f32, per_reach: (1.0 / reach) as f32, end: range as f32, rest: rest as f32 }
    }

    /// The push over the distance of the centers, by which the way between them is to be multiplied. Bodies that together are by `girth`
    /// larger than usual are that much nearer.
    #[inline]
    pub fn per_way(&self, apart: f32, girth: f32) -> f32 {
        let distance = apart - girth;
        let distance = if distance > NEAREST { distance } else { NEAREST };
        let push = (self.strength * exp_single(-distance * self.per_reach) - self.rest * distance) / (distance * apart);
        if distance < self.end { push } else { 0.0 }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn it_is_the_formula_less_its_end() {
        let push = Push::new(5.0, 0.3, 6.0);
        let formula = |d: f64| 5.0 * (-d / 0.3).exp() / d;
        for k in 1..=180 {
            let (distance, apart) = (0.01 * f64::from(k), 0.01 * f64::from(k) + 0.2);
            let expected = (formula(distance.max(f64::from(NEAREST))) - formula(1.8)).max(0.0) / apart;
            let found = f64::from(push.per_way(apart as f32, 0.2));
            // The exponential's error, that of a distance of two times as many lengths, and a few round-offs, of at most 36.
            assert!((found - expected).abs() < 36.0 * 3e-6 / apart, "{distance}: {found} {expected}");
        }
        assert_eq!([1.81, 7.0].map(|far| push.per_way(far, 0.0)), [0.0; 2]);
    }
}
