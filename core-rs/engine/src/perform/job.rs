//! One segment's work, in steps: a busy worker cannot hear "cancel", so it pauses between any two.
//!
//! Ties of the keyframes → what auto chooses, here and next door → the plan → the clock → samples → forces → keeping apart → numbers.

use std::sync::Arc;

use super::Performer;
use super::avoid::{Avoiding, Kept, judged};
use super::brief::Brief;
use super::clock::{Clock, path_parameters};
use super::crowd::Crowding;
use super::free::freed;
use super::hurry::hurried;
use super::part::Part;
use super::performed::{Candidate, Performed};
use super::plan::Plan;
use super::resorts::{Attempt, Next, Resorts};
use super::sampling::Sampling;
use super::tied;
use super::trial::{Trial, chosen, with_resort};
use crate::COMPARES;
use crate::choice::{Choice, MethodName};
use crate::edits::Deviation;
use crate::error::Error;
use crate::measure;
use crate::motion::{Motion, sample_times};
use crate::recent::Same;
use crate::scene::Scene;
use crate::transition::{Chain, End, Transition, Travel, Way, Ways, interpolated};

/// How much of a segment's progress is its planning.
const PLANNING_SHARE: f64 = 0.7;

/// How much is learning the path of an even clock.
const CLOCK_SHARE: f64 = 0.05;

/// How much is evaluating samples.
const MOVING_SHARE: f64 = 0.05;

/// How much is walking by forces.
const CROWDING_SHARE: f64 = 0.05;

/// How much is keeping agents apart; the rest is measuring.
const AVOIDING_SHARE: f64 = 0.1;

/// Steps that one spectral choice takes: spectra, eigenbases, pairing, rotation planes.
const TYPICAL_STEPS: f64 = 8.0;

/// What one choice still to make counts for: more than the ways that auto tries, so that progress never falls.
const CHOICE_STEPS: f64 = 12.0;

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
    /// What it is a part of is performed first.
    Whole(Box<AsPart>),
    Work(Box<Work>),
}

/// Segment `index` of a scene, which is a part of the transition from one of two keyframes to the other.
struct AsPart {
    whole: SegmentJob,
    scene: Scene,
    index: usize,
    ends: [usize; 2],
}

struct Work {
    scene: Scene,
    brief: Brief,
    stage: Stage,
    resorts: Resorts,
    /// Steps so far; a spectral candidate takes several.
    steps: usize,
}

enum Stage {
    /// The ties of the keyframes are not all known yet.
    Tying(Vec<End>),
    /// What the segment before, the segment itself and the one after use, as far as it is known.
    Choosing(Choosing),
    /// All choices are made.
    Planning(Plan),
    /// An even clock learns the path.
    Clocking(Plan, Sampling),
    /// Frames come a few at a time.
    Moving(Plan, Clock, Vec<f64>, Sampling),
    /// Forces lead along what was sampled.
    Crowding(Plan, Clock, Sampling, Box<Crowding>),
    /// Whoever is too near is kept apart.
    Avoiding(Plan, Clock, Sampling, Box<Avoiding>),
    /// The motion is settled, its numbers are to come.
    Measuring(Box<Attempt>),
}

struct Choosing {
    chain: Chain,
    travel: Option<Arc<Travel>>,
    /// Of the next, where auto must find it.
    trial: Option<Trial>,
    known: Vec<Option<Choice>>,
    /// Of the segment itself.
    candidates: Arc<Vec<Candidate>>,
}

impl SegmentJob {
    pub(super) fn done(performed: Arc<Performed>) -> Self {
        Self(Phase::Done(performed))
    }

    pub(super) fn new(scene: Scene, brief: Brief) -> Self {
        Self(Phase::Work(Box::new(Work { scene, brief, stage: Stage::Tying(Vec::new()), resorts: Resorts::default(), steps: 0 })))
    }

    /// A part of a transition, which is performed as a `whole`.
    pub(super) fn part(whole: Self, scene: Scene, index: usize, ends: [usize; 2]) -> Self {
        Self(Phase::Whole(Box::new(AsPart { whole, scene, index, ends })))
    }

    /// The motion, as soon as it is settled: it can be played before it is measured.
    pub fn motion(&self) -> Option<&Motion> {
        match &self.0 {
            Phase::Done(performed) => Some(&performed.motion),
            Phase::Whole(_) => None,
            Phase::Work(work) => {
                // Of some agents it is no motion of all.
                if let (Stage::Measuring(attempt), None) = (&work.stage, &work.brief.cast) { Some(&attempt.kept.motion) } else { None }
            }
        }
    }

