//! One transition moved in many ways, each with the numbers that tell them apart (paper D, figures 10, 11 and 13, tables 2 and 3).
//!
//! A way is a method or what no scene has, under a cost of who goes where. The scene stays as it is.

use std::sync::Arc;

use serde::Serialize;

use super::Performer;
use super::counterpart::{Aside, Counterpart};
use super::job::{SegmentJob, Step};
use super::outcome::Avoided;
use super::performed::Performed;
use super::whole::Whole;
use crate::assignment::{self, Assignment, AssignmentSpec, Cost};
use crate::choice::MethodName;
use crate::error::Error;
use crate::formation::Formation;
use crate::measure::{Extreme, Measures, Movement, MovementCurves};
use crate::recent::{Recent, Same};
use crate::scene::{Group, Obstacle, Scene, Segment, TransitionSpec, group_levels};

/// Permuted keyframes keep formations alive; one of 5,000 agents has 80 kB.
const SEATS_BYTE_LIMIT: usize = 16 << 20;

/// How much of the progress is finding who goes where.
const SEATING_SHARE: f64 = 0.2;

/// How near to the target everybody must be at the end to have arrived, as a share of the formation's extent: round-off of a sum.
const ARRIVED: f64 = 1e-9;

/// A way that a transition can be moved.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ComparedWay {
    /// A method of scenes.
    Method(MethodName),
    /// A crowd that does not heed its mutual information.
    WithoutFeedback,
    /// A crowd without the forces of subgroups.
    WithoutGroups,
    /// What no scene has.
    Counterpart(Counterpart),
}

impl ComparedWay {
    /// Every way by its name.
    pub const ALL: [(&str, Self); 11] = [
        ("auto", Self::Method(MethodName::Auto)),
        ("linear", Self::Method(MethodName::Linear)),
        ("polar", Self::Method(MethodName::Polar)),
        ("shared", Self::Method(MethodName::Shared)),
        ("spectral", Self::Method(MethodName::Spectral)),
        ("crowd", Self::Method(MethodName::Crowd)),
        ("crowd-no-feedback", Self::WithoutFeedback),
        ("crowd-no-groups", Self::WithoutGroups),
        ("social-force-guide", Self::Counterpart(Counterpart::GuidedForce)),
        ("social-force", Self::Counterpart(Counterpart::PlainForce)),
        ("orca", Self::Counterpart(Counterpart::Orca)),
    ];

    /// Its name.
    pub fn name(self) -> &'static str {
        Self::ALL.iter().find(|(_, way)| *way == self).map_or("", |(name, _)| name)
    }

    /// By its name.
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|(known, _)| *known == name).map(|(_, way)| way)
    }

    /// Tells a transition to go this way, whatever it says; what moves it instead, where that is nothing a scene has.
    fn tell(self, transition: &mut TransitionSpec) -> Option<Counterpart> {
        transition.chosen = None;
        transition.nodes.clear();
        match self {
            Self::Method(method) => transition.method = method,
            Self::WithoutFeedback => {
                transition.method = MethodName::Crowd;
                (transition.crowd.direction_feedback, transition.crowd.speed_feedback) = (false, false);
            }
            Self::WithoutGroups => {
                transition.method = MethodName::Crowd;
                transition.crowd.constants.group_strength = 0.0;
            }
            Self::Counterpart(counterpart) => return Some(counterpart),
        }
        None
    }
}

/// What is to be compared: one of many.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Comparison {
    /// How the agents move.
    pub way: ComparedWay,
    /// By what they are given their places first; [`Cost::Keep`]: they have those of the scene. λ, locks and kept groups are those of the
    /// transition's own recipe.
    pub cost: Cost,
    /// Meters a second of everybody who arrives when they do; none: at the keyframe's time.
    pub pace: Option<f64>,
}

/// The numbers of one way.
#[derive(Debug, Serialize)]
#[serde(rename_all = "camelCase")]
pub struct Compared {
    /// The name of the way.
    pub method: &'static str,
    /// By what places were given.
    pub cost: Cost,
    /// Seconds until everybody is there; none where some never are.
    pub time: Option<f64>,
    /// Those of any transition.
    #[serde(flatten)]
    pub measures: Measures,
    /// Those of paper D.
    #[serde(flatten)]
    pub movement: Movement,
    /// What keeping apart came to, where it was asked for.
    #[serde(flatten)]
    pub avoided: Option<Avoided>,
    /// How far forces lead agents from their guide, meters.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub guide_deviation: Option<Extreme>,
    /// How far they were from the target by forces alone when the time was over, meters.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub arrival_error: Option<Extreme>,
    /// The movement over time.
    pub curves: MovementCurves,
}

/// Places given lately: ways under one cost share them.
pub struct Seats(Recent<Question, Arc<Seated>>);

/// Who takes whose place, and where everybody stands then: from the target on, a keyframe each.
struct Seated {
    takes: Assignment,
    formations: Vec<Arc<Formation>>,
}

