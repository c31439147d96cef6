//! How the coefficients of the modes, or the places of agents about their barycenter, run between two ends in space.

use std::f64::consts::PI;

use crate::trig::direction;
use glam::{DQuat, DVec2, DVec3};

use super::super::angle::HALF_TURN_SNAP;
use super::super::coefficients::{ROUND_OFF, TINY_RADIUS};

/// One arc a mode on the sphere: lengths linear, directions the shorter way on a great circle once the common rotation is taken out,
/// then turned by its share of that rotation: C(t) = slerp(A, B G⁻¹; t) Gᵗ.
#[derive(Clone, Debug)]
pub(crate) struct Arcs {
    modes: Vec<Arc>,
    /// The axis and the angle of the common rotation.
    axis: DVec3,
    angle: f64,
    sizes: Option<[f64; 2]>,
}

#[derive(Clone, Debug)]
struct Arc {
    lengths: [f64; 2],
    /// Where it points at first; zero where nothing points anywhere.
    start: DVec3,
    /// Where it points a quarter turn later.
    across: DVec3,
    angle: f64,
    residuals: [DVec3; 2],
}

impl Arcs {
    /// Arcs from `source` to `target`, of equal number, with the common `rotation`. What is reversed turns about the perpendicular
    /// nearest to `thinnest`, counterclockwise.
    pub(crate) fn between(source: &[DVec3], target: &[DVec3], rotation: DQuat, thinnest: DVec3) -> Self {
        assert_eq!(source.len(), target.len(), "both ends have the same modes");
        let greatest = source.iter().chain(target).map(|c| c.length()).fold(0.0, f64::max);
        let sine = DVec3::new(rotation.x, rotation.y, rotation.z);
        let (axis, angle) = (sine.try_normalize().unwrap_or(DVec3::Z), 2.0 * libm::atan2(sine.length(), rotation.w));
        let back = rotation.conjugate();
        let modes = source.iter().zip(target).map(|(from, to)| Arc::between(*from, back * *to, thinnest, greatest)).collect();
        let mut all = Self { modes, axis, angle, sizes: None };
        // What a direction of noise leaves open at the ends; round-off elsewhere.
        let [first, last] = [0.0, 1.0].map(|t| all.turned(t).collect::<Vec<_>>());
        for (k, arc) in all.modes.iter_mut().enumerate() {
            arc.residuals = [source[k] - first[k], target[k] - last[k]];
        }
        all
    }

    /// The same, scaled at every t so that the root of the summed squares runs linearly too.
    pub(crate) fn keeping_size(self) -> Self {
        let size = |t: f64| self.at(t).map(DVec3::length_squared).sum::<f64>().sqrt();
        Self { sizes: Some([size(0.0), size(1.0)]), ..self }
    }

    /// Writes the coefficients at every `t` in 0..1: for each t a column of all x, one of all y, one of all z.
    pub(crate) fn write_columns(&self, ts: &[f64], columns: &mut [f64]) {
        let mode_count = self.modes.len();
        assert_eq!(columns.len(), 3 * mode_count * ts.len(), "three columns for every t");
        for (k, t) in ts.iter().enumerate() {
            let columns = &mut columns[3 * mode_count * k..][..3 * mode_count];
            let scale = self.scale(*t);
            for (mode, at) in self.at(*t).enumerate() {
                for (axis, entry) in (at * scale).to_array().into_iter().enumerate() {
                    columns[axis * mode_count + mode] = entry;
                }
            }
        }
    }

    /// What keeps the size; 1 where nothing is to be kept.
    fn scale(&self, t: f64) -> f64 {
        let Some([from, to]) = self.sizes else { return 1.0 };
        let squares: f64 = self.at(t).map(DVec3::length_squared).sum();
        if squares > 0.0 { ((1.0 - t) * from + t * to) / squares.sqrt() } else { 1.0 }
    }

    fn at(&self, t: f64) -> impl Iterator<Item = DVec3> {
        self.turned(t).zip(&self.modes).map(move |(at, arc)| at + (1.0 - t) * arc.residuals[0] + t * arc.residuals[1])
    }

    fn turned(&self, t: f64) -> impl Iterator<Item = DVec3> {
        let half = direction(0.5 * t * self.angle);
        let turn = DQuat::from_vec4((self.axis * half.y).extend(half.x));
        self.modes.iter().map(move |arc| turn * arc.at(t))
    }
}

