//! Exponentials and logarithms of rotations, through the planes in which they turn.
//!
//! A general matrix exponential costs ten products and a general logarithm loses digits where angles repeat; in its planes a rotation
//! is only angles.

use faer::{Mat, MatRef};

use super::eigenspaces::Eigenspaces;
use super::planes::Planes;
use glam::DVec2;

use crate::trig::direction;
use eigenform_dense::{columns, lower_square, product, skew_part, symmetric_eigen};

impl Planes {
    /// The planes of exp(`skew`), of a skew-symmetric matrix, in O(n³); its angles are not reduced to half turns.
    ///
    /// The Cayley transform Q = (I + B)(I − B)⁻¹, B = skew/2, turns in the same planes by 2 atan(θ/2) < π, and needs no inverse: in
    /// eigenvectors v of `BᵀB` with value b², (1 + b²) Q v = (1 − b²) v + 2 B v.
    pub(crate) fn of_logarithm(skew: MatRef<'_, f64>) -> Self {
        let eigen = symmetric_eigen(lower_square(skew).as_ref());
        let squares: Vec<f64> = eigen.values.iter().map(|value| 0.25 * value.max(0.0)).collect();
        let negative_cosines: Vec<f64> = squares.iter().map(|square| (square - 1.0) / (1.0 + square)).collect();
        let spaces = Eigenspaces::new(&negative_cosines, eigen.vectors);
        let leading = spaces.leading();
        let mut image = product(skew, leading.as_ref());
        for (column, leader) in spaces.leaders().into_iter().enumerate() {
            let square = squares[leader];
            let (along, across) = ((1.0 - square) / (1.0 + square), 1.0 / (1.0 + square));
            for (entry, own) in image.col_mut(column).iter_mut().zip(leading.col(column).iter()) {
                *entry = along * own + across * *entry;
            }
        }
        let cayley = Self::within(&spaces, image.as_ref());
        let angles = cayley.angles().iter().map(|angle| 2.0 * libm::tan(0.5 * angle)).collect();
        Self::with_angles(cayley.basis().to_owned(), angles)
    }

    /// The same turns of all agents about the constant: `modes_in_planes` (agents × modes) with the constant mode as the last column,
    /// which stays.
    pub(super) fn over_agents(&self, modes_in_planes: MatRef<'_, f64>) -> Self {
        let (agent_count, mode_count) = (modes_in_planes.nrows(), modes_in_planes.ncols());
        let constant = (agent_count as f64).sqrt().recip();
        let basis = Mat::from_fn(
            agent_count,
            agent_count,
            |row, column| {
                if column < mode_count { modes_in_planes[(row, column)] } else { constant }
            },
        );
        Self::with_angles(basis, self.angles().to_vec())
    }

    /// The rotation to the power `factor`, in the same planes.
    pub(crate) fn scaled(&self, factor: f64) -> Self {
        Self::with_angles(self.basis().to_owned(), self.angles().iter().map(|angle| factor * angle).collect())
    }

    /// The greatest angle, radians; 0 for what does not turn.
    pub(crate) fn greatest_angle(&self) -> f64 {
        self.angles().iter().map(|angle| angle.abs()).fold(0.0, f64::max)
    }

    /// The skew-symmetric K with exp(K) = the rotation, half a product.
    pub(crate) fn logarithm(&self) -> Mat<f64> {
        let basis = self.basis();
        let starts = self.angles().iter().enumerate().map(|(plane, _)| 2 * plane);
        // K = Σ θ (w vᵀ − v wᵀ) is twice the skew part of Σ θ w vᵀ.
        let mut turned = columns(basis, &starts.clone().map(|start| start + 1).collect::<Vec<_>>());
        for (mut column, angle) in turned.col_iter_mut().zip(self.angles()) {
            column *= faer::Scale(2.0 * angle);
        }
        let from = columns(basis, &starts.collect::<Vec<_>>());
        skew_part(product(turned.as_ref(), from.transpose()).as_ref())
    }

    /// The rotation to the power `power` as a matrix, one product.
    pub(crate) fn matrix(&self, power: f64) -> Mat<f64> {
        let mut turned = self.basis().to_owned();
        for (plane, angle) in self.angles().iter().enumerate() {
            let DVec2 { x: cos, y: sin } = direction(power * angle);
            for row in 0..turned.nrows() {
                let (v, w) = (turned[(row, 2 * plane)], turned[(row, 2 * plane + 1)]);
                (turned[(row, 2 * plane)], turned[(row, 2 * plane + 1)]) = (v * cos + w * sin, w * cos - v * sin);
            }
        }
        product(turned.as_ref(), self.basis().transpose())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A skew matrix with the given angles in planes at random.
    fn skew(size: usize, angles: &[f64], seed: u64) -> Mat<f64> {
        let mut state = seed;
        let mut next = || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (state >> 11) as f64 / (1_u64 << 53) as f64 - 0.5
        };
        let basis = symmetric_eigen(Mat::from_fn(size, size, |_, _| next()).as_ref()).vectors;
        Planes::with_angles(basis, angles.to_vec()).logarithm()
    }

    fn check(name: &str, size: usize, angles: &[f64]) {
        let logarithm = skew(size, angles, 5 + size as u64);
        let planes = Planes::of_logarithm(logarithm.as_ref());
        let scale = angles.iter().copied().fold(1.0, f64::max);
        // As for rotations: orthogonality and the cuts between runs cost some n · eps; tan widens an angle's error by 1 + θ²/4.
        let tolerance = 1e-11 * scale * (1.0 + 0.25 * scale * scale);
        let error = (planes.logarithm() - &logarithm).norm_max();
        assert!(error < tolerance, "{name} n={size}: off by {error:e}");
        let root = planes.matrix(0.5);
        assert!((&root * &root - planes.matrix(1.0)).norm_max() < 1e-12, "{name} n={size}: the root squared");
        if scale < std::f64::consts::PI {
            let again = Planes::of(planes.matrix(1.0).as_ref());
            assert!((again.logarithm() - &logarithm).norm_max() < tolerance, "{name} n={size}: there and back");
        }
    }

    #[test]
    fn the_logarithm_of_the_exponential_is_where_it_started() {
        for size in [2, 3, 5, 8, 30, 61, 150] {
            let count = size / 2;
            let each = |f: &dyn Fn(f64) -> f64| (0..count).map(|k| f((k as f64 + 0.5) / count as f64)).collect::<Vec<f64>>();
            check("spread", size, &each(&|u| 3.0 * u));
            check("beyond a half turn", size, &each(&|u| 6.0 * u));
            check("nothing", size, &[]);
            check("one small turn", size, &[1e-6]);
            check("graded", size, &each(&|u| 10.0_f64.powf(-11.0 * u)));
            check("alike", size, &vec![1.2; count]);
        }
    }

    #[test]
    fn velocities_are_the_logarithm_applied() {
        let logarithm = skew(9, &[0.3, 1.5, 2.9], 3);
        let planes = Planes::of_logarithm(logarithm.as_ref());
        let rows: Vec<DVec2> = (0..9).map(|i| DVec2::new(f64::from(i), 4.0 - f64::from(i * i))).collect();
        for (row, velocity) in planes.velocities(&rows).into_iter().enumerate() {
            let expected: DVec2 = rows.iter().enumerate().map(|(column, p)| *p * logarithm[(row, column)]).sum();
            // Three products of nine terms up to 60.
            assert!(velocity.distance(expected) < 1e-11, "{velocity} {expected}");
        }
    }
}
