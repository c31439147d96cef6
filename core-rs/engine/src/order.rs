//! The sort of everything that is put in order once a formation, a scene or a segment.
//!
//! A library sort is 6 kB of code for every type it is used with, and a visitor loads each of them. Here what decides is one number,
//! so one sort serves all: byte by byte from the lowest, which needs no comparison and keeps the order of equals.

pub(crate) use eigenform_apart::sort_by_bytes;

/// Indices 0, 1, … by ascending key; those of equal keys in their order.
pub(crate) fn by_key(keys: impl Iterator<Item = u128>) -> Vec<u32> {
    indices(keys.zip(0..).collect())
}

/// Puts items in the order of their keys; items of equal keys keep theirs.
pub(crate) fn sort_by_key<T: Copy>(items: &mut [T], key: impl Fn(&T) -> u128) {
    let before = items.to_vec();
    for (item, from) in items.iter_mut().zip(by_key(before.iter().map(key))) {
        *item = before[from as usize];
    }
}

/// A key by two numbers, the first before the second.
pub(crate) fn key_of_two(first: u64, second: u64) -> u128 {
    u128::from(first) << 64 | u128::from(second)
}

/// A key by a pair of indices.
pub(crate) fn key_of_pair((a, b): (u32, u32)) -> u128 {
    u128::from(u64::from(a) << 32 | u64::from(b))
}

/// A number that orders as the real does, −0 before 0.
pub(crate) fn of_real(value: f64) -> u64 {
    let bits = value.to_bits();
    if bits >> 63 == 1 { !bits } else { bits | 1 << 63 }
}

/// A number that orders as the integer does.
pub(crate) fn of_integer(value: i64) -> u64 {
    value.cast_unsigned() ^ 1 << 63
}

fn indices(mut keyed: Vec<(u128, u32)>) -> Vec<u32> {
    sort_by_bytes(&mut keyed, &mut Vec::new(), 0..size_of::<u128>(), |(key, _), place| key.to_le_bytes()[place]);
    keyed.into_iter().map(|(_, index)| index).collect()
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    proptest! {
        #[test]
        fn the_order_is_that_of_a_stable_sort(items in prop::collection::vec((any::<f64>(), -3_i64..3), 0..50)) {
            let mut sorted = items.clone();
            sort_by_key(&mut sorted, |item| key_of_two(of_integer(item.1), of_real(item.0)));
            let mut expected = items.clone();
            expected.sort_by(|p, q| p.1.cmp(&q.1).then(p.0.total_cmp(&q.0)));
            let bits = |items: &[(f64, i64)]| items.iter().map(|item| (item.0.to_bits(), item.1)).collect::<Vec<_>>();
            prop_assert_eq!(bits(&sorted), bits(&expected));
            let order = by_key(items.iter().map(|item| u128::from(of_integer(item.1))));
            prop_assert!(order.is_sorted_by_key(|&index| (items[index as usize].1, index)));
        }
    }
}
