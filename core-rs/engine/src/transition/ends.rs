//! What a transition runs between.

use std::sync::Arc;

use crate::adjacency::Adjacency;
use crate::formation::Formation;
use crate::spectral::Eigenbasis;

/// One end of a transition.
#[derive(Clone, Debug)]
pub struct End {
    /// Where the agents stand.
    pub formation: Arc<Formation>,
    /// Who keeps place with whom.
    pub adjacency: Arc<Adjacency>,
    /// The eigenbasis of the adjacency's Laplacian, where it is known already.
    pub basis: Option<Arc<Eigenbasis>>,
}

/// Both ends of a transition: the same agents.
#[derive(Clone, Debug)]
pub struct Ends {
    /// Where it starts.
    pub source: End,
    /// Where it arrives.
    pub target: End,
}

impl Ends {
    /// # Panics
    /// When formations and adjacencies are not of the same agents: a bug, the document guarantees it.
    pub fn new(source: End, target: End) -> Self {
        let agent_count = source.formation.agent_count();
        let counts = [source.adjacency.agent_count(), target.formation.agent_count(), target.adjacency.agent_count()];
        assert_eq!(counts, [agent_count; 3], "both ends are of the same agents");
        Self { source, target }
    }

    /// How many agents.
    pub fn agent_count(&self) -> usize {
        self.source.formation.agent_count()
    }

    pub(super) fn formations(&self) -> [&Formation; 2] {
        [&self.source.formation, &self.target.formation]
    }
}
