//! A small cache that forgets the least recently used.

/// Values by key, at most so many bytes of them; the newest stays whatever its size.
#[derive(Debug)]
pub(super) struct Recent<Key, Value> {
    entries: Vec<(Key, Value, usize)>,
    byte_limit: usize,
}

impl<Key: PartialEq, Value: Clone> Recent<Key, Value> {
    pub(super) fn new(byte_limit: usize) -> Self {
        Self { entries: Vec::new(), byte_limit }
    }

    /// The value of an equal key, which becomes the most recent.
    pub(super) fn get(&mut self, key: &Key) -> Option<Value> {
        let place = self.entries.iter().rposition(|(known, _, _)| known == key)?;
        let entry = self.entries.remove(place);
        let value = entry.1.clone();
        self.entries.push(entry);
        Some(value)
    }

    /// Keeps a value of about `bytes` bytes and forgets what no longer fits.
    pub(super) fn put(&mut self, key: Key, value: Value, bytes: usize) {
        self.entries.push((key, value, bytes));
        let mut total: usize = self.entries.iter().map(|entry| entry.2).sum();
        while total > self.byte_limit && self.entries.len() > 1 {
            total -= self.entries.remove(0).2;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_least_recently_used_is_forgotten_first() {
        let mut recent = Recent::new(2);
        recent.put('a', 1, 1);
        recent.put('b', 2, 1);
        assert_eq!(recent.get(&'a'), Some(1));
        recent.put('c', 3, 1);
        assert_eq!([recent.get(&'a'), recent.get(&'b'), recent.get(&'c')], [Some(1), None, Some(3)]);
    }

    #[test]
    fn the_newest_stays_even_when_it_is_too_large() {
        let mut recent = Recent::new(2);
        recent.put('a', 1, 1);
        recent.put('b', 2, 5);
        assert_eq!([recent.get(&'a'), recent.get(&'b')], [None, Some(2)]);
    }
}
