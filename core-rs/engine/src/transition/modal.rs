//! From coefficients in modes to places on the stage, many instants as one matrix product.

use faer::MatRef;
use glam::{DVec2, DVec3};

use super::chain::Chain;
use crate::formation::Formation;
use crate::spectral::{cubic_weights, product_into_columns};

/// The barycenters of both ends, by which a formation moves as a whole.
#[derive(Clone, Copy, Debug)]
pub(super) struct Barycenters([DVec3; 2]);

impl Barycenters {
    pub(super) fn of(formations: [&Formation; 2]) -> Self {
        Self(formations.map(|formation| formation.places().barycenter()))
    }

    pub(super) fn at(self, t: f64) -> DVec3 {
        self.0[0] * (1.0 - t) + self.0[1] * t
    }
}

/// The barycenter's way past both ends of a segment: a cubic of its place, velocity × duration, place, velocity × duration.
#[derive(Clone, Copy, Debug)]
pub(super) struct Drift([DVec3; 4]);

impl Drift {
    /// Along the chain's segment.
    pub(super) fn of(chain: &Chain) -> Self {
        let center = |end: usize| chain.formation(end).places().barycenter();
        let duration = chain.duration(chain.at());
        let [source, target] = [chain.at(), chain.at() + 1].map(|end| [center(end), duration * chain.velocity(end, center)]);
        Self([source[0], source[1], target[0], target[1]])
    }

    pub(super) fn at(self, t: f64) -> DVec3 {
        cubic_weights(t).into_iter().zip(self.0).map(|(weight, part)| weight * part).sum()
    }
}

/// What moves: modes, agents × modes, or where there are none the agents themselves; and the columns that their coefficients have at
/// each instant, x and y and in space z.
#[derive(Clone, Copy)]
pub(super) struct Modes<'m> {
    pub(super) agent_count: usize,
    pub(super) basis: Option<MatRef<'m, f64>>,
    pub(super) dimensions: usize,
}

impl<'m> Modes<'m> {
    /// Modes on the plane.
    pub(super) fn level(basis: MatRef<'m, f64>) -> Self {
        Self { agent_count: basis.nrows(), basis: Some(basis), dimensions: 2 }
    }

    /// Writes modes · coefficients + center for every t; heights where they are asked for.
    ///
    /// `coefficients_into(ts, columns)` fills the columns of every t.
    pub(super) fn evaluate(
        self,
        center_at: &dyn Fn(f64) -> DVec3,
        ts: &[f64],
        (plan, mut heights): (&mut [DVec2], Option<&mut [f64]>),
        coefficients_into: &mut dyn FnMut(&[f64], &mut [f64]),
    ) {
        let agent_count = self.agent_count;
        let mode_count = self.basis.map_or(agent_count, |basis| basis.ncols());
        assert_eq!(plan.len(), ts.len() * agent_count, "a place for every agent at every t");
        let column_count = self.dimensions * ts.len();
        let mut away = vec![0.0; column_count * mode_count];
        // One agent is its own barycenter.
        if mode_count > 0 {
            coefficients_into(ts, &mut away);
        }
        if let Some(basis) = self.basis {
            let coefficients = std::mem::replace(&mut away, vec![0.0; column_count * agent_count]);
            if mode_count > 0 {
                product_into_columns(&mut away, basis, &coefficients);
            }
        }
        for (k, t) in ts.iter().enumerate() {
            let frame = k * agent_count..(k + 1) * agent_count;
            let away = &away[self.dimensions * k * agent_count..][..self.dimensions * agent_count];
            let heights = heights.as_deref_mut().map(|heights| &mut heights[frame.clone()]);
            write_frame(center_at(*t), away, &mut plan[frame], heights);
        }
    }
}

/// Writes the places of one instant from columns x, y and, in space, z about a center.
fn write_frame(center: DVec3, columns: &[f64], plan: &mut [DVec2], heights: Option<&mut [f64]>) {
    let (x, rest) = columns.split_at(plan.len());
    let (y, z) = rest.split_at(plan.len());
    for (place, (x, y)) in plan.iter_mut().zip(x.iter().zip(y)) {
        *place = center.truncate() + DVec2::new(*x, *y);
    }
    if let Some(heights) = heights {
        heights.fill(center.z);
        heights.iter_mut().zip(z).for_each(|(height, z)| *height += z);
    }
}
