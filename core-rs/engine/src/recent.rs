//! A small cache that forgets the least recently used.

use std::sync::Arc;

/// A shared value compared by identity: an immutable object is its own cache key, and the key keeps it alive.
#[derive(Debug)]
pub(crate) struct Same<Value>(pub(crate) Arc<Value>);

impl<Value> Clone for Same<Value> {
    fn clone(&self) -> Self {
        Self(self.0.clone())
    }
}

impl<Value> PartialEq for Same<Value> {
    fn eq(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.0, &other.0)
    }
}

/// Values by key, at most so many bytes of them; the newest stays whatever its size.
#[derive(Debug)]
pub(crate) struct Recent<Key, Value> {
    entries: Vec<(Key, Value, usize)>,
    byte_limit: usize,
}

impl<Key: PartialEq, Value: Clone> Recent<Key, Value> {
    pub(crate) fn new(byte_limit: usize) -> Self {
        Self { entries: Vec::new(), byte_limit }
    }

    /// The value of an equal key, which becomes the most recent.
    pub(crate) fn get(&mut self, key: &Key) -> Option<Value> {
        let place = self.entries.iter().rposition(|(known, _, _)| known == key)?;
        let entry = self.entries.remove(place);
        let value = entry.1.clone();
        self.entries.push(entry);
        Some(value)
    }

    /// Keeps a value of about `bytes` bytes and forgets what no longer fits.
    pub(crate) fn put(&mut self, key: Key, value: Value, bytes: usize) {
        self.add(key, value, bytes);
        self.trim();
    }

    /// Keeps a value of about `bytes` bytes and forgets nothing yet: for work that still needs all it has.
    pub(crate) fn add(&mut self, key: Key, value: Value, bytes: usize) {
        self.entries.push((key, value, bytes));
    }

    /// Forgets what no longer fits.
    pub(crate) fn trim(&mut self) {
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
    fn what_is_added_stays_until_the_trim() {
        let mut recent = Recent::new(1);
        recent.add('a', 1, 1);
        recent.add('b', 2, 1);
        assert_eq!([recent.get(&'a'), recent.get(&'b')], [Some(1), Some(2)]);
        recent.trim();
        assert_eq!([recent.get(&'a'), recent.get(&'b')], [None, Some(2)]);
    }

    #[test]
    fn the_newest_stays_even_when_it_is_too_large() {
        let mut recent = Recent::new(2);
        recent.put('a', 1, 1);
        recent.put('b', 2, 5);
        assert_eq!([recent.get(&'a'), recent.get(&'b')], [None, Some(2)]);
    }
}
