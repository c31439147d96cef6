//! One segment's work, in steps: a busy worker cannot hear "cancel", so it pauses between any two.

use std::sync::Arc;

use glam::DVec2;

use super::auto;
use super::brief::Brief;
use super::performed::{Candidate, Performed};
use super::{Performer, graphs::Graph};
use crate::choice::{Choice, MethodName};
use crate::error::Error;
use crate::formation::Formation;
use crate::measure::{self, Score};
use crate::motion::{Motion, sample_times};
use crate::scene::Scene;
use crate::transition::{End, Ends, Planner, Transition};

/// Positions evaluated in one step; about 10 ms.
const POSITIONS_PER_STEP: usize = 60_000;

/// How much of a segment's progress is its planning.
const PLANNING_SHARE: f64 = 0.7;

/// How much is evaluating samples; the rest is measuring them.
const MOVING_SHARE: f64 = 0.2;

/// Steps that one spectral choice takes: eigenbases, pairing, rotation planes.
const TYPICAL_STEPS: f64 = 6.0;

/// A spectral plan keeps so many matrices of agents × agents.
const PLAN_MATRICES: usize = 2;

/// What a step came to.
pub enum Step {
    /// How far the segment is, 0–1.
    Progress(f64),
    /// The segment is performed.
    Done(Arc<Performed>),
}

/// The work on one segment.
pub struct SegmentJob(Phase);

enum Phase {
    /// Nothing is left to do.
    Done(Arc<Performed>),
    /// The ties of both ends are not known yet.
    Start(Box<(Scene, usize, Brief)>),
    Work(Box<Work>),
}

struct Work {
    brief: Brief,
    graphs: [Arc<Graph>; 2],
    planner: Planner,
    stage: Stage,
    /// Steps so far; a spectral candidate takes several.
    steps: usize,
}

enum Stage {
    /// Ways still to try, last first, and those tried.
    Trying { left: Vec<Choice>, tried: Vec<(Choice, Score)> },
    /// The way is known.
    Planning { choice: Choice, candidates: Vec<Candidate> },
    /// Frames come a few at a time.
    Moving(Moving),
}

struct Moving {
    choice: Choice,
    candidates: Vec<Candidate>,
    transition: Arc<dyn Transition>,
    times: Vec<f64>,
    ts: Vec<f64>,
    positions: Vec<DVec2>,
}

impl SegmentJob {
    pub(super) fn done(performed: Arc<Performed>) -> Self {
        Self(Phase::Done(performed))
    }

    pub(super) fn new(scene: Scene, index: usize, brief: Brief) -> Self {
        Self(Phase::Start(Box::new((scene, index, brief))))
    }

    /// Works for a while: usually some milliseconds, longer where one eigenproblem of many agents is one step.
    pub fn step(&mut self, performer: &mut Performer) -> Result<Step, Error> {
        match &mut self.0 {
            Phase::Done(result) => Ok(Step::Done(result.clone())),
            Phase::Start(start) => {
                let (scene, index, brief) = &**start;
                let graphs = [performer.graphs.of(scene, *index)?, performer.graphs.of(scene, index + 1)?];
                self.0 = Phase::Work(Box::new(Work::new(brief.clone(), graphs)));
                Ok(Step::Progress(0.0))
            }
            Phase::Work(work) => {
                let Some(result) = work.step() else { return Ok(Step::Progress(work.progress())) };
                let result = Arc::new(result);
                let agent_count = result.motion.agent_count();
                let bytes = size_of_val(result.motion.positions()) + PLAN_MATRICES * agent_count * agent_count * size_of::<f64>();
                performer.performed.put(work.brief.clone(), result.clone(), bytes);
                self.0 = Phase::Done(result.clone());
                Ok(Step::Done(result))
            }
        }
    }
}

impl Work {
    fn new(brief: Brief, graphs: [Arc<Graph>; 2]) -> Self {
        let end = |formation: &Arc<Formation>, graph: &Graph| End {
            formation: formation.clone(),
            adjacency: graph.adjacency.clone(),
            basis: graph.known_eigenbasis(),
        };
        let ends = Ends::new(end(&brief.source.formation, &graphs[0]), end(&brief.target.formation, &graphs[1]));
        let spec = &brief.transition;
        let own = Choice { method: spec.method, order: spec.order, alignment: spec.alignment, sharing: spec.sharing };
        let given = if spec.method == MethodName::Auto { brief.held.or(spec.chosen) } else { Some(own) };
        let stage = if let Some(choice) = given {
            Stage::Planning { choice, candidates: Vec::new() }
        } else {
            let mut left = auto::choices(ends.agent_count());
            left.reverse();
            Stage::Trying { left, tried: Vec::new() }
        };
        Self { brief, graphs, planner: Planner::new(ends), stage, steps: 0 }
    }

