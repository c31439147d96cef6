//! From those who are there back to everybody: agents get their own numbers, and who is absent is put straight between both ends.

use std::sync::Arc;

use glam::DVec2;

use super::{Cast, others};
use crate::adjacency::{Adjacency, Tie};
use crate::edits::{Blocked, Breach, Other};
use crate::formation::Formation;
use crate::measure::Clearance;
use crate::motion::Motion;
use crate::perform::outcome::{Avoided, Suggestion};
use crate::perform::performed::Performed;
use crate::perform::salvage::Salvage;
use crate::transition::Transition;

impl Cast {
    /// What was performed, of everybody.
    pub(in crate::perform) fn fill(self: &Arc<Self>, mut performed: Performed) -> Performed {
        let shares = performed.parameters(performed.motion.times());
        performed.motion = self.fill_motion(&performed.motion, &shares);
        self.number(performed.measures.clearance.iter_mut());
        performed.measures.top_speed.agent = self.agent(performed.measures.top_speed.agent);
        if let Some(avoided) = &mut performed.avoided {
            self.number_avoided(avoided);
        }
        performed.held_clearance.iter_mut().for_each(|held| held.agent = self.agent(held.agent));
        if let Some(crowded) = &mut performed.crowded {
            crowded.deviation.number(&self.there);
            for hurry in &mut crowded.hurried {
                hurry.agent = self.agent(hurry.agent);
            }
        }
        if let Some(deviation) = &mut performed.deviation {
            deviation.number(&self.there);
        }
        performed.transition = Arc::new(Filled { cast: self.clone(), path: performed.transition });
        performed.there = Some(self.there.clone());
        performed
    }

    /// Keyframes that were found between both ends, `shares` of the way, of everybody.
    pub(in crate::perform) fn fill_salvage(&self, salvage: &mut Salvage, [start, end]: [f64; 2]) {
        for keyframe in &mut salvage.keyframes {
            let share = (keyframe.time - start) / (end - start);
            let mut plan = vec![DVec2::ZERO; self.count()];
            let mut heights = keyframe.positions.heights().map(|_| vec![0.0; self.count()]);
            self.place_all(share, keyframe.positions.positions(), &mut plan);
            if let (Some(heights), Some(known)) = (&mut heights, keyframe.positions.heights()) {
                self.raise_all(share, known, heights);
            }
            keyframe.positions = Arc::new(match heights {
                Some(heights) => Formation::spatial(plan, heights),
                None => Formation::new(plan),
            });
            keyframe.absent = others(&self.there, self.count());
        }
        let report = &mut salvage.report;
        self.number(report.clearance.iter_mut().chain(&mut report.unsolved));
        self.number_blocked(&mut report.blocked);
    }

    fn agent(&self, place: u32) -> u32 {
        self.there.get(place as usize).copied().unwrap_or_default()
    }

    fn count(&self) -> usize {
        self.ends[0].0.agent_count()
    }

    /// Of everybody at a share of the way, 0–1, from the places of those who are there.
    fn place_all(&self, share: f64, known: &[DVec2], plan: &mut [DVec2]) {
        let [from, to] = [0, 1].map(|end: usize| self.ends[end].0.positions());
        plan.iter_mut().zip(from.iter().zip(to)).for_each(|(place, (from, to))| *place = from.lerp(*to, share.clamp(0.0, 1.0)));
        self.there.iter().zip(known).for_each(|(agent, place)| plan[*agent as usize] = *place);
    }

    fn raise_all(&self, share: f64, known: &[f64], heights: &mut [f64]) {
        let [from, to] = [0, 1].map(|end: usize| &self.ends[end].0);
        heights.iter_mut().enumerate().for_each(|(agent, height)| {
            *height = from.height(agent) + (to.height(agent) - from.height(agent)) * share;
        });
        self.there.iter().zip(known).for_each(|(agent, height)| heights[*agent as usize] = *height);
    }

    fn fill_motion(&self, motion: &Motion, shares: &[f64]) -> Motion {
        let count = self.count();
        let mut plan = vec![DVec2::ZERO; count * shares.len()];
        let mut heights = motion.heights().map(|_| vec![0.0; plan.len()]);
        for (k, share) in shares.iter().enumerate() {
            let sample = k * count..(k + 1) * count;
            self.place_all(*share, motion.sample(k), &mut plan[sample.clone()]);
            if let (Some(heights), Some(known)) = (&mut heights, motion.sample_heights(k)) {
                self.raise_all(*share, known, &mut heights[sample]);
            }
        }
        Motion::sampled(motion.times().to_vec(), count, plan, heights)
    }

    fn number<'c>(&self, meetings: impl Iterator<Item = &'c mut Clearance>) {
        meetings.for_each(|meeting| meeting.agents = (self.agent(meeting.agents.0), self.agent(meeting.agents.1)));
    }

    fn number_blocked(&self, blocked: &mut [Blocked]) {
        for Blocked { agent, .. } in blocked {
            *agent = self.agent(*agent);
        }
    }

    fn number_avoided(&self, avoided: &mut Avoided) {
        self.number(avoided.guide_clearance.iter_mut().chain(&mut avoided.unsolved));
        self.number_blocked(&mut avoided.blocked);
        for shut in &mut avoided.shut_off {
            shut.agent = self.agent(shut.agent);
        }
        for Breach { agent, other, .. } in &mut avoided.breaches {
            *agent = self.agent(*agent);
            if let Other::Agent(other) = other {
                *other = self.agent(*other);
            }
        }
        for suggestion in &mut avoided.suggestions {
            if let Suggestion::Swap { agents } = suggestion {
                *agents = (self.agent(agents.0), self.agent(agents.1));
            }
        }
    }
}

/// A graph of some agents as one of all: nobody else has a tie.
pub(in crate::perform) fn among_all(graph: &Adjacency, there: &[u32], agent_count: usize) -> Adjacency {
    let number = |place: u32| there[place as usize];
    let ties = graph.ties().iter().map(|tie| Tie { a: number(tie.a), b: number(tie.b), ..*tie }).collect();
    let mut obstacle_ties = graph.obstacle_ties().to_vec();
    for tie in &mut obstacle_ties {
        tie.agent = number(tie.agent);
    }
    Adjacency::new(agent_count, ties).with_obstacle_ties(obstacle_ties)
}

/// A way of those who are there, and of everybody else straight from end to end.
struct Filled {
    cast: Arc<Cast>,
    path: Arc<dyn Transition>,
}

impl Transition for Filled {
    fn agent_count(&self) -> usize {
        self.cast.count()
    }

    fn matrix_count(&self) -> usize {
        self.path.matrix_count()
    }

    fn evaluate_into(&self, ts: &[f64], plan: &mut [DVec2], mut heights: Option<&mut [f64]>) {
        let (count, known) = (self.agent_count(), self.path.agent_count());
        let mut places = vec![DVec2::ZERO; known * ts.len()];
        let mut rises = heights.as_ref().map(|_| vec![0.0; places.len()]);
        self.path.evaluate_into(ts, &mut places, rises.as_deref_mut());
        for (k, t) in ts.iter().enumerate() {
            let (all, some) = (k * count..(k + 1) * count, k * known..(k + 1) * known);
            self.cast.place_all(*t, &places[some.clone()], &mut plan[all.clone()]);
            if let (Some(heights), Some(rises)) = (&mut heights, &rises) {
                self.cast.raise_all(*t, &rises[some], &mut heights[all]);
            }
        }
    }
}