    /// Works for a while: usually some milliseconds, longer where one eigenproblem of many agents is one step.
    pub fn step(&mut self, performer: &mut Performer) -> Result<Step, Error> {
        let work = match &mut self.0 {
            Phase::Done(result) => return Ok(Step::Done(result.clone())),
            Phase::Whole(part) => {
                return Ok(match part.whole.step(performer)? {
                    Step::Progress(progress) => Step::Progress(PLANNING_SHARE * progress),
                    Step::Done(whole) => {
                        self.0 = performer.begin_part(&part.scene, part.index, part.ends, whole).0;
                        Step::Progress(PLANNING_SHARE)
                    }
                });
            }
            Phase::Work(work) => work,
        };
        let Some(result) = work.step(performer)? else { return Ok(Step::Progress(work.progress())) };
        let result = Arc::new(match &work.brief.cast {
            None => result,
            Some(cast) => cast.fill(result),
        });
        let agent_count = result.motion.agent_count();
        let bytes = size_of_val(result.motion.positions())
            + size_of_val(result.motion.heights().unwrap_or_default())
            + result.deviations().map(Deviation::byte_count).sum::<usize>()
            + result.transition.matrix_count() * agent_count * agent_count * size_of::<f64>();
        performer.performed.put(work.brief.clone(), result.clone(), bytes);
        performer.planner.tidy();
        self.0 = Phase::Done(result.clone());
        Ok(Step::Done(result))
    }
}

impl Work {
    fn step(&mut self, performer: &mut Performer) -> Result<Option<Performed>, Error> {
        self.steps += 1;
        let stage = std::mem::replace(&mut self.stage, Stage::Tying(Vec::new()));
        self.stage = match stage {
            Stage::Tying(ends) => self.tie(ends, performer)?,
            Stage::Choosing(choosing) => self.choose(choosing, performer),
            Stage::Planning(plan) => self.plan(plan, performer),
            Stage::Clocking(plan, mut path) => {
                if path.step() {
                    Stage::Clocking(plan, path)
                } else {
                    let clock = Clock::even(path.transition.agent_count(), &path.positions, path.heights.as_deref());
                    self.set_off(plan, path.transition, clock)
                }
            }
            Stage::Moving(plan, clock, times, mut samples) => {
                if samples.step() {
                    Stage::Moving(plan, clock, times, samples)
                } else {
                    let positions = std::mem::take(&mut samples.positions);
                    let guide = Motion::sampled(times, plan.chain.agent_count(), positions, samples.heights.take());
                    let guide = self.at_pace(guide, &mut samples.ts);
                    match Crowding::of(&self.brief, guide) {
                        Ok(crowding) => Stage::Crowding(plan, clock, samples, Box::new(crowding)),
                        Err(guide) => self.keep_apart(plan, clock, samples, guide),
                    }
                }
            }
            Stage::Crowding(mut plan, clock, samples, mut crowding) => match crowding.step() {
                None => Stage::Crowding(plan, clock, samples, crowding),
                Some((motion, crowded)) => {
                    plan.crowded = Some(crowded);
                    self.keep_apart(plan, clock, samples, motion)
                }
            },
            Stage::Avoiding(plan, clock, samples, mut avoiding) => {
                let Some(kept) = avoiding.step(&self.brief, &plan.ways.own.choice) else {
                    self.stage = Stage::Avoiding(plan, clock, samples, avoiding);
                    return Ok(None);
                };
                match self.resorts.after(Attempt { plan, clock, samples, kept }, &self.brief) {
                    Next::Keep(attempt) => Stage::Measuring(attempt),
                    Next::Try(plan) => Stage::Planning(*plan),
                }
            }
            Stage::Measuring(attempt) => return Ok(Some(self.finish(*attempt))),
        };
        Ok(None)
    }

    /// The ties of the next keyframe.
    fn tie(&self, mut ends: Vec<End>, performer: &mut Performer) -> Result<Stage, Error> {
        let mut missing = self.brief.keyframes().skip(ends.len());
        if let Some(keyframe) = missing.next() {
            let formation = self.scene.main_track().keyframes[keyframe].positions.clone();
            ends.push(End { formation, adjacency: performer.graphs.of(&self.scene, keyframe)? });
        }
        Ok(if missing.next().is_some() {
            Stage::Tying(ends)
        } else {
            let chain = self.brief.chain(ends);
            if let Some(Same(whole)) = &self.brief.whole {
                return Ok(self.follow(whole, chain));
            }
            let travel = self.brief.travel(&chain, &mut performer.turnings).map(Arc::new);
            Stage::Choosing(Choosing { chain, travel, trial: None, known: Vec::new(), candidates: Arc::default() })
        })
    }

    /// A part of a whole motion needs no plan of its own.
    fn follow(&self, whole: &Arc<Performed>, chain: Chain) -> Stage {
        let part = Arc::new(Part::new(whole.clone(), &chain, self.brief.start));
        let ways = Ways::all(Way::of(whole.choice, false));
        let candidates = Arc::new(whole.candidates.clone());
        let plan =
            Plan { chain, travel: None, part: Some(part.clone()), ways, hierarchy: None, ts: Arc::default(), candidates, crowded: None };
        self.set_off(plan, part, Clock::Linear)
    }

