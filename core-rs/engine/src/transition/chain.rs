//! What a transition runs between, and what it passes on the way.

use std::sync::Arc;

use glam::DVec3;

use crate::adjacency::Adjacency;
use crate::choice::{Choice, Join, MethodName};
use crate::formation::Formation;

/// Where agents stand at a keyframe and who keeps place with whom. Compared by identity.
#[derive(Clone, Debug)]
pub struct End {
    /// Where the agents stand.
    pub formation: Arc<Formation>,
    /// Who keeps place with whom.
    pub adjacency: Arc<Adjacency>,
}

impl PartialEq for End {
    fn eq(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.formation, &other.formation) && Arc::ptr_eq(&self.adjacency, &other.adjacency)
    }
}

/// Two keyframes next to each other. Compared by identity.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Couple {
    pub(super) source: End,
    pub(super) target: End,
}

impl Couple {
    pub(super) fn formations(&self) -> [&Formation; 2] {
        [&self.source.formation, &self.target.formation]
    }
}

/// A segment among the keyframes that its motion depends on: the same agents at each, passed without a stop.
///
/// The agents stop at the first and the last, or these are too far from the segment to matter: a segment depends on the next
/// keyframe on either side, and with sharing on one more. A group of barycenters is a chain like any other.
#[derive(Clone, Debug)]
pub struct Chain {
    ends: Vec<End>,
    durations: Vec<f64>,
    at: usize,
    join: Join,
    tension: f64,
    is_level: bool,
}

impl Chain {
    /// A segment on its own: it stops at both ends.
    ///
    /// # Panics
    /// As [`Chain::new`].
    pub fn between(source: End, target: End) -> Self {
        Self::new(vec![source, target], vec![1.0], 0, Join::Separate, 0.0)
    }

    /// The segment from `ends[at]` to `ends[at + 1]`; `durations[i]` seconds from `ends[i]` to the next. `join` is how it meets the
    /// segments beside it, with `tension` 0–1.
    ///
    /// # Panics
    /// When formations and adjacencies are not of the same agents, there is no such segment, or a separate one has neighbors: a bug.
    pub fn new(ends: Vec<End>, durations: Vec<f64>, at: usize, join: Join, tension: f64) -> Self {
        assert!(at + 1 < ends.len() && durations.len() + 1 == ends.len(), "a segment runs between two keyframes");
        assert!(join != Join::Separate || ends.len() == 2, "a separate segment has no neighbors");
        let agent_count = ends[0].formation.agent_count();
        let counts = ends.iter().flat_map(|end| [end.formation.agent_count(), end.adjacency.agent_count()]);
        assert!(counts.into_iter().all(|count| count == agent_count), "all keyframes are of the same agents");
        // The paper's formula counts segments, not seconds.
        let durations = if join == Join::Product { vec![1.0; durations.len()] } else { durations };
        let is_level = ends.iter().all(|end| end.formation.places().is_level());
        Self { ends, durations, at, join, tension, is_level }
    }

    /// The same where somebody climbs elsewhere in the show: then all segments meet as they do in space.
    #[must_use]
    pub fn in_space(self) -> Self {
        Self { is_level: false, ..self }
    }

    /// Whether the formations have heights, level or not.
    pub fn has_heights(&self) -> bool {
        self.ends.iter().any(|end| end.formation.heights().is_some())
    }

    /// Whether everybody is equally high at each keyframe of the show.
    pub(super) fn is_level(&self) -> bool {
        self.is_level
    }

    /// How many agents.
    pub fn agent_count(&self) -> usize {
        self.ends[0].formation.agent_count()
    }

    /// The keyframes, in order.
    pub fn ends(&self) -> &[End] {
        &self.ends
    }

    /// The segment's index among its keyframes: it runs from this one to the next.
    pub fn at(&self) -> usize {
        self.at
    }

    /// The segment without its neighbors.
    #[must_use]
    pub fn alone(&self) -> Self {
        Self::between(self.ends[self.at].clone(), self.ends[self.at + 1].clone())
    }

    /// The same segment for other agents: one end a keyframe, all of the same.
    pub(super) fn with_ends(&self, ends: Vec<End>) -> Self {
        assert_eq!(ends.len(), self.ends.len(), "one end a keyframe");
        Self { ends, ..self.clone() }
    }

    /// Whether another is made of equal parts, so that its motions are the same.
    pub(super) fn looks_like(&self, other: &Self) -> bool {
        let shape = |chain: &Self| (chain.at, chain.join, chain.tension, chain.is_level);
        let are_alike = |(one, other): (&End, &End)| one.formation == other.formation && one.adjacency == other.adjacency;
        shape(self) == shape(other)
            && self.durations == other.durations
            && self.ends.len() == other.ends.len()
            && self.ends.iter().zip(&other.ends).all(are_alike)
    }

    /// Whether the agents stop at both ends, so that no join matters.
    pub(super) fn is_alone(&self) -> bool {
        self.ends.len() == 2
    }

    pub(super) fn join(&self) -> Join {
        self.join
    }

