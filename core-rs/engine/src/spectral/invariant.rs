//! An orthogonal matrix whose angles are nearly alike, split into invariant lines and planes.
//!
//! Where all cosines agree the symmetric part says nothing more; K = (Q − Qᵀ)/2 does: v and K v span a plane that Q turns.

use faer::{Mat, MatRef};

use super::runs::runs;
use eigenform_dense::{largest, norm, product, skew_part, symmetric_eigen};

/// Sines below this are round-off of the eigensolver, not turns.
const NO_TURN: f64 = 1e-12;

/// Where 1 − |cos θ| is below this, sines separate angles better than cosines do; elsewhere the eigenvectors of the symmetric part
/// are separated as far as round-off allows.
const FLAT_COSINE: f64 = 1e-6;

/// Squared sines nearer than this, relative to the greatest, are taken together.
const EQUAL_SQUARED_SINES: f64 = 1e-8;

/// What one or two columns of a basis do under the matrix.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Block {
    /// A direction that stays.
    Fixed,
    /// A direction that is reversed.
    Reversed,
    /// Two directions that turn by an angle in (0, π), the first toward the second.
    Plane(f64),
}

impl Block {
    /// How many columns it takes.
    pub(super) fn dimension(self) -> usize {
        if matches!(self, Self::Plane(_)) { 2 } else { 1 }
    }
}

/// An orthogonal basis and what its columns do, in their order.
pub(super) struct Blocks {
    pub(super) basis: Mat<f64>,
    pub(super) blocks: Vec<Block>,
}

/// Splits two dimensions of one cosine, of which the first turns toward the second with this cosine and sine: the second does what
/// the first does.
pub(super) fn turning(cosine: f64, sine: f64) -> Blocks {
    if sine.abs() <= NO_TURN {
        return Blocks { basis: Mat::identity(2, 2), blocks: vec![line(cosine); 2] };
    }
    plane(cosine, sine)
}

/// Splits an orthogonal matrix given in a basis of eigenvectors of its symmetric part.
pub(super) fn split(matrix: MatRef<'_, f64>) -> Blocks {
    let size = matrix.nrows();
    let skew = skew_part(matrix);
    if size == 1 || largest(skew.as_ref()) <= NO_TURN {
        return Blocks { basis: Mat::identity(size, size), blocks: (0..size).map(|k| line(matrix[(k, k)])).collect() };
    }
    if size == 2 {
        return plane(f64::midpoint(matrix[(0, 0)], matrix[(1, 1)]), skew[(1, 0)]);
    }
    let cosine = (0..size).map(|k| matrix[(k, k)]).sum::<f64>() / size as f64;
    if 1.0 - cosine.abs() > FLAT_COSINE {
        return deflate(matrix, skew.as_ref(), Mat::identity(size, size));
    }
    let squared = product(skew.transpose(), skew.as_ref());
    let eigen = symmetric_eigen(squared.as_ref());
    let parts = runs(&eigen.values, EQUAL_SQUARED_SINES * eigen.values[size - 1]);
    if parts.len() == 1 {
        return deflate(matrix, skew.as_ref(), eigen.vectors);
    }
    let image = product(matrix, eigen.vectors.as_ref());
    let mut basis = Mat::zeros(size, size);
    let mut blocks = Vec::new();
    for part in parts {
        let own = eigen.vectors.subcols(part.start, part.len());
        let inner = split(product(own.transpose(), image.subcols(part.start, part.len())).as_ref());
        basis.subcols_mut(part.start, part.len()).copy_from(product(own, inner.basis.as_ref()));
        blocks.extend(inner.blocks);
    }
    Blocks { basis, blocks }
}

fn line(cosine: f64) -> Block {
    if cosine < 0.0 { Block::Reversed } else { Block::Fixed }
}

/// Two dimensions: the basis is kept, its second direction reversed where the first turns away from it.
fn plane(cosine: f64, sine: f64) -> Blocks {
    let mut basis = Mat::identity(2, 2);
    basis[(1, 1)] = sine.signum();
    Blocks { basis, blocks: vec![Block::Plane(libm::atan2(sine.abs(), cosine))] }
}

/// Takes a direction v, its plane with K v, and goes on in what is left, until nothing is.
///
/// The next direction is the candidate least spent, so nothing is divided by a small number.
fn deflate(matrix: MatRef<'_, f64>, skew: MatRef<'_, f64>, mut candidates: Mat<f64>) -> Blocks {
    let size = matrix.nrows();
    let mut basis = Mat::zeros(size, size);
    let mut blocks = Vec::new();
    let mut taken = 0;
    while taken < size {
        let left: Vec<f64> = candidates.col_iter().map(|column| norm(column.as_mat())).collect();
        let most = left.iter().copied().fold(0.0, f64::max);
        let next = left.iter().position(|left| *left >= most * (1.0 - 1e-9)).expect("the most is one of them");
        basis.col_mut(taken).copy_from(candidates.col(next));
        orthonormalize(&mut basis, taken);
        let turned = skew * basis.col(taken);
        let cosine = basis.col(taken).transpose() * (matrix * basis.col(taken));
        let first = taken;
        taken += 1;
        if norm(turned.as_mat()) <= NO_TURN || taken == size {
            blocks.push(line(cosine));
        } else {
            basis.col_mut(taken).copy_from(&turned);
            orthonormalize(&mut basis, taken);
            let across = basis.col(taken).transpose() * &turned;
            blocks.push(Block::Plane(libm::atan2(across, cosine)));
            taken += 1;
        }
        for mut candidate in candidates.col_iter_mut() {
            for spent in first..taken {
                let amount = basis.col(spent).transpose() * candidate.as_ref();
                candidate -= faer::Scale(amount) * basis.col(spent);
            }
        }
    }
    Blocks { basis, blocks }
}

/// Makes column `index` a unit vector orthogonal to the columns before it; twice is enough.
fn orthonormalize(basis: &mut Mat<f64>, index: usize) {
    for _ in 0..2 {
        let (before, rest) = basis.as_mut().split_at_col_mut(index);
        let mut own = rest.col_mut(0);
        for column in before.as_ref().col_iter() {
            let amount = column.transpose() * own.as_ref();
            own -= faer::Scale(amount) * column;
        }
        let length = norm(own.as_ref().as_mat());
        own /= faer::Scale(length);
    }
}