impl Arc {
    /// `to` is the target's coefficient with the common rotation taken out.
    fn between(from: DVec3, to: DVec3, thinnest: DVec3, greatest: f64) -> Self {
        let lengths = [from.length(), to.length()];
        let least = lengths[0].min(lengths[1]);
        let [start, end] = [from, to].map(DVec3::normalize_or_zero);
        let mut arc = Self { lengths, start, across: DVec3::ZERO, angle: 0.0, residuals: [DVec3::ZERO; 2] };
        if least <= TINY_RADIUS * greatest {
            // What has no direction takes the other end's.
            arc.start = if lengths[0] < lengths[1] { end } else { start };
            return arc;
        }
        let angle = libm::atan2(start.cross(end).length(), start.dot(end));
        if angle >= PI - f64::max(HALF_TURN_SNAP, ROUND_OFF * greatest / least) {
            arc.angle = PI;
            arc.across = perpendicular(start, thinnest).cross(start);
        } else {
            arc.angle = angle;
            arc.across = end.reject_from_normalized(start).normalize_or_zero();
        }
        arc
    }

    fn at(&self, t: f64) -> DVec3 {
        let length = (1.0 - t) * self.lengths[0] + t * self.lengths[1];
        let DVec2 { x: cos, y: sin } = direction(t * self.angle);
        length * (cos * self.start + sin * self.across)
    }
}

/// The unit perpendicular to a direction that is nearest to `wanted`; any where `wanted` lies along it.
fn perpendicular(direction: DVec3, wanted: DVec3) -> DVec3 {
    let rejected = wanted.reject_from_normalized(direction);
    if rejected.length() > HALF_TURN_SNAP { rejected.normalize() } else { direction.any_orthonormal_vector() }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::FRAC_PI_2;

    use super::*;

    fn at(arcs: &Arcs, t: f64) -> DVec3 {
        let count = arcs.modes.len();
        let mut columns = vec![f64::NAN; 3 * count];
        arcs.write_columns(&[t], &mut columns);
        DVec3::new(columns[0], columns[count], columns[2 * count])
    }

    fn check(from: DVec3, to: DVec3, rotation: DQuat, halfway: DVec3) {
        let arcs = Arcs::between(&[from, DVec3::X], &[to, DVec3::X], rotation, DVec3::Z);
        let found = at(&arcs, 0.5);
        assert!(found.distance(halfway) < 1e-12, "{from} to {to}: {found} for {halfway}");
        assert!(at(&arcs, 0.0).distance(from) < 1e-15 && at(&arcs, 1.0).distance(to) < 1e-15);
    }

    #[test]
    fn a_direction_takes_the_shorter_way_on_a_great_circle() {
        let half = 0.5_f64.sqrt();
        check(DVec3::X, 3.0 * DVec3::Z, DQuat::IDENTITY, 2.0 * DVec3::new(half, 0.0, half));
        check(DVec3::Y, DVec3::Y, DQuat::IDENTITY, DVec3::Y);
        // With a common quarter turn about the vertical only the rest is a way of its own.
        let quarter = DQuat::from_rotation_z(FRAC_PI_2);
        check(DVec3::X, DVec3::Y, quarter, DVec3::new(half, half, 0.0));
        check(DVec3::Z, DVec3::Z, quarter, DVec3::Z);
    }

    #[test]
    fn what_is_reversed_turns_within_the_formation_counterclockwise() {
        check(DVec3::X, -DVec3::X, DQuat::IDENTITY, DVec3::Y);
        check(DVec3::X, DVec3::new(-1.0, -1e-12, 1e-12), DQuat::IDENTITY, DVec3::Y);
        // Along the thinnest direction itself any perpendicular will do.
        let arcs = Arcs::between(&[DVec3::Z], &[-DVec3::Z], DQuat::IDENTITY, DVec3::Z);
        assert!(at(&arcs, 0.5).z.abs() < 1e-15 && (at(&arcs, 0.5).length() - 1.0).abs() < 1e-15);
    }

    #[test]
    fn what_has_no_direction_follows_the_common_rotation() {
        let half_way = |angle: f64| DQuat::from_rotation_z(angle) * DVec3::X;
        check(DVec3::new(0.0, 1e-13, 0.0), 2.0 * DVec3::X, DQuat::from_rotation_z(1.0), half_way(-0.5));
        check(2.0 * DVec3::X, DVec3::ZERO, DQuat::from_rotation_z(1.0), half_way(0.5));
        check(DVec3::ZERO, DVec3::ZERO, DQuat::from_rotation_z(1.0), DVec3::ZERO);
    }

    #[test]
    fn a_kept_size_runs_linearly() {
        let source = [DVec3::X, 2.0 * DVec3::Y, DVec3::new(1.0, 1.0, 1.0)];
        let target = [3.0 * DVec3::Z, DVec3::X, DVec3::new(-1.0, 1.0, 2.0)];
        let arcs = Arcs::between(&source, &target, DQuat::IDENTITY, DVec3::Z).keeping_size();
        let size = |t: f64| {
            let mut columns = vec![0.0; 9];
            arcs.write_columns(&[t], &mut columns);
            columns.iter().map(|entry| entry * entry).sum::<f64>().sqrt()
        };
        assert!((size(0.5) - f64::midpoint(size(0.0), size(1.0))).abs() < 1e-14);
    }
}
