//! The modes behind a motion, for whoever wants to look at them.

use std::sync::Arc;

use super::Performer;
use super::travel::charted;
use super::whole::Whole;
use crate::error::Error;
use crate::scene::{Scene, Segment};
use crate::spectral::{Eigenbasis, ModeMatch, eigenvalues_between};
use crate::transition::{Chain, End};

impl Performer {
    /// The eigenbasis of those who stand in a keyframe, kept for the motions that need it, and their numbers, ascending: an entry of
    /// each mode is theirs in this order.
    pub fn eigenbasis(&mut self, scene: &Scene, keyframe: usize) -> Result<(Arc<Eigenbasis>, Arc<Vec<u32>>), Error> {
        let everybody = || Arc::new((0..scene.main_track().agents.len() as u32).collect());
        let (adjacency, there) = match self.casting.standing(scene, keyframe) {
            None => (self.graphs.of(scene, keyframe)?, everybody()),
            Some((part, there)) => (self.graphs.of(&part, keyframe)?, there),
        };
        Ok((self.planner.eigenbasis(&adjacency), there))
    }

    /// How alike the modes at both ends of segment `index` are, or of the transition that it is a part of: of the very bases that
    /// spectral turns into one another.
    pub fn mode_match(&mut self, scene: &Scene, index: usize) -> Result<ModeMatch, Error> {
        let (scene, index) = self.walked(scene, index);
        let scene = &scene;
        let chain = Chain::between(self.end(scene, index)?, self.end(scene, index + 1)?);
        let Segment::Transition(transition) = &scene.main_track().segments[index];
        let chart = charted(chain, std::slice::from_ref(&transition.path), &mut self.turnings);
        let [source, target] = [0, 1].map(|end| chart.ends()[end].clone());
        Ok(self.planner.mode_match(source, target))
    }

    /// Eigenvalues of the graph that runs straight from one end of that to the other, at t = 0, 1/steps, …, 1.
    pub fn eigenvalues_between(&mut self, scene: &Scene, index: usize, steps: usize) -> Result<Vec<Vec<f64>>, Error> {
        let (scene, index) = self.walked(scene, index);
        let scene = &scene;
        let [source, target] = [self.graph(scene, index)?, self.graph(scene, index + 1)?];
        Ok(eigenvalues_between(&source.laplacian(), &target.laplacian(), steps))
    }

    /// The scene of those who walk a transition, and its number there.
    fn walked(&mut self, scene: &Scene, index: usize) -> (Scene, usize) {
        match Whole::of(scene, index, &[]) {
            Some(whole) => (self.casting.of(&whole.scene, whole.index).0, whole.index),
            None => (self.casting.of(scene, index).0, index),
        }
    }

    /// A keyframe with its ties.
    pub(super) fn end(&mut self, scene: &Scene, keyframe: usize) -> Result<End, Error> {
        let formation = scene.main_track().keyframes[keyframe].positions.clone();
        Ok(End { formation, adjacency: self.graph(scene, keyframe)? })
    }
}