    /// The choice of the next of the segments whose choices matter; `known` are those before.
    fn choose(&self, mut choosing: Choosing, performer: &mut Performer) -> Stage {
        let asked = self.brief.asked();
        let Some(next) = asked.get(choosing.known.len()) else {
            let way = |index: usize| {
                let (_, asked) = asked[index]?;
                Some(Way::of(choosing.known[index]?, asked.transition.keep_size))
            };
            let ways = Ways { before: way(0), own: way(1).expect("a segment has a choice of its own"), after: way(2) };
            return Stage::Planning(self.begin_plan(choosing, ways, performer));
        };
        let Some((source, asked)) = *next else {
            choosing.known.push(None);
            return Stage::Choosing(choosing);
        };
        if let Some(choice) = asked.given() {
            choosing.known.push(Some(choice));
            return Stage::Choosing(choosing);
        }
        let trial = choosing.trial.get_or_insert_with(|| {
            let chain = self.brief.alone(&choosing.chain, source, &mut performer.turnings);
            let by_groups = asked.transition.hierarchy;
            let hierarchy = by_groups.then(|| performer.levels.hierarchy(&self.scene.groups, &chain, None));
            Trial::new(chain, hierarchy, &asked.transition, self.brief.minimum_distance)
        });
        if let Some(table) = trial.step(&mut performer.planner, &mut performer.tables) {
            choosing.known.push(Some(chosen(&table)));
            choosing.trial = None;
            if source == choosing.chain.at() {
                choosing.candidates = table;
            }
        }
        Stage::Choosing(choosing)
    }

    fn begin_plan(&self, chosen: Choosing, ways: Ways, performer: &mut Performer) -> Plan {
        let Choosing { chain, travel, candidates, .. } = chosen;
        let ts = self.known_clock().map_or(Vec::new(), |clock| self.parameters(&clock, &self.times()));
        let mut plan = Plan { chain, travel, part: None, ways, hierarchy: None, ts: ts.into(), candidates, crowded: None };
        if self.brief.own.transition.hierarchy {
            plan.hierarchy = Some(performer.levels.hierarchy(&self.scene.groups, plan.chart(), Some(self.brief.segment())));
        }
        plan
    }

    fn plan(&self, mut plan: Plan, performer: &mut Performer) -> Stage {
        let transition: Arc<dyn Transition> = if let Some(hierarchy) = &mut plan.hierarchy {
            let node_ways = |path: &[u32]| self.brief.node_ways(path, &plan.ways);
            let Some(done) = hierarchy.step(&mut performer.planner, node_ways, &plan.ts) else { return Stage::Planning(plan) };
            let done = Arc::new(done);
            performer.levels.keep(self.brief.segment(), &done);
            done
        } else {
            let Some(done) = performer.planner.step(plan.chart(), &plan.ways) else { return Stage::Planning(plan) };
            // Methods without modes cost an instant less than a polynomial through it.
            if plan.ways.own.has_modes() { interpolated(done, self.times().len()).into() } else { done.into() }
        };
        let transition = match &plan.travel {
            Some(travel) => travel.led(transition),
            None => transition,
        };
        let transition = tied::held(transition, &plan.chain, &self.brief.obstacles);
        let has_heights = plan.chain.has_heights();
        match self.known_clock() {
            Some(clock) => self.set_off(plan, transition, clock),
            None => Stage::Clocking(plan, Sampling::new(transition, path_parameters(), has_heights)),
        }
    }

    /// None where the clock follows from the path.
    fn known_clock(&self) -> Option<Clock> {
        Clock::of(self.brief.own.transition.timing, self.brief.stops())
    }

    fn times(&self) -> Vec<f64> {
        sample_times(self.brief.start, self.brief.end, self.brief.frame_rate)
    }

    fn parameters(&self, clock: &Clock, times: &[f64]) -> Vec<f64> {
        times.iter().map(|time| clock.parameter(self.brief.fraction(*time))).collect()
    }

    fn set_off(&self, plan: Plan, transition: Arc<dyn Transition>, clock: Clock) -> Stage {
        let times = self.times();
        let ts = self.parameters(&clock, &times);
        let has_heights = plan.chain.has_heights();
        Stage::Moving(plan, clock, times, Sampling::new(transition, ts, has_heights))
    }

