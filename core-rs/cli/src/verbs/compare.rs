//! `eigenform compare`: one transition several ways, with the numbers to judge them (paper D, tables 2 and 3).

use std::fmt::Write as _;

use eigenform::assignment::{AssignmentSpec, Cost};
use eigenform::error::Error;
use eigenform::measure::{Extreme, Movement};
use eigenform::perform::{Compared, ComparedWay, Comparison, ComparisonJob, ComparisonStep, Performer, Seats};
use eigenform::scene::{Opened, Scene, Segment, limits};
use serde::Serialize;

use super::assign;
use crate::arguments::Compare;
use crate::failure::Failure;
use crate::{input, output};

const NAMES: [&str; ComparedWay::ALL.len()] = {
    let mut names = [""; ComparedWay::ALL.len()];
    let mut at = 0;
    while at < names.len() {
        names[at] = ComparedWay::ALL[at].0;
        at += 1;
    }
    names
};

#[derive(Serialize)]
struct Report {
    segments: Vec<SegmentReport>,
}

#[derive(Serialize)]
struct SegmentReport {
    from: usize,
    to: usize,
    methods: Vec<Compared>,
}

pub fn run(arguments: &Compare) -> Result<Vec<String>, Failure> {
    let ways = arguments.methods.iter().map(|typed| way(typed)).collect::<Result<Vec<_>, _>>()?;
    let costs = arguments.costs.iter().map(|typed| input::word(typed, &assign::COSTS, "--costs")).collect::<Result<Vec<_>, _>>()?;
    let pace = arguments.free_arrival.map(|pace| input::within(pace, &limits::MAX_SPEED, "--free-arrival")).transpose()?;
    let lambda = arguments.lambda.map(|lambda| input::within(lambda, &limits::LAMBDA, "--lambda")).transpose()?;
    let Opened { mut scene, mut notes, .. } = input::read(&arguments.source)?;
    if let Some(lambda) = lambda {
        weigh(&mut scene, lambda);
    }
    let all: Vec<Comparison> = costs.iter().flat_map(|cost| ways.iter().map(|way| Comparison { way: *way, cost: *cost, pace })).collect();
    let (mut performer, mut seats) = (Performer::default(), Seats::default());
    let mut segments = Vec::new();
    for ends in scene.main_track().anchors().windows(2) {
        let (from, to) = (ends[0], ends[1]);
        let methods = all.iter().map(|asked| compared(&scene, from, *asked, &mut performer, &mut seats)).collect::<Result<_, Failure>>()?;
        segments.push(SegmentReport { from, to, methods });
    }
    let report = Report { segments };
    let json = || serde_json::to_string(&report).expect("numbers and words are JSON");
    output::print(&if arguments.json { json() } else { table(&report) })?;
    notes.extend(super::stillness(&scene));
    Ok(notes)
}

fn way(typed: &str) -> Result<ComparedWay, Error> {
    let unknown = || Error::UnknownValue { value: input::quoted(typed), admissible: &NAMES, place: "--methods".to_owned() };
    ComparedWay::named(typed).ok_or_else(unknown)
}

/// λ of every transition's recipe.
fn weigh(scene: &mut Scene, lambda: f64) {
    for Segment::Transition(transition) in &mut scene.tracks[0].segments {
        transition.assignment = Some(AssignmentSpec { lambda, ..transition.assignment.take().unwrap_or_default() });
    }
}

fn compared(scene: &Scene, segment: usize, asked: Comparison, performer: &mut Performer, seats: &mut Seats) -> Result<Compared, Failure> {
    let mut job = ComparisonJob::new(scene, segment, asked, seats)?;
    loop {
        if let ComparisonStep::Done(compared) = job.step(performer, seats)? {
            return Ok(*compared);
        }
    }
}

/// A column of the table: its head, and what stands under it.
type Column = (&'static str, fn(&Compared) -> String);

/// Averages over time, as in the paper.
const COLUMNS: [Column; 13] = [
    ("cost", |way| assign::word_of(way.cost).to_owned()),
    ("method", |way| way.method.to_owned()),
    ("time", |way| told(way.time, 2)),
    ("I_d", |way| mean(way, |movement| movement.mutual_information, 3)),
    ("I_v", |way| mean(way, |movement| movement.speed_information, 3)),
    ("structure", |way| mean(way, |movement| movement.structure_deviation, 4)),
    ("effort", |way| mean(way, |movement| movement.effort_deviation, 3)),
    ("target", |way| mean(way, |movement| movement.target_deviation, 3)),
    ("distance", |way| told(way.measures.clearance.map(|clearance| clearance.distance), 3)),
    ("turning", |way| told(Some(way.measures.turning.mean), 3)),
    ("path", |way| told(Some(way.measures.path_length.mean), 2)),
    ("roughness", |way| told(Some(way.movement.roughness), 2)),
    ("late", |way| told(way.arrival_error.map(|error| error.max), 3)),
];

fn told(value: Option<f64>, digits: usize) -> String {
    value.map_or_else(|| "-".to_owned(), |value| format!("{value:.digits$}"))
}

fn mean(way: &Compared, of: fn(&Movement) -> Extreme, digits: usize) -> String {
    told(Some(of(&way.movement).mean), digits)
}

/// A block a transition; the cost is left out where everybody has the place of the scene.
fn table(report: &Report) -> String {
    let mut text = String::new();
    for segment in &report.segments {
        writeln!(text, "keyframe {} to {}", segment.from, segment.to).expect("a string takes any text");
        let is_seated = segment.methods.iter().any(|way| way.cost != Cost::Keep);
        let columns = &COLUMNS[usize::from(!is_seated)..];
        let heads = columns.iter().map(|(head, _)| (*head).to_owned()).collect();
        let rows: Vec<Vec<String>> =
            std::iter::once(heads).chain(segment.methods.iter().map(|way| columns.iter().map(|(_, cell)| cell(way)).collect())).collect();
        let widths: Vec<usize> = (0..columns.len()).map(|column| rows.iter().map(|row| row[column].len()).max().unwrap_or(0)).collect();
        for row in rows {
            let cells: Vec<String> = row.iter().zip(&widths).map(|(cell, width)| format!("{cell:<width$}")).collect();
            writeln!(text, "{}", cells.join("  ").trim_end()).expect("a string takes any text");
        }
    }
    text
}
