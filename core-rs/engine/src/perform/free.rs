//! Free arrival: everybody walks their own way at one pace and is there when they are (paper D's times, tables 2 and 3).
//!
//! For comparison only: the keyframes of a scene have times.

use glam::DVec3;

use crate::motion::{Motion, sample_times};
use crate::scene::limits;

/// Round-off of a time, seconds.
const SAME_INSTANT: f64 = 1e-9;

/// How long those are waited for who are led aside, as a multiple of the longest walk's time.
const PATIENCE: f64 = 3.0;

/// Agents × samples of such a motion, at most: beyond that samples are farther apart.
const MOST_PLACES: f64 = 5e6;

/// What is walked at one pace, and how much of their ways agents have behind them at its samples, 0–1 on average.
pub(super) struct Freed {
    pub(super) motion: Motion,
    pub(super) ts: Vec<f64>,
}

/// A guide's ways, each walked evenly at `pace` meters a second or the agent's own top speed, until all are there; longer, as long as
/// they may have to be waited for, where forces lead them aside.
pub(super) fn freed(guide: &Motion, pace: f64, top_speeds: &[f64], frame_rate: f64, is_led: bool) -> Freed {
    let start = guide.times()[0];
    let mut walks: Vec<Walk> =
        top_speeds.iter().enumerate().map(|(agent, top_speed)| Walk::new(guide, agent, pace.min(*top_speed))).collect();
    let longest = walks.iter().map(Walk::seconds).fold(1.0 / frame_rate, f64::max).min(*limits::TIME.end());
    let seconds = if is_led { longest * PATIENCE } else { longest };
    let frame_rate = frame_rate.min(MOST_PLACES / (seconds * walks.len() as f64)).max(1.0 / seconds);
    let times = sample_times(start, start + seconds, frame_rate);
    let (mut plan, mut heights) = (Vec::new(), guide.heights().map(|_| Vec::new()));
    let mut ts = Vec::new();
    for time in &times {
        let mut behind = 0.0;
        for walk in &mut walks {
            let (place, share) = walk.at(guide, time - start);
            plan.push(place.truncate());
            if let Some(heights) = &mut heights {
                heights.push(place.z);
            }
            behind += share;
        }
        ts.push(behind / walks.len().max(1) as f64);
    }
    Freed { motion: Motion::sampled(times, walks.len(), plan, heights), ts }
}

/// One agent's way, walked at one speed; times ascend.
struct Walk {
    agent: usize,
    speed: f64,
    /// Meters walked at each sample of the guide.
    walked: Vec<f64>,
    /// The guide's piece that was walked on last.
    piece: usize,
}

impl Walk {
    fn new(guide: &Motion, agent: usize, speed: f64) -> Self {
        let mut walked = vec![0.0];
        for k in 1..guide.times().len() {
            walked.push(walked[k - 1] + guide.places(k - 1).at(agent).distance(guide.places(k).at(agent)));
        }
        Self { agent, speed, walked, piece: 0 }
    }

    fn length(&self) -> f64 {
        self.walked[self.walked.len() - 1]
    }

    fn seconds(&self) -> f64 {
        self.length() / self.speed
    }

    /// Where the agent is after so many seconds, and the share of the way that is behind.
    fn at(&mut self, guide: &Motion, seconds: f64) -> (DVec3, f64) {
        let last = self.walked.len() - 1;
        if seconds >= self.seconds() - SAME_INSTANT {
            return (guide.places(last).at(self.agent), 1.0);
        }
        let walked = seconds * self.speed;
        while self.walked[self.piece + 1] <= walked {
            self.piece += 1;
        }
        let (from, to) = (self.walked[self.piece], self.walked[self.piece + 1]);
        let [start, end] = [self.piece, self.piece + 1].map(|k| guide.places(k).at(self.agent));
        (start.lerp(end, (walked - from) / (to - from)), walked / self.length())
    }
}

#[cfg(test)]
mod tests {
    use glam::DVec2;

    use super::*;

    /// One walks 6 m around a corner, easing; one walks 2 m; one stays.
    fn guide() -> Motion {
        let eased = |t: f64| t * t * (3.0 - 2.0 * t);
        let corner = |s: f64| if s < 0.5 { DVec2::new(6.0 * s, 0.0) } else { DVec2::new(3.0, 6.0 * s - 3.0) };
        let times: Vec<f64> = (0..=40).map(|k| 1.0 + f64::from(k) / 10.0).collect();
        let places = (0..=40).flat_map(|k| {
            let s = eased(f64::from(k) / 40.0);
            [corner(s), DVec2::new(-2.0 * s, 5.0), DVec2::splat(9.0)]
        });
        Motion::new(times, 3, places.collect())
    }

    #[test]
    fn everybody_walks_their_way_at_one_pace_and_the_longest_says_when_it_is_over() {
        let Freed { motion, ts } = freed(&guide(), 1.5, &[f64::INFINITY; 3], 10.0, false);
        let times = motion.times();
        // 6 m at 1.5 m/s.
        assert!((times[times.len() - 1] - 5.0).abs() < 1e-9 && times[0] == 1.0);
        for k in 1..times.len() {
            let step = motion.sample(k)[0].distance(motion.sample(k - 1)[0]);
            // A chord across the corner is shorter by the most of √2.
            assert!(step <= 1.5 * (times[k] - times[k - 1]) + 1e-9 && step >= 1.0 * (times[k] - times[k - 1]), "{step} at {k}");
        }
        let second = times.iter().position(|time| *time >= 1.0 + 2.0 / 1.5).expect("it is over later");
        assert_eq!(motion.sample(second)[1], DVec2::new(-2.0, 5.0));
        assert!(ts.is_sorted() && ts[0] == 1.0 / 3.0 && ts[ts.len() - 1] == 1.0);
    }

    #[test]
    fn the_slow_take_longer_and_those_led_aside_are_waited_for() {
        let slow = [f64::INFINITY, 0.25, f64::INFINITY];
        let end = |is_led: bool| {
            let Freed { motion, .. } = freed(&guide(), 1.5, &slow, 10.0, is_led);
            motion.times()[motion.times().len() - 1] - 1.0
        };
        assert!((end(false) - 8.0).abs() < 1e-9 && (end(true) - 24.0).abs() < 1e-9);
    }

    #[test]
    fn where_nobody_moves_it_is_over_with_one_frame() {
        let still = Motion::new(vec![0.0, 4.0], 2, vec![DVec2::ZERO, DVec2::X, DVec2::ZERO, DVec2::X]);
        let Freed { motion, ts } = freed(&still, 1.5, &[f64::INFINITY; 2], 10.0, false);
        assert_eq!((motion.times(), ts.as_slice()), (&[0.0, 0.1][..], &[1.0, 1.0][..]));
    }
}
