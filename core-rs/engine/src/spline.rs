//! Cubic splines through values at rising times: flat, free or as parabolas at their ends.

/// What all splines through the same times share.
#[derive(Clone, Debug)]
pub(crate) struct Spline {
    times: Vec<f64>,
    /// The eliminated tridiagonal system of the second derivatives.
    upper: Vec<f64>,
    pivot: Vec<f64>,
    ends: [Ending; 2],
}

/// How a spline begins or ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Ending {
    /// With zero velocity.
    Clamped,
    /// Without curvature.
    Free,
    /// As a parabola: the second derivative is that at the next time.
    Parabola,
}

/// Where an instant lies: after which time, and what the values and second derivatives there and at the next count.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Weights {
    at: usize,
    values: [f64; 2],
    bends: [f64; 2],
    step: f64,
}

impl Spline {
    /// `is_clamped`: zero velocity at the first and the last time; else no curvature there.
    ///
    /// # Panics
    /// Below two times: a bug.
    pub(crate) fn new(times: Vec<f64>, is_clamped: [bool; 2]) -> Self {
        Self::with(times, is_clamped.map(|is_clamped| if is_clamped { Ending::Clamped } else { Ending::Free }))
    }

    /// Parabolas at both ends; straight through two times alone.
    ///
    /// # Panics
    /// Below two times: a bug.
    pub(crate) fn parabolic(times: Vec<f64>) -> Self {
        let ending = if times.len() == 2 { Ending::Free } else { Ending::Parabola };
        Self::with(times, [ending; 2])
    }

    fn with(times: Vec<f64>, ends: [Ending; 2]) -> Self {
        assert!(times.len() >= 2, "a spline has two ends");
        let count = times.len();
        let (mut upper, mut pivot) = (vec![0.0; count], vec![1.0; count]);
        for k in 0..count {
            let [below, diagonal, above] = row(&times, ends, k);
            pivot[k] = if k == 0 { diagonal } else { diagonal - below * upper[k - 1] };
            upper[k] = above / pivot[k];
        }
        Self { times, upper, pivot, ends }
    }

    /// The second derivative at each time of the spline through `values`.
    pub(crate) fn bends_into(&self, values: &[f64], out: &mut [f64]) {
        let count = self.times.len();
        let slope = |k: usize| (values[k + 1] - values[k]) / (self.times[k + 1] - self.times[k]);
        for k in 0..count {
            let before = if k > 0 { slope(k - 1) } else { 0.0 };
            let after = if k + 1 < count { slope(k) } else { 0.0 };
            let is_clamped = ending(self.ends, count, k).is_none_or(|ending| ending == Ending::Clamped);
            let right = if is_clamped { after - before } else { 0.0 };
            let [below, ..] = row(&self.times, self.ends, k);
            let known = if k == 0 { 0.0 } else { below * out[k - 1] };
            out[k] = (right - known) / self.pivot[k];
        }
        for k in (0..count - 1).rev() {
            out[k] -= self.upper[k] * out[k + 1];
        }
    }

    /// Where `time` lies; beyond the ends, at them.
    pub(crate) fn weights(&self, time: f64) -> Weights {
        let at = self.times.partition_point(|known| *known <= time).clamp(1, self.times.len() - 1) - 1;
        let step = self.times[at + 1] - self.times[at];
        let b = ((time - self.times[at]) / step).clamp(0.0, 1.0);
        let a = 1.0 - b;
        let bend = |w: f64| (w * w * w - w) * step * step / 6.0;
        Weights { at, values: [a, b], bends: [bend(a), bend(b)], step }
    }
}

impl Weights {
    /// The spline's value, from values and second derivatives by time.
    pub(crate) fn of(self, values: &[f64], bends: &[f64]) -> f64 {
        let next = self.at + 1;
        self.values[0] * values[self.at] + self.values[1] * values[next] + self.bends[0] * bends[self.at] + self.bends[1] * bends[next]
    }

    /// The spline's slope there.
    pub(crate) fn slope(self, values: &[f64], bends: &[f64]) -> f64 {
        let next = self.at + 1;
        let bend = |w: f64| (3.0 * w * w - 1.0) * self.step / 6.0;
        (values[next] - values[self.at]) / self.step - bend(self.values[0]) * bends[self.at] + bend(self.values[1]) * bends[next]
    }
}

/// Row k of the system: what the second derivatives before, at and after k count.
fn row(times: &[f64], ends: [Ending; 2], k: usize) -> [f64; 3] {
    let count = times.len();
    match ending(ends, count, k) {
        Some(Ending::Free) => return [0.0, 1.0, 0.0],
        Some(Ending::Parabola) => return if k == 0 { [0.0, 1.0, -1.0] } else { [-1.0, 1.0, 0.0] },
        Some(Ending::Clamped) | None => {}
    }
    let before = if k > 0 { times[k] - times[k - 1] } else { 0.0 };
    let after = if k + 1 < count { times[k + 1] - times[k] } else { 0.0 };
    [before / 6.0, (before + after) / 3.0, after / 6.0]
}

/// How the spline is at a time; none within.
fn ending(ends: [Ending; 2], count: usize, k: usize) -> Option<Ending> {
    match k {
        0 => Some(ends[0]),
        _ if k + 1 == count => Some(ends[1]),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const TIMES: [f64; 5] = [0.0, 0.3, 1.0, 1.1, 2.0];

    fn check(is_clamped: [bool; 2], curve: impl Fn(f64) -> f64, slope: impl Fn(f64) -> f64) {
        check_spline(&Spline::new(TIMES.to_vec(), is_clamped), curve, slope);
    }

    fn check_spline(spline: &Spline, curve: impl Fn(f64) -> f64, slope: impl Fn(f64) -> f64) {
        let values: Vec<f64> = TIMES.iter().map(|t| curve(*t)).collect();
        let mut bends = vec![0.0; 5];
        spline.bends_into(&values, &mut bends);
        for k in 0..=40 {
            let t = f64::from(k) * 0.05;
            let weights = spline.weights(t);
            let (found, rising) = (weights.of(&values, &bends), weights.slope(&values, &bends));
            assert!((found - curve(t)).abs() < 1e-13, "{:?} at {t}: {found}", spline.ends);
            // A difference over steps of at least 0.1 is good to a tenth as many digits.
            assert!((rising - slope(t)).abs() < 1e-12, "{:?} at {t}: {rising}", spline.ends);
        }
    }

    #[test]
    fn a_cubic_with_the_right_ends_is_its_own_spline() {
        check([false, false], |t| 3.0 - 2.0 * t, |_| -2.0);
        // u' = 0 at both ends, at 0, at 2.
        check([true, true], |t| t * t * (3.0 - t), |t| 3.0 * t * (2.0 - t));
        check([true, false], |t| t * t * (6.0 - t), |t| 3.0 * t * (4.0 - t));
        check([false, true], |t| t * t * t - 12.0 * t, |t| 3.0 * t * t - 12.0);
        check_spline(&Spline::parabolic(TIMES.to_vec()), |t| t * (3.0 - t), |t| 3.0 - 2.0 * t);
    }
}
