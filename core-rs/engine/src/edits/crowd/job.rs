//! The walk in steps: sample by sample, each in as many moments as the forces need.

use eigenform_apart::Paths;
use eigenform_force::Bodies;
use glam::DVec2;

use super::ending::{ended, smoothed, stretch};
use super::guide::Guide;
use super::walkers::{InTheWay, Speeds, Walkers};
use super::{Aim, CrowdRules, Ending, Led};
use crate::COMPARES;
use crate::edits::avoidance::WayAround;
use crate::edits::deviation::Deviation;
use crate::edits::moved::moved;
use crate::motion::Motion;

/// Moments a second, at least.
const MOMENTS: f64 = 30.0;

/// Agents × moments of one step; some milliseconds.
const MOVES_PER_STEP: usize = 20_000;

/// Whoever is this near to the target has arrived, units: nearer than to the place of a neighbor. Forces alone never end in a place, and
/// those of a subgroup pull its rim inward for good.
const ARRIVED: f64 = 0.5;

/// How long to wait for those who do not arrive, as a multiple of the guide's time.
const PATIENCE: f64 = 4.0;

/// The body that the constants are made for, meters: that of a person.
const USUAL_RADIUS: f64 = 0.25;

/// How fast those want to be who are late, as a multiple of the fastest on the guide.
const HURRY: f64 = 1.5;

/// Who is late means to arrive so much of the last stretch early: what is left there is led back onto the guide, faster than it was walked.
const SPARE: f64 = 0.6;

/// What a step came to.
pub enum CrowdStep {
    /// How far it is, 0–1; never falls.
    Progress(f64),
    /// It is walked.
    Done(Box<Led>),
}

/// A crowd on its way along a guide.
pub struct CrowdJob {
    rules: CrowdRules,
    /// As it was given.
    given: Motion,
    /// What leads it around obstacles, a knot a sample.
    detour: Paths,
    /// With that added.
    guide: Guide,
    crowd: Walkers,
    /// Samples walked.
    at: usize,
    offsets: Paths,
    /// When everybody had arrived, if they have.
    arrived_at: Option<f64>,
    /// Past the guide's end, while those who are late are waited for.
    overtime: f64,
}

impl CrowdJob {
    /// Nobody has moved yet.
    ///
    /// # Panics
    /// When the lists of the rules do not have an entry an agent.
    pub fn new(rules: CrowdRules, guide: Motion) -> Self {
        let offsets = Paths::new(guide.agent_count(), guide.times().len(), 2);
        let WayAround { detour, shut_off } = WayAround::of(&guide, &rules.obstacles, rules.clearance, &rules.group);
        let mut goes_through = vec![false; guide.agent_count()];
        for shut in shut_off {
            goes_through[shut.agent as usize] = true;
        }
        let given = guide;
        let mut guide = Guide::new(moved(&given, &detour), rules.unit);
        let crowd = crowd(&rules, &mut guide, goes_through);
        Self { rules, given, detour, guide, crowd, at: 0, offsets, arrived_at: None, overtime: 0.0 }
    }

    /// Walks for some milliseconds; longer where a crowd of thousands is dense.
    pub fn step(&mut self) -> CrowdStep {
        let agent_count = self.guide.motion().agent_count();
        let mut moves = 0;
        while moves < MOVES_PER_STEP {
            let is_guided = self.at + 1 < self.guide.motion().times().len();
            let is_free = COMPARES && self.rules.pace.is_some();
            let is_awaited = COMPARES && self.rules.waits && self.arrived_at.is_none();
            let moments = if is_guided && !(is_free && self.arrived_at.is_some()) {
                self.walk()
            } else if is_awaited && !is_free && self.overtime < PATIENCE * self.duration() {
                self.wait()
            } else {
                return CrowdStep::Done(Box::new(self.finish()));
            };
            moves += moments * agent_count.max(1);
        }
        CrowdStep::Progress(self.at as f64 / self.guide.motion().times().len() as f64)
    }

    fn duration(&self) -> f64 {
        let [start, end] = self.guide.span();
        end - start
    }

