//! A binary range coder with adaptive chances: the entropy stage of a link.
//!
//! One description serves both directions: what a [`Coder`] is asked to code it writes from, or reads into, the same place.
//! (Martin, Range encoding, 1979; the carry as in LZMA.) Integers only, so every machine reads the same.

/// The chance of `false`, learned from what has been seen.
#[derive(Clone, Copy, Debug)]
pub struct Bit {
    /// Of 65,536.
    chance: u16,
    seen: u8,
}

/// A chance never comes nearer to certainty, so an unlikely value costs at most 11 bits.
const FLOOR: u16 = 32;

/// Beyond this many sightings a chance follows the recent ones.
const MEMORY: u8 = 120;

impl Default for Bit {
    fn default() -> Self {
        Self { chance: 1 << 15, seen: 0 }
    }
}

impl Bit {
    /// Expected to be `value`, which then costs a twentieth of a bit.
    pub fn likely(value: bool) -> Self {
        let rare = 1 << 11;
        Self { chance: if value { rare } else { u16::MAX - rare }, seen: 8 }
    }

    /// The chance of `false`, of 65,536.
    pub fn chance(self) -> u16 {
        self.chance
    }

    /// How many values it has learned from, up to a limit.
    pub fn seen(self) -> u8 {
        self.seen
    }

    /// Moves toward what was seen: far at first, then by ever less.
    pub fn learn(&mut self, value: bool) {
        let pace = u32::from(self.seen) * 2 + 3;
        let chance = u32::from(self.chance);
        let moved = if value { chance - chance * 2 / pace } else { chance + ((1 << 16) - chance) * 2 / pace };
        self.chance = moved.clamp(u32::from(FLOOR), (1 << 16) - u32::from(FLOOR)) as u16;
        self.seen = (self.seen + 1).min(MEMORY);
    }
}

/// One direction of the link: a writer keeps the value, a reader replaces it.
pub trait Coder {
    /// A bit whose chance of `false` is `chance` of 65,536.
    fn weighted(&mut self, chance: u16, value: &mut bool);

    /// One of `count` equally likely values; 1 ≤ `count` ≤ 65,536.
    fn even(&mut self, count: u32, value: &mut u32);

    /// A bit with its learned chance.
    fn bit(&mut self, model: &mut Bit, value: &mut bool) {
        self.weighted(model.chance(), value);
        model.learn(*value);
    }

    /// Whether values come from the link.
    fn is_reading(&self) -> bool;
}

/// Below this the range takes in another byte.
const RENEW: u32 = 1 << 24;

/// Writes.
pub struct Writer {
    low: u64,
    range: u32,
    // A byte is held back with the run of 0xFF after it until no carry can reach it.
    held: u8,
    run: usize,
    bytes: Vec<u8>,
}

impl Default for Writer {
    fn default() -> Self {
        Self { low: 0, range: u32::MAX, held: 0, run: 1, bytes: Vec::new() }
    }
}

impl Writer {
    /// How many bytes are written so far, those held back included.
    pub fn len(&self) -> usize {
        self.bytes.len() + self.run
    }

    /// The bytes; the fewest that read back, since a reader takes what is missing as zeros.
    pub fn finish(mut self) -> Vec<u8> {
        let last = self.low + u64::from(self.range) - 1;
        let shortest = (0..=32).rev().map(|zeros| (self.low + (1 << zeros) - 1) >> zeros << zeros).find(|value| *value <= last);
        self.low = shortest.expect("the low end itself is in the range");
        for _ in 0..5 {
            self.shift();
        }
        // The first byte is only there to take a carry that never comes.
        self.bytes.remove(0);
        while self.bytes.last() == Some(&0) {
            self.bytes.pop();
        }
        self.bytes
    }

    fn shift(&mut self) {
        if self.low < 0xFF00_0000 || self.low > u64::from(u32::MAX) {
            let carry = (self.low >> 32) as u8;
            self.bytes.push(self.held.wrapping_add(carry));
            self.bytes.extend(std::iter::repeat_n(0xFF_u8.wrapping_add(carry), self.run - 1));
            self.run = 0;
            self.held = (self.low >> 24) as u8;
        }
        self.run += 1;
        self.low = (self.low & 0x00FF_FFFF) << 8;
    }

