//! `eigenform assign`: who takes which place of another keyframe at the least cost.

use std::fmt::Write as _;

use eigenform::assignment::{Assignment, AssignmentSpec, Cost, DEFAULT_LAMBDA, Job, Question, check_locks, cost_of};
use eigenform::error::Error;
use eigenform::formation::Formation;
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

/// What becomes of those for whom a keyframe has no place.
#[derive(Clone, Copy, PartialEq)]
enum Rest {
    /// They are absent there.
    Leave,
    /// Where they stand already.
    Stay,
    /// At the places of the absent.
    Bench,
}

const RESTS: Words<Rest> = (&["leave", "stay", "bench"], &[Rest::Leave, Rest::Stay, Rest::Bench]);

#[derive(Serialize)]
struct Report<'a> {
    assignment: &'a [u32],
    cost: f64,
    /// By agent, where its way bends around obstacles; left out where all go straight.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    bends: Vec<Vec<[f64; 2]>>,
    /// Who takes the place of an absent agent: absent there, staying or waiting, as asked; left out where nobody is absent.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    rest: Vec<u32>,
}

pub fn run(arguments: &Assign) -> Result<Vec<String>, Failure> {
    let Opened { scene, notes, .. } = input::read(&arguments.source)?;
    let spec = spec(arguments, &scene)?;
    let [from, to] = [(arguments.from, "--from"), (arguments.to, "--to")].map(|(number, option)| input::keyframe(&scene, number, option));
    let [from, to] = [from?, to?].map(|keyframe| &scene.main_track().keyframes[keyframe]);
    let question = Question {
        source: &from.positions,
        target: &to.positions,
        spec: &spec,
        sections: &group_levels(&scene.groups, scene.main_track().agents.len()),
        is_flipped: arguments.flip,
        is_predicted: arguments.predict,
    };
    let rest = input::word(&arguments.rest, &RESTS, "--rest")?;
    let absent = &to.absent;
    let spared: &[u32] = if rest == Rest::Stay { absent } else { &[] };
    let mut job = Job::around(&question, &scene.obstacle_shapes(), scene.minimum_distance)?.sparing(spared);
    while job.step()? < 1.0 {}
    let mut bends = job.bends_to(job.slots());
    let assignment = job.into_assignment();
    let without: Vec<u32> = (0..).zip(assignment.targets()).filter(|(_, slot)| absent.contains(slot)).map(|(agent, _)| agent).collect();
    let mut ends = question.target.clone();
    if rest == Rest::Stay {
        ends = staying(&question, &assignment, &without);
        for agent in &without {
            bends[*agent as usize].clear();
        }
    }
    let cost = cost_of(&Question { target: &ends, ..question }, &assignment, &bends);
    let mut bends: Vec<Vec<[f64; 2]>> = bends.iter().map(|way| way.iter().map(|place| [place.x, place.y]).collect()).collect();
    if bends.iter().all(Vec::is_empty) {
        bends.clear();
    }
    let report = Report { assignment: assignment.targets(), cost, bends, rest: without };
    let json = || serde_json::to_string(&report).expect("numbers are JSON");
    output::print(&if arguments.json { json() } else { lines(&report) })?;
    Ok(notes)
}

/// The places once those without one stay where they are.
fn staying(question: &Question, assignment: &Assignment, without: &[u32]) -> Formation {
    let (source, target) = (question.source, question.target);
    let (mut plan, mut heights) = (target.positions().to_vec(), target.heights().map(<[f64]>::to_vec));
    for agent in without.iter().map(|agent| *agent as usize) {
        let slot = assignment.target(agent);
        plan[slot] = source.positions()[agent];
        if let Some(heights) = &mut heights {
            heights[slot] = source.height(agent);
        }
    }
    match heights {
        Some(heights) => Formation::spatial(plan, heights),
        None => Formation::new(plan),
    }
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
    for agent in &report.rest {
        writeln!(text, "rest {agent}").expect("a string takes any text");
    }
    writeln!(text, "cost {}", report.cost).expect("a string takes any text");
    text
}
