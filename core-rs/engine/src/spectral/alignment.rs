//! The turn from one formation to another that is taken out before modes interpolate (paper A, section 3.3).

use std::f64::consts::PI;

use glam::DVec2;

use super::angle::{HALF_TURN_SNAP, wrap};
use crate::choice::Alignment;
use crate::formation::Formation;

/// Principal variances nearer than this, relative to their sum, leave the axis to chance.
const ROUND: f64 = 1e-3;

/// Correlations below this, relative to the sizes, are round-off: no turn fits better than another.
const UNRELATED: f64 = 1e-12;

/// The angle φ in (−π, π] by which the source turns into the target, radians, counterclockwise.
pub(crate) fn turn_between(source: &Formation, target: &Formation, alignment: Alignment) -> f64 {
    match alignment {
        Alignment::None => 0.0,
        Alignment::Procrustes => procrustes(&Correlation::of(source, target)),
        Alignment::Pca => principal(source, target),
    }
}

/// The turn of least squares.
fn procrustes(correlation: &Correlation) -> f64 {
    if correlation.along.hypot(correlation.across) <= UNRELATED * correlation.scale {
        return 0.0;
    }
    wrap(libm::atan2(correlation.across, correlation.along), HALF_TURN_SNAP)
}

/// The turn between the principal axes; of its two directions the one that brings the agents nearer to their targets.
fn principal(source: &Formation, target: &Formation) -> f64 {
    let correlation = Correlation::of(source, target);
    let (Some(from), Some(to)) = (axis_angle(source), axis_angle(target)) else {
        return procrustes(&correlation);
    };
    let ahead = wrap(to - from, HALF_TURN_SNAP);
    let behind = wrap(to - from + PI, HALF_TURN_SNAP);
    let gain = correlation.along * libm::cos(ahead) + correlation.across * libm::sin(ahead);
    if gain.abs() <= UNRELATED * correlation.scale {
        // Both fit equally well: the shorter way, so that the answer does not hang on where the axes of the stage point.
        return if behind.abs() < ahead.abs() { behind } else { ahead };
    }
    if gain > 0.0 { ahead } else { behind }
}

/// The direction of greatest variance, in (−π/2, π/2]; `None` for a formation as wide as it is long.
fn axis_angle(formation: &Formation) -> Option<f64> {
    let center = formation.barycenter();
    let (xx, xy, yy) = formation
        .positions()
        .iter()
        .map(|p| *p - center)
        .fold((0.0, 0.0, 0.0), |(xx, xy, yy), p| (xx + p.x * p.x, xy + p.x * p.y, yy + p.y * p.y));
    let spread = (xx - yy).hypot(2.0 * xy);
    (spread > ROUND * (xx + yy)).then(|| 0.5 * libm::atan2(2.0 * xy, xx - yy))
}

/// How the positions of two formations about their barycenters go together.
struct Correlation {
    along: f64,
    across: f64,
    scale: f64,
}

impl Correlation {
    fn of(source: &Formation, target: &Formation) -> Self {
        let (from, to) = (source.barycenter(), target.barycenter());
        let (mut cross, mut sizes) = (DVec2::ZERO, DVec2::ZERO);
        for (s, t) in source.positions().iter().zip(target.positions()) {
            let (s, t) = (*s - from, *t - to);
            cross += DVec2::new(s.dot(t), s.perp_dot(t));
            sizes += DVec2::new(s.length_squared(), t.length_squared());
        }
        Self { along: cross.x, across: cross.y, scale: (sizes.x * sizes.y).sqrt() }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const WEDGE: [[f64; 2]; 4] = [[0.0, 0.0], [6.0, 1.0], [6.5, -1.0], [9.0, 0.5]];

    fn wedge(turn: f64) -> Formation {
        let shift = DVec2::new(2.0, -5.0);
        Formation::new(WEDGE.iter().map(|p| DVec2::from_angle(turn).rotate(DVec2::from_array(*p)) + shift).collect())
    }

    #[test]
    fn a_turned_copy_gives_its_turn_whichever_way_its_axis_points() {
        for turn in [0.0, 0.4, -1.5, 1.7, 3.0, -3.0, PI] {
            for alignment in [Alignment::Pca, Alignment::Procrustes] {
                let found = turn_between(&wedge(0.3), &wedge(0.3 + turn), alignment);
                assert!((found - turn).abs() < 1e-12, "{alignment:?}: {found} for {turn}");
            }
            assert!(turn_between(&wedge(0.3), &wedge(0.3 + turn), Alignment::None).abs() < f64::EPSILON);
        }
    }

    #[test]
    fn a_round_formation_has_no_axis_and_turns_by_least_squares() {
        let ring = |turn: f64| Formation::new((0..5).map(|i| DVec2::from_angle(turn + f64::from(i) * 1.2 * PI / 3.0)).collect());
        let square = |turn: f64| Formation::new((0..4).map(|i| DVec2::from_angle(turn + f64::from(i) * PI / 2.0)).collect());
        assert!((turn_between(&square(0.1), &square(0.8), Alignment::Pca) - 0.7).abs() < 1e-12);
        assert!((turn_between(&ring(0.0), &ring(-0.5), Alignment::Procrustes) + 0.5).abs() < 1e-12);
    }

    #[test]
    fn formations_that_no_turn_brings_together_are_not_turned() {
        let at = |x: f64, y: f64| DVec2::new(x, y);
        let square = [at(1.0, 1.0), at(-1.0, 1.0), at(-1.0, -1.0), at(1.0, -1.0)];
        let mirrored = square.map(|p| DVec2::new(-p.x, p.y));
        let one_place = Formation::new(vec![DVec2::ONE; 4]);
        let [square, mirrored] = [square, mirrored].map(|points| Formation::new(points.to_vec()));
        for alignment in [Alignment::Pca, Alignment::Procrustes] {
            assert!(turn_between(&square, &mirrored, alignment).abs() < f64::EPSILON);
            assert!(turn_between(&square, &one_place, alignment).abs() < f64::EPSILON);
            assert!(turn_between(&one_place, &one_place, alignment).abs() < f64::EPSILON);
        }
    }
}
