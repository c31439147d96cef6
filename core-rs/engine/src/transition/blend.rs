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

    fn matrix_count(&self) -> usize {
        self.0.iter().map(|(part, _)| part.matrix_count()).sum()
    }

    fn evaluate_into(&self, ts: &[f64], plan: &mut [DVec2], mut heights: Option<&mut [f64]>) {
        let mut places = vec![DVec2::ZERO; plan.len()];
        let mut rises = vec![0.0; heights.as_ref().map_or(0, |heights| heights.len())];
        plan.fill(DVec2::ZERO);
        if let Some(heights) = heights.as_deref_mut() {
            heights.fill(0.0);
        }
        for (part, share) in &self.0 {
            part.evaluate_into(ts, &mut places, heights.is_some().then_some(&mut rises[..]));
            plan.iter_mut().zip(&places).for_each(|(mixed, place)| *mixed += *share * *place);
            if let Some(heights) = heights.as_deref_mut() {
                heights.iter_mut().zip(&rises).for_each(|(mixed, rise)| *mixed += *share * *rise);
            }
        }
    }
}
