//! Everything one segment's motion depends on.

use std::sync::Arc;

use super::cast::Cast;
use super::counterpart::Aside;
use super::levels::node_way;
use super::outline::outline;
use super::performed::Performed;
use super::travel::{Turnings, charted, travel};
use crate::adjacency::AdjacencySpec;
use crate::choice::{Choice, Join, MethodName, Timing};
use crate::edits::Outline;
use crate::formation::Formation;
use crate::recent::Same;
use crate::scene::{Agent, Group, Keyframe, Obstacle, PathSpec, Scene, Segment, TransitionSpec};
use crate::transition::{Chain, End, Travel, Way, Ways};

/// Two equal briefs have the same motion. Large parts are compared by identity.
///
/// It holds the keyframes that matter and no others: a moved agent performs the two segments at its keyframe under `separate`, one
/// more on either side where they meet with one velocity, and one more again where bases are shared.
#[derive(Clone)]
pub(super) struct Brief {
    keyframes: Vec<Seen>,
    pub(super) groups: Arc<Vec<Group>>,
    pub(super) agents: Arc<Vec<Agent>>,
    /// The segment runs from this one of the keyframes to the next.
    at: usize,
    /// Seconds from the departure at each of them to the arrival at the next.
    durations: Vec<f64>,
    /// The paths to travel between them.
    paths: Vec<Option<PathSpec>>,
    /// The segment.
    pub(super) own: Asked,
    /// Its neighbors where the agents pass without a stop.
    beside: [Option<Asked>; 2],
    join: Join,
    tension: f64,
    /// Whether somebody climbs anywhere in the show.
    is_in_space: bool,
    /// Departure from the source, scene seconds.
    pub(super) start: f64,
    /// Arrival at the target.
    pub(super) end: f64,
    pub(super) frame_rate: f64,
    pub(super) minimum_distance: f64,
    pub(super) obstacles: Arc<Vec<Obstacle>>,
    pub(super) seed: u32,
    /// What is asked beside the scene.
    pub(super) aside: Aside,
    /// Whom it is of, where it is not of everybody.
    pub(super) cast: Option<Arc<Cast>>,
    /// What it is a part of, where keyframes lie in its transition.
    pub(super) whole: Option<Same<Performed>>,
}

/// A keyframe as a segment sees it.
#[derive(Clone, Debug)]
struct Seen {
    /// Its number in the scene; the motion does not depend on it.
    index: usize,
    formation: Arc<Formation>,
    adjacency: Arc<AdjacencySpec>,
}

/// What a segment is asked to do.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Asked {
    pub(super) transition: TransitionSpec,
    /// What to use although the method is auto.
    held: Option<Choice>,
}

impl Asked {
    fn of(scene: &Scene, segment: usize, held: &[Option<Choice>]) -> Self {
        let Segment::Transition(transition) = &scene.main_track().segments[segment];
        Self { transition: transition.clone(), held: held.get(segment).copied().flatten() }
    }

    /// As a neighbor: when it runs does not matter there.
    fn beside(mut self) -> Self {
        self.transition.timing = Timing::default();
        self
    }

    /// The choice, a crowd's guide for a crowd; none where auto must find it.
    pub(super) fn given(&self) -> Option<Choice> {
        let TransitionSpec { method, order, alignment, sharing, chosen, crowd, .. } = self.transition;
        match method {
            MethodName::Auto => self.held.or(chosen),
            MethodName::Crowd => Some(Choice { method: crowd.guide, order, alignment, sharing }),
            _ => Some(Choice { method, order, alignment, sharing }),
        }
    }

    /// Whether its bases may move toward those of the keyframes beside.
    fn may_share(&self) -> bool {
        self.given().is_none_or(|choice| choice.method == MethodName::Spectral && choice.sharing > 0.0)
    }
}

impl Brief {
    /// Of segment `index`. `held`: by segment, what to use although it says `auto`; segments beyond its end hold nothing.
    pub(super) fn of(scene: &Scene, index: usize, held: &[Option<Choice>]) -> Self {
        let asked = |segment: usize| Asked::of(scene, segment, held);
        let own = asked(index);
        let before = (!is_stop(scene, index)).then(|| asked(index - 1).beside());
        let after = (!is_stop(scene, index + 1)).then(|| asked(index + 1).beside());
        let shares =
            scene.join == Join::Smooth && [Some(&own), before.as_ref(), after.as_ref()].into_iter().flatten().any(Asked::may_share);
        let (mut first, mut last) = (index, index + 1);
        for _ in 0..if shares { 2 } else { 1 } {
            first -= usize::from(!is_stop(scene, first));
            last += usize::from(!is_stop(scene, last));
        }
        Self::among(scene, index, [first, last], own, [before, after])
    }

