//! How the parameter t of a segment runs with time.

use glam::DVec2;

use crate::choice::Timing;

/// Pieces of equal t in which a path is measured: a chord of 1/128 of a half turn is short by 3e-5.
const PIECES: usize = 128;

/// From fractions of a segment's time to t.
#[derive(Clone, Debug)]
pub(super) enum Clock {
    /// t is the fraction.
    Linear,
    /// It eases where the agents stop, at the start and at the end, and runs at the pace of time where they pass.
    Eased([bool; 2]),
    /// t runs so that the formation's RMS speed is the same throughout the segment. Where agents pass a keyframe their direction stays,
    /// but the speed may jump: that of each segment follows from its way and its time.
    Even(Odometer),
}

impl Clock {
    /// The clock of a timing; none where only the path can tell, see [`Clock::even`].
    pub(super) fn of(timing: Timing, stops: [bool; 2]) -> Option<Self> {
        match timing {
            Timing::Linear => Some(Self::Linear),
            Timing::Smooth => Some(Self::Eased(stops)),
            Timing::Even => None,
        }
    }

    /// The clock of equal speed along a path (paper A, section 5.3), known at [`path_parameters`]. Its speed is the root of the agents'
    /// mean squared speed, so that nobody's detour counts alone. Where nobody moves t is the fraction.
    pub(super) fn even(agent_count: usize, positions: &[DVec2], heights: Option<&[f64]>) -> Self {
        let mut squares: Vec<f64> = squared_ways(agent_count, positions, DVec2::distance_squared);
        if let Some(heights) = heights {
            let rises = squared_ways(agent_count, heights, |from, to| (to - from).powi(2));
            squares.iter_mut().zip(rises).for_each(|(square, rise)| *square += rise);
        }
        let ways: Vec<f64> = squares.into_iter().map(f64::sqrt).collect();
        Odometer::new(&ways).map_or(Self::Linear, Self::Even)
    }

    /// t at a fraction 0–1 of the segment's time; 0 at 0 and 1 at 1, never falling.
    pub(super) fn parameter(&self, fraction: f64) -> f64 {
        let (f, f2) = (fraction, fraction * fraction);
        match self {
            Self::Linear | Self::Eased([false, false]) => f,
            Self::Eased([true, true]) => f2 * (3.0 - 2.0 * f),
            Self::Eased([true, false]) => f2 * (2.0 - f),
            Self::Eased([false, true]) => f + f2 * (1.0 - f),
            Self::Even(odometer) => odometer.parameter(f),
        }
    }
}

/// From sample to sample, the sum over the agents of their squared ways.
fn squared_ways<P: Copy>(agent_count: usize, places: &[P], square: impl Fn(P, P) -> f64) -> Vec<f64> {
    let samples: Vec<&[P]> = places.chunks_exact(agent_count.max(1)).collect();
    samples.windows(2).map(|pair| pair[0].iter().zip(pair[1]).map(|(from, to)| square(*from, *to)).sum()).collect()
}

/// The t at which an even clock wants to know the path.
pub(super) fn path_parameters() -> Vec<f64> {
    (0..=PIECES).map(|piece| piece as f64 / PIECES as f64).collect()
}

/// The share of a path that lies behind, over t: a rising cubic in each of equal pieces.
#[derive(Clone, Debug)]
pub(super) struct Odometer {
    shares: Vec<f64>,
    slopes: Vec<f64>,
}

impl Odometer {
    /// From the ways of equal pieces of t; none where there is no way.
    fn new(ways: &[f64]) -> Option<Self> {
        let total: f64 = ways.iter().sum();
        // Round-off of standing still is no path.
        if total.is_nan() || total <= f64::MIN_POSITIVE {
            return None;
        }
        let mut shares = vec![0.0];
        let mut behind = 0.0;
        shares.extend(ways.iter().map(|way| {
            behind += way;
            (behind / total).min(1.0)
        }));
        // The harmonic mean of the rises on both sides keeps a cubic from falling (Fritsch and Butland).
        let rises: Vec<f64> = shares.windows(2).map(|pair| pair[1] - pair[0]).collect();
        let edge = |own: f64, next: f64| (1.5 * own - 0.5 * next).clamp(0.0, 3.0 * own);
        let inner = rises.windows(2).map(|pair| if pair[0] * pair[1] > 0.0 { 2.0 * pair[0] * pair[1] / (pair[0] + pair[1]) } else { 0.0 });
        let count = rises.len();
        let slopes = std::iter::once(edge(rises[0], rises[1]))
            .chain(inner)
            .chain(std::iter::once(edge(rises[count - 1], rises[count - 2])))
            .collect();
        Some(Self { shares, slopes })
    }

