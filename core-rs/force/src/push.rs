//! How hard agents push each other at a distance (paper D, equations 10 and 22).
//!
//! Four at a time, in single precision: a push is known to six digits, and the same on every machine.

use wide::f32x4;

use crate::exponential::exp_of_four;

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

    /// Four pushes over the distances of the centers, by which the ways between them are to be multiplied. Bodies that together are by
    /// `girth` larger than usual are that much nearer.
    #[inline]
    pub fn per_way(&self, apart: f32x4, girth: f32x4) -> f32x4 {
        let Self { strength, per_reach, end, rest, .. } = *self;
        let distance = (apart - girth).fast_max(f32x4::splat(NEAREST));
        let fallen = exp_of_four(distance * f32x4::splat(-per_reach));
        let push = (f32x4::splat(strength) * fallen - f32x4::splat(rest) * distance) / (distance * apart);
        distance.simd_lt(f32x4::splat(end)).select(push, f32x4::ZERO)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn it_is_the_formula_less_its_end() {
        let push = Push::new(5.0, 0.3, 6.0);
        let formula = |d: f64| 5.0 * (-d / 0.3).exp() / d;
        let one = |apart: f32, girth: f32| push.per_way(f32x4::splat(apart), f32x4::splat(girth)).to_array()[0];
        for k in 1..=180 {
            let (distance, apart) = (0.01 * f64::from(k), 0.01 * f64::from(k) + 0.2);
            let expected = (formula(distance.max(f64::from(NEAREST))) - formula(1.8)).max(0.0) / apart;
            let found = f64::from(one(apart as f32, 0.2));
            // The exponential's error, that of a distance of two times as many lengths, and a few round-offs, of at most 36.
            assert!((found - expected).abs() < 36.0 * 3e-6 / apart, "{distance}: {found} {expected}");
        }
        assert_eq!([1.81, 7.0].map(|far| one(far, 0.0)), [0.0; 2]);
    }
}
