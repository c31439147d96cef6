//! e^x with the same last bit on every machine, one and four at a time.
//!
//! x is so many ln 2 and a rest: the whole ones go into the exponent's bits, a series gives the rest, interpolated at the Chebyshev
//! nodes of |r| ≤ ½ ln 2.

use std::{f32, f64};

use wide::f32x4;

/// Added and taken off again it rounds to a whole number, which the sum's lowest bits then hold: 1.5 · 2⁵².
const ROUNDER: f64 = 6_755_399_441_055_744.0;

/// ln 2 with so many zeros at its end that whole multiples are exact, and what is left of it (fdlibm).
const LN_2: [f64; 2] = [6.931_471_803_691_238e-1, 1.908_214_929_270_587_7e-10];

/// (e^r − 1)/r, lowest power first.
const SERIES: [f64; 7] = [
    1.0,
    0.500_000_004_711_778_6,
    0.166_666_667_189_975_4,
    0.041_666_352_896_649_515,
    0.008_333_298_483_740_934,
    0.001_394_110_844_443_401_3,
    0.000_198_992_739_702_660_23,
];

/// Below this e^x counts as zero: its exponent would have no bits left.
const LEAST: f64 = -700.0;

/// Relative error below 1.2e-10, exactly 1 at 0. From 700 on: nonsense.
#[inline]
pub fn exp(x: f64) -> f64 {
    let shifted = x * f64::consts::LOG2_E + ROUNDER;
    let whole = shifted - ROUNDER;
    let r = x - whole * LN_2[0] - whole * LN_2[1];
    let series = SERIES.iter().rev().fold(0.0, |sum, term| sum * r + term);
    let value = 1.0 + r * series;
    let scaled = f64::from_bits(value.to_bits().wrapping_add(shifted.to_bits() << 52));
    if x > LEAST { scaled } else { 0.0 }
}

/// The same of single precision: 1.5 · 2²³.
const ROUNDER_SINGLE: f32 = 12_582_912.0;

/// As [`LN_2`].
const LN_2_SINGLE: [f32; 2] = [0.693_359_4, -2.121_944_4e-4];

/// As [`SERIES`].
const SERIES_SINGLE: [f32; 6] = [1.0, 0.5, 0.166_665_05, 0.041_666_465, 0.008_369_149, 0.001_393_364];

/// Four in single precision, of x in −80..=0, with a relative error below 2e-7; elsewhere nonsense.
#[inline]
pub fn exp_of_four(x: f32x4) -> f32x4 {
    let [rounder, log_2_e, high, low] = [ROUNDER_SINGLE, f32::consts::LOG2_E, LN_2_SINGLE[0], LN_2_SINGLE[1]].map(f32x4::splat);
    let shifted = x * log_2_e + rounder;
    let whole = shifted - rounder;
    let r = x - whole * high - whole * low;
    let series = SERIES_SINGLE.iter().rev().fold(f32x4::ZERO, |sum, term| sum * r + f32x4::splat(*term));
    let value = f32x4::ONE + r * series;
    f32x4::from_bits(value.to_bits() + (shifted.to_bits() << 23))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn it_is_as_near_as_it_says() {
        for k in -140_000..=140_000 {
            let x = f64::from(k) / 200.0;
            let (found, expected) = (exp(x), x.exp());
            let error = if x > LEAST { (found / expected - 1.0).abs() } else { found };
            assert!(error < 1.2e-10, "e^{x}: {error}");
        }
        assert_eq!([0.0, -1e4, f64::NEG_INFINITY].map(exp), [1.0, 0.0, 0.0]);
    }

    #[test]
    fn so_are_four_in_single_precision() {
        for k in 0..40_000_u16 {
            let x = [0.0, 0.25, 0.5, 0.75].map(|part| (f32::from(k) + part) / -500.0);
            let found = exp_of_four(f32x4::new(x)).to_array();
            let errors = x.iter().zip(found).map(|(x, found)| (f64::from(found) / f64::from(*x).exp() - 1.0).abs());
            assert!(errors.fold(0.0, f64::max) < 2e-7, "e^{x:?}: {found:?}");
        }
        assert_eq!(exp_of_four(f32x4::ZERO), f32x4::ONE);
    }
}
