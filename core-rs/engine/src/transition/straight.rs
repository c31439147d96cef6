//! Agents that go by places alone.

use glam::DVec3;

use super::chain::Chain;
use crate::choice::{Choice, MethodName};

/// Whether agents go by places alone; one agent has no modes.
pub(super) fn goes_straight(chain: &Chain, choice: &Choice) -> bool {
    choice.method == MethodName::Linear || chain.agent_count() < 2
}

/// How fast each agent passes keyframe `end` on a straight way, meters a second.
pub(super) fn straight_velocities(chain: &Chain, end: usize) -> Vec<DVec3> {
    (0..chain.agent_count()).map(|agent| chain.velocity(end, |end| chain.formation(end).places().at(agent))).collect()
}