/// Formations by identity.
#[derive(Clone, Debug, PartialEq)]
struct Question {
    source: Same<Formation>,
    targets: Vec<Same<Formation>>,
    groups: Same<Vec<Group>>,
    obstacles: Same<Vec<Obstacle>>,
    minimum_distance: f64,
    spec: AssignmentSpec,
}

impl Default for Seats {
    fn default() -> Self {
        Self(Recent::new(SEATS_BYTE_LIMIT))
    }
}

/// The work on one way.
pub struct ComparisonJob {
    scene: Scene,
    segment: usize,
    asked: Comparison,
    /// Places are being given.
    seating: Option<(assignment::Job, Question)>,
    /// The agents are moved, once everybody has a place.
    moving: Option<SegmentJob>,
}

/// What a step came to.
pub enum ComparisonStep {
    /// 0–1.
    Progress(f64),
    /// The numbers.
    Done(Box<Compared>),
}

impl ComparisonJob {
    /// Nothing is known yet. A part of a transition is compared as the whole. Refuses locks that contradict each other.
    pub fn new(scene: &Scene, segment: usize, asked: Comparison, seats: &mut Seats) -> Result<Self, Error> {
        let (scene, segment) = match Whole::of(scene, segment, &[]) {
            Some(whole) => (whole.scene, whole.index),
            None => (scene.clone(), segment),
        };
        let mut job = Self { scene, segment, asked, seating: None, moving: None };
        if asked.cost != Cost::Keep {
            let question = Question::of(&job.scene, segment, asked.cost);
            match seats.0.get(&question) {
                Some(seated) => job.sit(&seated),
                None => job.seating = Some((question.begin(&job.scene)?, question)),
            }
        }
        Ok(job)
    }

    /// Works for a while; measuring at the end is one step of up to a second or two.
    pub fn step(&mut self, performer: &mut Performer, seats: &mut Seats) -> Result<ComparisonStep, Error> {
        if let Some((mut job, question)) = self.seating.take() {
            let progress = job.step()?;
            if progress < 1.0 {
                self.seating = Some((job, question));
                return Ok(ComparisonStep::Progress(SEATING_SHARE * progress));
            }
            let seated = Arc::new(question.answered(job.into_assignment()));
            let bytes = seated.formations.iter().map(|formation| 2 * size_of_val(formation.positions())).sum();
            seats.0.put(question, seated.clone(), bytes);
            self.sit(&seated);
        }
        let Self { scene, segment, asked, moving, .. } = self;
        let job = moving.get_or_insert_with(|| asked.begin(scene, *segment, performer));
        Ok(match job.step(performer)? {
            Step::Progress(progress) => ComparisonStep::Progress(SEATING_SHARE + (1.0 - SEATING_SHARE) * progress),
            Step::Done(performed) => ComparisonStep::Done(Box::new(asked.told(&performed))),
        })
    }

    /// From the target on everybody has the place that was found for them, and is absent where whoever had it was.
    fn sit(&mut self, seated: &Seated) {
        for (keyframe, formation) in self.scene.tracks[0].keyframes.iter_mut().skip(self.segment + 1).zip(&seated.formations) {
            keyframe.positions = formation.clone();
            let is_absent = |slot: &u32| keyframe.absent.binary_search(slot).is_ok();
            keyframe.absent = (0..).zip(seated.takes.targets()).filter(|(_, slot)| is_absent(slot)).map(|(agent, _)| agent).collect();
        }
    }
}

impl Comparison {
    fn begin(self, scene: &Scene, segment: usize, performer: &mut Performer) -> SegmentJob {
        let mut tried = scene.clone();
        let Segment::Transition(transition) = &mut tried.tracks[0].segments[segment];
        let counterpart = self.way.tell(transition);
        performer.begin_compared(&tried, segment, &[], Aside { counterpart, waits: true, pace: self.pace })
    }

    fn told(self, performed: &Performed) -> Compared {
        let (movement, curves) = performed.movement();
        let crowded = performed.crowded.as_deref();
        Compared {
            method: self.way.name(),
            cost: self.cost,
            time: crowded.map_or_else(|| time_of(performed), |crowded| crowded.arrived_after),
            measures: performed.measures.clone(),
            movement,
            avoided: performed.avoided.clone(),
            guide_deviation: crowded.map(|crowded| crowded.guide_deviation),
            arrival_error: crowded.map(|crowded| crowded.arrival_error),
            curves,
        }
    }
}

/// The whole time, if that was enough.
fn time_of(performed: &Performed) -> Option<f64> {
    let (motion, target) = (performed.walked(), &performed.target);
    let last = motion.times().len() - 1;
    let near = ARRIVED * target.extent().max(1.0);
    let is_there = motion.places(last).iter().zip(target.places().iter()).all(|(at, due)| at.distance(due) <= near);
    is_there.then(|| motion.times()[last] - motion.times()[0])
}

