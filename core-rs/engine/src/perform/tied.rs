//! Agents tied to obstacles: the paths they keep to, how near they come, and what keeping apart leaves them.

use std::sync::Arc;

use super::outline::outline;
use crate::edits::{Blocked, Hold, nearest_to};
use crate::motion::Motion;
use crate::scene::Obstacle;
use crate::transition::{self, Chain, Tied, Transition, tied};

/// The path with tied agents held to their obstacles.
pub(super) fn held(path: Arc<dyn Transition>, chain: &Chain, obstacles: &[Obstacle]) -> Arc<dyn Transition> {
    let shapes: Vec<_> = obstacles.iter().map(|obstacle| &obstacle.shape).collect();
    transition::held(path, chain, &shapes)
}

/// The nearest that anybody comes to an obstacle that they are tied to at either end.
pub(super) fn nearest(motion: &Motion, chain: &Chain, obstacles: &[Obstacle]) -> Option<Blocked> {
    let nearest = |Tied { agent, obstacle, .. }| nearest_to(motion, agent, obstacle, &outline(&obstacles[obstacle as usize].shape));
    tied(chain).into_iter().map(nearest).min_by(|a, b| a.distance.total_cmp(&b.distance))
}

/// Where keeping apart must leave agents that are tied at both ends, if that is farther than everybody keeps: no nearer than they are.
pub(super) fn holds(guide: &Motion, chain: &Chain, obstacles: &[Obstacle], minimum_distance: f64) -> Vec<Hold> {
    let hold = |Tied { agent, obstacle, .. }| {
        let outline = outline(&obstacles[obstacle as usize].shape);
        let distance = nearest_to(guide, agent, obstacle, &outline).distance;
        (distance > minimum_distance).then_some(Hold { agent, obstacle, distance })
    };
    tied(chain).into_iter().filter(|tied| tied.factors.iter().all(|factor| *factor >= 1.0)).filter_map(hold).collect()
}