    fn renew(&mut self) {
        while self.range < RENEW {
            self.range <<= 8;
            self.shift();
        }
    }
}

impl Coder for Writer {
    fn weighted(&mut self, chance: u16, value: &mut bool) {
        let bound = (self.range >> 16) * u32::from(chance);
        if *value {
            self.low += u64::from(bound);
            self.range -= bound;
        } else {
            self.range = bound;
        }
        self.renew();
    }

    fn even(&mut self, count: u32, value: &mut u32) {
        debug_assert!(*value < count && count <= 1 << 16, "the value is one of the count");
        self.range /= count;
        self.low += u64::from(self.range) * u64::from(*value);
        self.renew();
    }

    fn is_reading(&self) -> bool {
        false
    }
}

/// Reads; any bytes whatsoever read as some values.
pub struct Reader<'b> {
    code: u32,
    range: u32,
    bytes: std::slice::Iter<'b, u8>,
}

impl<'b> Reader<'b> {
    /// From what a [`Writer`] finished.
    pub fn new(bytes: &'b [u8]) -> Self {
        let mut reader = Self { code: 0, range: u32::MAX, bytes: bytes.iter() };
        for _ in 0..4 {
            reader.take();
        }
        reader
    }

    fn take(&mut self) {
        self.code = self.code << 8 | u32::from(self.bytes.next().copied().unwrap_or(0));
    }

    fn renew(&mut self) {
        while self.range < RENEW {
            self.range <<= 8;
            self.take();
        }
    }
}

impl Coder for Reader<'_> {
    fn weighted(&mut self, chance: u16, value: &mut bool) {
        let bound = (self.range >> 16) * u32::from(chance);
        *value = self.code >= bound;
        if *value {
            self.code -= bound;
            self.range -= bound;
        } else {
            self.range = bound;
        }
        self.renew();
    }

    fn even(&mut self, count: u32, value: &mut u32) {
        self.range /= count;
        *value = (self.code / self.range).min(count - 1);
        self.code -= *value * self.range;
        self.renew();
    }

    fn is_reading(&self) -> bool {
        true
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn code_all(coder: &mut dyn Coder, flags: &mut [bool], numbers: &mut [(u32, u32)]) {
        let mut model = Bit::likely(false);
        for flag in flags {
            coder.bit(&mut model, flag);
        }
        for (count, value) in numbers {
            coder.even(*count, value);
        }
    }

    proptest! {
        #[test]
        fn what_is_written_is_read(
            flags in proptest::collection::vec(any::<bool>(), 0..200),
            numbers in proptest::collection::vec((1_u32..=1 << 16, any::<u32>()), 0..200),
        ) {
            let numbers: Vec<(u32, u32)> = numbers.into_iter().map(|(count, value)| (count, value % count)).collect();
            let mut writer = Writer::default();
            code_all(&mut writer, &mut flags.clone(), &mut numbers.clone());
            let bytes = writer.finish();
            let mut read_flags = vec![false; flags.len()];
            let mut read_numbers: Vec<(u32, u32)> = numbers.iter().map(|(count, _)| (*count, 0)).collect();
            code_all(&mut Reader::new(&bytes), &mut read_flags, &mut read_numbers);
            prop_assert_eq!(read_flags, flags);
            prop_assert_eq!(read_numbers, numbers);
        }

        #[test]
        fn any_bytes_read_as_something(bytes in proptest::collection::vec(any::<u8>(), 0..40)) {
            let mut numbers: Vec<(u32, u32)> = (1..60).map(|count| (count * 1000, 0)).collect();
            code_all(&mut Reader::new(&bytes), &mut [false; 50], &mut numbers);
            for (count, value) in numbers {
                prop_assert!(value < count);
            }
        }
    }

    #[test]
    fn the_expected_costs_next_to_nothing() {
        let mut writer = Writer::default();
        code_all(&mut writer, &mut [false; 2000], &mut []);
        assert!(writer.finish().len() <= 3);
    }
}
