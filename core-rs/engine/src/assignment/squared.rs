//! Least total squared distance between two formations.

use glam::DVec2;

use super::augment::{Search, bearable_prices_into};
use super::costs::{Costs, SquaredDistances};
use super::{Assignment, solve};
use crate::formation::Formation;

/// Below this many agents a coarse problem costs more than it saves.
const COARSE_FROM: usize = 64;

/// When more than this fraction of the agents is left over by row reduction, prices of a coarse problem are tried.
///
/// Scattered agents leave a sixth and gain nothing from it; drawn shapes leave up to nine tenths and gain a factor of ten or more.
const COARSE_WORTHWHILE: f64 = 0.2;

/// The assignment of the agents of `source` to the slots of `target` with the least sum of squared distances; else as [`super::solve`].
///
/// # Panics
/// When the formations differ in number.
pub fn squared(source: &Formation, target: &Formation) -> Assignment {
    if !source.places().is_level() || !target.places().is_level() {
        return squared_in_space(source, target);
    }
    // Moving a formation as a whole changes the cost of every assignment alike, and the nearer they are, the less there is to search.
    let costs = SquaredDistances::new(centered(source), &centered(target));
    let mut search = start(&costs);
    search.finish();
    search.into_assignment()
}

/// Without the speed of the plane, which most scenes are in.
fn squared_in_space(source: &Formation, target: &Formation) -> Assignment {
    assert_eq!(source.agent_count(), target.agent_count(), "as many sources as targets");
    // About both barycenters: moving a formation as a whole changes the cost of every assignment alike.
    let [from, to] = [source, target].map(|formation| formation.places().about_barycenter());
    solve(from.len(), |agent, slot| from[agent].distance_squared(to[slot]))
}

/// Positions about the barycenter, rounded so coarsely that coordinates on a grid stay exact and ties stay ties.
fn centered(formation: &Formation) -> Vec<DVec2> {
    let extent = formation.extent();
    // By its exponent, not its logarithm, which is not the same on every machine.
    let step = if extent > 0.0 { libm::ldexp(1.0, libm::ilogb(extent) - 6) } else { 1.0 };
    let middle = (formation.barycenter() / step).round() * step;
    formation.positions().iter().map(|&position| position - middle).collect()
}

/// A search with the better of two starts: no prices, or those of the same problem with half of the agents.
///
/// Both problems sample one continuous transport problem, so what each coarse source pays prices every target of the fine one.
fn start(costs: &SquaredDistances) -> Search<'_, SquaredDistances> {
    let agent_count = costs.agent_count();
    let mut plain = Search::new(costs, vec![0.0; agent_count]);
    plain.reduce();
    if agent_count < COARSE_FROM || (plain.free_sources().len() as f64) <= COARSE_WORTHWHILE * agent_count as f64 {
        return plain;
    }
    let coarse = costs.halved();
    let mut coarse_search = start(&coarse);
    coarse_search.finish();
    let mut prices = vec![0.0; agent_count];
    bearable_prices_into(&costs.with_half_the_sources(), &coarse_search.least_payments(), &mut prices);
    let mut informed = Search::new(costs, prices);
    informed.reduce();
    if informed.lower_bound() > plain.lower_bound() { informed } else { plain }
}
