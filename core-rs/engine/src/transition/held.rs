//! Agents tied to obstacles keep their clearance to them, whatever the method does with the others.
//!
//! A tied agent goes around its obstacle: the clearance runs evenly from that at one keyframe to that at the next, never below the
//! lesser nor above the greater of the two, while the agent covers the way along the obstacle's hull, the shorter way around. A factor
//! of 1 and more keeps to that path, a lesser one to its share between it and the method's. Heights are the method's.

use std::sync::Arc;

use glam::DVec2;

use super::Transition;
use super::chain::Chain;
use crate::obstacle::{Beside, ObstacleShape, Rim};
use crate::order::{key_of_pair, sort_by_key};
use crate::spectral::cubic_weights;

/// Three times a secant's slope at both ends is the steepest that never leaves the values between (de Boor and Swartz).
const STEEPEST: f64 = 3.0;

/// Who is nearer to a corner than this, of the line's distance, stands at it: there is no speed around it then.
const AT_CORNER: f64 = 1e-3;

/// A path whose tied agents keep their clearance.
struct Held {
    path: Arc<dyn Transition>,
    courses: Vec<Course>,
}

/// How one agent passes one obstacle.
struct Course {
    agent: usize,
    rim: Arc<Rim>,
    /// The line along which lengths are measured, meters from the hull.
    line: f64,
    /// Cubics over t: along that line, and the clearance.
    along: [f64; 4],
    clearance: [f64; 4],
    /// How firmly the agent keeps to it at both ends, 0–1.
    shares: [f64; 2],
}

/// The same path with agents held to their obstacles; itself where nobody is tied to any.
///
/// At a keyframe where an agent is not tied, or stands within the hull, the tie takes hold or ends without a jump of place or
/// velocity. Of several ties of an agent the mean counts, by their shares.
pub fn held(path: Arc<dyn Transition>, chain: &Chain, obstacles: &[&ObstacleShape]) -> Arc<dyn Transition> {
    let courses = courses(chain, obstacles);
    if courses.is_empty() { path } else { Arc::new(Held { path, courses }) }
}

/// An agent and an obstacle that it is tied to at a keyframe of a segment, or at both.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tied {
    /// Who.
    pub agent: u32,
    /// To what, by number.
    pub obstacle: u32,
    /// At the source and at the target; 0 where there is no tie.
    pub factors: [f64; 2],
}

/// Who is tied to what in the chain's segment; by agent, then by obstacle.
pub fn tied(chain: &Chain) -> Vec<Tied> {
    let mut all = Vec::new();
    for (side, end) in [chain.at(), chain.at() + 1].into_iter().enumerate() {
        for tie in chain.ends()[end].adjacency.obstacle_ties() {
            let mut factors = [0.0; 2];
            factors[side] = tie.factor;
            all.push(Tied { agent: tie.agent, obstacle: tie.obstacle, factors });
        }
    }
    sort_by_key(&mut all, |tied| key_of_pair((tied.agent, tied.obstacle)));
    // At most one of each end.
    all.dedup_by(|second, first| {
        let is_same = (second.agent, second.obstacle) == (first.agent, first.obstacle);
        if is_same {
            first.factors = [first.factors[0] + second.factors[0], first.factors[1] + second.factors[1]];
        }
        is_same
    });
    all
}

fn courses(chain: &Chain, obstacles: &[&ObstacleShape]) -> Vec<Course> {
    let mut rims: Vec<Option<Arc<Rim>>> = vec![None; obstacles.len()];
    let mut courses: Vec<Course> = Vec::new();
    for Tied { agent, obstacle, factors } in tied(chain) {
        let rim = rims[obstacle as usize].get_or_insert_with(|| Arc::new(Rim::of(obstacles[obstacle as usize])));
        courses.push(Around::of(chain, agent as usize, rim.clone()).course(factors));
    }
    for of_agent in courses.chunk_by_mut(|a, b| a.agent == b.agent) {
        for side in [0, 1] {
            let total: f64 = of_agent.iter().map(|course| course.shares[side]).sum();
            for course in of_agent.iter_mut() {
                course.shares[side] /= total.max(1.0);
            }
        }
    }
    courses.retain(|course| course.shares != [0.0; 2]);
    courses
}

impl Course {
    fn place(&self, t: f64) -> DVec2 {
        let mix = |parts: [f64; 4]| -> f64 { cubic_weights(t).into_iter().zip(parts).map(|(weight, part)| weight * part).sum() };
        self.rim.place(mix(self.along), self.line, mix(self.clearance))
    }

    fn share(&self, t: f64) -> f64 {
        let [from, to] = self.shares;
        from + (to - from) * t * t * (3.0 - 2.0 * t)
    }
}

/// An agent beside an obstacle at the keyframes of a chain.
struct Around<'a> {
    chain: &'a Chain,
    agent: usize,
    rim: Arc<Rim>,
    /// By keyframe; within the hull it counts as on it.
    besides: Vec<Beside>,
    is_within: Vec<bool>,
}

