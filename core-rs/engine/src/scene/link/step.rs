//! The grid that a link's coordinates are integers of.

use glam::DVec3;

use super::models::{Integer, Symbol};
use super::range::Coder;
use crate::error::Error;
use crate::order;
use crate::scene::limits::COORDINATE;

/// A coordinate is an integer times this length.
///
/// Values are quotients of integers, so that 0.01 · k is the double nearest to the decimal.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Step {
    /// 1.143 / 2^halvings m: four marching steps to ten yards, and their halves.
    Field { halvings: i32 },
    /// 1 / parts m.
    Part { parts: i32 },
    /// 2^exponent m.
    Binary { exponent: i32 },
    /// mantissa · 2^exponent m, 64 ≤ mantissa < 128: within 1.6 % of any length.
    Rounded { mantissa: i32, exponent: i32 },
}

/// A step represents a coordinate that it comes this near to, meters.
const TOLERANCE: f64 = 1e-6;

/// Rounded coordinates span at most this many steps: 12 bits.
pub const ROUNDED_SPAN: i64 = 4095;

/// No coordinate of a valid scene is further out than 10⁵ m: 2^36 of the finest steps.
const FARTHEST: i64 = 1 << 40;

/// The catalog ends where a step represents every coordinate, half of 2⁻¹⁹ m being less than the tolerance.
const FINEST_EXPONENT: i32 = -19;

impl Step {
    /// Every step of the catalog, coarsest first.
    pub fn catalog() -> Vec<Self> {
        let field = (0..20).map(|halvings| Self::Field { halvings });
        let parts = [10, 20, 50, 100].map(|parts| Self::Part { parts });
        let binary = (FINEST_EXPONENT..=16).map(|exponent| Self::Binary { exponent });
        let mut all: Vec<Self> = field.chain(parts).chain(binary).collect();
        coarsest_first(&mut all);
        all
    }

    /// The finest step of twelve bits over a box, or none for a point.
    pub fn rounded(low: DVec3, high: DVec3) -> Option<Self> {
        let extent = (high - low).max_element();
        let ideal = extent / ROUNDED_SPAN as f64;
        // Twelve bits finer than the finest of the catalog are never asked for.
        if ideal < power_of_two(FINEST_EXPONENT - 1) {
            return None;
        }
        let mut exponent = exponent_of(ideal) - 6;
        let mut mantissa = (ideal / power_of_two(exponent)).floor() as i32 - 1;
        loop {
            if mantissa >= 128 {
                (mantissa, exponent) = (64, exponent + 1);
            }
            let step = Self::Rounded { mantissa, exponent };
            if mantissa >= 64 && step.span(low, high) <= ROUNDED_SPAN {
                return Some(step);
            }
            mantissa += 1;
        }
    }

    /// The next coarser of the rounded steps.
    pub fn coarser(self) -> Self {
        match self {
            Self::Rounded { mantissa: 127, exponent } => Self::Rounded { mantissa: 64, exponent: exponent + 1 },
            Self::Rounded { mantissa, exponent } => Self::Rounded { mantissa: mantissa + 1, exponent },
            other => other,
        }
    }

    /// Its length, meters.
    pub fn meters(self) -> f64 {
        self.value(1)
    }

    /// A step of the catalog that stands for all that this one does and is at most `longest` meters; a rounded one stays.
    pub fn at_most(self, longest: f64) -> Self {
        let mut step = self;
        while step.meters() > longest {
            step = match step {
                Self::Field { halvings } => Self::Field { halvings: halvings + 1 },
                Self::Part { parts } if parts < 100 => Self::Part { parts: 100 },
                // Quarters of a meter are whole centimeters, which a person reads more easily than halvings.
                Self::Binary { exponent: -2.. } => Self::Part { parts: 100 },
                Self::Binary { exponent } => Self::Binary { exponent: exponent - 1 },
                Self::Part { .. } | Self::Rounded { .. } => return step,
            };
        }
        step
    }

    /// The coordinate `index` steps from the origin, meters.
    pub fn value(self, index: i64) -> f64 {
        let index = index as f64;
        match self {
            Self::Field { halvings } => index * 1143.0 / 1000.0 * power_of_two(-halvings),
            Self::Part { parts } => index / f64::from(parts),
            Self::Binary { exponent } => index * power_of_two(exponent),
            Self::Rounded { mantissa, exponent } => index * f64::from(mantissa) * power_of_two(exponent),
        }
    }

    /// The step nearest to a coordinate, of those within the limit of coordinates.
    pub fn index(self, coordinate: f64) -> i64 {
        let nearest = (coordinate / self.meters()).round() as i64;
        if COORDINATE.contains(&self.value(nearest)) { nearest } else { nearest - nearest.signum() }
    }

