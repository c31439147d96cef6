//! Where a formation goes that follows a drawn path, and how far it has turned with the path's heading.
//!
//! The path is a smooth curve through its points, which begins and ends at the barycenters of both keyframes: its points keep their
//! distances from the straight way between its ends. Equal steps of t are equal lengths of the curve. The heading counts as seen from
//! above, and as the mean over a stretch of the curve, so that a corner turns nobody at once.

use glam::{DVec2, DVec3};

use crate::spline::Spline;

/// Pieces of equal length that a curve is kept in: in 1/512 of a circle a parabola's slopes leave 3e-8 of the length.
const PIECES: usize = 512;

/// The pieces to either side whose headings count, twice over: a corner is turned within a sixteenth of the curve.
const REACH: usize = PIECES / 64;

/// Places at which the curve's length is measured, at the least: eight a piece.
const MEASURED: usize = 8 * PIECES;

/// A curve that is slower than this as seen from above, relative to its mean speed, has no heading there: it climbs, or turns back.
const SLOWEST: f64 = 1e-9;

/// A way from one barycenter to another, over t.
#[derive(Clone, Debug)]
pub(super) struct Course {
    from: DVec3,
    way: DVec3,
    /// None for the straight way.
    curve: Option<Curve>,
}

/// At t = 0, 1/[`PIECES`], …, 1.
#[derive(Clone, Debug)]
struct Curve {
    /// From the straight way, meters.
    aside: Vec<DVec3>,
    /// Since the start, radians, counterclockwise.
    turns: Vec<f64>,
}

impl Course {
    /// Straight on, without a turn.
    pub(super) fn straight([from, to]: [DVec3; 2]) -> Self {
        Self { from, way: to - from, curve: None }
    }

    /// Along a path through `points`; straight where that has no length between these ends.
    pub(super) fn along(points: &[DVec3], ends: [DVec3; 2]) -> Self {
        Self { curve: Curve::through(&fitted(points, ends), ends), ..Self::straight(ends) }
    }

    /// The barycenter's place, and the turn since the start.
    pub(super) fn at(&self, t: f64) -> (DVec3, f64) {
        let straight = self.from + self.way * t;
        match &self.curve {
            None => (straight, 0.0),
            Some(curve) => (straight + between(&curve.aside, t), between(&curve.turns, t)),
        }
    }

    /// What both change by with t at an end: 0, the start, or 1.
    pub(super) fn rate(&self, end: usize) -> (DVec3, f64) {
        match &self.curve {
            None => (self.way, 0.0),
            Some(Curve { aside, turns }) => {
                let (knot, scale) = (end * PIECES, PIECES as f64);
                (self.way + slope(aside, knot) * scale, slope(turns, knot) * scale)
            }
        }
    }

    /// From the start to the end.
    pub(super) fn turn(&self) -> f64 {
        self.curve.as_ref().map_or(0.0, |curve| curve.turns[PIECES])
    }
}

/// The points of a path where they are followed: each as far from the straight way between the ends as it is from that between the
/// path's own, at its share of the path's length. Points in one place are one.
fn fitted(points: &[DVec3], [from, to]: [DVec3; 2]) -> Vec<DVec3> {
    let shares = lengths(points);
    let total = shares[shares.len() - 1];
    let (first, last) = (points[0], points[points.len() - 1]);
    let place = |(point, length): (&DVec3, &f64)| {
        let share = length / total;
        from + (to - from) * share + (*point - (first + (last - first) * share))
    };
    let mut fitted: Vec<DVec3> = points.iter().zip(&shares).map(place).collect();
    let end = fitted.len() - 1;
    (fitted[0], fitted[end]) = (from, to);
    fitted.dedup();
    fitted
}

/// How far each point is from the first, along the points.
fn lengths(points: &[DVec3]) -> Vec<f64> {
    let mut length = 0.0;
    std::iter::once(0.0)
        .chain(points.windows(2).map(|pair| {
            length += pair[0].distance(pair[1]);
            length
        }))
        .collect()
}

impl Curve {
    /// The spline through points, none equal to the next, over the length of their chords, parabolas at its ends; none through one
    /// point.
    fn through(points: &[DVec3], ends: [DVec3; 2]) -> Option<Self> {
        let knots = lengths(points);
        let chords = knots[knots.len() - 1];
        if chords.is_nan() || chords <= 0.0 {
            return None;
        }
        let spline = Threads::new(points, knots.clone());
        let each = MEASURED.div_ceil(points.len() - 1);
        let parameters: Vec<f64> = knots
            .windows(2)
            .flat_map(|pair| (0..each).map(|k| pair[0] + (pair[1] - pair[0]) * k as f64 / each as f64))
            .chain(std::iter::once(chords))
            .collect();
        let measured = lengths(&parameters.iter().map(|u| spline.at(*u).0).collect::<Vec<_>>());
        let is_flat = points.iter().all(|point| point.z == points[0].z);
        let (mut aside, mut headings, mut heading) = (Vec::new(), Vec::new(), Heading::default());
        for k in 0..=PIECES {
            let t = k as f64 / PIECES as f64;
            let (place, velocity) = spline.at(at_length(&parameters, &measured, t));
            let off = place - (ends[0] + (ends[1] - ends[0]) * t);
            // What is level stays so to the bit.
            aside.push(if is_flat { off.with_z(0.0) } else { off });
            headings.push(heading.follow(velocity.truncate()));
        }
        (aside[0], aside[PIECES]) = (DVec3::ZERO, DVec3::ZERO);
        Some(Self { aside, turns: averaged(&averaged(&headings)) })
    }
}

