//! Who belongs together: the tree of groups, and proposals for one.
//!
//! Groups are sets of agent indices. This room knows graphs and positions, never names, colors or scenes.

mod affinity;
mod connected;
mod fiedler;
mod graph;
mod low_modes;
mod propose;
mod split;
mod tree;

pub use affinity::{AffinityJob, MOST_SAMPLED, Metric, Preference};
pub use propose::{MOST_LEVELS, MOST_PARTS, Way, propose};
pub use tree::{Node, Part, Tree};

use serde::Serialize;

/// A group by its members: agents of its own and groups within.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Branch {
    /// Agents of its own, beside its children's.
    pub members: Vec<u32>,
    /// Groups within; nobody is in two of them.
    pub children: Vec<Branch>,
}

impl Branch {
    /// A group without groups within.
    pub fn leaf(members: Vec<u32>) -> Self {
        Self { members, children: Vec::new() }
    }
}