    /// The t at which `share` of the path lies behind.
    fn parameter(&self, share: f64) -> f64 {
        let count = self.slopes.len() - 1;
        if share >= 1.0 {
            return 1.0;
        }
        let piece = self.shares.partition_point(|known| *known <= share).saturating_sub(1).min(count - 1);
        let (mut low, mut high) = (0.0, 1.0);
        // Halving to the last bit; a cubic that never falls has one answer.
        for _ in 0..53 {
            let middle = f64::midpoint(low, high);
            if self.share_within(piece, middle) <= share { low = middle } else { high = middle }
        }
        (piece as f64 + low) / count as f64
    }

    fn share_within(&self, piece: usize, u: f64) -> f64 {
        let v = 1.0 - u;
        let (from, to) = (self.shares[piece], self.shares[piece + 1]);
        v * v * ((1.0 + 2.0 * u) * from + u * self.slopes[piece]) + u * u * ((1.0 + 2.0 * v) * to - v * self.slopes[piece + 1])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn slope(clock: &Clock, fraction: f64) -> f64 {
        let step = 1e-6;
        let (low, high) = ((fraction - step).max(0.0), (fraction + step).min(1.0));
        (clock.parameter(high) - clock.parameter(low)) / (high - low)
    }

    #[test]
    fn t_stands_where_the_agents_stop_and_runs_with_time_where_they_pass() {
        for stops in [[true, true], [true, false], [false, true], [false, false]] {
            let clock = Clock::Eased(stops);
            assert_eq!((clock.parameter(0.0), clock.parameter(1.0)), (0.0, 1.0));
            for (end, is_stop) in [0.0, 1.0].into_iter().zip(stops) {
                // The step of the difference quotient times a second derivative of at most 6.
                assert!((slope(&clock, end) - if is_stop { 0.0 } else { 1.0 }).abs() < 1e-5, "{stops:?} at {end}");
            }
        }
    }

    #[test]
    fn an_even_clock_covers_equal_ways_in_equal_times() {
        // Two agents on circles of one radius: the speed is that of the angle, 2t.
        let place = |t: f64| [DVec2::from_angle(2.0 * t * t), 5.0 + DVec2::from_angle(1.0 - 2.0 * t * t)];
        let positions: Vec<DVec2> = path_parameters().into_iter().flat_map(place).collect();
        let clock = Clock::even(2, &positions, None);
        for fraction in [0.0_f64, 0.1, 0.37, 0.5, 0.9, 1.0] {
            // The cubic in a piece of 1/128, with slopes good to its square.
            assert!((clock.parameter(fraction) - fraction.sqrt()).abs() < 2e-4, "{fraction}: {}", clock.parameter(fraction));
        }
        assert_eq!((clock.parameter(0.0), clock.parameter(1.0)), (0.0, 1.0));
    }

    #[test]
    fn an_even_clock_never_runs_backwards_and_leaps_over_a_rest() {
        let place = |t: f64| [DVec2::new((t - 0.3).min(0.0) + (t - 0.6).max(0.0), 0.0)];
        let positions: Vec<DVec2> = path_parameters().into_iter().flat_map(place).collect();
        let clock = Clock::even(1, &positions, None);
        let ts: Vec<f64> = (0..=1000).map(|k| clock.parameter(f64::from(k) / 1000.0)).collect();
        assert!(ts.is_sorted());
        assert!((clock.parameter(0.5) - 0.65).abs() < 0.01, "{}", clock.parameter(0.5));
    }

    #[test]
    fn who_stands_still_has_a_clock() {
        assert!((Clock::even(3, &vec![DVec2::ONE; 3 * (PIECES + 1)], None).parameter(0.4) - 0.4).abs() < 1e-15);
        assert!((Clock::even(0, &[], None).parameter(0.4) - 0.4).abs() < 1e-15);
    }
}
