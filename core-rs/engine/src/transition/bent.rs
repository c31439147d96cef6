//! Paths that are made exact at their ends.

use glam::{DVec2, DVec3};

use super::Transition;
use super::chain::Chain;
use super::cubic::{Bent, Cubic};

/// A path bent so that it starts and ends exactly, and with velocities that lack nothing.
pub(super) fn bent(chain: &Chain, path: Box<dyn Transition>, velocity_lacks: [Option<Vec<DVec3>>; 2]) -> Box<dyn Transition> {
    let (at, agent_count) = (chain.at(), chain.agent_count());
    let ends = places_at(&*path, &[0.0, 1.0]);
    let (starts, stops) = ends.split_at(agent_count);
    let place_lack = |end: usize, found: &[DVec3]| chain.formation(end).places().iter().zip(found).map(|(p, q)| p - *q).collect();
    let duration = chain.duration(at);
    let [leaving, arriving] =
        velocity_lacks.map(|lacks| lacks.map_or(vec![DVec3::ZERO; agent_count], |l| l.into_iter().map(|v| duration * v).collect()));
    Box::new(Bent::new(path, Cubic::new([place_lack(at, starts), leaving, place_lack(at + 1, stops), arriving])))
}

/// Places at each t, sample by sample.
pub(super) fn places_at(path: &dyn Transition, ts: &[f64]) -> Vec<DVec3> {
    let count = ts.len() * path.agent_count();
    let (mut plan, mut heights) = (vec![DVec2::ZERO; count], vec![0.0; count]);
    path.evaluate_into(ts, &mut plan, Some(&mut heights));
    plan.into_iter().zip(heights).map(|(place, height)| place.extend(height)).collect()
}
