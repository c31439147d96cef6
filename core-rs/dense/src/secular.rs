//! The eigenvalues of a diagonal matrix to which a rank-one matrix is added.

/// Sums of so many terms are kept apart, so that they become vector instructions.
const LANES: usize = 4;

/// Steps toward one root; four are usual.
const STEPS: usize = 200;

/// A root, as an offset from the pole nearest to it: what is left when poles are subtracted keeps its digits.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Root {
    /// The pole's number.
    pub(crate) pole: usize,
    pub(crate) offset: f64,
}

/// Root `at` of 1 + Σ wᵢ/(dᵢ − λ), which lies between pole `at` and the next, or beyond the last.
///
/// `poles` rise; `weights` are above 0. Both sides' sums are replaced by what one pole makes of their value and slope (Bunch, Nielsen
/// and Sorensen 1978): quadratic convergence, and every step stays between the poles.
pub(crate) fn root(poles: &[f64], weights: &[f64], at: usize) -> Root {
    let is_last = at + 1 == poles.len();
    let width = if is_last { weights.iter().sum() } else { poles[at + 1] - poles[at] };
    let middle = 0.5 * width;
    let halfway = Sums::at(poles, weights, at, at, middle);
    let is_right = !is_last && halfway.value() < 0.0;
    let pole = if is_right { at + 1 } else { at };
    // The sign changes between these, from below 0 to above.
    let mut bounds = match (is_right, halfway.value() < 0.0) {
        (true, _) => [-middle, 0.0],
        (false, true) => [middle, width],
        (false, false) => [0.0, middle],
    };
    let mut offset = match (is_last, is_right) {
        (true, _) => bounds[1],
        (false, true) => -near_pole(weights[at + 1], weights[at], width, -halfway.without(poles, weights, at, middle)),
        (false, false) => near_pole(weights[at], weights[at + 1], width, halfway.without(poles, weights, at, middle)),
    };
    for _ in 0..STEPS {
        if !(offset > bounds[0] && offset < bounds[1]) {
            offset = f64::midpoint(bounds[0], bounds[1]);
        }
        let sums = Sums::at(poles, weights, at, pole, offset);
        let value = sums.value();
        // What round-off leaves of the sums, and what the last digit of the offset does to them.
        if value.abs() <= f64::EPSILON * (8.0 * sums.size() + offset.abs() * sums.slope()) {
            break;
        }
        bounds[usize::from(value > 0.0)] = offset;
        let distance = |pole_at: usize| (poles[pole_at] - poles[pole]) - offset;
        let step = if is_last { sums.step_beyond(distance(at)) } else { sums.step_between(distance(at), distance(at + 1)) };
        let next = offset + step;
        if next == offset || bounds[1] - bounds[0] <= f64::EPSILON * offset.abs() {
            break;
        }
        offset = next;
    }
    Root { pole, offset }
}

/// Where c + w/(0 − x) + v/(width − x) is 0, x in 0..width.
fn near_pole(w: f64, v: f64, width: f64, c: f64) -> f64 {
    let (a, b) = (c * width + w + v, w * width);
    let root = (a * a - 4.0 * b * c).abs().sqrt();
    if a > 0.0 { 2.0 * b / (a + root) } else { (a - root) / (2.0 * c) }
}

/// The sums over the poles up to one, and over those after it: values and slopes.
struct Sums {
    left: [f64; 2],
    right: [f64; 2],
}

impl Sums {
    /// At an offset from pole `from`; poles up to number `at` are on the left.
    fn at(poles: &[f64], weights: &[f64], at: usize, from: usize, offset: f64) -> Self {
        let side = |range: std::ops::Range<usize>| sums(&poles[range.clone()], &weights[range], poles[from], offset);
        Self { left: side(0..at + 1), right: side(at + 1..poles.len()) }
    }

    fn value(&self) -> f64 {
        1.0 + self.left[0] + self.right[0]
    }

    fn slope(&self) -> f64 {
        self.left[1] + self.right[1]
    }

    /// Of what cancels in the value.
    fn size(&self) -> f64 {
        1.0 + self.left[0].abs() + self.right[0].abs()
    }