    /// Of segment `index`, which is a part of a transition that runs from keyframe `first` to keyframe `last`: what is asked of it is
    /// to follow the motion of the `whole`, to bend it, and to keep agents apart.
    pub(super) fn part(scene: &Scene, index: usize, [first, last]: [usize; 2], whole: Arc<Performed>) -> Self {
        let Asked { transition, .. } = Asked::of(scene, first, &[]);
        let follow = TransitionSpec {
            method: MethodName::Linear,
            timing: Timing::Linear,
            avoidance: transition.avoidance,
            ..TransitionSpec::default()
        };
        let own = Asked { transition: follow, held: None };
        let [leaves, arrives] = whole.stops;
        let passes = [index > first || !leaves, index + 1 < last || !arrives];
        let brief = Self::among(scene, index, [first, last], own.clone(), passes.map(|is_passed| is_passed.then(|| own.clone())));
        Self { paths: vec![None; brief.paths.len()], join: Join::Smooth, whole: Some(Same(whole)), ..brief }
    }

    fn among(scene: &Scene, index: usize, [first, last]: [usize; 2], own: Asked, beside: [Option<Asked>; 2]) -> Self {
        let track = scene.main_track();
        let seen = |(index, keyframe): (usize, &Keyframe)| Seen {
            index,
            formation: keyframe.positions.clone(),
            adjacency: keyframe.adjacency.as_ref().unwrap_or(&scene.adjacency).clone(),
        };
        let departure = |keyframe: &Keyframe| keyframe.time + keyframe.hold;
        let known = &track.keyframes[first..=last];
        Self {
            keyframes: (first..).zip(known).map(seen).collect(),
            groups: scene.groups.clone(),
            agents: track.agents.clone(),
            at: index - first,
            durations: known.windows(2).map(|pair| pair[1].time - departure(&pair[0])).collect(),
            paths: track.segments[first..last].iter().map(|Segment::Transition(transition)| transition.path.clone()).collect(),
            own,
            beside,
            join: scene.join,
            tension: scene.tension,
            is_in_space: !track.keyframes.iter().all(|keyframe| keyframe.positions.places().is_level()),
            start: departure(&track.keyframes[index]),
            end: track.keyframes[index + 1].time,
            frame_rate: scene.frame_rate,
            minimum_distance: scene.minimum_distance,
            obstacles: scene.obstacles.clone(),
            seed: scene.seed,
            aside: Aside::default(),
            cast: None,
            whole: None,
        }
    }

    /// The same as a comparison asks for it.
    pub(super) fn compared(self, aside: Aside) -> Self {
        Self { aside, ..self }
    }

    /// The same as a part of what everybody does.
    pub(super) fn with_cast(self, cast: Option<Arc<Cast>>) -> Self {
        Self { cast, ..self }
    }

    /// The keyframes that it depends on, by number in its scene, in order.
    pub(super) fn keyframes(&self) -> impl Iterator<Item = usize> {
        self.keyframes.iter().map(|seen| seen.index)
    }

    /// The segment among those keyframes; `ends`: one each.
    pub(super) fn chain(&self, ends: Vec<End>) -> Chain {
        let join = if ends.len() == 2 { Join::Separate } else { self.join };
        let chain = Chain::new(ends, self.durations.clone(), self.at, join, self.tension);
        if self.is_in_space { chain.in_space() } else { chain }
    }

    /// The segment as it travels along paths; none where no path matters.
    pub(super) fn travel(&self, chain: &Chain, turnings: &mut Turnings) -> Option<Travel> {
        travel(chain, &self.paths, turnings)
    }

    /// The segment from keyframe `pair` of the chain to the next, without its neighbors, as methods see it.
    pub(super) fn alone(&self, chain: &Chain, pair: usize, turnings: &mut Turnings) -> Chain {
        let [from, to] = [pair, pair + 1].map(|end| chain.ends()[end].clone());
        charted(Chain::between(from, to), &self.paths[pair..=pair], turnings)
    }

