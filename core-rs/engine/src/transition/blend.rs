//! Several transitions at once, each with its share.

use glam::DVec2;

use super::Transition;

/// The weighted mean of transitions of the same agents; shares sum to 1.
pub(super) struct Blend(Vec<(Box<dyn Transition>, f64)>);

impl Blend {
    pub(super) fn new(parts: Vec<(Box<dyn Transition>, f64)>) -> Self {
        Self(parts)
    }
}

impl Transition for Blend {
    fn agent_count(&self) -> usize {
        self.0[0].0.agent_count()
    }

    fn evaluate_into(&self, ts: &[f64], out: &mut [DVec2]) {
        let mut places = vec![DVec2::ZERO; out.len()];
        out.fill(DVec2::ZERO);
        for (part, share) in &self.0 {
            part.evaluate_into(ts, &mut places);
            out.iter_mut().zip(&places).for_each(|(mixed, place)| *mixed += *share * *place);
        }
    }
}
