//! The rotation from one formation to another in space that is taken out before modes interpolate (paper A, section 4.5).

use faer::Mat;
use glam::{DMat3, DQuat, DVec3};

use crate::choice::Alignment;
use crate::formation::Places;
use eigenform_dense::symmetric_eigen;

/// Principal variances nearer than this, relative to their sum, leave the axes to chance.
const ROUND: f64 = 1e-3;

/// Correlations below this, relative to the sizes, are round-off: no rotation fits better than another.
const UNRELATED: f64 = 1e-12;

/// Rotations that fit equally well up to this, relative to the correlation, are all best ones: those about the line that everybody
/// stands on, for one.
const EQUAL_FIT: f64 = 1e-9;

/// The cosine of half an angle that counts as a half turn: its axis has no sign of its own, and round-off would choose it.
const HALF_TURN: f64 = 1e-9;

/// The rotation that takes the source into the target, both about their barycenters, with w ≥ 0; a half turn is counterclockwise seen
/// from above.
pub(in crate::spectral) fn rotation_between(source: Places<'_>, target: Places<'_>, alignment: Alignment) -> DQuat {
    match alignment {
        Alignment::None => DQuat::IDENTITY,
        Alignment::Procrustes => Correlation::of(source, target).best_rotation(),
        Alignment::Pca => principal(source, target),
    }
}

/// The direction in which a formation is thinnest, pointing up.
pub(in crate::spectral) fn thinnest(formation: Places<'_>) -> DVec3 {
    upright(principal_axes(formation).directions.x_axis)
}

/// Between the principal axes: of the four ways to match them the one that brings the agents nearest to their targets.
fn principal(source: Places<'_>, target: Places<'_>) -> DQuat {
    let correlation = Correlation::of(source, target);
    let [from, to] = [source, target].map(principal_axes);
    if from.are_round() || to.are_round() {
        return correlation.best_rotation();
    }
    // Two axes reversed at a time: a mirror image is no rotation.
    let ways = [[1.0, 1.0, 1.0], [1.0, -1.0, -1.0], [-1.0, 1.0, -1.0], [-1.0, -1.0, 1.0]];
    let rotations = ways.map(|signs| to.directions * DMat3::from_diagonal(signs.into()) * from.directions.transpose());
    let fits = rotations.map(|rotation| correlation.fit(rotation));
    let best = fits.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let quaternions = rotations.iter().zip(fits).filter(|(_, fit)| *fit >= best - UNRELATED * correlation.scale);
    // Of those that fit equally well the least turn, so that the answer does not hang on where the axes of the stage point.
    let quaternions = quaternions.map(|(rotation, _)| canonical(DQuat::from_mat3(rotation)));
    quaternions.max_by(|p, q| p.w.total_cmp(&q.w)).unwrap_or(DQuat::IDENTITY)
}

struct PrincipalAxes {
    /// Right-handed, of ascending variance.
    directions: DMat3,
    variances: [f64; 3],
}

impl PrincipalAxes {
    fn are_round(&self) -> bool {
        let [least, middle, greatest] = self.variances;
        (middle - least).min(greatest - middle) <= ROUND * (least + middle + greatest)
    }
}

fn principal_axes(formation: Places<'_>) -> PrincipalAxes {
    let spread: DMat3 = formation.about_barycenter().iter().map(|away| outer(*away, *away)).sum();
    let eigen = symmetric_eigen(Mat::from_fn(3, 3, |row, column| spread.col(column)[row]).as_ref());
    let direction = |column: usize| DVec3::new(eigen.vectors[(0, column)], eigen.vectors[(1, column)], eigen.vectors[(2, column)]);
    let (middle, greatest) = (direction(1), direction(2));
    let directions = DMat3::from_cols(middle.cross(greatest), middle, greatest);
    PrincipalAxes { directions, variances: [eigen.values[0], eigen.values[1], eigen.values[2]] }
}

/// How the places of two formations about their barycenters go together.
struct Correlation {
    /// Σ target sourceᵀ.
    cross: DMat3,
    scale: f64,
}

