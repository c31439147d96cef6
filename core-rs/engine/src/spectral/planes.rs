//! A rotation taken apart into the planes in which it turns.
//!
//! Only symmetric eigenproblems are solved: a general eigensolver loses half the digits where angles repeat.

use std::f64::consts::PI;

use crate::trig::direction;
use faer::{Mat, MatRef};
use glam::{DVec2, DVec3};

use super::eigenspaces::Eigenspaces;
use super::invariant::Block;
use eigenform_dense::{columns, product, product_into_columns, symmetric_eigen, symmetric_part};

/// A rotation Q = Z Θ Zᵀ: Z orthogonal, Θ turning pairs of coordinates.
#[derive(Clone, Debug)]
pub(crate) struct Planes {
    basis: Mat<f64>,
    /// Positive, one a plane; at most π where a rotation was taken apart, which has no other turns.
    angles: Vec<f64>,
}

impl Planes {
    /// Takes an orthogonal matrix of determinant +1 apart, in O(n³).
    ///
    /// Directions that are reversed pair up, as they appear, into half turns.
    ///
    /// # Panics
    /// When the determinant is −1: a bug, the matching makes it +1.
    pub(crate) fn of(rotation: MatRef<'_, f64>) -> Self {
        let eigen = symmetric_eigen(symmetric_part(rotation).as_ref());
        let spaces = Eigenspaces::new(&eigen.values, eigen.vectors);
        let image = product(rotation, spaces.leading().as_ref());
        Self::within(&spaces, image.as_ref())
    }

    /// From the eigenspaces of the symmetric part and the image of their leaders under the rotation.
    pub(super) fn within(spaces: &Eigenspaces, image: MatRef<'_, f64>) -> Self {
        let mut angles = Vec::new();
        let mut turning = Vec::new();
        let mut reversed = Vec::new();
        let mut fixed = Vec::new();
        // Columns of `found` in the order of the spaces; the lists say which are what.
        let mut found = Mat::zeros(spaces.dimension(), spaces.dimension());
        let mut column = 0;
        for parts in spaces.split(image) {
            found.subcols_mut(column, parts.basis.ncols()).copy_from(&parts.basis);
            for block in parts.blocks {
                match block {
                    Block::Fixed => fixed.push(column),
                    Block::Reversed => reversed.push(column),
                    Block::Plane(angle) => {
                        angles.push(angle);
                        turning.extend([column, column + 1]);
                    }
                }
                column += block.dimension();
            }
        }
        assert!(reversed.len().is_multiple_of(2), "a rotation reverses an even number of directions");
        angles.extend(std::iter::repeat_n(PI, reversed.len() / 2));
        let order: Vec<usize> = turning.into_iter().chain(reversed).chain(fixed).collect();
        Self { basis: columns(found.as_ref(), &order), angles }
    }

