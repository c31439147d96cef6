//! Sorting byte by byte, without comparisons.

use std::ops::Range;

/// Puts items in the order of some bytes of theirs, the last of them first; items that agree in all keep theirs. O(n) a byte.
pub fn sort_by_bytes<T: Copy>(items: &mut Vec<T>, spare: &mut Vec<T>, places: Range<usize>, byte: impl Fn(&T, usize) -> u8) {
    for place in places {
        let mut ends = [0_u32; 256];
        for item in items.iter() {
            ends[usize::from(byte(item, place))] += 1;
        }
        if ends.contains(&(items.len() as u32)) {
            continue;
        }
        let mut start = 0;
        for end in &mut ends {
            let count = std::mem::replace(end, start);
            start += count;
        }
        spare.clone_from(items);
        for item in items.iter() {
            let next = &mut ends[usize::from(byte(item, place))];
            spare[*next as usize] = *item;
            *next += 1;
        }
        std::mem::swap(items, spare);
    }
}
