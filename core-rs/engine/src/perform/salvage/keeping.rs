//! A motion told in keyframes, as few as hold it, and tried in the scene.

use std::sync::Arc;

use glam::{DVec2, DVec3};

use super::super::Performer;
use super::super::avoid;
use super::super::job::{SegmentJob, Step};
use super::super::performed::Performed;
use super::{Salvage, SalvageReport, in_parts};
use crate::choice::{Join, MethodName, Timing};
use crate::edits::{Blocked, Edited};
use crate::error::Error;
use crate::formation::Formation;
use crate::measure::Clearance;
use crate::motion::Motion;
use crate::scene::limits::{KEYFRAMES, POSITIONS};
use crate::scene::{Keyframe, Scene, Segment, TransitionSpec, link};

/// So many keyframes are tried between the two, one after the other.
const COUNTS: [usize; 6] = [1, 2, 3, 5, 7, 11];

/// Motions told in keyframes, the nearest to the guide first; the rest would look wilder still.
const MOTIONS: usize = 4;

/// Keyframes lie no nearer in time, seconds: a person could not tell them apart on the timeline.
const SHORTEST_PART: f64 = 0.25;

/// A keyframe that a person places lies on this grid or a coarser one, meters.
const GRID: f64 = 0.01;

/// Times are whole milliseconds, as those a person drags to.
const MILLISECONDS: f64 = 1e3;

/// The trials of one segment.
pub(super) struct Keeping {
    scene: Scene,
    index: usize,
    /// The segment and those beside it as they were, and which of them it is.
    before: Vec<Arc<Performed>>,
    own: usize,
    part: Segment,
    /// Motions that keep apart, or one that does not.
    spread: Vec<Edited>,
    /// Still to try, last first.
    left: Vec<(usize, usize)>,
    trial_count: usize,
    trial: Option<Trial>,
    /// Of those that keep everybody apart and are wild all the same, the one nearest to the method's motion.
    wild: Option<Salvage>,
    /// What the best of those that failed left too near.
    closest: Option<(Vec<Clearance>, Vec<Blocked>)>,
}

/// One set of keyframes in the scene.
struct Trial {
    scene: Scene,
    count: usize,
    job: Option<SegmentJob>,
    performed: Vec<Arc<Performed>>,
}

impl Keeping {
    pub(super) fn new(scene: &Scene, index: usize, own: usize, before: Vec<Arc<Performed>>, spread: Vec<Edited>) -> Self {
        let track = scene.main_track();
        let room = (KEYFRAMES.min(POSITIONS / track.agents.len().max(1))).saturating_sub(track.keyframes.len());
        let seconds = before[own].end - before[own].start;
        let fits = |count: usize| count <= room && seconds / (count + 1) as f64 >= SHORTEST_PART;
        let is_solved = |edited: &Edited| edited.report.unsolved.is_empty() && edited.report.blocked.is_empty();
        let solved = spread.iter().take(MOTIONS).filter(|edited| is_solved(edited)).count();
        let mut left: Vec<(usize, usize)> =
            (0..solved).flat_map(|motion| COUNTS.into_iter().filter(|count| fits(*count)).map(move |count| (motion, count))).collect();
        left.reverse();
        let trial_count = left.len();
        let part = part(scene, index);
        Self { scene: scene.clone(), index, before, own, part, spread, left, trial_count, trial: None, wild: None, closest: None }
    }

    /// Works for a while; what was found once it is.
    pub(super) fn step(&mut self, performer: &mut Performer) -> Result<Option<Salvage>, Error> {
        let Some(mut trial) = self.trial.take() else {
            let Some((motion, count)) = self.left.pop() else { return Ok(Some(self.wild.take().unwrap_or_else(|| self.give_up()))) };
            self.trial = Some(self.begin(motion, count));
            return Ok(None);
        };
        let wanted = self.wanted(trial.count);
        let (next, allowed) = wanted[trial.performed.len()];
        let mut job = trial.job.take().unwrap_or_else(|| performer.begin(&trial.scene, next, &[]));
        match job.step(performer)? {
            Step::Progress(_) => trial.job = Some(job),
            Step::Done(performed) if performed.open_count() > allowed => {
                self.note(&performed);
                return Ok(None);
            }
            Step::Done(performed) => {
                trial.performed.push(performed);
                if trial.performed.len() == wanted.len() {
                    return Ok(self.judge(self.take(&trial)));
                }
            }
        }
        self.trial = Some(trial);
        Ok(None)
    }

    /// 0–1.
    pub(super) fn progress(&self) -> f64 {
        1.0 - self.left.len() as f64 / self.trial_count.max(1) as f64
    }

