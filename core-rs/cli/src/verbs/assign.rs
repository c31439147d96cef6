//! `eigenform assign`: who takes which place of another keyframe at the least cost.

use std::fmt::Write as _;

use eigenform::assignment::squared;
use eigenform::error::Error;
use eigenform::scene::Opened;
use serde::Serialize;

use crate::arguments::Assign;
use crate::failure::Failure;
use crate::{input, output};

#[derive(Serialize)]
struct Report<'a> {
    assignment: &'a [u32],
    cost: f64,
}

pub fn run(arguments: &Assign) -> Result<Vec<String>, Failure> {
    check_cost(arguments)?;
    let Opened { scene, notes, .. } = input::read(&arguments.source)?;
    let source = input::formation(&scene, arguments.from, "--from")?;
    let target = input::formation(&scene, arguments.to, "--to")?;
    let assignment = squared(source, target);
    let (from, to) = (source.places(), target.places());
    let cost = assignment.total(|agent, slot| from.at(agent).distance_squared(to.at(slot)));
    let report = Report { assignment: assignment.targets(), cost };
    let json = || serde_json::to_string(&report).expect("numbers are JSON");
    output::print(&if arguments.json { json() } else { lines(&report) })?;
    Ok(notes)
}

fn check_cost(arguments: &Assign) -> Result<(), Failure> {
    let supported = "squared".to_owned();
    if arguments.cost != supported {
        let (value, place) = (format!("{:?}", arguments.cost), "--cost".to_owned());
        return Err(Error::Unsupported { value, supported, place }.into());
    }
    match arguments.lambda {
        Some(lambda) => {
            let supported = "the cost squared, which has no such weight,".to_owned();
            Err(Error::Unsupported { value: lambda.to_string(), supported, place: "--lambda".to_owned() }.into())
        }
        None => Ok(()),
    }
}

fn lines(report: &Report<'_>) -> String {
    let mut text = String::new();
    for (agent, slot) in report.assignment.iter().enumerate() {
        writeln!(text, "{agent} {slot}").expect("a string takes any text");
    }
    writeln!(text, "cost {}", report.cost).expect("a string takes any text");
    text
}
