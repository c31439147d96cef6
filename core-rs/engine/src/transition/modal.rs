//! From coefficients in modes to places on the stage, many instants as one matrix product.

use faer::{MatMut, MatRef};
use glam::DVec2;

use super::chain::Chain;
use crate::formation::Formation;
use crate::spectral::{cubic_weights, product_into};

/// How many instants share one product: enough to run at the product's full speed, few enough to bound its buffers.
const BATCH: usize = 64;

/// The barycenters of both ends, by which a formation moves as a whole.
#[derive(Clone, Copy, Debug)]
pub(super) struct Barycenters([DVec2; 2]);

impl Barycenters {
    pub(super) fn of(formations: [&Formation; 2]) -> Self {
        Self(formations.map(Formation::barycenter))
    }

    pub(super) fn at(self, t: f64) -> DVec2 {
        self.0[0] * (1.0 - t) + self.0[1] * t
    }
}

/// The barycenter's way past both ends of a segment: a cubic of its place, velocity × duration, place, velocity × duration.
#[derive(Clone, Copy, Debug)]
pub(super) struct Drift([DVec2; 4]);

impl Drift {
    /// Along the chain's segment.
    pub(super) fn of(chain: &Chain) -> Self {
        let center = |end: usize| chain.formation(end).barycenter();
        let duration = chain.duration(chain.at());
        let [source, target] = [chain.at(), chain.at() + 1].map(|end| [center(end), duration * chain.velocity(end, center)]);
        Self([source[0], source[1], target[0], target[1]])
    }

    pub(super) fn at(self, t: f64) -> DVec2 {
        cubic_weights(t).into_iter().zip(self.0).map(|(weight, part)| weight * part).sum()
    }
}

/// Writes coefficients + center for every t, where every agent is its own mode.
///
/// `coefficients_into(ts, columns)` fills two columns, x and y, for every t of a batch.
pub(super) fn evaluate_places(
    agent_count: usize,
    center_at: impl Fn(f64) -> DVec2,
    ts: &[f64],
    out: &mut [DVec2],
    coefficients_into: impl Fn(&[f64], &mut [f64]),
) {
    assert_eq!(out.len(), ts.len() * agent_count, "a place for every agent at every t");
    let mut columns = vec![0.0; 2 * agent_count];
    for (t, out) in ts.iter().zip(out.chunks_exact_mut(agent_count.max(1))) {
        coefficients_into(&[*t], &mut columns);
        let (x, y) = columns.split_at(agent_count);
        let center = center_at(*t);
        for (place, (x, y)) in out.iter_mut().zip(x.iter().zip(y)) {
            *place = center + DVec2::new(*x, *y);
        }
    }
}

/// Writes modes · coefficients + center for every t; `modes` is agents × modes.
///
/// `coefficients_into(ts, columns)` fills two columns, x and y, for every t of a batch.
pub(super) fn evaluate_modes(
    modes: MatRef<'_, f64>,
    center_at: impl Fn(f64) -> DVec2,
    ts: &[f64],
    out: &mut [DVec2],
    mut coefficients_into: impl FnMut(&[f64], &mut [f64]),
) {
    let (agent_count, mode_count) = (modes.nrows(), modes.ncols());
    assert_eq!(out.len(), ts.len() * agent_count, "a place for every agent at every t");
    if mode_count == 0 {
        // Nobody, or one agent that is its own barycenter.
        out.iter_mut().zip(ts).for_each(|(place, t)| *place = center_at(*t));
        return;
    }
    let batch = BATCH.min(ts.len());
    let mut columns = vec![0.0; 2 * batch * mode_count];
    let mut places = vec![0.0; 2 * batch * agent_count];
    for (ts, out) in ts.chunks(BATCH).zip(out.chunks_mut(BATCH * agent_count)) {
        let columns = &mut columns[..2 * ts.len() * mode_count];
        let places = &mut places[..2 * ts.len() * agent_count];
        coefficients_into(ts, columns);
        product_into(
            MatMut::from_column_major_slice_mut(places, agent_count, 2 * ts.len()),
            modes,
            MatRef::from_column_major_slice(columns, mode_count, 2 * ts.len()),
        );
        let frames = out.chunks_exact_mut(agent_count).zip(places.chunks_exact(2 * agent_count));
        for (t, (out, places)) in ts.iter().zip(frames) {
            let center = center_at(*t);
            let (x, y) = places.split_at(agent_count);
            for (place, (x, y)) in out.iter_mut().zip(x.iter().zip(y)) {
                *place = center + DVec2::new(*x, *y);
            }
        }
    }
}
