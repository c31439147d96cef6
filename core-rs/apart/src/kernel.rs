//! How a push at one knot spreads over time: a smooth bump that leaves both ends where they are.

/// A bump is cut where it falls below this of its peak; the jump is then far below a millimeter.
const CUT: f64 = 2e-4;

/// `K = 2τ (τ⁴/4 · D₂ᵀD₂ + I)⁻¹`, u = 0 at both ends and u' = 0 where clamped; τ in knots. Its diagonal is about 1 far from the ends.
pub struct Kernel {
    time: f64,
    /// A = L D Lᵀ, L unit lower with two subdiagonals.
    diagonal: Vec<f64>,
    first: Vec<f64>,
    second: Vec<f64>,
    columns: Vec<Bump>,
}

/// A column of K without its tails.
#[derive(Clone, Default)]
pub(crate) struct Bump {
    pub(crate) start: usize,
    pub(crate) values: Vec<f64>,
    pub(crate) peak: f64,
}

impl Kernel {
    /// A kernel of time τ for so many knots, its two ends clamped or free.
    ///
    /// # Panics
    /// Below four knots: a bug.
    pub fn new(knot_count: usize, time: f64, is_clamped: [bool; 2]) -> Self {
        assert!(knot_count >= 4, "a bump needs room");
        let count = knot_count - 2;
        let stiffness = 0.25 * (time * time) * (time * time);
        // A clamped end mirrors the path beyond it; a free one has no curvature there.
        let corner = |is_clamped: bool| if is_clamped { 7.0 } else { 5.0 };
        let mut diagonal = vec![6.0; count];
        diagonal[0] = corner(is_clamped[0]);
        diagonal[count - 1] = if count == 1 { diagonal[0] } else { corner(is_clamped[1]) };
        let (mut first, mut second) = (vec![0.0; count], vec![0.0; count]);
        for k in 0..count {
            let two_back = if k >= 2 { stiffness } else { 0.0 };
            let one_back = if k >= 1 { -4.0 * stiffness } else { 0.0 };
            if k >= 2 {
                second[k] = two_back / diagonal[k - 2];
            }
            if k >= 1 {
                let shared = if k >= 2 { second[k] * diagonal[k - 2] * first[k - 1] } else { 0.0 };
                first[k] = (one_back - shared) / diagonal[k - 1];
            }
            let mut pivot = stiffness * diagonal[k] + 1.0;
            if k >= 1 {
                pivot -= first[k] * first[k] * diagonal[k - 1];
            }
            if k >= 2 {
                pivot -= second[k] * second[k] * diagonal[k - 2];
            }
            diagonal[k] = pivot;
        }
        Self { time, diagonal, first, second, columns: vec![Bump::default(); knot_count] }
    }

    /// The bump of a push at an inner knot; found once.
    pub(crate) fn bump(&mut self, knot: usize) -> &Bump {
        if self.columns[knot].values.is_empty() {
            self.columns[knot] = self.column(knot);
        }
        &self.columns[knot]
    }

    /// Smooths values by knot: the least τ⁴/4 |u''|² + |u − values|², zero at both ends and flat where clamped.
    pub fn smooth(&self, values: &mut [f64]) {
        let last = values.len() - 1;
        (values[0], values[last]) = (0.0, 0.0);
        self.solve(&mut values[1..last]);
    }

    /// Divides by `τ⁴/4 · D₂ᵀD₂ + I`.
    fn solve(&self, u: &mut [f64]) {
        let count = self.diagonal.len();
        for k in 1..count {
            let two_back = if k >= 2 { self.second[k] * u[k - 2] } else { 0.0 };
            u[k] -= self.first[k] * u[k - 1] + two_back;
        }
        u.iter_mut().zip(&self.diagonal).for_each(|(u, pivot)| *u /= pivot);
        for k in (0..count).rev() {
            let next = if k + 1 < count { self.first[k + 1] * u[k + 1] } else { 0.0 };
            let after = if k + 2 < count { self.second[k + 2] * u[k + 2] } else { 0.0 };
            u[k] -= next + after;
        }
    }

    fn column(&self, knot: usize) -> Bump {
        let at = knot - 1;
        let mut u = vec![0.0; self.diagonal.len()];
        u[at] = 2.0 * self.time;
        self.solve(&mut u);
        let peak = u[at];
        let least = CUT * u.iter().fold(0.0_f64, |greatest, u| greatest.max(u.abs()));
        let start = u.iter().position(|u| u.abs() > least).unwrap_or(at);
        let end = u.iter().rposition(|u| u.abs() > least).unwrap_or(at) + 1;
        Bump { start: start + 1, values: u[start..end].to_vec(), peak }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn whole(kernel: &mut Kernel, knot: usize, knot_count: usize) -> Vec<f64> {
        let bump = kernel.bump(knot);
        let mut column = vec![0.0; knot_count];
        column[bump.start..bump.start + bump.values.len()].copy_from_slice(&bump.values);
        column
    }

    #[test]
    fn a_bump_solves_its_equation_up_to_the_tails_cut_off() {
        for (knot_count, time, clamped) in
            [(40, 3.0, [false, false]), (40, 3.0, [true, true]), (12, 2.0, [false, true]), (4, 1.5, [true, false])]
        {
            let stiffness = 0.25 * time * time * time * time;
            let mut kernel = Kernel::new(knot_count, time, clamped);
            for knot in 1..knot_count - 1 {
                let u = whole(&mut kernel, knot, knot_count);
                let last = knot_count - 1;
                // Second differences at every knot; at an end a clamped path is mirrored, a free one is straight.
                let bend = |k: usize| {
                    if k == 0 {
                        if clamped[0] { 2.0 * u[1] } else { 0.0 }
                    } else if k == last {
                        if clamped[1] { 2.0 * u[last - 1] } else { 0.0 }
                    } else {
                        u[k - 1] - 2.0 * u[k] + u[k + 1]
                    }
                };
                for (k, here) in u.iter().enumerate().take(last).skip(1) {
                    let fourth = bend(k - 1) - 2.0 * bend(k) + bend(k + 1);
                    let expected = if k == knot { 2.0 * time } else { 0.0 };
                    let residual = stiffness * fourth + here - expected;
                    // Sixteen tails of CUT, as stiff as the equation.
                    assert!(residual.abs() < 16.0 * CUT * stiffness.max(1.0), "{knot_count} {clamped:?} {knot} {k}: {residual}");
                }
            }
        }
    }

    #[test]
    fn far_from_the_ends_a_bump_peaks_at_one() {
        let peak = Kernel::new(200, 8.0, [false, false]).bump(100).peak;
        assert!((peak - 1.0).abs() < 0.01, "{peak}");
    }

    #[test]
    fn a_clamped_bump_leaves_its_end_flat() {
        let [free, clamped] = [false, true].map(|is_clamped| whole(&mut Kernel::new(60, 6.0, [is_clamped, false]), 6, 60));
        assert_eq!([free[0], clamped[0]], [0.0, 0.0]);
        // A flat start rises with the square of the way from it.
        assert!(free[1] > 0.4 * free[2] && clamped[1] < 0.35 * clamped[2], "{free:?} {clamped:?}");
    }
}