impl Correlation {
    fn of(source: Places<'_>, target: Places<'_>) -> Self {
        let [from, to] = [source, target].map(Places::about_barycenter);
        let cross = from.iter().zip(&to).map(|(from, to)| outer(*to, *from)).sum();
        let size = |away: &[DVec3]| away.iter().map(|away| away.length_squared()).sum::<f64>();
        Self { cross, scale: (size(&from) * size(&to)).sqrt() }
    }

    /// How well a rotation brings the source to the target: the sum of inner products.
    fn fit(&self, rotation: DMat3) -> f64 {
        (0..3).map(|column| self.cross.col(column).dot(rotation.col(column))).sum()
    }

    /// The rotation of least squares; of equally good ones that which turns least.
    ///
    /// The eigenvector of the greatest eigenvalue of a symmetric matrix, as a quaternion: never a reflection, and well defined where
    /// a singular value decomposition is not. Horn, "Closed-form solution of absolute orientation using unit quaternions" (1987).
    fn best_rotation(&self) -> DQuat {
        let [x, y, z] = [self.cross.x_axis, self.cross.y_axis, self.cross.z_axis];
        let size = (x.length_squared() + y.length_squared() + z.length_squared()).sqrt();
        if size <= UNRELATED * self.scale || size == 0.0 {
            return DQuat::IDENTITY;
        }
        // In the order w, x, y, z.
        let rows = [
            [x.x + y.y + z.z, y.z - z.y, z.x - x.z, x.y - y.x],
            [y.z - z.y, x.x - y.y - z.z, x.y + y.x, z.x + x.z],
            [z.x - x.z, x.y + y.x, y.y - x.x - z.z, y.z + z.y],
            [x.y - y.x, z.x + x.z, y.z + z.y, z.z - x.x - y.y],
        ];
        let eigen = symmetric_eigen(Mat::from_fn(4, 4, |row, column| rows[row][column] / size).as_ref());
        let best: Vec<usize> = (0..4).filter(|&column| eigen.values[column] >= eigen.values[3] - EQUAL_FIT).collect();
        let nearest_to = |axis: usize| {
            let mut sum = [0.0; 4];
            for &column in &best {
                sum.iter_mut().enumerate().for_each(|(row, entry)| *entry += eigen.vectors[(axis, column)] * eigen.vectors[(row, column)]);
            }
            DQuat::from_xyzw(sum[1], sum[2], sum[3], sum[0])
        };
        // The identity; where all are half turns, the one about the vertical, then those about the axes in plan.
        let nearest = [0, 3, 2, 1].map(nearest_to).into_iter().find(|nearest| nearest.length() > HALF_TURN);
        canonical(nearest.unwrap_or(DQuat::IDENTITY).normalize())
    }
}

/// The same rotation with w ≥ 0, and the axis of a half turn pointing up.
fn canonical(rotation: DQuat) -> DQuat {
    let DQuat { x, y, z, w } = rotation;
    let axis = DVec3::new(x, y, z);
    let is_reversed = if w.abs() <= HALF_TURN { upright(axis) != axis } else { w < 0.0 };
    if is_reversed { -rotation } else { rotation }
}

/// A direction or its opposite: up, else away from the audience, else to the right.
fn upright(direction: DVec3) -> DVec3 {
    let decisive = [direction.z, direction.y, direction.x].into_iter().find(|part| part.abs() > HALF_TURN);
    if decisive.is_some_and(|part| part < 0.0) { -direction } else { direction }
}

/// p qᵀ.
fn outer(p: DVec3, q: DVec3) -> DMat3 {
    DMat3::from_cols(p * q.x, p * q.y, p * q.z)
}

#[cfg(test)]
mod tests {
    use std::f64::consts::{FRAC_PI_2, PI};

    use glam::DVec2;

    use super::*;

    /// A solid with three different axes and no symmetry.
    const WEDGE: [[f64; 3]; 5] = [[0.0, 0.0, 0.0], [6.0, 1.0, 0.5], [6.5, -1.0, 0.2], [9.0, 0.5, -0.4], [3.0, 2.0, 1.0]];

