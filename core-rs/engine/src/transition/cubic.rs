//! Cubics through both keyframes with given velocities: a path on its own, or what bends another to meet its neighbors.

use glam::DVec2;

use super::Transition;
use crate::spectral::cubic_weights;

/// By agent: the place at the start, the velocity there times the duration, the place at the end, the velocity there times the
/// duration; meters.
#[derive(Clone, Debug)]
pub(super) struct Cubic([Vec<DVec2>; 4]);

impl Cubic {
    pub(super) fn new(parts: [Vec<DVec2>; 4]) -> Self {
        Self(parts)
    }

    fn add_into(&self, t: f64, out: &mut [DVec2]) {
        for (weight, part) in cubic_weights(t).into_iter().zip(&self.0) {
            out.iter_mut().zip(part).for_each(|(place, own)| *place += weight * *own);
        }
    }
}

impl Transition for Cubic {
    fn agent_count(&self) -> usize {
        self.0[0].len()
    }

    fn evaluate_into(&self, ts: &[f64], out: &mut [DVec2]) {
        out.fill(DVec2::ZERO);
        for (t, out) in ts.iter().zip(out.chunks_exact_mut(self.agent_count().max(1))) {
            self.add_into(*t, out);
        }
    }
}

/// A path plus what its places and velocities lack at both ends.
pub(super) struct Bent {
    path: Box<dyn Transition>,
    lacks: Cubic,
}

impl Bent {
    pub(super) fn new(path: Box<dyn Transition>, lacks: Cubic) -> Self {
        Self { path, lacks }
    }
}

impl Transition for Bent {
    fn agent_count(&self) -> usize {
        self.path.agent_count()
    }

    fn evaluate_into(&self, ts: &[f64], out: &mut [DVec2]) {
        self.path.evaluate_into(ts, out);
        for (t, out) in ts.iter().zip(out.chunks_exact_mut(self.agent_count().max(1))) {
            self.lacks.add_into(*t, out);
        }
    }
}
