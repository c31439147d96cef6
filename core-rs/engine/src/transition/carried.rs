//! A basis carried by several rotations in a row, each to a power of its own, while the coefficients run.

use std::sync::Arc;

use faer::{Mat, MatMut, MatRef};
use glam::DVec2;

use super::Transition;
use super::modal::{Drift, Modes};
use crate::spectral::{Passage, Planes, cubic_weights, product, product_into};

/// The power of a rotation over t.
#[derive(Clone, Copy, Debug)]
pub(super) enum Power {
    /// It leaves the start at three times this rate and stands at the end: rate · (1 − (1 − t)³).
    Leaving(f64),
    /// It stands at both ends: 3t² − 2t³.
    Crossing,
    /// It stands at the start and reaches the end at three times this rate: rate · t³.
    Arriving(f64),
    /// The weight of the source, the target or the keyframe after it in paper A's equation 5, with its tension.
    Source(f64),
    Target(f64),
    Beyond(f64),
}

impl Power {
    fn at(self, t: f64) -> f64 {
        let [source, leaving, target, arriving] = cubic_weights(t);
        match self {
            Self::Leaving(rate) => rate * (1.0 - (1.0 - t).powi(3)),
            Self::Crossing => target,
            Self::Arriving(rate) => rate * t.powi(3),
            Self::Source(tension) => source - tension * arriving,
            Self::Target(tension) => target + tension * leaving,
            Self::Beyond(tension) => tension * arriving,
        }
    }
}

/// X(t) = `R₃^p₃ R₂^p₂ R₁^p₁` S C(t) + b(t): no power of a matrix is formed, each rotation acts in its planes.
pub(super) struct Carried {
    turns: Vec<(Arc<Planes>, Power)>,
    /// From the modes into the planes of the first rotation, then from planes to planes.
    links: Vec<Mat<f64>>,
    mode_count: usize,
    coefficients: Passage,
    drift: Drift,
}

impl Carried {
    /// Plans it: one product of matrices a rotation. `modes` is agents × modes, at least one rotation acts, the first first.
    pub(super) fn new(modes: MatRef<'_, f64>, turns: Vec<(Arc<Planes>, Power)>, coefficients: Passage, drift: Drift) -> Self {
        let mut links = vec![product(turns[0].0.basis().transpose(), modes)];
        links.extend(turns.windows(2).map(|pair| product(pair[1].0.basis().transpose(), pair[0].0.basis())));
        Self { turns, links, mode_count: modes.ncols(), coefficients, drift }
    }
}

impl Transition for Carried {
    fn agent_count(&self) -> usize {
        self.links[0].nrows()
    }

    fn evaluate_into(&self, ts: &[f64], plan: &mut [DVec2], heights: Option<&mut [f64]>) {
        let agent_count = self.agent_count();
        let Some((last, _)) = self.turns.last() else { return };
        let mut within = Vec::new();
        Modes::level(last.basis()).evaluate(&|t| self.drift.at(t), ts, (plan, heights), &mut |ts, columns| {
            within.resize(2 * ts.len() * self.mode_count, 0.0);
            self.coefficients.write_columns(ts, &mut within);
            for (link, (planes, power)) in self.links.iter().zip(&self.turns) {
                product_into(
                    MatMut::from_column_major_slice_mut(columns, agent_count, 2 * ts.len()),
                    link.as_ref(),
                    MatRef::from_column_major_slice(&within, link.ncols(), 2 * ts.len()),
                );
                for (t, columns) in ts.iter().zip(columns.chunks_exact_mut(2 * agent_count)) {
                    planes.turn(power.at(*t), columns);
                }
                within.resize(columns.len(), 0.0);
                within.copy_from_slice(columns);
            }
        });
    }
}
