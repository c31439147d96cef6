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
    wrap(correlation.across.atan2(correlation.along), HALF_TURN_SNAP)
}

/// The turn between the principal axes; of its two directions the one that brings the agents nearer to their targets.
fn principal(source: &Formation, target: &Formation) -> f64 {
    let correlation = Correlation::of(source, target);
    let (Some(from), Some(to)) = (axis_angle(source), axis_angle(target)) else {
        return procrustes(&correlation);
    };
    let ahead = wrap(to - from, HALF_TURN_SNAP);
    let behind = wrap(to - from + PI, HALF_TURN_SNAP);
    let gain = correlation.along * ahead.cos() + correlation.across * ahead.sin();
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
    (spread > ROUND * (xx + yy)).then(|| 0.5 * (2.0 * xy).atan2(xx - yy))
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
