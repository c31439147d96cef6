//! `eigenform compare`: one transition several ways, with the numbers to judge them (paper D, tables 2 and 3).

use std::fmt::Write as _;
use std::sync::Arc;

use eigenform::choice::MethodName;
use eigenform::error::Error;
use eigenform::measure::{Measures, Movement, MovementCurves};
use eigenform::perform::{Avoided, Counterpart, Crowded, Performed, Performer, Step};
use eigenform::scene::{Opened, Scene, Segment};
use serde::Serialize;

use crate::arguments::Compare;
use crate::failure::Failure;
use crate::{input, output};

/// Every way there is, by the name that is typed.
const WAYS: [(&str, Way); 10] = [
    ("auto", Way::Method(MethodName::Auto)),
    ("linear", Way::Method(MethodName::Linear)),
    ("polar", Way::Method(MethodName::Polar)),
    ("shared", Way::Method(MethodName::Shared)),
    ("spectral", Way::Method(MethodName::Spectral)),
    ("crowd", Way::Method(MethodName::Crowd)),
    ("crowd-no-feedback", Way::WithoutFeedback),
    ("crowd-no-groups", Way::WithoutGroups),
    ("social-force-guide", Way::Counterpart(Counterpart::GuidedForce)),
    ("social-force", Way::Counterpart(Counterpart::PlainForce)),
];

const NAMES: [&str; WAYS.len()] = {
    let mut names = [""; WAYS.len()];
    let mut at = 0;
    while at < WAYS.len() {
        names[at] = WAYS[at].0;
        at += 1;
    }
    names
};

#[derive(Clone, Copy)]
enum Way {
    Method(MethodName),
    WithoutFeedback,
    WithoutGroups,
    /// What no scene has.
    Counterpart(Counterpart),
}

#[derive(Serialize)]
struct Report {
    segments: Vec<SegmentReport>,
}

#[derive(Serialize)]
struct SegmentReport {
    from: usize,
    to: usize,
    methods: Vec<WayReport>,
}

#[derive(Serialize)]
struct WayReport {
    method: &'static str,
    /// Seconds until everybody is there; none where forces alone never bring them.
    time: Option<f64>,
    #[serde(flatten)]
    measures: Measures,
    #[serde(flatten)]
    movement: Movement,
    #[serde(flatten)]
    avoided: Option<Avoided>,
    #[serde(rename = "guideDeviation", skip_serializing_if = "Option::is_none")]
    guide_deviation: Option<eigenform::measure::Extreme>,
    #[serde(rename = "arrivalError", skip_serializing_if = "Option::is_none")]
    arrival_error: Option<eigenform::measure::Extreme>,
    curves: MovementCurves,
}

pub fn run(arguments: &Compare) -> Result<Vec<String>, Failure> {
    let ways = arguments.methods.iter().map(|typed| way(typed)).collect::<Result<Vec<_>, _>>()?;
    let Opened { scene, notes, .. } = input::read(&arguments.source)?;
    let mut performer = Performer::default();
    let segments = (0..scene.main_track().segments.len()).map(|index| {
        let methods = ways.iter().map(|way| try_way(&mut performer, &scene, index, *way)).collect::<Result<_, Failure>>()?;
        Ok(SegmentReport { from: index, to: index + 1, methods })
    });
    let report = Report { segments: segments.collect::<Result<_, Failure>>()? };
    let json = || serde_json::to_string(&report).expect("numbers and words are JSON");
    output::print(&if arguments.json { json() } else { table(&report) })?;
    Ok(notes)
}

fn way(typed: &str) -> Result<(&'static str, Way), Error> {
    let known = WAYS.into_iter().find(|(name, _)| *name == typed);
    known.ok_or_else(|| Error::UnknownValue { value: input::quoted(typed), admissible: &NAMES, place: "--methods".to_owned() })
}

/// The segment moved one way, whatever the scene says of it; its neighbors stay as they are.
fn try_way(performer: &mut Performer, scene: &Scene, index: usize, (method, way): (&'static str, Way)) -> Result<WayReport, Failure> {
    let mut tried = scene.clone();
    let Segment::Transition(transition) = &mut tried.tracks[0].segments[index];
    let counterpart = match way {
        Way::Method(method) => {
            transition.method = method;
            None
        }
        Way::WithoutFeedback => {
            transition.method = MethodName::Crowd;
            (transition.crowd.direction_feedback, transition.crowd.speed_feedback) = (false, false);
            None
        }
        Way::WithoutGroups => {
            transition.method = MethodName::Crowd;
            transition.crowd.constants.group_strength = 0.0;
            None
        }
        Way::Counterpart(counterpart) => Some(counterpart),
    };
    transition.chosen = None;
    transition.nodes.clear();
    let mut job = performer.begin_compared(&tried, index, &[], counterpart, true);
    loop {
        if let Step::Done(performed) = job.step(performer)? {
            return Ok(report(method, &performed));
        }
    }
}

fn report(method: &'static str, performed: &Arc<Performed>) -> WayReport {
    let (movement, curves) = performed.movement();
    let crowded = performed.crowded.as_deref();
    let times = performed.motion.times();
    WayReport {
        method,
        time: match crowded {
            Some(Crowded { arrived_after, .. }) => *arrived_after,
            None => Some(times[times.len() - 1] - times[0]),
        },
        measures: performed.measures.clone(),
        movement,
        avoided: performed.avoided.clone(),
        guide_deviation: crowded.map(|crowded| crowded.guide_deviation),
        arrival_error: crowded.map(|crowded| crowded.arrival_error),
        curves,
    }
}

/// Averages over time, as in the paper.
fn table(report: &Report) -> String {
    let mut text = String::new();
    for segment in &report.segments {
        writeln!(text, "keyframe {} to {}", segment.from, segment.to).expect("a string takes any text");
        text.push_str(
            "method              time    I_d    I_v    structure  effort   target   distance  turning  path    roughness  late\n",
        );
        for way in &segment.methods {
            let Movement { mutual_information, speed_information, structure_deviation, effort_deviation, target_deviation, roughness } =
                &way.movement;
            let told = |value: Option<f64>, digits: usize| value.map_or_else(|| "-".to_owned(), |value| format!("{value:.digits$}"));
            writeln!(
                text,
                "{:<18}  {:<6}  {:<5.3}  {:<5.3}  {:<9.4}  {:<7.3}  {:<7.3}  {:<8}  {:<7.3}  {:<6.2}  {:<9.2}  {}",
                way.method,
                told(way.time, 2),
                mutual_information.mean,
                speed_information.mean,
                structure_deviation.mean,
                effort_deviation.mean,
                target_deviation.mean,
                told(way.measures.clearance.map(|clearance| clearance.distance), 3),
                way.measures.turning.mean,
                way.measures.path_length.mean,
                roughness,
                told(way.arrival_error.map(|error| error.max), 3),
            )
            .expect("a string takes any text");
        }
    }
    text
}