impl Question {
    fn of(scene: &Scene, segment: usize, cost: Cost) -> Self {
        let track = scene.main_track();
        let Segment::Transition(transition) = &track.segments[segment];
        let same = |keyframe: usize| Same(track.keyframes[keyframe].positions.clone());
        Self {
            source: same(segment),
            targets: (segment + 1..track.keyframes.len()).map(same).collect(),
            groups: Same(scene.groups.clone()),
            obstacles: Same(scene.obstacles.clone()),
            minimum_distance: scene.minimum_distance,
            spec: AssignmentSpec { cost, ..transition.assignment.clone().unwrap_or_default() },
        }
    }

    fn begin(&self, scene: &Scene) -> Result<assignment::Job, Error> {
        let (source, target) = (&*self.source.0, &*self.targets[0].0);
        let sections = &group_levels(&scene.groups, source.agent_count());
        let question = assignment::Question { source, target, spec: &self.spec, sections, is_flipped: false, is_predicted: false };
        assignment::Job::around(&question, &scene.obstacle_shapes(), scene.minimum_distance)
    }

    fn answered(&self, takes: Assignment) -> Seated {
        let formations = self.targets.iter().map(|target| Arc::new(target.0.only(takes.targets()))).collect();
        Seated { takes, formations }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::read_json;

    /// Three in a row who are to stand in the same row, each on another's place, and then go on by two meters.
    fn mixed_up() -> Scene {
        let text = r#"{
            "format": "eigenform", "version": 1, "frameRate": 10,
            "keyframes": [
                { "positions": [[0, 0], [4, 0], [8, 0]] },
                { "time": 4, "positions": [[8, 3], [0, 3], [4, 3]] },
                { "time": 8, "positions": [[8, 5], [0, 5], [4, 5]] }
            ],
            "segments": [{ "method": "linear" }, { "method": "linear" }]
        }"#;
        read_json(text).expect("the scene is valid")
    }

    fn compared(scene: &Scene, asked: Comparison) -> Compared {
        let (mut performer, mut seats) = (Performer::default(), Seats::default());
        let mut job = ComparisonJob::new(scene, 0, asked, &mut seats).expect("nothing contradicts");
        let mut last = 0.0;
        loop {
            match job.step(&mut performer, &mut seats).expect("it can be performed") {
                ComparisonStep::Progress(now) => {
                    assert!((last..=1.0).contains(&now), "progress never falls: {last}, then {now}");
                    last = now;
                }
                ComparisonStep::Done(compared) => return *compared,
            }
        }
    }

    const LINEAR: Comparison = Comparison { way: ComparedWay::Method(MethodName::Linear), cost: Cost::Keep, pace: None };

    #[test]
    fn names_are_those_of_their_ways() {
        for (name, way) in ComparedWay::ALL {
            assert_eq!((ComparedWay::named(name), way.name()), (Some(way), name));
        }
    }

    #[test]
    fn each_cost_gives_the_places_it_finds_cheapest() {
        let scene = mixed_up();
        let walked = |cost: Cost| compared(&scene, Comparison { cost, ..LINEAR }).measures.path_length.max;
        // As they are, the first walks 8 m across; at the least of any cost everybody goes 3 m straight on.
        assert!((walked(Cost::Keep) - 8.0_f64.hypot(3.0)).abs() < 1e-9);
        for cost in [Cost::LeastEffort, Cost::Squared, Cost::Euclidean, Cost::Manhattan] {
            assert!((walked(cost) - 3.0).abs() < 1e-9, "{cost:?}");
        }
    }

    #[test]
    fn a_lock_of_the_recipe_stays_under_every_cost() {
        let mut scene = mixed_up();
        let Segment::Transition(transition) = &mut scene.tracks[0].segments[0];
        transition.assignment = Some(AssignmentSpec { locks: vec![(0, 0)], ..AssignmentSpec::default() });
        let longest = compared(&scene, Comparison { cost: Cost::Manhattan, ..LINEAR }).measures.path_length.max;
        assert!((longest - 8.0_f64.hypot(3.0)).abs() < 1e-9);
    }

    #[test]
    fn places_are_the_agents_own_from_then_on_and_found_once() {
        let scene = mixed_up();
        let mut seats = Seats::default();
        let asked = Comparison { cost: Cost::Squared, ..LINEAR };
        let mut job = ComparisonJob::new(&scene, 0, asked, &mut seats).expect("nothing contradicts");
        while let ComparisonStep::Progress(_) = job.step(&mut Performer::default(), &mut seats).expect("it can be performed") {}
        let keyframes = &job.scene.main_track().keyframes;
        assert_eq!(keyframes[1].positions.positions().iter().map(|p| p.x).collect::<Vec<_>>(), [0.0, 4.0, 8.0]);
        assert_eq!(keyframes[2].positions.positions().iter().map(|p| p.x).collect::<Vec<_>>(), [0.0, 4.0, 8.0]);
        let again = ComparisonJob::new(&scene, 0, asked, &mut seats).expect("nothing contradicts");
        assert!(Arc::ptr_eq(&again.scene.main_track().keyframes[1].positions, &keyframes[1].positions));
    }
}
