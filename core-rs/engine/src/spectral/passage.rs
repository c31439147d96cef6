//! How coefficients pass several keyframes: cubics of radius and unwrapped angle with one velocity at each (paper A, equation 5).

use crate::trig::direction;
use glam::DVec2;

use super::coefficients::{TINY_RADIUS, bearing, greatest_radius, write_pair};

/// Weights of a cubic at `t` in 0..1: its start, the velocity there, its end, the velocity there.
pub(crate) fn cubic_weights(t: f64) -> [f64; 4] {
    let s = 1.0 - t;
    [s * s * (1.0 + 2.0 * t), t * s * s, t * t * (3.0 - 2.0 * t), -t * t * s]
}

/// A keyframe next to another.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Beside<'a> {
    /// In the modes of the other.
    pub(crate) coefficients: &'a [DVec2],
    /// The common turn from the earlier to the later, radians.
    pub(crate) turn: f64,
    /// How many times itself a radius may lose on the way from the one to the other, in the unit of time that velocities are in.
    pub(crate) steepest: f64,
}

/// The velocity with which coefficients pass a keyframe; for each mode that of its radius and its angle.
#[derive(Clone, Debug)]
pub(crate) struct Passing {
    modes: Vec<ModePassing>,
    size: f64,
    size_velocity: f64,
}

#[derive(Clone, Copy, Debug)]
struct ModePassing {
    /// 0 for a mode too small to have a direction.
    radius: f64,
    radius_velocity: f64,
    angle_velocity: f64,
}

impl Passing {
    /// Past `here`, from the keyframe before and to the one after, in the same modes; none at a stop. The velocity is
    /// `pace[0]` times the way from the one before plus `pace[1]` times the way to the one after; that of a radius is held to the
    /// steepest allowed: at three times the radius over the duration no control point of a cubic is below 0, and none is cut off there,
    /// which would be a kink.
    pub(crate) fn new(before: Option<Beside<'_>>, here: &[DVec2], after: Option<Beside<'_>>, pace: [f64; 2]) -> Self {
        let greatest_with = |beside: &Option<Beside<'_>>| greatest_radius(here.iter().chain(beside.map_or(&[][..], |b| b.coefficients)));
        let greatest = [greatest_with(&before), greatest_with(&after)];
        let tiny = TINY_RADIUS * greatest[0].max(greatest[1]);
        let [falls, rises] = [after, before].map(|beside| beside.map_or(f64::INFINITY, |b| b.steepest));
        // Nothing times no limit is no number, and no limit to max and min.
        let held = |velocity: f64, radius: f64| velocity.max(-falls * radius).min(rises * radius);
        let modes = here.iter().enumerate().map(|(mode, at)| {
            let radius = at.length();
            let mut passing = ModePassing { radius, radius_velocity: 0.0, angle_velocity: 0.0 };
            if let Some(Beside { coefficients, turn, .. }) = before {
                passing.angle_velocity += pace[0] * bearing(coefficients[mode], *at, turn, greatest[0]).1;
                passing.radius_velocity += pace[0] * (radius - coefficients[mode].length());
            }
            if let Some(Beside { coefficients, turn, .. }) = after {
                passing.angle_velocity += pace[1] * bearing(*at, coefficients[mode], turn, greatest[1]).1;
                passing.radius_velocity += pace[1] * (coefficients[mode].length() - radius);
            }
            if radius <= tiny {
                return ModePassing { radius: 0.0, radius_velocity: 0.0, ..passing };
            }
            ModePassing { radius_velocity: held(passing.radius_velocity, radius), ..passing }
        });
        let size = size(here);
        let way = |beside: Option<Beside<'_>>| beside.map_or(0.0, |b| self::size(b.coefficients) - size);
        Self { modes: modes.collect(), size, size_velocity: held(pace[1] * way(after) - pace[0] * way(before), size) }
    }