    /// The segment before, itself and the one after, where they are known, each with the number of its source in the chain.
    pub(super) fn asked(&self) -> [Option<(usize, &Asked)>; 3] {
        let [before, after] = &self.beside;
        [before.as_ref().map(|asked| (self.at - 1, asked)), Some((self.at, &self.own)), after.as_ref().map(|asked| (self.at + 1, asked))]
    }

    /// The ways of the group at a path, where its segments go by groups: `ways` are those of the segments.
    pub(super) fn node_ways(&self, path: &[u32], ways: &Ways) -> Ways {
        let of = |asked: &Asked, way: Way| node_way(&asked.transition, path, way.choice);
        let [before, after] = &self.beside;
        Ways {
            before: before.as_ref().zip(ways.before).map(|(asked, way)| of(asked, way)),
            own: of(&self.own, ways.own),
            after: after.as_ref().zip(ways.after).map(|(asked, way)| of(asked, way)),
        }
    }

    /// Whether forces lead its agents.
    pub(super) fn has_crowd(&self) -> bool {
        self.own.transition.method == MethodName::Crowd || self.aside.counterpart.is_some()
    }

    fn has_edits(&self) -> bool {
        self.own.transition.avoidance || self.has_crowd()
    }

    /// What stands in the way.
    pub(super) fn outlines(&self) -> Vec<Outline> {
        self.obstacles.iter().map(|obstacle| outline(&obstacle.shape)).collect()
    }

    /// The number of the segment in its scene.
    pub(super) fn segment(&self) -> usize {
        self.keyframes[self.at].index
    }

    /// Whether the agents stop at the source and at the target.
    pub(super) fn stops(&self) -> [bool; 2] {
        [self.beside[0].is_none(), self.beside[1].is_none()]
    }

    /// Whether what stands in the way matters: agents keep clear of it, or are tied to it.
    fn knows_obstacles(&self) -> bool {
        self.has_edits() || self.keyframes.iter().any(|seen| !seen.adjacency.obstacle_ties.is_empty())
    }

    /// The fraction of the segment's time at a scene time.
    pub(super) fn fraction(&self, time: f64) -> f64 {
        (time - self.start) / (self.end - self.start)
    }
}

/// Whether the agents stop at a keyframe: every one where segments are separate, else the first, the last, corners, holds, and where
/// moving by groups begins or ends, since there is no one velocity for both.
fn is_stop(scene: &Scene, keyframe: usize) -> bool {
    let track = scene.main_track();
    let at = &track.keyframes[keyframe];
    let by_groups = |segment: usize| {
        let Segment::Transition(transition) = &track.segments[segment];
        transition.hierarchy
    };
    scene.join == Join::Separate
        || keyframe == 0
        || keyframe + 1 == track.keyframes.len()
        || at.corner
        || at.hold > 0.0
        || by_groups(keyframe - 1) != by_groups(keyframe)
}

impl PartialEq for Seen {
    fn eq(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.formation, &other.formation) && Arc::ptr_eq(&self.adjacency, &other.adjacency)
    }
}

impl PartialEq for Brief {
    fn eq(&self, other: &Self) -> bool {
        let numbers = |brief: &Self| [brief.start, brief.end, brief.frame_rate, brief.minimum_distance];
        // Keyframes alone have no join.
        let meets = |brief: &Self| (brief.keyframes.len() > 2).then_some((brief.join, brief.tension, brief.is_in_space));
        self.keyframes == other.keyframes
            && Arc::ptr_eq(&self.groups, &other.groups)
            && self.at == other.at
            && self.durations == other.durations
            && self.paths == other.paths
            && self.own == other.own
            && self.beside == other.beside
            && meets(self) == meets(other)
            && numbers(self) == numbers(other)
            && self.aside == other.aside
            && self.cast == other.cast
            && self.whole == other.whole
            && (!self.has_crowd() || have_same_bodies(&self.agents, &other.agents))
            && (!self.has_edits() || self.seed == other.seed)
            && (!self.knows_obstacles() || Arc::ptr_eq(&self.obstacles, &other.obstacles))
    }
}

/// Names and colors move nobody.
fn have_same_bodies(agents: &Arc<Vec<Agent>>, others: &Arc<Vec<Agent>>) -> bool {
    let bodies = |agents: &[Agent]| agents.iter().map(|agent| (agent.radius, agent.max_speed)).collect::<Vec<_>>();
    Arc::ptr_eq(agents, others) || bodies(agents) == bodies(others)
}