    /// To the next sample; answers in how many moments.
    fn walk(&mut self) -> usize {
        let [from, to] = [self.at, self.at + 1].map(|k| self.guide.motion().times()[k]);
        let moments = ((to - from) * MOMENTS - 1e-9).ceil().max(1.0);
        let seconds = (to - from) / moments;
        for moment in 0..moments as usize {
            self.move_on(from + moment as f64 * seconds, seconds);
        }
        self.at += 1;
        for agent in 0..self.guide.motion().agent_count() {
            let offset = self.place(agent) - self.guide.sample(self.at, agent);
            self.offsets.path_mut(0, agent)[self.at] = offset.x;
            self.offsets.path_mut(1, agent)[self.at] = offset.y;
        }
        if COMPARES && self.rules.waits {
            self.note_arrival(to);
        }
        moments as usize
    }

    /// A second beyond the guide's end.
    fn wait(&mut self) -> usize {
        let [_, end] = self.guide.span();
        for _ in 0..MOMENTS as usize {
            self.move_on(end + self.overtime, 1.0 / MOMENTS);
            self.overtime += 1.0 / MOMENTS;
            self.note_arrival(end + self.overtime);
            if self.arrived_at.is_some() {
                break;
            }
        }
        MOMENTS as usize
    }

    fn move_on(&mut self, time: f64, seconds: f64) {
        let [_, end] = self.guide.span();
        let (look_ahead, next) = (self.rules.constants.look_ahead, time + seconds);
        let (aim, within) = match self.rules.aim {
            // As fast as anybody hurries, until one is nearly there.
            Aim::Target if COMPARES && self.rules.pace.is_some() => (end, look_ahead),
            // As fast as to be there in time: the way that is left in the time that is left.
            Aim::Target if COMPARES => (end, (end - time).max(look_ahead)),
            _ => (next + look_ahead, look_ahead + seconds),
        };
        if self.rules.ending == Ending::Exact {
            self.let_arrive(end - time);
        }
        self.guide.places_into(aim.min(end), self.crowd.aims_mut());
        self.crowd.step(seconds, within);
    }

    /// Lets those be faster than they can who would not arrive else: as fast as the straight way that is left asks for in the seconds left.
    fn let_arrive(&mut self, left: f64) {
        let stretch = stretch(self.duration());
        if left <= stretch {
            return;
        }
        let left = left - SPARE * stretch;
        let last = self.guide.motion().times().len() - 1;
        for agent in 0..self.rules.top_speed.len() {
            let own = self.rules.top_speed[agent];
            if own.is_finite() {
                let needed = self.place(agent).distance(self.guide.sample(last, agent)) / left;
                self.crowd.top_speeds_mut()[agent] = own.max(needed) / self.rules.unit;
            }
        }
    }

    fn place(&self, agent: usize) -> DVec2 {
        let [x, y] = self.crowd.places();
        DVec2::new(x[agent], y[agent]) * self.rules.unit
    }

    fn errors(&self) -> impl Iterator<Item = f64> {
        let last = self.guide.motion().times().len() - 1;
        (0..self.guide.motion().agent_count()).map(move |agent| self.place(agent).distance(self.guide.sample(last, agent)))
    }

    fn note_arrival(&mut self, time: f64) {
        let is_there = self.errors().all(|error| error <= ARRIVED * self.rules.unit);
        self.arrived_at = if is_there { self.arrived_at.or(Some(time)) } else { None };
    }

