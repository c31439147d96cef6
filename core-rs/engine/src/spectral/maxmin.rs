//! Exchanges that raise the worse of two pairs (paper A, end of section 4.2).

use faer::MatRef;

/// Inner products nearer than this count as equal; the lower index is taken then, so that round-off decides nothing.
pub(super) const EQUAL_LIKENESS: f64 = 1e-12;

/// Exchanges the targets of the two sources whose worse |inner product| gains most, until none gains or n² are done.
///
/// The best partner of every source is kept, so that an exchange costs O(n) and not O(n²) unless it was many sources' best.
pub(super) fn exchange(likeness: MatRef<'_, f64>, mut targets: Vec<usize>) -> Vec<usize> {
    let size = targets.len();
    let gain = |targets: &[usize], a: usize, b: usize| {
        let now = likeness[(a, targets[a])].abs().min(likeness[(b, targets[b])].abs());
        let then = likeness[(a, targets[b])].abs().min(likeness[(b, targets[a])].abs());
        then - now
    };
    let best_of = |targets: &[usize], a: usize| {
        (a + 1..size)
            .map(|b| (gain(targets, a, b), b))
            .fold((f64::NEG_INFINITY, size), |best, next| if next.0 > best.0 { next } else { best })
    };
    let mut best: Vec<(f64, usize)> = (0..size).map(|a| best_of(&targets, a)).collect();
    for _ in 0..size * size {
        let most = best.iter().map(|(gain, _)| *gain).fold(f64::NEG_INFINITY, f64::max);
        if most <= EQUAL_LIKENESS {
            break;
        }
        // Among equal gains the lowest indices, so that round-off decides nothing.
        let a = best.iter().position(|(gain, _)| *gain >= most - EQUAL_LIKENESS).expect("the most is one of them");
        let b = (a + 1..size).find(|b| gain(&targets, a, *b) >= most - EQUAL_LIKENESS).expect("the best of a is one of them");
        targets.swap(a, b);
        for (source, best) in best.iter_mut().enumerate() {
            if [source, best.1].iter().any(|changed| *changed == a || *changed == b) {
                *best = best_of(&targets, source);
                continue;
            }
            for changed in [a, b] {
                if changed > source && gain(&targets, source, changed) > best.0 {
                    *best = (gain(&targets, source, changed), changed);
                }
            }
        }
    }
    targets
}

#[cfg(test)]
mod tests {
    use faer::Mat;

    use super::*;

    fn by_the_book(likeness: MatRef<'_, f64>, mut targets: Vec<usize>) -> Vec<usize> {
        let size = targets.len();
        loop {
            let mut best = (EQUAL_LIKENESS, 0, 0);
            for a in 0..size {
                for b in a + 1..size {
                    let now = likeness[(a, targets[a])].abs().min(likeness[(b, targets[b])].abs());
                    let then = likeness[(a, targets[b])].abs().min(likeness[(b, targets[a])].abs());
                    if then - now > best.0 {
                        best = (then - now, a, b);
                    }
                }
            }
            if best.1 == best.2 {
                return targets;
            }
            targets.swap(best.1, best.2);
        }
    }

    #[test]
    fn the_shortcut_takes_the_exchanges_of_the_plain_search() {
        let mut state = 7_u64;
        let mut next = || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (state >> 11) as f64 / (1_u64 << 53) as f64 - 0.5
        };
        for size in [0, 1, 2, 3, 9, 30] {
            let likeness = Mat::from_fn(size, size, |_, _| next());
            let start: Vec<usize> = (0..size).collect();
            assert_eq!(exchange(likeness.as_ref(), start.clone()), by_the_book(likeness.as_ref(), start));
        }
    }
}