    fn between(source: &[DVec3], target: &[DVec3], alignment: Alignment) -> DQuat {
        let parts = |points: &[DVec3]| -> (Vec<DVec2>, Vec<f64>) { points.iter().map(|p| (p.truncate(), p.z)).unzip() };
        let ((plan, heights), (target_plan, target_heights)) = (parts(source), parts(target));
        rotation_between(Places::new(&plan, Some(&heights)), Places::new(&target_plan, Some(&target_heights)), alignment)
    }

    fn turned(points: &[DVec3], rotation: DQuat) -> Vec<DVec3> {
        points.iter().map(|&point| rotation * point + DVec3::new(2.0, -5.0, 3.0)).collect()
    }

    fn apart(p: DQuat, q: DQuat) -> f64 {
        (p - q).length()
    }

    #[test]
    fn a_turned_copy_gives_its_turn_whichever_way_its_axes_point() {
        let wedge = WEDGE.map(DVec3::from_array);
        for axis in [DVec3::Z, DVec3::X, DVec3::new(1.0, 2.0, -0.5).normalize()] {
            for angle in [0.0, 1e-8, 0.4, -1.5, 3.0] {
                let turn = canonical(DQuat::from_axis_angle(axis, angle));
                for alignment in [Alignment::Pca, Alignment::Procrustes] {
                    let found = between(&wedge, &turned(&wedge, turn), alignment);
                    assert!(apart(found, turn) < 1e-12, "{alignment:?}: {found} for {turn}");
                }
                assert_eq!(between(&wedge, &turned(&wedge, turn), Alignment::None), DQuat::IDENTITY);
            }
        }
    }

    #[test]
    fn a_half_turn_is_counterclockwise_seen_from_above() {
        let wedge = WEDGE.map(DVec3::from_array);
        for axis in [DVec3::Z, DVec3::Y, DVec3::new(-1.0, 3.0, 0.5).normalize()] {
            let turn = DQuat::from_axis_angle(axis, PI);
            for alignment in [Alignment::Pca, Alignment::Procrustes] {
                let [there, opposite] = [turn, -turn].map(|turn| between(&wedge, &turned(&wedge, turn), alignment));
                let direction = DVec3::new(there.x, there.y, there.z);
                assert!(there.w.abs() < 1e-12 && direction.distance(axis) < 1e-12, "{there} about {axis}");
                assert!(apart(there, opposite) < 1e-12);
            }
        }
    }

    #[test]
    fn a_line_turns_the_shortest_way_to_where_it_points() {
        let line = |direction: DVec3| (0..5).map(|i| direction * f64::from(i)).collect::<Vec<_>>();
        for alignment in [Alignment::Pca, Alignment::Procrustes] {
            let found = between(&line(DVec3::X), &line(DVec3::Z), alignment);
            assert!(apart(found, DQuat::from_axis_angle(DVec3::NEG_Y, FRAC_PI_2)) < 1e-12, "{found}");
            // To its reverse about the vertical, as in the plane.
            let reversed = between(&line(DVec3::X), &line(DVec3::NEG_X), alignment);
            assert!(apart(reversed, DQuat::from_axis_angle(DVec3::Z, PI)) < 1e-12, "{reversed}");
        }
    }

    #[test]
    fn a_mirror_image_is_answered_by_a_rotation() {
        let wedge = WEDGE.map(DVec3::from_array);
        let mirrored = wedge.map(|point| point * DVec3::new(-1.0, 1.0, 1.0));
        for alignment in [Alignment::Pca, Alignment::Procrustes] {
            let found = between(&wedge, &mirrored, alignment);
            assert!((found.length() - 1.0).abs() < 1e-12 && found.w >= -HALF_TURN);
        }
    }

    #[test]
    fn formations_that_no_rotation_brings_together_are_not_turned() {
        let one_place = [DVec3::ONE; 4];
        let corners = [[1.0, 1.0, 1.0], [-1.0, -1.0, 1.0], [-1.0, 1.0, -1.0], [1.0, -1.0, -1.0]].map(DVec3::from_array);
        for alignment in [Alignment::Pca, Alignment::Procrustes] {
            assert_eq!(between(&corners, &one_place, alignment), DQuat::IDENTITY);
            assert_eq!(between(&one_place, &one_place, alignment), DQuat::IDENTITY);
        }
    }
}