    pub(super) fn tension(&self) -> f64 {
        self.tension
    }

    /// Seconds from keyframe `pair` to the next; 1 where the join counts segments.
    pub(crate) fn duration(&self, pair: usize) -> f64 {
        self.durations[pair]
    }

    /// How many times itself a second a radius may lose on the way from keyframe `pair` to the next: three times what would take it
    /// to 0 evenly keeps a cubic above. The paper's formula knows no limit.
    pub(super) fn steepest(&self, pair: usize) -> f64 {
        if self.join == Join::Product { f64::INFINITY } else { 3.0 / self.durations[pair] }
    }

    pub(super) fn formation(&self, end: usize) -> &Formation {
        &self.ends[end].formation
    }

    pub(super) fn couple(&self, pair: usize) -> Couple {
        Couple { source: self.ends[pair].clone(), target: self.ends[pair + 1].clone() }
    }

    /// Keyframes next to `end`, itself included.
    pub(super) fn around(&self, end: usize) -> std::ops::RangeInclusive<usize> {
        end.saturating_sub(1)..=(end + 1).min(self.ends.len() - 1)
    }

    /// What the ways from the keyframe before and to the one after contribute to the velocity at `end`, per second (Catmull-Rom,
    /// for uneven times). At a stop the keyframe itself takes the missing one's place, as paper A duplicates it.
    pub(super) fn pace(&self, end: usize) -> [f64; 2] {
        self.tensest_pace(end).map(|pace| self.tension * pace)
    }

    /// The same where the tension is 1.
    pub(super) fn tensest_pace(&self, end: usize) -> [f64; 2] {
        let before = end.checked_sub(1).map(|pair| self.durations[pair]);
        let after = self.durations.get(end).copied();
        match (before, after) {
            (Some(before), Some(after)) => {
                let share = share_of_velocity(before, after);
                [2.0 * share / before, 2.0 * (1.0 - share) / after]
            }
            (Some(before), None) => [1.0 / before, 0.0],
            (None, Some(after)) => [0.0, 1.0 / after],
            (None, None) => [0.0; 2],
        }
    }

    /// The velocity of a path through `places`, one a keyframe, at `end`.
    pub(super) fn velocity(&self, end: usize, place: impl Fn(usize) -> DVec3) -> DVec3 {
        let [before, after] = self.pace(end);
        let here = place(end);
        let arriving = if before == 0.0 { DVec3::ZERO } else { before * (here - place(end - 1)) };
        let leaving = if after == 0.0 { DVec3::ZERO } else { after * (place(end + 1) - here) };
        arriving + leaving
    }
}

/// How much the mean velocity of a segment of `own` seconds counts, 0–1, where it meets one of `other` seconds.
///
/// The parabola through three keyframes goes by the shorter segment, whose velocity is far too much for a longer one: its agents
/// would run on for the time of their whole way. Beyond `MOST_UNEVEN` a short segment counts the less the shorter it is, so that
/// what it asks of the long one no longer grows. An even velocity stays as it is: both shares make 1.
fn share_of_velocity(own: f64, other: f64) -> f64 {
    const MOST_UNEVEN: f64 = 3.0;
    const OF_SHORTER: f64 = MOST_UNEVEN * MOST_UNEVEN / (1.0 + MOST_UNEVEN);
    let ratio = own.max(other) / own.min(other);
    let of_shorter = if ratio > MOST_UNEVEN { OF_SHORTER / ratio } else { ratio / (1.0 + ratio) };
    if own < other { of_shorter } else { 1.0 - of_shorter }
}

/// How agents move in one segment: a method with its options.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Way {
    /// The method. `auto` is none: it tries others.
    pub choice: Choice,
    /// Scale the coefficients so that the formation keeps its size (spectral, shared).
    pub keeps_size: bool,
    /// A second choice and its share, 0–1.
    pub blend: Option<(Choice, f64)>,
}

impl Way {
    /// A single choice.
    pub fn of(choice: Choice, keeps_size: bool) -> Self {
        Self { choice, keeps_size, blend: None }
    }

    /// Whether agents × modes matrices are multiplied at every instant.
    pub(crate) fn has_modes(&self) -> bool {
        self.parts().iter().any(|(choice, _)| matches!(choice.method, MethodName::Shared | MethodName::Spectral))
    }

    /// What it mixes, with the shares.
    pub(super) fn parts(&self) -> Vec<(Choice, f64)> {
        match self.blend {
            None => vec![(self.choice, 1.0)],
            Some((second, share)) => vec![(self.choice, 1.0 - share), (second, share)],
        }
    }
}

/// The ways of a segment and of its neighbors, whose velocity it meets at the keyframes between them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ways {
    /// Of the segment before; not asked for at a stop.
    pub before: Option<Way>,
    /// Of the segment itself.
    pub own: Way,
    /// Of the segment after; not asked for at a stop.
    pub after: Option<Way>,
}

impl Ways {
    /// The same way everywhere.
    pub fn all(way: Way) -> Self {
        Self { before: Some(way), own: way, after: Some(way) }
    }
}
