//! Cubics through both keyframes with given velocities: a path on its own, or what bends another to meet its neighbors.

use glam::{DVec2, DVec3};

use super::Transition;
use crate::spectral::cubic_weights;

/// By agent: the place at the start, the velocity there times the duration, the place at the end, the velocity there times the
/// duration; meters.
#[derive(Clone, Debug)]
pub(super) struct Cubic([Vec<DVec3>; 4]);

impl Cubic {
    pub(super) fn new(parts: [Vec<DVec3>; 4]) -> Self {
        Self(parts)
    }

    /// Adds itself to the places at each t.
    fn add_into(&self, ts: &[f64], plan: &mut [DVec2], mut heights: Option<&mut [f64]>) {
        let agent_count = self.0[0].len();
        for (k, t) in ts.iter().enumerate() {
            let frame = k * agent_count..(k + 1) * agent_count;
            for (weight, part) in cubic_weights(*t).into_iter().zip(&self.0) {
                plan[frame.clone()].iter_mut().zip(part).for_each(|(place, own)| *place += weight * own.truncate());
                if let Some(heights) = heights.as_deref_mut() {
                    heights[frame.clone()].iter_mut().zip(part).for_each(|(height, own)| *height += weight * own.z);
                }
            }
        }
    }
}

impl Transition for Cubic {
    fn agent_count(&self) -> usize {
        self.0[0].len()
    }

    fn evaluate_into(&self, ts: &[f64], plan: &mut [DVec2], mut heights: Option<&mut [f64]>) {
        plan.fill(DVec2::ZERO);
        if let Some(heights) = heights.as_deref_mut() {
            heights.fill(0.0);
        }
        self.add_into(ts, plan, heights);
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

    fn matrix_count(&self) -> usize {
        self.path.matrix_count()
    }

    fn evaluate_into(&self, ts: &[f64], plan: &mut [DVec2], mut heights: Option<&mut [f64]>) {
        self.path.evaluate_into(ts, plan, heights.as_deref_mut());
        self.lacks.add_into(ts, plan, heights);
    }
}
