//! A basis carried by several rotations in a row, each to a power of its own, while the coefficients run.

use std::sync::Arc;

use glam::DVec2;

use super::Transition;
use super::modal::{Drift, Modes};
use crate::spectral::{Pair, Passage, Planes, cubic_weights, product_into_columns};

/// The power of a rotation over t.
#[derive(Clone, Copy, Debug)]
pub(super) enum Power {
    /// The same throughout.
    Always(f64),
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
            Self::Always(power) => power,
            Self::Leaving(rate) => rate * (1.0 - (1.0 - t).powi(3)),
            Self::Crossing => target,
            Self::Arriving(rate) => rate * t.powi(3),
            Self::Source(tension) => source - tension * arriving,
            Self::Target(tension) => target + tension * leaving,
            Self::Beyond(tension) => tension * arriving,
        }
    }
}

/// X(t) = `R₃^p₃ R₂^p₂ R₁^p₁` S C(t) + b(t): no power of a matrix is formed, and none is multiplied by another: each rotation acts on
/// the agents' places in its planes.
pub(super) struct Carried {
    pair: Arc<Pair>,
    /// The first acts first.
    turns: Vec<(Arc<Planes>, Power)>,
    coefficients: Passage,
    drift: Drift,
}

impl Carried {
    /// The source modes of a pair, carried.
    pub(super) fn new(pair: Arc<Pair>, turns: Vec<(Arc<Planes>, Power)>, coefficients: Passage, drift: Drift) -> Self {
        Self { pair, turns, coefficients, drift }
    }
}

impl Transition for Carried {
    fn agent_count(&self) -> usize {
        self.pair.source_modes().nrows()
    }

    fn matrix_count(&self) -> usize {
        3 + self.turns.len()
    }

    fn evaluate_into(&self, ts: &[f64], plan: &mut [DVec2], heights: Option<&mut [f64]>) {
        let modes = self.pair.source_modes();
        let agents = Modes { agent_count: modes.nrows(), basis: None, dimensions: 2 };
        agents.evaluate(&|t| self.drift.at(t), ts, (plan, heights), &mut |ts, columns| {
            let mut in_modes = vec![0.0; 2 * ts.len() * modes.ncols()];
            self.coefficients.write_columns(ts, &mut in_modes);
            product_into_columns(columns, modes, &in_modes);
            for (planes, power) in &self.turns {
                let powers: Vec<f64> = ts.iter().map(|t| power.at(*t)).collect();
                planes.turn_columns(&powers, columns);
            }
        });
    }
}