impl<'a> Around<'a> {
    fn of(chain: &'a Chain, agent: usize, rim: Arc<Rim>) -> Self {
        let mut besides: Vec<Beside> = (0..chain.ends().len()).map(|end| rim.beside(chain.formation(end).positions()[agent])).collect();
        let is_within = besides.iter().map(|beside| beside.clearance < 0.0).collect();
        for beside in &mut besides {
            beside.clearance = beside.clearance.max(0.0);
        }
        Self { chain, agent, rim, besides, is_within }
    }

    fn course(self, factors: [f64; 2]) -> Course {
        let at = self.chain.at();
        let [source, target] = [at, at + 1];
        let line = self.line(at);
        let (start, travel) = (self.rim.along(&self.besides[source], line), self.travel(at));
        let [from, to] = [source, target].map(|end| self.besides[end].clearance);
        let duration = self.chain.duration(at);
        let (along, clearance) = if self.chain.is_alone() {
            ([start, travel, start + travel, travel], [from, to - from, to, to - from])
        } else {
            let [leaving, arriving] = [source, target].map(|end| duration * self.along_line(end, at));
            let [climbing, reaching] = [source, target].map(|end| duration * self.climb(end));
            ([start, leaving, start + travel, arriving], [from, climbing, to, reaching])
        };
        let share = |side: usize| if self.is_within[at + side] { 0.0 } else { factors[side].min(1.0) };
        Course { agent: self.agent, rim: self.rim.clone(), line, along, clearance, shares: [share(0), share(1)] }
    }

    /// Where the way from keyframe `pair` to the next is measured: halfway between both clearances.
    fn line(&self, pair: usize) -> f64 {
        f64::midpoint(self.besides[pair].clearance, self.besides[pair + 1].clearance)
    }

    fn travel(&self, pair: usize) -> f64 {
        self.rim.travel(&self.besides[pair], &self.besides[pair + 1], self.line(pair))
    }

    /// How much faster an agent itself moves at keyframe `end` than along the line of `pair`, just within the pair, heading ahead or
    /// back.
    fn pace(&self, end: usize, pair: usize, heading: f64) -> f64 {
        let line = self.line(pair);
        let inward = if end == pair { heading } else { -heading };
        let beside = &self.besides[end];
        let pace = self.rim.pace(self.rim.along(beside, line), line, beside.clearance, inward);
        if pace < AT_CORNER { 1.0 } else { pace }
    }

    /// Along the hull past a keyframe, at the agent's own clearance, meters a second.
    fn velocity(&self, end: usize) -> f64 {
        let [before, after] = self.chain.pace(end);
        let of_pair = |pair: usize, pace: f64| {
            let travel = self.travel(pair);
            pace * travel * self.pace(end, pair, travel)
        };
        let arriving = if before == 0.0 { 0.0 } else { of_pair(end - 1, before) };
        let leaving = if after == 0.0 { 0.0 } else { of_pair(end, after) };
        arriving + leaving
    }

    /// The same along the line of `pair`.
    fn along_line(&self, end: usize, pair: usize) -> f64 {
        let velocity = self.velocity(end);
        velocity / self.pace(end, pair, velocity)
    }

    /// Away from the hull past a keyframe, meters a second: none where the clearance is a least or a greatest, else so little that it
    /// stays between its neighbors (Fritsch and Carlson).
    fn climb(&self, end: usize) -> f64 {
        let rise = |pair: usize| self.besides[pair + 1].clearance - self.besides[pair].clearance;
        let slope = |pair: usize| rise(pair) / self.chain.duration(pair);
        let [before, after] = self.chain.pace(end);
        let pairs = self.chain.around(end);
        let slopes: Vec<f64> = (*pairs.start()..*pairs.end()).map(slope).collect();
        if slopes.iter().any(|slope| slope * slopes[0] <= 0.0) {
            return 0.0;
        }
        let arriving = if before == 0.0 { 0.0 } else { before * rise(end - 1) };
        let leaving = if after == 0.0 { 0.0 } else { after * rise(end) };
        let limit = STEEPEST * slopes.iter().map(|slope| slope.abs()).fold(f64::INFINITY, f64::min);
        (arriving + leaving).clamp(-limit, limit)
    }
}

impl Transition for Held {
    fn agent_count(&self) -> usize {
        self.path.agent_count()
    }

    fn matrix_count(&self) -> usize {
        self.path.matrix_count()
    }

    fn evaluate_into(&self, ts: &[f64], plan: &mut [DVec2], heights: Option<&mut [f64]>) {
        self.path.evaluate_into(ts, plan, heights);
        let agent_count = self.agent_count();
        for (t, places) in ts.iter().zip(plan.chunks_exact_mut(agent_count)) {
            for courses in self.courses.chunk_by(|a, b| a.agent == b.agent) {
                let place = &mut places[courses[0].agent];
                let by_method = *place;
                for course in courses {
                    *place += course.share(*t) * (course.place(*t) - by_method);
                }
            }
        }
    }
}
