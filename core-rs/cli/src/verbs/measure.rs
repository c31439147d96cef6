//! `eigenform measure`: how good each transition is.

use std::fmt::Write as _;

use eigenform::choice::{Choice, MethodName, Timing};
use eigenform::edits::{Blocked, ShutOff};
use eigenform::measure::{Measures, Movement};
use eigenform::perform::{Avoided, Candidate, Crowded, Hurry, Performed, perform};
use eigenform::scene::{Opened, Scene, Segment, TransitionSpec, cautions};
use serde::Serialize;

use crate::arguments::Measure;
use crate::failure::Failure;
use crate::{input, output};

#[derive(Serialize)]
struct Report<'p> {
    segments: Vec<SegmentReport<'p>>,
}

#[derive(Serialize)]
#[serde(rename_all = "camelCase")]
struct SegmentReport<'p> {
    method: MethodName,
    options: Options,
    #[serde(flatten)]
    measures: &'p Measures,
    #[serde(flatten)]
    movement: Movement,
    #[serde(flatten)]
    avoided: Option<&'p Avoided>,
    #[serde(skip_serializing_if = "Option::is_none")]
    held_clearance: Option<&'p Blocked>,
    #[serde(flatten)]
    crowded: Option<&'p Crowded>,
    candidates: Vec<CandidateReport>,
}

#[derive(Serialize)]
struct CandidateReport {
    method: MethodName,
    options: Options,
    score: f64,
    chosen: bool,
}

/// The options that the method uses.
#[derive(Serialize)]
#[serde(rename_all = "camelCase")]
struct Options {
    #[serde(skip_serializing_if = "Option::is_none")]
    order: Option<eigenform::choice::Order>,
    #[serde(skip_serializing_if = "Option::is_none")]
    alignment: Option<eigenform::choice::Alignment>,
    #[serde(skip_serializing_if = "Option::is_none")]
    sharing: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    keep_size: Option<bool>,
    timing: Timing,
    /// Said where groups move as wholes.
    #[serde(skip_serializing_if = "Option::is_none")]
    hierarchy: Option<bool>,
}

pub fn run(arguments: &Measure) -> Result<Vec<String>, Failure> {
    let Opened { scene, mut notes, .. } = input::read(&arguments.source)?;
    let performance = perform(&scene)?;
    let segments = transitions(&scene).zip(performance.segments()).map(|(transition, performed)| report(transition, performed));
    let report = Report { segments: segments.collect() };
    let json = || serde_json::to_string(&report).expect("numbers and words are JSON");
    output::print(&if arguments.json { json() } else { table(&report) })?;
    notes.extend(super::stillness(&scene));
    notes.extend(cautions(&scene));
    Ok(notes)
}

fn transitions(scene: &Scene) -> impl Iterator<Item = &TransitionSpec> {
    scene.main_track().segments.iter().map(|Segment::Transition(transition)| transition)
}

fn report<'p>(transition: &TransitionSpec, performed: &'p Performed) -> SegmentReport<'p> {
    SegmentReport {
        method: performed.choice.method,
        options: options(&performed.choice, transition),
        measures: &performed.measures,
        movement: performed.movement().0,
        avoided: performed.avoided.as_ref(),
        held_clearance: performed.held_clearance.as_ref(),
        crowded: performed.crowded.as_deref(),
        candidates: performed.candidates.iter().map(|candidate| candidate_report(candidate, transition)).collect(),
    }
}

fn candidate_report(candidate: &Candidate, transition: &TransitionSpec) -> CandidateReport {
    let Candidate { choice, score, is_chosen, .. } = candidate;
    CandidateReport { method: choice.method, options: options(choice, transition), score: *score, chosen: *is_chosen }
}

fn options(choice: &Choice, transition: &TransitionSpec) -> Options {
    let is_spectral = choice.method == MethodName::Spectral;
    let has_modes = is_spectral || choice.method == MethodName::Shared;
    Options {
        order: is_spectral.then_some(choice.order),
        alignment: (has_modes || choice.method == MethodName::Polar).then_some(choice.alignment),
        sharing: is_spectral.then_some(choice.sharing),
        keep_size: has_modes.then_some(transition.keep_size),
        timing: transition.timing,
        hierarchy: transition.hierarchy.then_some(true),
    }
}

fn table(report: &Report<'_>) -> String {
    let mut text = String::from("segment  method    distortion  turning  clearance  near  path    speed\n");
    for (index, segment) in report.segments.iter().enumerate() {
        let measures = segment.measures;
        let clearance = measures.clearance.map_or_else(|| "-".to_owned(), |clearance| format!("{:.3}", clearance.distance));
        writeln!(
            text,
            "{index:<7}  {:<8}  {:<10.4}  {:<7.3}  {clearance:<9}  {:<4}  {:<6.2}  {:.2}",
            format!("{:?}", segment.method).to_lowercase(),
            measures.distortion.mean,
            measures.turning.mean,
            measures.near_collisions,
            measures.path_length.mean,
            measures.top_speed.speed,
        )
        .expect("a string takes any text");
    }
    for (index, segment) in report.segments.iter().enumerate() {
        if let Some(Blocked { distance, time, agent, obstacle }) = segment.held_clearance {
            writeln!(
                text,
                "segment {index}: agent {agent}, tied to obstacle {obstacle}, is {distance:.3} m from it at {time:.2} s, nobody nearer"
            )
            .expect("a string takes any text");
        }
        for Hurry { agent, speed, max_speed, duration } in segment.crowded.iter().flat_map(|crowded| &crowded.hurried) {
            writeln!(
                text,
                "segment {index}: agent {agent} moves at up to {speed:.2} m/s to arrive in time, and its top speed is {max_speed} m/s; \
                 {duration:.1} s would do"
            )
            .expect("a string takes any text");
        }
        for clash in segment.avoided.iter().flat_map(|avoided| &avoided.unsolved) {
            let (a, b) = clash.agents;
            writeln!(text, "segment {index}: agents {a} and {b} are {:.3} m apart at {:.2} s", clash.distance, clash.time)
                .expect("a string takes any text");
        }
        for ShutOff { agent, obstacle, distance } in segment.avoided.iter().flat_map(|avoided| &avoided.shut_off) {
            writeln!(
                text,
                "segment {index}: no way leads agent {agent} to its place, so it goes through: obstacle {obstacle} shuts it off; move the \
                 obstacle, or leave a gap of {} m",
                2.0 * distance
            )
            .expect("a string takes any text");
        }
        for at in segment.avoided.iter().flat_map(|avoided| &avoided.blocked) {
            let (agent, obstacle) = (at.agent, at.obstacle);
            let side = if at.distance < 0.0 { "inside" } else { "from" };
            writeln!(text, "segment {index}: agent {agent} is {:.3} m {side} obstacle {obstacle} at {:.2} s", at.distance.abs(), at.time)
                .expect("a string takes any text");
        }
    }
    text
}
