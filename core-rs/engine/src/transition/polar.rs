//! Polar coordinates about the barycenter, agent by agent: the paper's simple polar interpolation (paper A, section 3.3).

use glam::DVec2;

use super::modal::Barycenters;
use super::{Ends, Transition};
use crate::choice::Alignment;
use crate::formation::Formation;
use crate::spectral::{Coefficients, turn_between};

/// Every agent turns about the barycenter while its distance from it runs linearly.
#[derive(Clone, Debug)]
pub(super) struct Polar {
    agent_count: usize,
    places: Coefficients,
    barycenters: Barycenters,
}

impl Polar {
    /// Plans it; ties do not matter.
    pub(super) fn new(ends: &Ends, alignment: Alignment) -> Self {
        let formations = ends.formations();
        let turn = turn_between(formations[0], formations[1], alignment);
        let [source, target] = formations.map(about_barycenter);
        Self {
            agent_count: ends.agent_count(),
            places: Coefficients::between(&source, &target, turn),
            barycenters: Barycenters::of(formations),
        }
    }
}

impl Transition for Polar {
    fn agent_count(&self) -> usize {
        self.agent_count
    }

    fn evaluate_into(&self, ts: &[f64], out: &mut [DVec2]) {
        assert_eq!(out.len(), ts.len() * self.agent_count, "a place for every agent at every t");
        let mut columns = vec![0.0; 2 * self.agent_count];
        for (k, t) in ts.iter().enumerate() {
            self.places.write_columns(&[*t], &mut columns);
            let (x, y) = columns.split_at(self.agent_count);
            let center = self.barycenters.at(*t);
            for (place, (x, y)) in out[k * self.agent_count..][..self.agent_count].iter_mut().zip(x.iter().zip(y)) {
                *place = center + DVec2::new(*x, *y);
            }
        }
    }
}

fn about_barycenter(formation: &Formation) -> Vec<DVec2> {
    let center = formation.barycenter();
    formation.positions().iter().map(|p| *p - center).collect()
}