    /// The guide as it is walked: at its own pace where everybody arrives when they do.
    fn at_pace(&self, guide: Motion, ts: &mut Vec<f64>) -> Motion {
        let Some(pace) = self.brief.aside.pace.filter(|_| COMPARES) else { return guide };
        let top_speeds: Vec<f64> = self.brief.agents.iter().map(|agent| agent.max_speed.unwrap_or(f64::INFINITY)).collect();
        let freed = freed(&guide, pace, &top_speeds, self.brief.frame_rate, self.brief.has_crowd());
        *ts = freed.ts;
        freed.motion
    }

    /// Avoidance, where it has something to do and no counterpart is in its place.
    fn keep_apart(&self, plan: Plan, clock: Clock, samples: Sampling, guide: Motion) -> Stage {
        let kept = if let (true, Some(_), Some(crowded)) = (COMPARES, self.brief.aside.counterpart, &plan.crowded) {
            Kept { avoided: judged(&self.brief, &plan.chain, &guide, crowded.guide_deviation), ..Kept::as_is(guide) }
        } else {
            // What avoidance made of the whole is not made otherwise because a keyframe lies in it.
            let is_settled = plan.part.as_ref().is_some_and(|part| !part.is_bent());
            match Avoiding::of(&self.brief, &plan.chain, guide, is_settled) {
                Ok(avoiding) => return Stage::Avoiding(plan, clock, samples, Box::new(avoiding)),
                Err(motion) => Kept::as_is(motion),
            }
        };
        Stage::Measuring(Box::new(Attempt { plan, clock, samples, kept }))
    }

    fn finish(&self, attempt: Attempt) -> Performed {
        let Attempt { mut plan, clock, samples, kept } = attempt;
        if let (Some(crowded), None) = (&mut plan.crowded, self.brief.aside.counterpart) {
            crowded.hurried = hurried(&kept.motion, &self.brief.agents);
        }
        let (chain, brief) = (&plan.chain, &self.brief);
        let [source, target] = [&chain.ends()[chain.at()], &chain.ends()[chain.at() + 1]];
        let Kept { motion, deviation, mut avoided } = kept;
        if let (Some(part), Some(avoided)) = (&plan.part, &mut avoided) {
            part.tell(&motion, avoided);
        }
        let (measures, curves) =
            measure::measure(&motion, &samples.ts[..motion.times().len()], [&source.adjacency, &target.adjacency], brief.minimum_distance);
        let held_clearance = tied::nearest(&motion, chain, &brief.obstacles);
        let guide = plan.ways.own.choice;
        let is_crowd = brief.own.transition.method == MethodName::Crowd;
        Performed {
            choice: if is_crowd { Choice { method: MethodName::Crowd, ..guide } } else { guide },
            candidates: with_resort(&plan.candidates, guide, chain, &*samples.transition, brief.minimum_distance),
            motion,
            measures,
            curves,
            avoided,
            held_clearance,
            crowded: plan.crowded,
            target: target.formation.clone(),
            there: None,
            deviation,
            transition: samples.transition,
            clock,
            start: brief.start,
            end: brief.end,
            whole: brief.whole.as_ref().map(|Same(whole)| whole.clone()),
            stops: brief.stops(),
        }
    }

    /// Rises with every step; how many steps the planning takes is not known before.
    fn progress(&self) -> f64 {
        if self.resorts.are_needed() {
            return PLANNING_SHARE + CLOCK_SHARE + MOVING_SHARE + CROWDING_SHARE + AVOIDING_SHARE;
        }
        match &self.stage {
            Stage::Tying(_) => PLANNING_SHARE * self.planned(0, 3),
            Stage::Choosing(Choosing { trial, known, .. }) => {
                // The choice under way counts by the ways it has left.
                let untouched = 3 - known.len() - usize::from(trial.is_some());
                PLANNING_SHARE * self.planned(trial.as_ref().map_or(0, Trial::left), untouched)
            }
            Stage::Planning(_) => PLANNING_SHARE * self.planned(0, 0),
            Stage::Clocking(_, path) => PLANNING_SHARE + CLOCK_SHARE * path.progress(),
            Stage::Moving(.., samples) => PLANNING_SHARE + CLOCK_SHARE + MOVING_SHARE * samples.progress(),
            Stage::Crowding(.., crowding) => PLANNING_SHARE + CLOCK_SHARE + MOVING_SHARE + CROWDING_SHARE * crowding.progress(),
            Stage::Avoiding(.., avoiding) => {
                PLANNING_SHARE + CLOCK_SHARE + MOVING_SHARE + CROWDING_SHARE + AVOIDING_SHARE * avoiding.progress()
            }
            Stage::Measuring(_) => PLANNING_SHARE + CLOCK_SHARE + MOVING_SHARE + CROWDING_SHARE + AVOIDING_SHARE,
        }
    }

    fn planned(&self, ways_left: usize, choices_left: usize) -> f64 {
        let steps = self.steps as f64;
        steps / (steps + ways_left as f64 + CHOICE_STEPS * choices_left as f64 + TYPICAL_STEPS)
    }
}