    /// The velocity of the coefficients `here`, the same as those it was made of.
    pub(crate) fn velocities(&self, here: &[DVec2], keeps_size: bool) -> Vec<DVec2> {
        let own = here.iter().zip(&self.modes).map(|(at, passing)| {
            if passing.radius == 0.0 {
                return DVec2::ZERO;
            }
            *at * (passing.radius_velocity / passing.radius) + at.perp() * passing.angle_velocity
        });
        let mut velocities: Vec<DVec2> = own.collect();
        if keeps_size && self.size > 0.0 {
            let grows = here.iter().zip(&velocities).map(|(at, velocity)| at.dot(*velocity)).sum::<f64>() / self.size;
            let scale = (self.size_velocity - grows) / self.size;
            velocities.iter_mut().zip(here).for_each(|(velocity, at)| *velocity += *at * scale);
        }
        velocities
    }
}

/// The coefficients between two keyframes that they pass.
#[derive(Clone, Debug)]
pub(crate) struct Passage {
    curves: Vec<Curve>,
    sizes: Option<[f64; 4]>,
}

/// Radius and angle as cubics: start, velocity, end, velocity.
#[derive(Clone, Debug)]
struct Curve {
    radius: [f64; 4],
    angle: [f64; 4],
    residuals: [DVec2; 2],
}

impl Passage {
    /// From `source` to `target` in `duration` (of the unit that the velocities are in), with the common `turn` in radians.
    pub(crate) fn new(source: (&[DVec2], &Passing), target: (&[DVec2], &Passing), turn: f64, duration: f64, keeps_size: bool) -> Self {
        let greatest = greatest_radius(source.0.iter().chain(target.0));
        let ends = source.0.iter().zip(&source.1.modes).zip(target.0.iter().zip(&target.1.modes));
        let curves = ends.map(|((from, leaves), (to, arrives))| {
            let (angle, turn) = bearing(*from, *to, turn, greatest);
            let mut curve = Curve {
                radius: [leaves.radius, duration * leaves.radius_velocity, arrives.radius, duration * arrives.radius_velocity],
                angle: [angle, duration * leaves.angle_velocity, angle + turn, duration * arrives.angle_velocity],
                residuals: [DVec2::ZERO; 2],
            };
            curve.residuals = [*from - curve.at(cubic_weights(0.0)), *to - curve.at(cubic_weights(1.0))];
            curve
        });
        let sizes = [source.1.size, duration * source.1.size_velocity, target.1.size, duration * target.1.size_velocity];
        Self { curves: curves.collect(), sizes: keeps_size.then_some(sizes) }
    }

    /// Writes the coefficients at every `t` in 0..1: for each t a column of all x, then a column of all y.
    pub(crate) fn write_columns(&self, ts: &[f64], columns: &mut [f64]) {
        assert_eq!(columns.len(), 2 * self.curves.len() * ts.len(), "two columns for every t");
        for (t, columns) in ts.iter().zip(columns.chunks_exact_mut((2 * self.curves.len()).max(1))) {
            let weights = cubic_weights(*t);
            let size = self.sizes.map(|sizes| mix(weights, sizes).max(0.0));
            write_pair(self.curves.iter().map(|curve| curve.at(weights)), size, columns);
        }
    }
}

impl Curve {
    /// A radius never falls below 0; residuals fade without changing a velocity.
    fn at(&self, weights: [f64; 4]) -> DVec2 {
        let [from, to] = self.residuals;
        mix(weights, self.radius).max(0.0) * direction(mix(weights, self.angle)) + weights[0] * from + weights[2] * to
    }
}

fn mix(weights: [f64; 4], values: [f64; 4]) -> f64 {
    weights.iter().zip(values).map(|(weight, value)| weight * value).sum()
}

/// The root of the summed squares.
fn size(coefficients: &[DVec2]) -> f64 {
    coefficients.iter().map(|c| c.length_squared()).sum::<f64>().sqrt()
}