    /// The segments of a trial and how many meetings each may leave too near: the parts none, then those beside as many as before.
    fn wanted(&self, count: usize) -> Vec<(usize, usize)> {
        let first = self.index - self.own;
        let parts = (self.index..=self.index + count).map(|part| (part, 0));
        let beside = self.before.iter().enumerate().filter(|(place, _)| *place != self.own).map(|(place, was)| {
            let moved = if place > self.own { count } else { 0 };
            (first + place + moved, was.open_count())
        });
        parts.chain(beside).collect()
    }

    fn begin(&self, motion: usize, count: usize) -> Trial {
        let (start, end) = (self.before[self.own].start, self.before[self.own].end);
        let between: Vec<Keyframe> = (1..=count)
            .map(|k| {
                let share = k as f64 / (count + 1) as f64;
                let time = ((start + share * (end - start)) * MILLISECONDS).round() / MILLISECONDS;
                Keyframe { time, positions: Arc::new(formation(&self.scene, &self.spread[motion].motion, time)), ..Keyframe::default() }
            })
            .collect();
        let scene = in_parts(&self.scene, self.index, &between, &self.part);
        Trial { scene, count, job: None, performed: Vec::new() }
    }

    /// What can be shown is taken; of the rest the one nearest to the method's motion is remembered.
    fn judge(&mut self, salvage: Salvage) -> Option<Salvage> {
        if !salvage.report.is_wild {
            return Some(salvage);
        }
        let widest = |salvage: &Salvage| salvage.report.deviation.max;
        if self.wild.as_ref().is_none_or(|wild| widest(&salvage) < widest(wild)) {
            self.wild = Some(salvage);
        }
        None
    }

    fn note(&mut self, performed: &Performed) {
        let Some(avoided) = &performed.avoided else { return };
        let open_count = |left: &(Vec<Clearance>, Vec<Blocked>)| left.0.len() + left.1.len();
        let left = (avoided.unsolved.clone(), avoided.blocked.clone());
        if self.closest.as_ref().is_none_or(|closest| open_count(&left) < open_count(closest)) {
            self.closest = Some(left);
        }
    }

    fn take(&self, trial: &Trial) -> Salvage {
        let motions: Vec<&Motion> = trial.performed[..=trial.count].iter().map(|part| &part.motion).collect();
        let keyframes = trial.scene.main_track().keyframes[self.index + 1..=self.index + trial.count].to_vec();
        Salvage { keyframes, part: self.part.clone(), report: self.report(&motions, Vec::new(), Vec::new()) }
    }

    fn give_up(&mut self) -> Salvage {
        let nearest = &self.spread[0];
        let (unsolved, blocked) = self.closest.take().unwrap_or_else(|| {
            let report = &nearest.report;
            (report.unsolved.iter().map(|clash| avoid::clearance(*clash)).collect(), report.blocked.clone())
        });
        Salvage { keyframes: Vec::new(), part: self.part.clone(), report: self.report(&[&nearest.motion], unsolved, blocked) }
    }

    fn report(&self, motions: &[&Motion], unsolved: Vec<Clearance>, blocked: Vec<Blocked>) -> SalvageReport {
        SalvageReport::new(&self.before[self.own], motions, unsolved, blocked, self.scene.minimum_distance)
    }
}

/// Straight ways between keyframes as near as these; where every keyframe is a stop the clock runs evenly, so that nobody stops there.
fn part(scene: &Scene, index: usize) -> Segment {
    let Segment::Transition(spec) = &scene.main_track().segments[index];
    let timing = if scene.join == Join::Separate { Timing::Linear } else { spec.timing };
    let plain = TransitionSpec::default();
    Segment::Transition(TransitionSpec { method: MethodName::Linear, timing, avoidance: true, ..plain })
}

/// Where a motion has everybody at a time, on the scene's grid.
fn formation(scene: &Scene, motion: &Motion, time: f64) -> Formation {
    let times = motion.times();
    let at = times.partition_point(|known| *known <= time).clamp(1, times.len() - 1) - 1;
    let w = (time - times[at]) / (times[at + 1] - times[at]);
    let mut places: Vec<DVec3> = motion.places(at).iter().zip(motion.places(at + 1).iter()).map(|(from, to)| from.lerp(to, w)).collect();
    link::onto_grid(scene, GRID, &mut places);
    let plan: Vec<DVec2> = places.iter().map(|place| place.truncate()).collect();
    match motion.heights() {
        Some(_) => Formation::spatial(plan, places.iter().map(|place| place.z).collect()),
        None => Formation::new(plan),
    }
}