    /// Z: columns 2j and 2j + 1 span plane j; the columns after the last plane stay where they are.
    pub(crate) fn basis(&self) -> MatRef<'_, f64> {
        self.basis.as_ref()
    }

    /// The angles in radians: positive, one a plane.
    pub(crate) fn angles(&self) -> &[f64] {
        &self.angles
    }

    /// The same planes with other angles, one a plane.
    pub(super) fn with_angles(basis: Mat<f64>, angles: Vec<f64>) -> Self {
        Self { basis, angles }
    }

    /// Turns columns of coordinates, which lie one after the other: so many for each of `powers`, by that power of the rotation.
    pub(crate) fn turn_columns(&self, powers: &[f64], columns: &mut [f64]) {
        let each = columns.len() / powers.len().max(1);
        self.in_planes(columns, &|columns| {
            for (power, columns) in powers.iter().zip(columns.chunks_exact_mut(each.max(1))) {
                self.turn(*power, columns);
            }
        });
    }

    /// The same within the planes.
    fn turn(&self, power: f64, columns: &mut [f64]) {
        let size = self.basis.ncols();
        for (plane, angle) in self.angles.iter().enumerate() {
            let DVec2 { x: cos, y: sin } = direction(power * angle);
            for start in (2 * plane..columns.len()).step_by(size) {
                let (x, y) = (columns[start], columns[start + 1]);
                (columns[start], columns[start + 1]) = (x * cos - y * sin, x * sin + y * cos);
            }
        }
    }

    /// Coordinates, a row each, turned by `power` of the rotation.
    pub(crate) fn turned(&self, coordinates: &[DVec2], power: f64) -> Vec<DVec2> {
        self.acted_on(coordinates, &|columns| self.turn(power, columns))
    }

    /// The same for rows that have heights; where nobody has one the plane is all there is.
    pub(super) fn turned_in_space(&self, coordinates: &[DVec3], power: f64) -> Vec<DVec3> {
        let count = coordinates.len();
        let dimensions = if coordinates.iter().all(|row| row.z == 0.0) { 2 } else { 3 };
        let mut columns = vec![0.0; 3 * count];
        for axis in 0..dimensions {
            columns[axis * count..][..count].iter_mut().zip(coordinates).for_each(|(entry, row)| *entry = row[axis]);
        }
        self.turn_columns(&[power], &mut columns[..dimensions * count]);
        (0..count).map(|row| DVec3::new(columns[row], columns[count + row], columns[2 * count + row])).collect()
    }

    /// How fast coordinates, a row each, move when the rotation's power grows by one a second: its logarithm times them.
    pub(crate) fn velocities(&self, coordinates: &[DVec2]) -> Vec<DVec2> {
        let size = self.basis.ncols();
        self.acted_on(coordinates, &|columns| {
            for column in columns.chunks_exact_mut(size) {
                for (pair, angle) in column.chunks_exact_mut(2).zip(&self.angles) {
                    (pair[0], pair[1]) = (-angle * pair[1], angle * pair[0]);
                }
                column[2 * self.angles.len()..].fill(0.0);
            }
        })
    }

    fn acted_on(&self, coordinates: &[DVec2], act: &dyn Fn(&mut [f64])) -> Vec<DVec2> {
        let mut columns: Vec<f64> = coordinates.iter().map(|row| row.x).chain(coordinates.iter().map(|row| row.y)).collect();
        self.in_planes(&mut columns, act);
        let (x, y) = columns.split_at(coordinates.len());
        x.iter().zip(y).map(|(x, y)| DVec2::new(*x, *y)).collect()
    }

    /// Takes columns of coordinates into the planes, has them acted on, and takes them back.
    fn in_planes(&self, columns: &mut [f64], act: &dyn Fn(&mut [f64])) {
        let mut within = vec![0.0; columns.len()];
        product_into_columns(&mut within, self.basis.transpose(), columns);
        act(&mut within);
        product_into_columns(columns, self.basis.as_ref(), &within);
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::TAU;

    use super::*;

    fn numbers(seed: u64) -> impl FnMut() -> f64 {
        let mut state = seed;
        move || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (state >> 11) as f64 / (1_u64 << 53) as f64
        }
    }

    fn orthogonal(size: usize, seed: u64) -> Mat<f64> {
        let mut next = numbers(seed);
        let random = Mat::from_fn(size, size, |_, _| next() - 0.5);
        symmetric_eigen(random.as_ref()).vectors
    }

    /// A rotation with the given angles in planes at random; a lone last direction stays.
    fn rotation(size: usize, angles: &[f64], seed: u64) -> Mat<f64> {
        let basis = orthogonal(size, seed);
        let mut turned = basis.clone();
        for (plane, angle) in angles.iter().enumerate() {
            let (sin, cos) = angle.sin_cos();
            for row in 0..size {
                let (v, w) = (basis[(row, 2 * plane)], basis[(row, 2 * plane + 1)]);
                turned[(row, 2 * plane)] = v * cos + w * sin;
                turned[(row, 2 * plane + 1)] = w * cos - v * sin;
            }
        }
        product(turned.as_ref(), basis.transpose())
    }

    fn power(planes: &Planes, power: f64) -> Mat<f64> {
        let size = planes.basis().nrows();
        let mut columns: Vec<f64> =
            planes.basis().transpose().to_owned().col_iter().flat_map(|c| c.iter().copied().collect::<Vec<_>>()).collect();
        planes.turn(power, &mut columns);
        product(planes.basis(), MatRef::from_column_major_slice(&columns, size, size))
    }

    fn check(name: &str, angles: &[f64], size: usize) {
        let matrix = rotation(size, angles, 11 + size as u64);
        let planes = Planes::of(matrix.as_ref());
        // Orthogonality of Z and the runs' cuts cost some n · eps; 1e-10 is what the ends of a 1 km formation bear.
        let error = (power(&planes, 1.0) - &matrix).norm_max();
        assert!(error < 1e-11, "{name} n={size}: off by {error:e}");
        let orthogonality = (planes.basis().transpose() * planes.basis() - Mat::<f64>::identity(size, size)).norm_max();
        assert!(orthogonality < 1e-12, "{name} n={size}: Z off by {orthogonality:e}");
        assert!(planes.angles.iter().all(|angle| (0.0..=PI).contains(angle)), "{name}");
        let half = power(&planes, 0.5);
        assert!((&half * &half - &matrix).norm_max() < 1e-11, "{name} n={size}: the root squared");
        let mut expected: Vec<f64> = angles.iter().map(|a| (a - TAU * (a / TAU).round()).abs()).filter(|a| *a > 1e-11).collect();
        let mut found: Vec<f64> = planes.angles.iter().copied().filter(|a| *a > 1e-11).collect();
        expected.sort_by(f64::total_cmp);
        found.sort_by(f64::total_cmp);
        assert_eq!(expected.len(), found.len(), "{name} n={size}: number of planes");
        for (expected, found) in expected.iter().zip(&found) {
            assert!((expected - found).abs() < 1e-11, "{name} n={size}: {found} for {expected}");
        }
    }

    #[test]
    fn a_rotation_is_the_product_of_its_planes_whatever_its_angles() {
        for size in [2, 3, 4, 5, 8, 13, 30, 61, 200] {
            let count = size / 2;
            let each = |f: &dyn Fn(f64) -> f64| (0..count).map(|k| f((k as f64 + 0.5) / count as f64)).collect::<Vec<f64>>();
            check("spread", &each(&|u| PI * u), size);
            check("both ways", &each(&|u| PI * (2.0 * u - 1.0)), size);
            check("identity", &[], size);
            check("one small turn", &[1e-6], size);
            check("tiny", &each(&|u| 1e-5 * u), size);
            check("graded", &each(&|u| 10.0_f64.powf(-11.0 * u)), size);
            check("near half turns", &each(&|u| PI - 1e-5 * u), size);
            check("graded half turns", &each(&|u| PI - 10.0_f64.powf(-11.0 * u)), size);
            check("half turns", &each(&|_| PI), size);
            check("all the same", &each(&|_| 1.25), size);
            check("quarter turns", &each(&|_| PI / 2.0), size);
            check("three kinds", &each(&|u| [0.0, TAU / 3.0, PI][(3.0 * u) as usize]), size);
            check("nearly the same", &each(&|u| 0.7 + 1e-8 * u), size);
            check("nearly quarter turns", &each(&|u| PI / 2.0 + 1e-8 * u), size);
            check("nearly quarter turns, nearer", &each(&|u| PI / 2.0 + 1e-12 * u), size);
        }
    }

    #[test]
    fn a_reversed_pair_is_a_half_turn() {
        let mut matrix: Mat<f64> = Mat::identity(5, 5);
        matrix[(1, 1)] = -1.0;
        matrix[(3, 3)] = -1.0;
        assert_eq!(Planes::of(matrix.as_ref()).angles, [PI]);
    }

    #[test]
    #[should_panic(expected = "even number")]
    fn a_reflection_is_no_rotation() {
        let mut matrix: Mat<f64> = Mat::identity(3, 3);
        matrix[(0, 0)] = -1.0;
        Planes::of(matrix.as_ref());
    }
}
