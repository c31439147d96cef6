//! `eigenform assign`: who takes which place of another keyframe at the least cost.

use std::fmt::Write as _;

use eigenform::assignment::{AssignmentSpec, Cost, DEFAULT_LAMBDA, Question, assign_around, check_locks, cost_of};
use eigenform::error::Error;
use eigenform::scene::{Opened, Scene, group_levels, limits};
use serde::Serialize;

use crate::arguments::Assign;
use crate::failure::Failure;
use crate::input::Words;
use crate::{input, output};

pub const COSTS: Words<Cost> = (
    &["squared", "least-effort", "euclidean", "manhattan", "keep"],
    &[Cost::Squared, Cost::LeastEffort, Cost::Euclidean, Cost::Manhattan, Cost::Keep],
);

/// The word for a cost.
pub fn word_of(cost: Cost) -> &'static str {
    let (words, costs) = COSTS;
    words[costs.iter().position(|known| *known == cost).expect("every cost has a word")]
}

#[derive(Serialize)]
struct Report<'a> {
    assignment: &'a [u32],
    cost: f64,
    /// By agent, where its way bends around obstacles; left out where all go straight.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    bends: Vec<Vec<[f64; 2]>>,
}

pub fn run(arguments: &Assign) -> Result<Vec<String>, Failure> {
    let Opened { scene, notes, .. } = input::read(&arguments.source)?;
    let spec = spec(arguments, &scene)?;
    let question = Question {
        source: input::formation(&scene, arguments.from, "--from")?,
        target: input::formation(&scene, arguments.to, "--to")?,
        spec: &spec,
        sections: &group_levels(&scene.groups, scene.main_track().agents.len()),
        is_flipped: arguments.flip,
        is_predicted: arguments.predict,
    };
    let (assignment, bends) = assign_around(&question, &scene.obstacle_shapes(), scene.minimum_distance)?;
    let cost = cost_of(&question, &assignment, &bends);
    let mut bends: Vec<Vec<[f64; 2]>> = bends.iter().map(|way| way.iter().map(|place| [place.x, place.y]).collect()).collect();
    if bends.iter().all(Vec::is_empty) {
        bends.clear();
    }
    let report = Report { assignment: assignment.targets(), cost, bends };
    let json = || serde_json::to_string(&report).expect("numbers are JSON");
    output::print(&if arguments.json { json() } else { lines(&report) })?;
    Ok(notes)
}

fn spec(arguments: &Assign, scene: &Scene) -> Result<AssignmentSpec, Failure> {
    let cost = input::word(&arguments.cost, &COSTS, "--cost")?;
    let lambda = arguments.lambda.unwrap_or(DEFAULT_LAMBDA);
    let (low, high) = limits::LAMBDA.into_inner();
    if !limits::LAMBDA.contains(&lambda) {
        return Err(Error::OutOfRange { value: lambda, low, high, place: "--lambda".to_owned() }.into());
    }
    let locks = arguments.lock.iter().map(|typed| lock(typed)).collect::<Result<Vec<_>, _>>()?;
    check_locks(&locks, scene.main_track().agents.len(), |index| format!("--lock {}", arguments.lock[index]))?;
    Ok(AssignmentSpec { cost, lambda, locks, keep_groups: arguments.keep_groups })
}

fn lock(typed: &str) -> Result<(u32, u32), Failure> {
    let pair = typed.split_once(':').and_then(|(agent, slot)| Some((agent.trim().parse().ok()?, slot.trim().parse().ok()?)));
    pair.ok_or_else(|| Failure::usage(format!("{typed:?} is no lock; it is an agent and its place, such as 3:17"), "--lock"))
}

fn lines(report: &Report<'_>) -> String {
    let mut text = String::new();
    for (agent, slot) in report.assignment.iter().enumerate() {
        writeln!(text, "{agent} {slot}").expect("a string takes any text");
    }
    writeln!(text, "cost {}", report.cost).expect("a string takes any text");
    text
}
