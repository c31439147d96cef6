//! A keyframe's ties, made once for as long as its positions and adjacency are the same objects.

use std::sync::Arc;

use crate::adjacency::{self, Adjacency, AdjacencySpec};
use crate::error::Error;
use crate::formation::Formation;
use crate::recent::{Recent, Same};
use crate::scene::{Group, Obstacle, Scene, group_ties};

/// A show of 23 keyframes of 200 agents takes 2 MB in all.
const BYTE_LIMIT: usize = 64 << 20;

/// What ties follow from, by identity.
#[derive(Clone, Debug, PartialEq)]
struct Key {
    formation: Same<Formation>,
    spec: Same<AdjacencySpec>,
    groups: Same<Vec<Group>>,
    /// Where somebody is tied to them.
    obstacles: Option<Same<Vec<Obstacle>>>,
}

/// The ties of the keyframes seen lately.
#[derive(Debug)]
pub(super) struct Graphs(Recent<Key, Arc<Adjacency>>);

impl Default for Graphs {
    fn default() -> Self {
        Self(Recent::new(BYTE_LIMIT))
    }
}

impl Graphs {
    /// The ties of a keyframe of `scene`: its own adjacency, or else the scene's.
    pub(super) fn of(&mut self, scene: &Scene, keyframe: usize) -> Result<Arc<Adjacency>, Error> {
        let at = &scene.main_track().keyframes[keyframe];
        let spec = at.adjacency.as_ref().unwrap_or(&scene.adjacency);
        let obstacles = (!spec.obstacle_ties.is_empty()).then(|| Same(scene.obstacles.clone()));
        let key = Key { formation: Same(at.positions.clone()), spec: Same(spec.clone()), groups: Same(scene.groups.clone()), obstacles };
        if let Some(known) = self.0.get(&key) {
            return Ok(known);
        }
        let adjacency = adjacency::build(&at.positions, spec, &group_ties(&scene.groups)).map_err(|refused| refused.at(keyframe))?;
        let centers: Vec<_> = scene.obstacles.iter().map(|obstacle| obstacle.shape.center()).collect();
        let adjacency = Arc::new(adjacency.with_obstacle_ties(adjacency::obstacle_ties(&at.positions, spec, &centers)));
        self.0.put(key, adjacency.clone(), size_of_val(adjacency.ties()) + size_of_val(at.positions.positions()));
        Ok(adjacency)
    }
}
