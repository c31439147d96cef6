//! Numbers for bins, 0, 1, …, in the order in which they are first met.

/// An open table that is emptied without touching it.
#[derive(Clone, Debug)]
pub struct Slots {
    keys: Vec<i64>,
    numbers: Vec<u32>,
    /// A place is taken where this is the table's.
    rounds: Vec<u32>,
    round: u32,
    count: u32,
}

impl Slots {
    /// For at most so many different keys a round.
    pub fn new(most: usize) -> Self {
        let places = (2 * most).next_power_of_two().max(2);
        Self { keys: vec![0; places], numbers: vec![0; places], rounds: vec![0; places], round: 0, count: 0 }
    }

    /// Forgets all keys.
    pub fn clear(&mut self) {
        if self.round == u32::MAX {
            self.rounds.fill(0);
            self.round = 0;
        }
        self.round += 1;
        self.count = 0;
    }

    /// How many different keys there were since.
    pub fn count(&self) -> usize {
        self.count as usize
    }

    /// The number of a key.
    pub fn number(&mut self, key: i64) -> usize {
        // Keys are neighbors mostly; an odd factor with well mixed upper bits spreads them.
        const SPREAD: u64 = 0x9E37_79B9_7F4A_7C15;
        let mask = self.keys.len() - 1;
        let mut place = (key.cast_unsigned().wrapping_mul(SPREAD) >> 32) as usize & mask;
        while self.rounds[place] == self.round {
            if self.keys[place] == key {
                return self.numbers[place] as usize;
            }
            place = (place + 1) & mask;
        }
        (self.keys[place], self.numbers[place], self.rounds[place]) = (key, self.count, self.round);
        self.count += 1;
        self.count() - 1
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn keys_are_numbered_as_they_come_anew_after_each_clearing() {
        let mut slots = Slots::new(3);
        for keys in [[7, -1, 7], [-1, 8, 7]] {
            slots.clear();
            let numbers = keys.map(|key| slots.number(key));
            assert_eq!((numbers, slots.count()), if keys[0] == 7 { ([0, 1, 0], 2) } else { ([0, 1, 2], 3) });
        }
    }
}