/// The parameter at which a share of all of `lengths` lies behind.
fn at_length(parameters: &[f64], lengths: &[f64], share: f64) -> f64 {
    let length = share * lengths[lengths.len() - 1];
    let at = lengths.partition_point(|known| *known <= length).clamp(1, lengths.len() - 1) - 1;
    let step = lengths[at + 1] - lengths[at];
    let within = if step > 0.0 { ((length - lengths[at]) / step).clamp(0.0, 1.0) } else { 0.0 };
    parameters[at] + (parameters[at + 1] - parameters[at]) * within
}

/// One spline an axis.
struct Threads {
    spline: Spline,
    /// Values and second derivatives.
    axes: [(Vec<f64>, Vec<f64>); 3],
}

impl Threads {
    fn new(points: &[DVec3], knots: Vec<f64>) -> Self {
        let spline = Spline::parabolic(knots);
        let axes = [0, 1, 2].map(|axis| {
            let values: Vec<f64> = points.iter().map(|point| point[axis]).collect();
            let mut bends = vec![0.0; values.len()];
            spline.bends_into(&values, &mut bends);
            (values, bends)
        });
        Self { spline, axes }
    }

    /// Place and velocity at a parameter.
    fn at(&self, parameter: f64) -> (DVec3, DVec3) {
        let weights = self.spline.weights(parameter);
        let of = |axis: usize| weights.of(&self.axes[axis].0, &self.axes[axis].1);
        let slope = |axis: usize| weights.slope(&self.axes[axis].0, &self.axes[axis].1);
        (DVec3::new(of(0), of(1), of(2)), DVec3::new(slope(0), slope(1), slope(2)))
    }
}

/// A direction that is followed, over whole turns.
#[derive(Default)]
struct Heading {
    direction: Option<DVec2>,
    turned: f64,
}

impl Heading {
    /// The turn since the first direction. A spline over its chords has about unit speed.
    fn follow(&mut self, velocity: DVec2) -> f64 {
        let speed = velocity.length();
        if speed.is_nan() || speed <= SLOWEST {
            return self.turned;
        }
        let direction = velocity / speed;
        if let Some(last) = self.direction {
            let (across, along) = (last.perp_dot(direction), last.dot(direction));
            // Who goes straight back turns left, whatever the round-off.
            let is_back = along < 0.0 && across.abs() < SLOWEST;
            self.turned += if is_back { std::f64::consts::PI } else { libm::atan2(across, along) };
        }
        self.direction = Some(direction);
        self.turned
    }
}

/// Means over the neighbors to either side. Beyond an end headings go on turned about it, so that the end stays.
fn averaged(headings: &[f64]) -> Vec<f64> {
    let last = headings.len() - 1;
    let before = (1..=REACH).rev().map(|k| 2.0 * headings[0] - headings[k]);
    let after = (1..=REACH).map(|k| 2.0 * headings[last] - headings[last - k]);
    let longer: Vec<f64> = before.chain(headings.iter().copied()).chain(after).collect();
    let mut means: Vec<f64> = longer.windows(2 * REACH + 1).map(|window| window.iter().sum::<f64>() / window.len() as f64).collect();
    // Both ends are their own means, up to round-off.
    (means[0], means[last]) = (headings[0], headings[last]);
    means
}

/// What knots take: numbers and places.
trait Knot: Copy + std::ops::Add<Output = Self> + std::ops::Sub<Output = Self> + std::ops::Mul<f64, Output = Self> {}
impl Knot for f64 {}
impl Knot for DVec3 {}

/// The slope of a parabola through three knots, a knot's step.
fn slope<K: Knot>(knots: &[K], k: usize) -> K {
    let last = knots.len() - 1;
    match k {
        0 => (knots[1] - knots[0]) * 2.0 - (knots[2] - knots[0]) * 0.5,
        _ if k == last => (knots[last] - knots[last - 1]) * 2.0 - (knots[last] - knots[last - 2]) * 0.5,
        _ => (knots[k + 1] - knots[k - 1]) * 0.5,
    }
}

/// A cubic from knot to knot.
fn between<K: Knot>(knots: &[K], t: f64) -> K {
    let pieces = knots.len() - 1;
    let at = ((t * pieces as f64) as usize).min(pieces - 1);
    let u = t * pieces as f64 - at as f64;
    let v = 1.0 - u;
    let (from, to) = (knots[at], knots[at + 1]);
    from * (v * v * (1.0 + 2.0 * u)) + slope(knots, at) * (u * v * v) + to * (u * u * (1.0 + 2.0 * v)) - slope(knots, at + 1) * (u * u * v)
}
