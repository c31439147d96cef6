//! One segment as it is played, with the numbers to judge it.

use std::borrow::Cow;
use std::sync::Arc;

use glam::DVec2;
use serde::Serialize;

use super::clock::Clock;
use super::outcome::{Avoided, Crowded};
use crate::choice::Choice;
use crate::edits::{Blocked, Deviation};
use crate::formation::Formation;
use crate::measure::{Curves, Measures, Movement, MovementCurves, movement};
use crate::motion::Motion;
use crate::transition::Transition;

/// The motion of one segment between the departure from one keyframe and the arrival at the next.
pub struct Performed {
    /// What moved it.
    pub choice: Choice,
    /// What `auto` compared, in the order tried; empty when nothing was chosen.
    pub candidates: Vec<Candidate>,
    /// Its samples: departure, the frames between, arrival.
    pub motion: Motion,
    /// Over those samples.
    pub measures: Measures,
    /// One value a sample.
    pub curves: Curves,
    /// What keeping apart came to; none where the segment does not ask for it.
    pub avoided: Option<Avoided>,
    /// The nearest that anybody comes to an obstacle that they are tied to; none where nobody is.
    pub held_clearance: Option<Blocked>,
    /// What forces came to; none where the segment has none.
    pub crowded: Option<Box<Crowded>>,
    /// Of those who are there.
    pub(super) target: Arc<Formation>,
    /// Who that is, where it is not everybody.
    pub(super) there: Option<Arc<Vec<u32>>>,
    pub(super) deviation: Option<Deviation>,
    pub(super) transition: Arc<dyn Transition>,
    pub(super) clock: Clock,
    pub(super) start: f64,
    pub(super) end: f64,
    /// What it is a part of.
    pub(super) whole: Option<Arc<Self>>,
    /// Whether agents stop at its start and its end.
    pub(super) stops: [bool; 2],
}

/// One way that `auto` tried.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(rename_all = "camelCase")]
pub struct Candidate {
    /// The method with its options.
    #[serde(flatten)]
    pub choice: Choice,
    /// Mean adjacency distortion.
    pub distortion: f64,
    /// Mean turning, radians.
    pub turning: f64,
    /// Least distance seen on the frames tried, meters; none for fewer than two agents.
    pub clearance: Option<f64>,
    /// What is compared: lower is better.
    pub score: f64,
    /// Whether it is the one kept.
    pub is_chosen: bool,
}

/// A segment's numbers as the page reads them.
#[derive(Serialize)]
#[serde(rename_all = "camelCase")]
pub struct Report<'a> {
    choice: Choice,
    #[serde(flatten)]
    measures: &'a Measures,
    candidates: &'a [Candidate],
    #[serde(flatten)]
    avoided: Option<&'a Avoided>,
    #[serde(skip_serializing_if = "Option::is_none")]
    held_clearance: Option<&'a Blocked>,
    #[serde(flatten)]
    crowded: Option<&'a Crowded>,
}

impl Performed {
    /// Its numbers.
    pub fn report(&self) -> Report<'_> {
        let Self { choice, measures, candidates, avoided, held_clearance, crowded, .. } = self;
        let (avoided, held_clearance, crowded) = (avoided.as_ref(), held_clearance.as_ref(), crowded.as_deref());
        Report { choice: *choice, measures, candidates, avoided, held_clearance, crowded }
    }

    /// How the movement looks as a whole. It is found anew each time, and takes longer than all other numbers.
    pub fn movement(&self) -> (Movement, MovementCurves) {
        movement(&self.walked(), &self.target)
    }

    /// The motion of those who are there.
    pub(super) fn walked(&self) -> Cow<'_, Motion> {
        match &self.there {
            None => Cow::Borrowed(&self.motion),
            Some(there) => Cow::Owned(self.motion.only(there)),
        }
    }

    /// Places at `times` (scene seconds within the segment), from the method itself and what keeps agents apart:
    /// `plan[k * agent_count + i]`, and so the heights where they are asked for.
    pub fn places_into(&self, times: &[f64], plan: &mut [DVec2], mut heights: Option<&mut [f64]>) {
        self.transition.evaluate_into(&self.parameters(times), plan, heights.as_deref_mut());
        let agent_count = self.transition.agent_count();
        for deviation in self.deviations() {
            for (k, time) in times.iter().enumerate() {
                let range = k * agent_count..(k + 1) * agent_count;
                deviation.add_to(*time, &mut plan[range.clone()], heights.as_deref_mut().map(|heights| &mut heights[range]));
            }
        }
    }

    /// What was added to the method's own way.
    pub(super) fn deviations(&self) -> impl Iterator<Item = &Deviation> {
        self.crowded.iter().map(|crowded| &crowded.deviation).chain(&self.deviation)
    }

    /// Whether anybody was kept apart, here or in what it is a part of.
    pub(super) fn is_moved(&self) -> bool {
        self.deviation.is_some() || self.whole.as_ref().is_some_and(|whole| whole.is_moved())
    }

    /// Adds how far that has taken everybody at `time`.
    pub(super) fn add_moved(&self, time: f64, plan: &mut [DVec2], heights: &mut [f64]) {
        if let Some(deviation) = &self.deviation {
            deviation.add_to(time, plan, Some(heights));
        }
        if let Some(whole) = &self.whole {
            whole.add_moved(time, plan, heights);
        }
    }

    /// The method's parameters at `times`, scene seconds.
    pub(super) fn parameters(&self, times: &[f64]) -> Vec<f64> {
        times.iter().map(|time| self.clock.parameter((time - self.start) / (self.end - self.start))).collect()
    }

    /// Where everybody is at `times` before they are kept apart.
    pub(super) fn guide(&self, times: Vec<f64>) -> Motion {
        let agent_count = self.transition.agent_count();
        let mut plan = vec![DVec2::ZERO; times.len() * agent_count];
        let mut heights = self.motion.heights().map(|_| vec![0.0; plan.len()]);
        self.transition.evaluate_into(&self.parameters(&times), &mut plan, heights.as_deref_mut());
        if let Some(crowded) = &self.crowded {
            for (k, time) in times.iter().enumerate() {
                let range = k * agent_count..(k + 1) * agent_count;
                crowded.deviation.add_to(*time, &mut plan[range.clone()], heights.as_deref_mut().map(|heights| &mut heights[range]));
            }
        }
        Motion::sampled(times, agent_count, plan, heights)
    }

    /// How many meetings are too near, of agents and with obstacles.
    pub(super) fn open_count(&self) -> usize {
        self.avoided.as_ref().map_or(0, |avoided| avoided.unsolved.len() + avoided.blocked.len())
    }
}