    /// How many steps the longest side of a box takes.
    pub fn span(self, low: DVec3, high: DVec3) -> i64 {
        let side = |low, high| self.index(high) - self.index(low);
        side(low.x, high.x).max(side(low.y, high.y)).max(side(low.z, high.z))
    }

    /// Whether it stands for the coordinate.
    ///
    /// A rounded step must meet it to the last bit: it is no round length, so anything else is chance.
    pub fn represents(self, coordinate: f64) -> bool {
        let nearest = self.value(self.index(coordinate));
        match self {
            Self::Rounded { .. } => (nearest - coordinate).abs() <= 0.0,
            _ => (nearest - coordinate).abs() <= TOLERANCE,
        }
    }

    /// Codes the step.
    pub fn code(&mut self, coder: &mut dyn Coder) -> Result<(), Error> {
        let catalog = Self::catalog();
        let mut at = catalog.iter().position(|step| step == self).unwrap_or(catalog.len()) as u32;
        Symbol::new(6).code(coder, &mut at);
        if let Some(step) = catalog.get(at as usize) {
            *self = *step;
            return Ok(());
        }
        let (mut mantissa, mut exponent) = match *self {
            Self::Rounded { mantissa, exponent } => (mantissa as u32 - 64, i64::from(exponent)),
            _ => (0, 0),
        };
        Symbol::new(6).code(coder, &mut mantissa);
        Integer::default().code(coder, &mut exponent);
        if !(-64..=64).contains(&exponent) {
            return Err(Error::LinkDamaged);
        }
        *self = Self::Rounded { mantissa: mantissa.cast_signed() + 64, exponent: exponent as i32 };
        Ok(())
    }
}

/// Puts steps in order, those of equal length in theirs.
pub fn coarsest_first(steps: &mut [Step]) {
    order::sort_by_key(steps, |step| u128::from(order::of_real(-step.meters())));
}

/// Whether a reader may take the index for a coordinate.
pub fn is_near(index: i64) -> bool {
    index.abs() <= FARTHEST
}

/// By its bits: a power function may differ between machines. For normal doubles only.
fn power_of_two(exponent: i32) -> f64 {
    f64::from_bits(u64::from((exponent + 1023).cast_unsigned()) << 52)
}

/// The largest e with 2^e ≤ x, for normal x.
fn exponent_of(x: f64) -> i32 {
    (x.to_bits() >> 52 & 0x7FF) as i32 - 1023
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn decimals_come_back_to_the_last_bit() {
        for parts in [1, 2, 4, 10, 20, 50, 100] {
            let step = if parts <= 4 { Step::Binary { exponent: -(parts / 2) } } else { Step::Part { parts } };
            for index in -20_000_i64..20_000 {
                let decimal: f64 = format!("{:.2}", index as f64 / f64::from(parts)).parse().unwrap();
                assert_eq!(step.value(step.index(decimal)).to_bits() << 1, decimal.to_bits() << 1);
            }
        }
    }

    #[test]
    fn a_finer_step_stands_for_all_that_its_own_does() {
        for step in Step::catalog() {
            let fine = step.at_most(0.01);
            assert!(fine.meters() <= 0.01, "{step:?}");
            let coordinates = (-500..500).map(|index| step.value(index)).filter(|coordinate| COORDINATE.contains(coordinate));
            assert!(coordinates.into_iter().all(|coordinate| fine.represents(coordinate)), "{step:?}");
        }
    }

    #[test]
    fn the_catalog_descends_and_its_end_represents_everything() {
        let catalog = Step::catalog();
        assert!(catalog.is_sorted_by(|a, b| a.meters() > b.meters()));
        assert!(catalog.len() < 64, "an index of six bits");
        let last = catalog[catalog.len() - 1];
        for coordinate in [0.123_456_789, 99_999.999_999_9, -3.0e-7, 1.0 / 3.0] {
            assert!(last.represents(coordinate));
        }
    }

    #[test]
    fn a_rounded_step_spans_twelve_bits_and_wastes_few_of_them() {
        for extent in [0.01, 0.9, 1.0, 63.999, 64.0, 100.0, 131.0, 99_999.0] {
            let (low, high) = (DVec3::new(-0.3 * extent, 0.0, 0.0), DVec3::new(0.7 * extent, 0.1 * extent, 0.0));
            let span = Step::rounded(low, high).unwrap().span(low, high);
            // One step in 64 is the widest gap between neighbors; the ends may round inward by one step.
            assert!((4030..=ROUNDED_SPAN).contains(&span), "{extent} m spans {span}");
        }
    }
}
