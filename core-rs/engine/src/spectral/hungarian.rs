//! The pairing with the greatest sum of squared inner products.

use faer::MatRef;

/// `targets[source]`, exact, in O(n³).
pub(super) fn hungarian(likeness: MatRef<'_, f64>) -> Vec<usize> {
    let size = likeness.nrows();
    let cost = |row: usize, column: usize| -snapped(likeness[(row, column)]);
    // Shortest augmenting paths over one-based columns; column 0 holds the row being placed.
    let mut row_of = vec![0; size + 1];
    let (mut u, mut v) = (vec![0.0; size + 1], vec![0.0; size + 1]);
    for row in 1..=size {
        row_of[0] = row;
        let mut column = 0;
        let mut least = vec![f64::INFINITY; size + 1];
        let mut from = vec![0; size + 1];
        let mut done = vec![false; size + 1];
        while row_of[column] != 0 {
            done[column] = true;
            let (own, mut step, mut next) = (row_of[column], f64::INFINITY, 0);
            for other in 1..=size {
                if !done[other] {
                    let reduced = cost(own - 1, other - 1) - u[own] - v[other];
                    if reduced < least[other] {
                        (least[other], from[other]) = (reduced, column);
                    }
                    if least[other] < step {
                        (step, next) = (least[other], other);
                    }
                }
            }
            for other in 0..=size {
                if done[other] {
                    u[row_of[other]] += step;
                    v[other] -= step;
                } else {
                    least[other] -= step;
                }
            }
            column = next;
        }
        while column != 0 {
            row_of[column] = row_of[from[column]];
            column = from[column];
        }
    }
    let mut targets = vec![0; size];
    for column in 1..=size {
        targets[row_of[column] - 1] = column - 1;
    }
    targets
}

/// The square, rounded to 2⁻⁴⁰ so that what symmetry makes equal is equal and sums are exact.
fn snapped(likeness: f64) -> f64 {
    let unit = (1_u64 << 40) as f64;
    (likeness * likeness * unit).round() / unit
}
