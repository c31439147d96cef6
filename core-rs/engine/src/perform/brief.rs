//! Everything one segment's motion depends on.

use std::sync::Arc;

use crate::adjacency::AdjacencySpec;
use crate::choice::Choice;
use crate::formation::Formation;
use crate::scene::{Group, Scene, Segment, TransitionSpec};

/// Two equal briefs have the same motion. Large parts are compared by identity.
#[derive(Clone, Debug)]
pub(super) struct Brief {
    pub(super) source: End,
    pub(super) target: End,
    groups: Arc<Vec<Group>>,
    pub(super) transition: TransitionSpec,
    /// What to use although the method is auto.
    pub(super) held: Option<Choice>,
    /// Departure from the source, scene seconds.
    pub(super) start: f64,
    /// Arrival at the target.
    pub(super) end: f64,
    pub(super) frame_rate: f64,
    pub(super) minimum_distance: f64,
}

/// A keyframe as a segment sees it.
#[derive(Clone, Debug)]
pub(super) struct End {
    pub(super) formation: Arc<Formation>,
    adjacency: Arc<AdjacencySpec>,
}

impl Brief {
    pub(super) fn of(scene: &Scene, index: usize, held: Option<Choice>) -> Self {
        let track = scene.main_track();
        let Segment::Transition(transition) = &track.segments[index];
        let [from, to] = [&track.keyframes[index], &track.keyframes[index + 1]];
        let end = |keyframe: &crate::scene::Keyframe| End {
            formation: keyframe.positions.clone(),
            adjacency: keyframe.adjacency.as_ref().unwrap_or(&scene.adjacency).clone(),
        };
        Self {
            source: end(from),
            target: end(to),
            groups: scene.groups.clone(),
            transition: transition.clone(),
            held,
            start: from.time + from.hold,
            end: to.time,
            frame_rate: scene.frame_rate,
            minimum_distance: scene.minimum_distance,
        }
    }
}

impl Brief {
    /// The parameter t at a scene time, by the segment's timing.
    pub(super) fn parameter(&self, time: f64) -> f64 {
        self.transition.timing.parameter((time - self.start) / (self.end - self.start))
    }
}

impl PartialEq for End {
    fn eq(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.formation, &other.formation) && Arc::ptr_eq(&self.adjacency, &other.adjacency)
    }
}

impl PartialEq for Brief {
    fn eq(&self, other: &Self) -> bool {
        let numbers = |brief: &Self| [brief.start, brief.end, brief.frame_rate, brief.minimum_distance];
        self.source == other.source
            && self.target == other.target
            && Arc::ptr_eq(&self.groups, &other.groups)
            && self.transition == other.transition
            && self.held == other.held
            && numbers(self) == numbers(other)
    }
}