    fn finish(&mut self) -> Led {
        let Self { rules, given, detour, guide, offsets, .. } = self;
        let (last, end) = (self.at, guide.motion().times().len() - 1);
        let motion = &up_to(guide.motion(), last);
        let offsets = offsets_up_to(offsets, last);
        let error = |agent: usize| {
            let [x, y, _] = offsets.place(agent, last);
            (DVec2::new(x, y) + (guide.sample(last, agent) - guide.sample(end, agent))).length()
        };
        let arrival_error = mean_and_greatest((0..motion.agent_count()).map(error));
        let (offsets, is_clamped) = match rules.ending {
            Ending::Smoothed(least) if COMPARES => (smoothed(&offsets, motion, least), true),
            Ending::AsItComes if COMPARES => (offsets, false),
            _ => (ended(&offsets, motion.times()), true),
        };
        let offsets = sum(&offsets, &offsets_up_to(detour, last));
        let distances = (0..motion.agent_count()).flat_map(|agent| (0..=last).map(move |k| (agent, k)));
        Led {
            motion: moved(&up_to(given, last), &offsets),
            distance: mean_and_greatest(distances.map(|(agent, k)| length(&offsets, agent, k))),
            deviation: Deviation::new(motion.times().to_vec(), &offsets, [true, is_clamped]),
            arrival_error,
            arrived_after: self.arrived_at.map(|time| time - motion.times()[0]),
        }
    }
}

fn sum(paths: &Paths, other: &Paths) -> Paths {
    let mut sum = paths.clone();
    for axis in 0..2 {
        sum.axis_mut(axis).iter_mut().zip(other.axis(axis)).for_each(|(value, other)| *value += other);
    }
    sum
}

fn crowd(rules: &CrowdRules, guide: &mut Guide, goes_through: Vec<bool>) -> Walkers {
    let agent_count = guide.motion().agent_count();
    let [start, _] = guide.span();
    let mut places = |time: f64| {
        let (mut x, mut y) = (vec![0.0; agent_count], vec![0.0; agent_count]);
        guide.places_into(time, [&mut x, &mut y]);
        (x, y)
    };
    let (seconds, (x, y)) = (1.0 / MOMENTS, places(start));
    let (next_x, next_y) = places(start + seconds);
    let velocity = |from: &[f64], to: Vec<f64>| to.into_iter().zip(from).map(|(to, from)| (to - from) / seconds).collect();
    let in_units = |lengths: &[f64]| lengths.iter().map(|length| length / rules.unit).collect();
    let bodies = Bodies {
        vx: velocity(&x, next_x),
        vy: velocity(&y, next_y),
        x,
        y,
        radius: in_units(&rules.radius),
        top_speed: in_units(&rules.top_speed),
        group: rules.group.clone(),
    };
    let outlines = rules.obstacles.iter().map(|outline| {
        let mut outline = outline.clone();
        outline.points.iter_mut().flatten().for_each(|along| *along /= rules.unit);
        outline.radius /= rules.unit;
        outline
    });
    let speeds = match (rules.aim, rules.pace.map(|pace| pace / rules.unit)) {
        (Aim::Target, Some(pace)) if COMPARES => Speeds { wished: pace, greatest: HURRY * pace },
        _ => Speeds { wished: HURRY * guide.top_speed(), greatest: HURRY * guide.top_speed() },
    };
    let way = InTheWay { obstacles: outlines.collect(), goes_through };
    Walkers::new(rules, bodies, way, USUAL_RADIUS / rules.unit, speeds)
}

fn length(offsets: &Paths, agent: usize, k: usize) -> f64 {
    let [x, y, _] = offsets.place(agent, k);
    (x * x + y * y).sqrt()
}

fn mean_and_greatest(lengths: impl Iterator<Item = f64>) -> [f64; 2] {
    let (count, sum, greatest) =
        lengths.fold((0_usize, 0.0, 0.0_f64), |(count, sum, greatest), length| (count + 1, sum + length, greatest.max(length)));
    [sum / count.max(1) as f64, greatest]
}

/// The samples of a motion up to one of them.
fn up_to(motion: &Motion, last: usize) -> Motion {
    let count = (last + 1) * motion.agent_count();
    let heights = motion.heights().map(|heights| heights[..count].to_vec());
    Motion::sampled(motion.times()[..=last].to_vec(), motion.agent_count(), motion.positions()[..count].to_vec(), heights)
}

fn offsets_up_to(offsets: &Paths, last: usize) -> Paths {
    let mut kept = Paths::new(offsets.agent_count(), last + 1, 2);
    for axis in 0..2 {
        for agent in 0..offsets.agent_count() {
            kept.path_mut(axis, agent).copy_from_slice(&offsets.path(axis, agent)[..=last]);
        }
    }
    kept
}
