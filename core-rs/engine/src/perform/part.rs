//! A part of a transition that is performed as a whole: it follows that motion, bent to its keyframes.
//!
//! What a keyframe asks for beside the motion of the whole comes to nothing at the next keyframes, value and velocity, so the rest of
//! the motion stays where it was; where it asks for what is seen there, nothing changes.

use std::sync::Arc;

use glam::{DVec2, DVec3};

use super::avoid::clearance;
use super::bends::{Bend, UNSEEN, bends, between};
use super::outcome::Avoided;
use super::performed::Performed;
use crate::measure::Extreme;
use crate::motion::{Motion, closeness};
use crate::transition::{Chain, Transition};

/// Samples nearer in time are one, seconds.
const SAME_INSTANT: f64 = 1e-9;

/// A part of a whole motion, bent to its keyframes.
pub(super) struct Part {
    whole: Arc<Performed>,
    agent_count: usize,
    start: f64,
    end: f64,
    /// By agent, at both ends.
    bends: Vec<[Bend; 2]>,
}

impl Part {
    /// The segment of a chain of keyframes of the whole, of the same agents; `start` is when it leaves its source.
    pub(super) fn new(whole: Arc<Performed>, chain: &Chain, start: f64) -> Self {
        let at = chain.at();
        let mut times = vec![start - (0..at).map(|pair| chain.duration(pair)).sum::<f64>()];
        for pair in 0..chain.ends().len() - 1 {
            times.push(times[pair] + chain.duration(pair));
        }
        let mut part = Self { whole, agent_count: chain.agent_count(), start, end: times[at + 1], bends: Vec::new() };
        let asides: Vec<Vec<DVec3>> = chain
            .ends()
            .iter()
            .zip(&times)
            .map(|(end, time)| {
                let (mut plan, mut heights) = (vec![DVec2::ZERO; part.agent_count], vec![0.0; part.agent_count]);
                part.follow(&[*time], &mut plan, chain.has_heights().then_some(&mut heights[..]));
                (0..part.agent_count).map(|agent| end.formation.places().at(agent) - plan[agent].extend(heights[agent])).collect()
            })
            .collect();
        for agent in 0..part.agent_count {
            let asked: Vec<DVec3> = asides.iter().map(|asides| asides[agent]).collect();
            let known = bends(&times, &asked);
            part.bends.push([known[at], known[at + 1]]);
        }
        part
    }

    /// Whether anybody is elsewhere than the whole motion has them.
    pub(super) fn is_bent(&self) -> bool {
        self.bends.iter().flatten().any(|bend| bend.aside.length() > UNSEEN)
    }

    /// What keeping apart came to: the whole motion was kept apart already, so what was before, and how far agents are from it now, are
    /// those of the method's own way, bent alike.
    pub(super) fn tell(&self, motion: &Motion, avoided: &mut Avoided) {
        if !self.whole.is_moved() {
            return;
        }
        let seconds = self.end - self.start;
        let ts: Vec<f64> = motion.times().iter().map(|time| (time - self.start) / seconds).collect();
        let mut plan = vec![DVec2::ZERO; motion.agent_count() * ts.len()];
        let mut heights = motion.heights().map(|_| vec![0.0; plan.len()]);
        self.evaluate_into(&ts, &mut plan, heights.as_deref_mut());
        let all = self.whole.motion.agent_count();
        for (k, time) in motion.times().iter().enumerate() {
            let (mut aside, mut above) = (vec![DVec2::ZERO; all], vec![0.0; all]);
            self.whole.add_moved(*time, &mut aside, &mut above);
            for place in 0..self.agent_count {
                let (at, agent) = (k * self.agent_count + place, self.number(place));
                plan[at] -= aside[agent];
                if let Some(heights) = &mut heights {
                    heights[at] -= above[agent];
                }
            }
        }
        let before = Motion::sampled(motion.times().to_vec(), self.agent_count, plan, heights);
        avoided.guide_clearance = closeness(&before, 0.0).nearest().map(clearance);
        let moved: Vec<f64> = (0..ts.len())
            .flat_map(|k| motion.places(k).iter().zip(before.places(k).iter()).map(|(is, was)| is.distance(was)).collect::<Vec<_>>())
            .collect();
        let mean = moved.iter().sum::<f64>() / moved.len().max(1) as f64;
        avoided.deviation = Extreme { mean, max: moved.into_iter().fold(0.0, f64::max) };
        avoided.rung = avoided.rung.max(self.whole.avoided.as_ref().map_or(0, |avoided| avoided.rung));
    }

    /// The agent that is so many of those who are there.
    fn number(&self, place: usize) -> usize {
        self.whole.there.as_ref().map_or(place, |there| there[place] as usize)
    }

    /// Where the whole motion has those who are there. At its own samples it is known; evaluating thousands of agents there again would
    /// take longer than anybody waits while they drag one of them.
    fn follow(&self, times: &[f64], plan: &mut [DVec2], mut heights: Option<&mut [f64]>) {
        let motion = &self.whole.motion;
        for (k, time) in times.iter().enumerate() {
            let here = k * self.agent_count..(k + 1) * self.agent_count;
            let heights = heights.as_deref_mut().map(|heights| &mut heights[here.clone()]);
            let sample = motion.times().partition_point(|known| *known < time - SAME_INSTANT);
            if motion.times().get(sample).is_some_and(|known| *known <= time + SAME_INSTANT) {
                self.pick((motion.sample(sample), motion.sample_heights(sample)), &mut plan[here], heights);
            } else {
                let mut everybody = vec![DVec2::ZERO; motion.agent_count()];
                let mut rises = motion.heights().map(|_| vec![0.0; everybody.len()]);
                self.whole.places_into(&[*time], &mut everybody, rises.as_deref_mut());
                self.pick((&everybody, rises.as_deref()), &mut plan[here], heights);
            }
        }
    }

    fn pick(&self, (places, rises): (&[DVec2], Option<&[f64]>), plan: &mut [DVec2], mut heights: Option<&mut [f64]>) {
        for place in 0..self.agent_count {
            let agent = self.number(place);
            plan[place] = places[agent];
            if let (Some(heights), Some(rises)) = (&mut heights, rises) {
                heights[place] = rises[agent];
            }
        }
    }
}

impl Transition for Part {
    fn agent_count(&self) -> usize {
        self.agent_count
    }

    /// `ts` are shares of its time.
    fn evaluate_into(&self, ts: &[f64], plan: &mut [DVec2], mut heights: Option<&mut [f64]>) {
        let seconds = self.end - self.start;
        let times: Vec<f64> = ts.iter().map(|t| self.start + t * seconds).collect();
        self.follow(&times, plan, heights.as_deref_mut());
        for (k, u) in ts.iter().enumerate() {
            for (agent, bends) in self.bends.iter().enumerate() {
                let Bend { aside, .. } = between(*bends, *u, seconds);
                plan[k * self.agent_count + agent] += aside.truncate();
                if let Some(heights) = &mut heights {
                    heights[k * self.agent_count + agent] += aside.z;
                }
            }
        }
    }
}
