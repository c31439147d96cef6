//! Agents tied to obstacles: the paths they keep to, how near they come, and what keeping apart leaves them.

use std::collections::BTreeSet;
use std::sync::Arc;

use super::avoid::outline;
use crate::edits::{Blocked, Hold, nearest_to};
use crate::motion::Motion;
use crate::scene::Obstacle;
use crate::transition::{self, Chain, Transition};

/// The path with tied agents held to their obstacles.
pub(super) fn held(path: Arc<dyn Transition>, chain: &Chain, obstacles: &[Obstacle]) -> Arc<dyn Transition> {
    let shapes: Vec<_> = obstacles.iter().map(|obstacle| &obstacle.shape).collect();
    transition::held(path, chain, &shapes)
}

/// The nearest that anybody comes to an obstacle that they are tied to at either end.
pub(super) fn nearest(motion: &Motion, chain: &Chain, obstacles: &[Obstacle]) -> Option<Blocked> {
    let nearest = |(agent, obstacle): (u32, u32)| nearest_to(motion, agent, obstacle, &outline(&obstacles[obstacle as usize].shape));
    let tied = tied(chain, 0.0);
    tied.into_iter().map(nearest).min_by(|a, b| a.distance.total_cmp(&b.distance))
}

/// Where keeping apart must leave agents that are tied at both ends, if that is farther than everybody keeps: no nearer than they are.
pub(super) fn holds(guide: &Motion, chain: &Chain, obstacles: &[Obstacle], minimum_distance: f64) -> Vec<Hold> {
    let hold = |(agent, obstacle): (u32, u32)| {
        let outline = outline(&obstacles[obstacle as usize].shape);
        let distance = nearest_to(guide, agent, obstacle, &outline).distance;
        (distance > minimum_distance).then_some(Hold { agent, obstacle, distance })
    };
    tied(chain, 1.0).into_iter().filter_map(hold).collect()
}

/// Agents with the obstacles that they are tied to: at both ends, if `factor` is above 0, with at least that.
fn tied(chain: &Chain, factor: f64) -> BTreeSet<(u32, u32)> {
    let at = |end: usize| -> BTreeSet<(u32, u32)> {
        let ties = chain.ends()[end].adjacency.obstacle_ties().iter();
        ties.filter(|tie| tie.factor >= factor).map(|tie| (tie.agent, tie.obstacle)).collect()
    };
    let [source, target] = [at(chain.at()), at(chain.at() + 1)];
    if factor > 0.0 { &source & &target } else { &source | &target }
}
