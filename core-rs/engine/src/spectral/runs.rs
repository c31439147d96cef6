//! Runs of values too near one another to be told apart.

use std::ops::Range;

/// Splits ascending values into runs: within a run each value is at most `gap` above the one before it.
pub(super) fn runs(values: &[f64], gap: f64) -> Vec<Range<usize>> {
    let mut found = Vec::new();
    let mut start = 0;
    for end in 1..=values.len() {
        if end == values.len() || values[end] - values[end - 1] > gap {
            found.push(start..end);
            start = end;
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::runs;

    #[test]
    fn a_run_ends_where_the_gap_is_wider() {
        assert_eq!(runs(&[0.0, 0.5, 1.0, 3.0, 4.5, 5.0], 0.5), [0..3, 3..4, 4..6]);
        assert_eq!(runs(&[], 1.0), []);
        assert_eq!(runs(&[2.0, 2.0, 3.0], 0.0), [0..2, 2..3]);
    }
}