    fn step(&mut self) -> Option<Performed> {
        self.steps += 1;
        let keep_size = self.brief.transition.keep_size;
        match &mut self.stage {
            Stage::Trying { left, tried } => {
                if let Some(&choice) = left.last() {
                    let transition = self.planner.step(&choice, keep_size);
                    self.keep_eigenbases();
                    if let (Some(transition), Stage::Trying { left, tried }) = (transition, &mut self.stage) {
                        left.pop();
                        tried.push((choice, judge(&*transition, &self.graphs, &self.brief)));
                    }
                    return None;
                }
                let candidates = auto::decide(std::mem::take(tried));
                let choice = candidates.iter().find(|candidate| candidate.is_chosen).map(|candidate| candidate.choice)?;
                self.stage = Stage::Planning { choice, candidates };
                None
            }
            Stage::Planning { choice, candidates } => {
                let choice = *choice;
                let candidates = std::mem::take(candidates);
                let transition = self.planner.step(&choice, keep_size);
                self.keep_eigenbases();
                self.stage = match transition {
                    Some(transition) => Stage::Moving(Moving::new(choice, candidates, transition.into(), &self.brief)),
                    None => Stage::Planning { choice, candidates },
                };
                None
            }
            Stage::Moving(moving) => {
                if moving.step() {
                    return None;
                }
                Some(finish(moving, &self.graphs, &self.brief))
            }
        }
    }

    /// The next segment starts from the same keyframe: what was found of it serves again.
    fn keep_eigenbases(&self) {
        let ends = self.planner.ends();
        for (graph, end) in self.graphs.iter().zip([&ends.source, &ends.target]) {
            if let Some(basis) = &end.basis {
                graph.remember(basis);
            }
        }
    }

    /// Rises with every step; how many steps the planning takes is not known before.
    fn progress(&self) -> f64 {
        match &self.stage {
            Stage::Trying { left, .. } => PLANNING_SHARE * self.planned(left.len()),
            Stage::Planning { .. } => PLANNING_SHARE * self.planned(0),
            Stage::Moving(moving) => {
                let all = (moving.ts.len() * moving.transition.agent_count()).max(1);
                PLANNING_SHARE + MOVING_SHARE * moving.positions.len() as f64 / all as f64
            }
        }
    }

    fn planned(&self, left: usize) -> f64 {
        let steps = self.steps as f64;
        steps / (steps + left as f64 + TYPICAL_STEPS)
    }
}

impl Moving {
    fn new(choice: Choice, candidates: Vec<Candidate>, transition: Arc<dyn Transition>, brief: &Brief) -> Self {
        let times = sample_times(brief.start, brief.end, brief.frame_rate);
        let ts = times.iter().map(|time| brief.parameter(*time)).collect();
        Self { choice, candidates, transition, times, ts, positions: Vec::new() }
    }

    /// Evaluates some more samples; false when there were none left.
    fn step(&mut self) -> bool {
        let agent_count = self.transition.agent_count();
        let done = self.positions.len() / agent_count.max(1);
        let next = (done + (POSITIONS_PER_STEP / agent_count.max(1)).max(1)).min(self.ts.len());
        if agent_count == 0 || done == self.ts.len() {
            return false;
        }
        self.positions.resize(next * agent_count, DVec2::ZERO);
        self.transition.evaluate_into(&self.ts[done..next], &mut self.positions[done * agent_count..]);
        true
    }
}

fn judge(transition: &dyn Transition, graphs: &[Arc<Graph>; 2], brief: &Brief) -> Score {
    let ts = auto::trial_parameters();
    let mut positions = vec![DVec2::ZERO; ts.len() * transition.agent_count()];
    transition.evaluate_into(&ts, &mut positions);
    let motion = Motion::new(ts.clone(), transition.agent_count(), positions);
    measure::score(&motion, &ts, [&graphs[0].adjacency, &graphs[1].adjacency], brief.minimum_distance)
}

fn finish(moving: &mut Moving, graphs: &[Arc<Graph>; 2], brief: &Brief) -> Performed {
    let motion = Motion::new(std::mem::take(&mut moving.times), moving.transition.agent_count(), std::mem::take(&mut moving.positions));
    let (measures, curves) = measure::measure(&motion, &moving.ts, [&graphs[0].adjacency, &graphs[1].adjacency], brief.minimum_distance);
    Performed {
        choice: moving.choice,
        candidates: std::mem::take(&mut moving.candidates),
        motion,
        measures,
        curves,
        transition: moving.transition.clone(),
        timing: brief.transition.timing,
        start: brief.start,
        end: brief.end,
    }
}
