//! Groups of those whom firm ties connect.

use super::Branch;
use crate::adjacency::{Adjacency, Components};

/// A group for every two or more of `agents` (ascending) that ties of at least `factor` connect; by their lowest agents.
pub(super) fn connected(adjacency: &Adjacency, agents: &[u32], factor: f64) -> Vec<Branch> {
    let mut components = Components::new(adjacency.agent_count());
    let is_among = |agent: u32| agents.binary_search(&agent).is_ok();
    for tie in adjacency.ties().iter().filter(|tie| tie.factor >= factor && is_among(tie.a) && is_among(tie.b)) {
        components.join(tie.a, tie.b);
    }
    components.lists().into_iter().filter(|list| list.len() > 1).map(Branch::leaf).collect()
}
