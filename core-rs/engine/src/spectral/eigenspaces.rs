//! The eigenspaces of a rotation's symmetric part: the rotation keeps each of them to itself.

use std::ops::Range;

use faer::{Mat, MatRef};

use super::invariant::{Blocks, split, turning};
use super::runs::runs;
use eigenform_dense::{columns, product};

/// Cosines nearer than this are taken together: the symmetric part cannot tell their planes apart (round-off is eps over the
/// gap), the skew part can.
const EQUAL_COSINES: f64 = 1e-8;

/// Orthonormal vectors, a column each, in runs of equal cosines.
pub(super) struct Eigenspaces {
    vectors: Mat<f64>,
    runs: Vec<Range<usize>>,
}

impl Eigenspaces {
    /// Of eigenvectors of the symmetric part. `values` ascend and are equal where the cosines are: the cosines themselves or their
    /// negatives.
    pub(super) fn new(values: &[f64], vectors: Mat<f64>) -> Self {
        Self { vectors, runs: runs(values, EQUAL_COSINES) }
    }

    /// How many dimensions they have together.
    pub(super) fn dimension(&self) -> usize {
        self.vectors.nrows()
    }

    /// The columns whose images say what the rotation does: all, save the second of two alone, which turns with the first.
    pub(super) fn leaders(&self) -> Vec<usize> {
        self.runs.iter().flat_map(|run| run.start..run.start + image_count(run)).collect()
    }

    /// The vectors of the leaders.
    pub(super) fn leading(&self) -> Mat<f64> {
        columns(self.vectors.as_ref(), &self.leaders())
    }

    /// Every space split into lines and planes, with a basis of it that follows them; `image` is that of the leaders.
    pub(super) fn split<'a>(&'a self, image: MatRef<'a, f64>) -> impl Iterator<Item = Blocks> + 'a {
        let mut first = 0;
        self.runs.iter().map(move |run| {
            let own = self.vectors.subcols(run.start, run.len());
            let restricted = product(own.transpose(), image.subcols(first, image_count(run)));
            first += image_count(run);
            let parts = if run.len() == 2 { turning(restricted[(0, 0)], restricted[(1, 0)]) } else { split(restricted.as_ref()) };
            Blocks { basis: product(own, parts.basis.as_ref()), ..parts }
        })
    }
}

fn image_count(run: &Range<usize>) -> usize {
    if run.len() == 2 { 1 } else { run.len() }
}
