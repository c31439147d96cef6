//! How offsets from a guide come to nothing at its end, and are smoothed.

use eigenform_apart::Paths;

use crate::edits::moved::moved;
use crate::motion::{Motion, closeness};

/// The last stretch, seconds, and at most this share of the whole.
const STRETCH: f64 = 1.0;
const GREATEST_SHARE: f64 = 0.25;

/// Widths of smoothing to try, seconds, the smoothest first.
const WIDTHS: [f64; 4] = [0.8, 0.4, 0.2, 0.1];

/// Averages one after the other: three are nearly a bell.
const PASSES: usize = 3;

/// How long the last stretch of so many seconds is.
pub(super) fn stretch(seconds: f64) -> f64 {
    STRETCH.min(GREATEST_SHARE * seconds)
}

/// Offsets that fall smoothly to zero over the last stretch: value and velocity are continuous at both of its ends.
pub(super) fn ended(offsets: &Paths, times: &[f64]) -> Paths {
    faded(offsets, times, [false, true])
}

/// Offsets that come from and fall to zero over a stretch where they are to.
fn faded(offsets: &Paths, times: &[f64], is_faded: [bool; 2]) -> Paths {
    let (start, end) = (times[0], times[times.len() - 1]);
    let stretch = stretch(end - start);
    let share = |from: f64, is_faded: bool| {
        let left = if is_faded { (from / stretch).clamp(0.0, 1.0) } else { 1.0 };
        left * left * (3.0 - 2.0 * left)
    };
    let shares: Vec<f64> = times.iter().map(|time| share(time - start, is_faded[0]) * share(end - time, is_faded[1])).collect();
    let mut ended = offsets.clone();
    for axis in 0..2 {
        for agent in 0..offsets.agent_count() {
            ended.path_mut(axis, agent).iter_mut().zip(&shares).for_each(|(offset, share)| *offset *= share);
        }
    }
    ended
}

/// The smoothest offsets, ended at both ends, with which nobody comes nearer than `least` meters, or than they do without.
pub(super) fn smoothed(offsets: &Paths, guide: &Motion, least: f64) -> Paths {
    let nearest = |offsets: &Paths| closeness(&moved(guide, offsets), 0.0).nearest().map_or(f64::INFINITY, |nearest| nearest.distance);
    let times = guide.times();
    let rough = ended(offsets, times);
    let least = least.min(nearest(&rough));
    let samples_per_second = (times.len() - 1) as f64 / (times[times.len() - 1] - times[0]);
    let tries = WIDTHS.iter().map(|width| {
        let reach = (0.5 * width * samples_per_second).round() as usize;
        faded(&averaged(offsets, reach), times, [true, true])
    });
    tries.into_iter().find(|tried| nearest(tried) >= least).unwrap_or(rough)
}

/// Means over `reach` samples on either side, again and again. Beyond an end the path goes on turned about it, so that the end stays.
fn averaged(offsets: &Paths, reach: usize) -> Paths {
    let last = offsets.knot_count() - 1;
    let reach = reach.min(last);
    let mut smooth = offsets.clone();
    let mut longer = Vec::new();
    for axis in 0..2 {
        for agent in 0..offsets.agent_count() {
            let path = smooth.path_mut(axis, agent);
            for _ in 0..PASSES {
                longer.clear();
                longer.extend((1..=reach).rev().map(|k| 2.0 * path[0] - path[k]));
                longer.extend_from_slice(path);
                longer.extend((1..=reach).map(|k| 2.0 * path[last] - path[last - k]));
                let windows = longer.windows(2 * reach + 1).map(|window| window.iter().sum::<f64>() / window.len() as f64);
                // Both ends are their own means, up to round-off.
                path.iter_mut().zip(windows).skip(1).take(last.saturating_sub(1)).for_each(|(value, mean)| *value = mean);
            }
        }
    }
    smooth
}
