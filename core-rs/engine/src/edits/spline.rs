//! Cubic splines through values at rising times, flat or free at their ends.

/// What all splines through the same times share.
#[derive(Clone, Debug)]
pub(super) struct Spline {
    times: Vec<f64>,
    /// The eliminated tridiagonal system of the second derivatives.
    upper: Vec<f64>,
    pivot: Vec<f64>,
    is_clamped: [bool; 2],
}

/// Where an instant lies: after which time, and what the values and second derivatives there and at the next count.
#[derive(Clone, Copy, Debug)]
pub(super) struct Weights {
    at: usize,
    values: [f64; 2],
    bends: [f64; 2],
}

impl Spline {
    /// `is_clamped`: zero velocity at the first and the last time; else no curvature there.
    ///
    /// # Panics
    /// Below two times: a bug.
    pub(super) fn new(times: Vec<f64>, is_clamped: [bool; 2]) -> Self {
        assert!(times.len() >= 2, "a spline has two ends");
        let count = times.len();
        let (mut upper, mut pivot) = (vec![0.0; count], vec![1.0; count]);
        for k in 0..count {
            let [below, diagonal, above] = row(&times, is_clamped, k);
            pivot[k] = if k == 0 { diagonal } else { diagonal - below * upper[k - 1] };
            upper[k] = above / pivot[k];
        }
        Self { times, upper, pivot, is_clamped }
    }

    /// The second derivative at each time of the spline through `values`.
    pub(super) fn bends_into(&self, values: &[f64], out: &mut [f64]) {
        let count = self.times.len();
        let slope = |k: usize| (values[k + 1] - values[k]) / (self.times[k + 1] - self.times[k]);
        for k in 0..count {
            let before = if k > 0 { slope(k - 1) } else { 0.0 };
            let after = if k + 1 < count { slope(k) } else { 0.0 };
            let is_free_end = (k == 0 && !self.is_clamped[0]) || (k + 1 == count && !self.is_clamped[1]);
            let right = if is_free_end { 0.0 } else { after - before };
            let [below, ..] = row(&self.times, self.is_clamped, k);
            let known = if k == 0 { 0.0 } else { below * out[k - 1] };
            out[k] = (right - known) / self.pivot[k];
        }
        for k in (0..count - 1).rev() {
            out[k] -= self.upper[k] * out[k + 1];
        }
    }

    /// Where `time` lies; beyond the ends, at them.
    pub(super) fn weights(&self, time: f64) -> Weights {
        let at = self.times.partition_point(|known| *known <= time).clamp(1, self.times.len() - 1) - 1;
        let step = self.times[at + 1] - self.times[at];
        let b = ((time - self.times[at]) / step).clamp(0.0, 1.0);
        let a = 1.0 - b;
        let bend = |w: f64| (w * w * w - w) * step * step / 6.0;
        Weights { at, values: [a, b], bends: [bend(a), bend(b)] }
    }
}

impl Weights {
    /// The spline's value, from values and second derivatives by time.
    pub(super) fn of(self, values: &[f64], bends: &[f64]) -> f64 {
        let next = self.at + 1;
        self.values[0] * values[self.at] + self.values[1] * values[next] + self.bends[0] * bends[self.at] + self.bends[1] * bends[next]
    }
}

/// Row k of the system: what the second derivatives before, at and after k count.
fn row(times: &[f64], is_clamped: [bool; 2], k: usize) -> [f64; 3] {
    let count = times.len();
    if (k == 0 && !is_clamped[0]) || (k + 1 == count && !is_clamped[1]) {
        return [0.0, 1.0, 0.0];
    }
    let before = if k > 0 { times[k] - times[k - 1] } else { 0.0 };
    let after = if k + 1 < count { times[k + 1] - times[k] } else { 0.0 };
    [before / 6.0, (before + after) / 3.0, after / 6.0]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn check(is_clamped: [bool; 2], curve: impl Fn(f64) -> f64) {
        let times = vec![0.0, 0.3, 1.0, 1.1, 2.0];
        let values: Vec<f64> = times.iter().map(|t| curve(*t)).collect();
        let spline = Spline::new(times, is_clamped);
        let mut bends = vec![0.0; 5];
        spline.bends_into(&values, &mut bends);
        for k in 0..=40 {
            let t = f64::from(k) * 0.05;
            let found = spline.weights(t).of(&values, &bends);
            assert!((found - curve(t)).abs() < 1e-13, "{is_clamped:?} at {t}: {found}");
        }
    }

    #[test]
    fn a_cubic_with_the_right_ends_is_its_own_spline() {
        check([false, false], |t| 3.0 - 2.0 * t);
        // u' = 0 at both ends, at 0, at 2.
        check([true, true], |t| t * t * (3.0 - t));
        check([true, false], |t| t * t * (6.0 - t));
        check([false, true], |t| t * t * t - 12.0 * t);
    }
}
