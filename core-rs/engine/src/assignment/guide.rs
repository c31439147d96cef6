//! Where agents are taken to stand before ways are measured: mirrored, or carried along by a few given pairs.

use glam::{DMat2, DVec2, DVec3};

use crate::formation::principal_axes;
use crate::trig::direction;

/// Pairs whose spread across is less than this part of the spread along stand on a line and tell nothing about the other direction.
const LINE: f64 = 1e-6;

/// Everybody mirrored so that both ends of the longest direction in plan change places.
pub(super) fn flip(points: &mut [DVec3]) {
    let plan: Vec<DVec2> = points.iter().map(|point| point.truncate()).collect();
    let along = direction(principal_axes(&plan).angle);
    let middle = mean(&plan);
    for (point, place) in points.iter_mut().zip(plan) {
        *point = (place - 2.0 * along.dot(place - middle) * along).extend(point.z);
    }
}

/// Everybody carried as the pairs are, one at least: shifted by one pair, turned and scaled by two or by pairs on a line, stretched
/// and sheared by more (least squares). Heights shift by their mean.
pub(super) fn carry(points: &mut [DVec3], pairs: &[(DVec3, DVec3)]) {
    let (from, to): (Vec<DVec2>, Vec<DVec2>) = pairs.iter().map(|(p, q)| (p.truncate(), q.truncate())).unzip();
    let (source, target) = (mean(&from), mean(&to));
    let about: Vec<(DVec2, DVec2)> = from.iter().zip(&to).map(|(p, q)| (p - source, q - target)).collect();
    let spread = principal_axes(&from);
    let map = if spread.minor > LINE * spread.major {
        // q pᵀ (p pᵀ)⁻¹
        let outer = |a: DVec2, b: DVec2| DMat2::from_cols(a * b.x, a * b.y);
        let sum = |of: fn(&(DVec2, DVec2)) -> (DVec2, DVec2)| about.iter().map(of).fold(DMat2::ZERO, |sum, (a, b)| sum + outer(a, b));
        sum(|&(p, q)| (q, p)) * sum(|&(p, _)| (p, p)).inverse()
    } else if spread.major > 0.0 {
        // Of complex numbers: q p̄ / p p̄.
        let along: DVec2 = about.iter().map(|(p, q)| DVec2::new(p.dot(*q), p.perp_dot(*q))).sum();
        let turn = along / about.iter().map(|(p, _)| p.length_squared()).sum::<f64>();
        DMat2::from_cols(turn, turn.perp())
    } else {
        DMat2::IDENTITY
    };
    let rise = pairs.iter().map(|(p, q)| q.z - p.z).sum::<f64>() / pairs.len() as f64;
    for point in points {
        *point = (target + map * (point.truncate() - source)).extend(point.z + rise);
    }
}

fn mean(points: &[DVec2]) -> DVec2 {
    points.iter().sum::<DVec2>() / points.len().max(1) as f64
}
