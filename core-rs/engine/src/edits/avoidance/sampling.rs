//! From samples to knots and back.

use eigenform_apart::Paths;
use glam::DVec3;

use crate::edits::grain::rounded;
use crate::motion::Motion;
use crate::spline::Spline;

/// The guide at `knot_count` evenly spaced instants, straight between its samples, rounded.
pub(super) fn at_knots(guide: &Motion, knot_count: usize) -> Paths {
    let times = guide.times();
    let mut paths = Paths::new(guide.agent_count(), knot_count, axis_count(guide));
    for (knot, time) in knot_times(times, knot_count).enumerate() {
        let at = times.partition_point(|known| *known <= time).clamp(1, times.len() - 1) - 1;
        let w = ((time - times[at]) / (times[at + 1] - times[at])).clamp(0.0, 1.0);
        for (agent, (from, to)) in guide.places(at).iter().zip(guide.places(at + 1).iter()).enumerate() {
            let place = rounded(from) * (1.0 - w) + rounded(to) * w;
            set(&mut paths, agent, knot, place);
        }
    }
    paths
}

/// The guide at its own samples, moved by `deviation` (a knot a sample), rounded.
pub(super) fn at_samples(guide: &Motion, deviation: &Paths) -> Paths {
    let mut paths = Paths::new(guide.agent_count(), guide.times().len(), axis_count(guide));
    for k in 0..guide.times().len() {
        for (agent, place) in guide.places(k).iter().enumerate() {
            set(&mut paths, agent, k, rounded(place) + DVec3::from_array(deviation.place(agent, k)));
        }
    }
    paths
}

/// What is between two sets of paths of the same shape.
pub(super) fn difference(paths: &Paths, from: &Paths) -> Paths {
    let mut difference = paths.clone();
    for axis in 0..paths.axis_count() {
        difference.axis_mut(axis).iter_mut().zip(from.axis(axis)).for_each(|(value, from)| *value -= from);
    }
    difference
}

/// The sum of two sets of paths of the same shape.
pub(super) fn sum(paths: &Paths, other: &Paths) -> Paths {
    let mut sum = paths.clone();
    for axis in 0..paths.axis_count() {
        sum.axis_mut(axis).iter_mut().zip(other.axis(axis)).for_each(|(value, other)| *value += other);
    }
    sum
}

/// Mean and greatest length of a deviation, meters.
pub(super) fn lengths(deviation: &Paths) -> [f64; 2] {
    let (mut sum, mut greatest): (f64, f64) = (0.0, 0.0);
    for agent in 0..deviation.agent_count() {
        for k in 0..deviation.knot_count() {
            let [x, y, z] = deviation.place(agent, k);
            let length = (x * x + y * y + z * z).sqrt();
            sum += length;
            greatest = greatest.max(length);
        }
    }
    [sum / (deviation.agent_count() * deviation.knot_count()).max(1) as f64, greatest]
}

/// A deviation at evenly spaced knots as a cubic spline at sample times; exactly zero at both ends.
pub(super) fn lifted(deviation: &Paths, times: &[f64], is_clamped: [bool; 2]) -> Paths {
    let knot_count = deviation.knot_count();
    let spline = Spline::new(knot_times(times, knot_count).collect(), is_clamped);
    let weights: Vec<_> = times.iter().map(|time| spline.weights(*time)).collect();
    let mut lifted = Paths::new(deviation.agent_count(), times.len(), deviation.axis_count());
    let mut bends = vec![0.0; knot_count];
    for axis in 0..deviation.axis_count() {
        for agent in 0..deviation.agent_count() {
            let values = deviation.path(axis, agent);
            if values.iter().all(|u| *u == 0.0) {
                continue;
            }
            spline.bends_into(values, &mut bends);
            let out = lifted.path_mut(axis, agent);
            out.iter_mut().zip(&weights).for_each(|(out, weights)| *out = weights.of(values, &bends));
            (out[0], out[times.len() - 1]) = (0.0, 0.0);
        }
    }
    lifted
}

fn axis_count(guide: &Motion) -> usize {
    if guide.heights().is_some() { 3 } else { 2 }
}

fn knot_times(times: &[f64], knot_count: usize) -> impl Iterator<Item = f64> {
    let (start, end) = (times[0], times[times.len() - 1]);
    (0..knot_count).map(move |knot| {
        let t = knot as f64 / (knot_count - 1) as f64;
        start * (1.0 - t) + end * t
    })
}

fn set(paths: &mut Paths, agent: usize, knot: usize, place: DVec3) {
    for axis in 0..paths.axis_count() {
        paths.path_mut(axis, agent)[knot] = place[axis];
    }
}
