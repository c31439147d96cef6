//! A keyframe's ties and eigenbasis, made once for as long as its positions and adjacency are the same objects.

use std::sync::{Arc, OnceLock};

use super::recent::Recent;
use crate::adjacency::{self, Adjacency, AdjacencySpec};
use crate::error::Error;
use crate::formation::Formation;
use crate::scene::{Group, Scene, group_ties};
use crate::spectral::Eigenbasis;

/// Eigenbases of a few thousand agents are 100 MB each; a show of 23 keyframes of 200 agents takes 8 MB in all.
const BYTE_LIMIT: usize = 192 << 20;

/// The ties of one formation and what follows from them alone.
#[derive(Debug)]
pub(super) struct Graph {
    /// Who is tied to whom.
    pub(super) adjacency: Arc<Adjacency>,
    eigenbasis: OnceLock<Arc<Eigenbasis>>,
}

impl Graph {
    /// The eigenbasis of its Laplacian, once somebody found it.
    pub(super) fn known_eigenbasis(&self) -> Option<Arc<Eigenbasis>> {
        self.eigenbasis.get().cloned()
    }

    /// Keeps the eigenbasis of its Laplacian for the next who asks.
    pub(super) fn remember(&self, eigenbasis: &Arc<Eigenbasis>) {
        self.eigenbasis.get_or_init(|| eigenbasis.clone());
    }
}

/// Identity, not content: an immutable object is its own key, and the key keeps it alive.
#[derive(Clone, Debug)]
struct Key {
    formation: Arc<Formation>,
    spec: Arc<AdjacencySpec>,
    groups: Arc<Vec<Group>>,
}

impl PartialEq for Key {
    fn eq(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.formation, &other.formation) && Arc::ptr_eq(&self.spec, &other.spec) && Arc::ptr_eq(&self.groups, &other.groups)
    }
}

/// The graphs of the keyframes seen lately.
#[derive(Debug)]
pub(super) struct Graphs(Recent<Key, Arc<Graph>>);

impl Default for Graphs {
    fn default() -> Self {
        Self(Recent::new(BYTE_LIMIT))
    }
}

impl Graphs {
    /// The graph of a keyframe of `scene`: its own adjacency, or else the scene's.
    pub(super) fn of(&mut self, scene: &Scene, keyframe: usize) -> Result<Arc<Graph>, Error> {
        let at = &scene.main_track().keyframes[keyframe];
        let spec = at.adjacency.as_ref().unwrap_or(&scene.adjacency);
        let key = Key { formation: at.positions.clone(), spec: spec.clone(), groups: scene.groups.clone() };
        if let Some(graph) = self.0.get(&key) {
            return Ok(graph);
        }
        let adjacency = adjacency::build(&at.positions, spec, &group_ties(&scene.groups)).map_err(|refused| refused.at(keyframe))?;
        let graph = Arc::new(Graph { adjacency: Arc::new(adjacency), eigenbasis: OnceLock::new() });
        let agent_count = at.positions.agent_count();
        self.0.put(key, graph.clone(), agent_count * agent_count * size_of::<f64>());
        Ok(graph)
    }
}
