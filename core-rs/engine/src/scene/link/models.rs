//! How values are coded: symbols, integers, numbers.

use super::range::{Bit, Coder};

/// One of 2^`bits` values, each with its learned chance.
#[derive(Clone, Debug)]
pub struct Symbol {
    bits: u32,
    nodes: Vec<Bit>,
}

impl Symbol {
    /// Of 2^`bits` values.
    pub fn new(bits: u32) -> Self {
        Self { bits, nodes: vec![Bit::default(); 1 << bits] }
    }

    /// Codes the value, below 2^`bits`.
    pub fn code(&mut self, coder: &mut dyn Coder, value: &mut u32) {
        let mut node = 1;
        for place in (0..self.bits).rev() {
            let mut bit = *value >> place & 1 == 1;
            coder.bit(&mut self.nodes[node], &mut bit);
            node = node * 2 + usize::from(bit);
        }
        *value = (node - (1 << self.bits)) as u32;
    }
}

/// Integers, small ones cheaper: the bit length is learned, then the two bits below the leading one; the rest is even.
#[derive(Clone, Debug)]
pub struct Integer {
    length: Symbol,
    sign: Bit,
    below: Vec<[Bit; 4]>,
}

impl Default for Integer {
    fn default() -> Self {
        Self { length: Symbol::new(6), sign: Bit::default(), below: vec![[Bit::default(); 4]; 64] }
    }
}

impl Integer {
    /// Codes the value, |value| < 2^62.
    pub fn code(&mut self, coder: &mut dyn Coder, value: &mut i64) {
        let mut magnitude = value.unsigned_abs();
        let mut length = u64::BITS - magnitude.leading_zeros();
        self.length.code(coder, &mut length);
        let mut is_negative = *value < 0;
        if length > 0 {
            coder.bit(&mut self.sign, &mut is_negative);
        }
        if length > 1 {
            self.code_below(coder, length, &mut magnitude);
        } else {
            magnitude = u64::from(length);
        }
        *value = if is_negative { -magnitude.cast_signed() } else { magnitude.cast_signed() };
    }

    fn code_below(&mut self, coder: &mut dyn Coder, length: u32, magnitude: &mut u64) {
        let models = &mut self.below[length as usize];
        let mut node = 1;
        let mut read = 1;
        let mut left = length - 1;
        while left > 0 && node < 4 {
            left -= 1;
            let mut bit = *magnitude >> left & 1 == 1;
            coder.bit(&mut models[node], &mut bit);
            node = node * 2 + usize::from(bit);
            read = read * 2 + u64::from(bit);
        }
        let mut rest = *magnitude & ((1 << left) - 1);
        code_even(coder, 1 << left, &mut rest);
        *magnitude = read << left | rest;
    }
}

/// Codes one of `count` equally likely values; 1 ≤ `count` ≤ 2^62.
pub fn code_even(coder: &mut dyn Coder, count: u64, value: &mut u64) {
    const PART: u64 = 1 << 16;
    if count <= PART {
        let mut part = *value as u32;
        coder.even(count as u32, &mut part);
        *value = u64::from(part);
    } else {
        let mut high = *value / PART;
        code_even(coder, count.div_ceil(PART), &mut high);
        let mut low = (*value % PART) as u32;
        coder.even(PART as u32, &mut low);
        *value = high * PART + u64::from(low);
    }
}

/// Doubles, kept to the last bit: decimals of few places are short, all others take their 64 bits.
#[derive(Clone, Debug)]
pub struct Number {
    places: Symbol,
    digits: Integer,
}

/// Not a decimal of few places.
const RAW: u32 = 15;

/// Exact, as literals are; by the number of decimal places.
const POWERS_OF_TEN: [f64; 10] = [1.0, 10.0, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9];

impl Default for Number {
    fn default() -> Self {
        Self { places: Symbol::new(4), digits: Integer::default() }
    }
}

impl Number {
    /// Codes the value.
    pub fn code(&mut self, coder: &mut dyn Coder, value: &mut f64) {
        let (mut places, mut digits) = as_decimal(*value).unwrap_or((RAW, 0));
        self.places.code(coder, &mut places);
        if places == RAW {
            let mut bits = value.to_bits();
            for part in [0, 16, 32, 48] {
                let mut word = (bits >> part & 0xFFFF) as u32;
                coder.even(1 << 16, &mut word);
                bits = bits & !(0xFFFF << part) | u64::from(word) << part;
            }
            *value = f64::from_bits(bits);
        } else {
            self.digits.code(coder, &mut digits);
            *value = digits as f64 / POWERS_OF_TEN.get(places as usize).copied().unwrap_or(f64::NAN);
        }
    }
}

/// `value` = digits / 10^places to the last bit.
fn as_decimal(value: f64) -> Option<(u32, i64)> {
    const EXACT: f64 = 9_007_199_254_740_992.0;
    POWERS_OF_TEN.iter().zip(0..).find_map(|(power, places)| {
        let digits = (value * power).round();
        let is_decimal = digits.abs() <= EXACT && (digits / power).to_bits() == value.to_bits();
        // An integer has no sign at zero, a double has.
        let keeps_sign = digits != 0.0 || value.is_sign_positive();
        (is_decimal && keeps_sign).then_some((places, digits as i64))
    })
}

#[cfg(test)]
mod tests {
    use std::fmt::Debug;

    use proptest::collection::vec;
    use proptest::prelude::*;

    use super::super::range::{Reader, Writer};
    use super::*;

    /// Writes the values and reads them back.
    fn check<T: Clone + Debug + PartialEq>(
        values: &[T],
        blank: &T,
        code: impl Fn(&mut dyn Coder, &mut [T]),
    ) -> Result<usize, TestCaseError> {
        let mut writer = Writer::default();
        code(&mut writer, &mut values.to_vec());
        let bytes = writer.finish();
        let mut found = vec![blank.clone(); values.len()];
        code(&mut Reader::new(&bytes), &mut found);
        prop_assert_eq!(&found, values);
        Ok(bytes.len())
    }

    fn code_integers(coder: &mut dyn Coder, values: &mut [i64]) {
        let mut model = Integer::default();
        for value in values {
            model.code(coder, value);
        }
    }

    fn code_bits_of_numbers(coder: &mut dyn Coder, values: &mut [u64]) {
        let mut model = Number::default();
        for bits in values {
            let mut value = f64::from_bits(*bits);
            model.code(coder, &mut value);
            *bits = value.to_bits();
        }
    }

    proptest! {
        #[test]
        fn integers_come_back(values in vec(prop_oneof![-5_i64..5, -(1_i64 << 62) + 1..1 << 62], 0..100)) {
            check(&values, &0, code_integers)?;
        }

        #[test]
        fn numbers_come_back_to_the_last_bit(values in vec(prop_oneof![any::<f64>(), (-99_999..99_999).prop_map(|cents| f64::from(cents) / 100.0)], 0..100)) {
            let bits: Vec<u64> = values.into_iter().map(f64::to_bits).collect();
            check(&bits, &0, code_bits_of_numbers)?;
        }
    }
}