    /// The value without both poles beside the middle of their gap.
    fn without(&self, poles: &[f64], weights: &[f64], at: usize, middle: f64) -> f64 {
        let next = (poles[at + 1] - poles[at]) - middle;
        self.value() + weights[at] / middle - weights[at + 1] / next
    }

    /// The step to the root between poles at these distances.
    fn step_between(&self, left: f64, right: f64) -> f64 {
        let value = self.value();
        let c = value - left * self.left[1] - right * self.right[1];
        let a = (left + right) * value - left * right * self.slope();
        let b = left * right * value;
        let root = (a * a - 4.0 * b * c).abs().sqrt();
        if a > 0.0 { 2.0 * b / (a + root) } else { (a - root) / (2.0 * c) }
    }

    /// The step to the root beyond the last pole, at this distance.
    fn step_beyond(&self, last: f64) -> f64 {
        let c = self.value() - last * self.left[1];
        last + self.left[1] * last * last / c
    }
}

/// Σ w/(d − λ) and its slope.
fn sums(poles: &[f64], weights: &[f64], origin: f64, offset: f64) -> [f64; 2] {
    let (mut values, mut slopes) = ([0.0; LANES], [0.0; LANES]);
    let (poles, last_poles) = poles.as_chunks::<LANES>();
    let (weights, last_weights) = weights.as_chunks::<LANES>();
    for (poles, weights) in poles.iter().zip(weights) {
        for lane in 0..LANES {
            let inverse = 1.0 / ((poles[lane] - origin) - offset);
            let value = weights[lane] * inverse;
            values[lane] += value;
            slopes[lane] += value * inverse;
        }
    }
    for (pole, weight) in last_poles.iter().zip(last_weights) {
        let inverse = 1.0 / ((pole - origin) - offset);
        values[0] += weight * inverse;
        slopes[0] += weight * inverse * inverse;
    }
    [values.iter().sum(), slopes.iter().sum()]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tests::numbers;

    fn check(name: &str, poles: &[f64], weights: &[f64]) {
        for at in 0..poles.len() {
            let Root { pole, offset } = root(poles, weights, at);
            assert!(pole == at || pole == at + 1, "{name}");
            let beyond = if at + 1 == poles.len() { poles[at] + weights.iter().sum::<f64>() } else { poles[at + 1] };
            let found = poles[pole] + offset;
            assert!((poles[at]..=beyond).contains(&found) && offset != 0.0, "{name}: {found} of {}..{beyond}", poles[at]);
            // The sign changes within a few units of the last digit, or of round-off.
            let value = |offset: f64| poles.iter().zip(weights).map(|(d, w)| w / ((d - poles[pole]) - offset)).sum::<f64>() + 1.0;
            let size = poles.iter().zip(weights).map(|(d, w)| (w / ((d - poles[pole]) - offset)).abs()).sum::<f64>() + 1.0;
            let error = 8.0 * f64::EPSILON * poles.len().max(8) as f64;
            let nudge = 8.0 * f64::EPSILON * offset.abs();
            assert!(value(offset - nudge) <= error * size && value(offset + nudge) >= -error * size, "{name} at {at}: {offset:e}");
        }
    }

    #[test]
    fn the_sign_changes_at_the_roots() {
        let mut next = numbers();
        for size in [1_u8, 2, 3, 4, 7, 60, 251] {
            let each = |f: &dyn Fn(f64) -> f64| (0..size).map(|k| f(f64::from(k))).collect::<Vec<f64>>();
            let even = each(&|k| k / f64::from(size));
            let random: Vec<f64> = (0..size).map(|_| next() + 0.6).collect();
            check("random weights", &even, &random);
            check("faint", &even, &random.iter().map(|w| 1e-15 * w).collect::<Vec<_>>());
            check("fainter in turn", &even, &each(&|k| 10_f64.powf(-(k % 17.0))));
            check("nearer and nearer", &each(&|k| (k / 90.0).floor() - 0.7_f64.powf(k % 90.0)), &random);
            check("pairs", &each(&|k| (k / 2.0).floor() + 1e-14 * (k % 2.0) * (k + 1.0)), &random);
        }
    }
}
