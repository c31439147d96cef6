//! Who is there: a segment that not everybody walks is a segment of a scene of those who do.
//!
//! An agent that is absent at a keyframe is not there while the others stand in it. Absent at both ends of a segment, it is not there on
//! the way either; at one end only, it walks to its place there and is gone with the arrival, or comes from there with the departure. So
//! a segment has one cast from its start to its end, and ties, measures and avoidance know nobody else. Where the cast changes from
//! one segment to the next, everybody stops: there is no one velocity for all.

mod fill;

pub(super) use fill::among_all;

use std::sync::Arc;

use crate::adjacency::AdjacencySpec;
use crate::formation::Formation;
use crate::recent::{Recent, Same};
use crate::scene::{Group, Scene, Track};

/// A show of 1,260 agents at 200 keyframes takes 4 MB.
const BYTE_LIMIT: usize = 32 << 20;

/// Those who walk a segment, where not everybody does.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Cast {
    /// Ascending.
    there: Arc<Vec<u32>>,
    /// Everybody, at both ends: who is absent is put straight between.
    ends: [Same<Formation>; 2],
}

/// Parts of scenes for casts; equal casts of one part have the same object.
#[derive(Default)]
pub(super) struct Casting {
    formations: Kept<Formation>,
    groups: Kept<Vec<Group>>,
    ties: Kept<AdjacencySpec>,
}

impl Casting {
    /// The scene that segment `index` is performed in, and its cast where that is not everybody.
    pub(super) fn of(&mut self, scene: &Scene, index: usize) -> (Scene, Option<Arc<Cast>>) {
        let mut scene = scene.clone();
        let track = &mut scene.tracks[0];
        if track.keyframes.iter().all(|keyframe| keyframe.absent.is_empty()) {
            return (scene, None);
        }
        let casts: Vec<Vec<u32>> = (0..track.segments.len()).map(|segment| there(track, segment)).collect();
        for (keyframe, casts) in track.keyframes[1..].iter_mut().zip(casts.windows(2)) {
            keyframe.corner |= casts[0] != casts[1];
        }
        track.keyframes.iter_mut().for_each(|keyframe| keyframe.absent.clear());
        let there = casts.into_iter().nth(index).expect("a segment of the scene");
        if there.len() == track.agents.len() {
            return (scene, None);
        }
        let ends = [index, index + 1].map(|end| Same(track.keyframes[end].positions.clone()));
        let cast = Cast { there: Arc::new(there), ends };
        self.restrict(&mut scene, &cast.there);
        (scene, Some(Arc::new(cast)))
    }

    /// The scene of some agents.
    fn restrict(&mut self, scene: &mut Scene, there: &Arc<Vec<u32>>) {
        let places = places(there, scene.main_track().agents.len());
        let track = &mut scene.tracks[0];
        track.agents = Arc::new(there.iter().map(|agent| track.agents[*agent as usize].clone()).collect());
        for keyframe in &mut track.keyframes {
            keyframe.positions = self.formations.of(there, &keyframe.positions, |formation| formation.only(there));
            keyframe.adjacency = keyframe.adjacency.take().map(|own| self.ties.of(there, &own, |spec| among(spec, &places)));
        }
        scene.groups = self.groups.of(there, &scene.groups, |groups| within(groups, &places));
        scene.adjacency = self.ties.of(there, &scene.adjacency, |spec| among(spec, &places));
    }

    /// A scene's part at a keyframe, where somebody is absent: those who stand there and their numbers.
    pub(super) fn standing(&mut self, scene: &Scene, keyframe: usize) -> Option<(Scene, Arc<Vec<u32>>)> {
        let at = &scene.main_track().keyframes[keyframe];
        if at.absent.is_empty() {
            return None;
        }
        let there = Arc::new(others(&at.absent, scene.main_track().agents.len()));
        let mut scene = scene.clone();
        scene.tracks[0].keyframes[keyframe].absent.clear();
        self.restrict(&mut scene, &there);
        Some((scene, there))
    }
}

/// Who is not absent at both ends of a segment.
fn there(track: &Track, segment: usize) -> Vec<u32> {
    let gone = track.keyframes[segment].absent_too(&track.keyframes[segment + 1]);
    others(&gone, track.agents.len())
}

/// All agents but some, which ascend.
fn others(gone: &[u32], agent_count: usize) -> Vec<u32> {
    (0..agent_count as u32).filter(|agent| gone.binary_search(agent).is_err()).collect()
}

/// By agent its number among those who are there.
fn places(there: &[u32], agent_count: usize) -> Vec<Option<u32>> {
    let mut places = vec![None; agent_count];
    for (place, agent) in (0..).zip(there) {
        places[*agent as usize] = Some(place);
    }
    places
}

/// Groups keep their paths, also without anybody.
fn within(groups: &[Group], places: &[Option<u32>]) -> Vec<Group> {
    let group = |group: &Group| Group {
        members: group.members.iter().filter_map(|agent| places[*agent as usize]).collect(),
        children: within(&group.children, places),
        ..group.clone()
    };
    groups.iter().map(group).collect()
}

fn among(spec: &AdjacencySpec, places: &[Option<u32>]) -> AdjacencySpec {
    let place = |agent: u32| places[agent as usize];
    AdjacencySpec {
        ties: spec.ties.iter().filter_map(|&(a, b, factor)| Some((place(a)?, place(b)?, factor))).collect(),
        cuts: spec.cuts.iter().filter_map(|&(a, b)| Some((place(a)?, place(b)?))).collect(),
        obstacle_ties: spec.obstacle_ties.iter().filter_map(|&(agent, obstacle, factor)| Some((place(agent)?, obstacle, factor))).collect(),
        ..spec.clone()
    }
}

/// What a part is of, and for whom.
type Key<T> = (Same<T>, Arc<Vec<u32>>);

struct Kept<T>(Recent<Key<T>, Arc<T>>);

impl<T> Default for Kept<T> {
    fn default() -> Self {
        Self(Recent::new(BYTE_LIMIT))
    }
}

impl<T> Kept<T> {
    fn of(&mut self, there: &Arc<Vec<u32>>, whole: &Arc<T>, part: impl FnOnce(&T) -> T) -> Arc<T> {
        let key = (Same(whole.clone()), there.clone());
        self.0.get(&key).unwrap_or_else(|| {
            let part = Arc::new(part(whole));
            self.0.put(key, part.clone(), 16 * there.len());
            part
        })
    }
}
