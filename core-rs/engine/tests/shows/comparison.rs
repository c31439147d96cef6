//! The tables of docs/comparison.md say what is found.

use std::fs;
use std::path::PathBuf;

use eigenform::assignment::Cost;
use eigenform::choice::MethodName;
use eigenform::perform::{Compared, ComparedWay, Comparison, ComparisonJob, ComparisonStep, Counterpart, Performer, Seats};
use eigenform::scene::{Scene, open};

/// Meters a second, as everybody goes with free arrival.
const PACE: f64 = 1.34;

/// A mark to round where it is printed, and what differs from one machine to another beside it: a hundredth.
const HALF_A_DIGIT: f64 = 0.51;

fn read(path: &str) -> String {
    let path = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../..").join(path);
    fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

/// Head and rows of a table, cell by cell.
struct Table {
    head: Vec<String>,
    rows: Vec<Vec<String>>,
}

/// The tables below a heading.
fn tables_below(heading: &str) -> Vec<Table> {
    let text = read("docs/comparison.md");
    let (_, below) = text.split_once(heading).expect("the heading is there");
    let blocks = below.split("\n\n").filter(|block| block.starts_with('|'));
    let cells = |line: &str| line.trim_matches('|').split('|').map(|cell| cell.trim().to_owned()).collect::<Vec<_>>();
    let table = |block: &str| {
        let mut lines = block.lines().map(cells);
        let head = lines.next().expect("a table has a head");
        Table { head, rows: lines.skip(1).collect() }
    };
    blocks.map(table).collect()
}

fn way_of(words: &str) -> ComparedWay {
    match words {
        "linear" => ComparedWay::Method(MethodName::Linear),
        "polar" => ComparedWay::Method(MethodName::Polar),
        "spectral" => ComparedWay::Method(MethodName::Spectral),
        "crowd" => ComparedWay::Method(MethodName::Crowd),
        "crowd without feedback" => ComparedWay::WithoutFeedback,
        "crowd without subgroups" => ComparedWay::WithoutGroups,
        "social force alone" => ComparedWay::Counterpart(Counterpart::PlainForce),
        "ORCA alone" => ComparedWay::Counterpart(Counterpart::Orca),
        other => panic!("{other:?} is no way"),
    }
}

fn cost_of(words: &str) -> Cost {
    match words {
        "least effort" => Cost::LeastEffort,
        "Euclidean" => Cost::Euclidean,
        "Manhattan" => Cost::Manhattan,
        other => panic!("{other:?} is no cost"),
    }
}

/// What stands under a head, and whether more of it is better.
fn found_in(compared: &Compared, head: &str) -> (f64, bool) {
    let movement = &compared.movement;
    let less = |value| (value, false);
    match head {
        "time, s" => less(compared.time.expect("all arrive")),
        "I_d, bits" => less(movement.mutual_information.mean),
        "structure σ, m" => less(movement.structure_deviation.mean),
        "effort σ, m" => less(movement.effort_deviation.mean),
        "clearance, m" => (compared.measures.clearance.expect("there are several").distance, true),
        "path, m" => less(compared.measures.path_length.mean),
        "turning, rad" => less(compared.measures.turning.mean),
        "jerk, m/s³" => less(movement.roughness),
        other => panic!("{other:?} is no measure"),
    }
}

fn compared(scene: &Scene, asked: Comparison, performer: &mut Performer, seats: &mut Seats) -> Compared {
    let mut job = ComparisonJob::new(scene, 0, asked, seats).expect("nothing is locked");
    loop {
        if let ComparisonStep::Done(compared) = job.step(performer, seats).expect("it can be performed") {
            return *compared;
        }
    }
}

/// Every row of a table is asked for by what its first cell says.
fn check(table: &Table, asked: fn(&str) -> Comparison) {
    let scene = open(&read("public/examples/fighters.eigenform.json")).expect("an example opens").scene;
    let (mut performer, mut seats) = (Performer::default(), Seats::default());
    let found: Vec<Compared> = table.rows.iter().map(|row| compared(&scene, asked(&row[0]), &mut performer, &mut seats)).collect();
    for (column, head) in table.head.iter().enumerate().skip(1) {
        let told: Vec<f64> = found.iter().map(|compared| found_in(compared, head).0).collect();
        for (row, told) in table.rows.iter().zip(&told) {
            let said = row[column].trim_matches('*');
            let digits = said.split_once('.').map_or(0, |(_, digits)| digits.len());
            let off = (said.parse::<f64>().expect("a number") - told).abs() * 10_f64.powf(digits as f64);
            assert!(off <= HALF_A_DIGIT, "{}, {head}: {said} is said, {told} found", row[0]);
        }
        let is_more_better = found_in(&found[0], head).1;
        let best = told.iter().copied().reduce(if is_more_better { f64::max } else { f64::min }).expect("there are rows");
        let (bold, _) = table.rows.iter().zip(&told).find(|(_, told)| **told == best).expect("it is one of them");
        assert!(bold[column].starts_with("**"), "{head}: {} is the best", bold[0]);
    }
}

#[test]
fn the_table_of_costs_says_what_is_found() {
    let tables = tables_below("## What we measured");
    assert_eq!(tables.len(), 3, "each is found again by a test");
    check(&tables[0], |cost| Comparison { way: way_of("crowd"), cost: cost_of(cost), pace: Some(PACE) });
}

#[test]
fn the_table_of_ways_that_arrive_when_they_do_says_what_is_found() {
    check(&tables_below("## What we measured")[1], |way| Comparison { way: way_of(way), cost: Cost::LeastEffort, pace: Some(PACE) });
}

#[test]
fn the_table_of_ways_at_the_keyframes_time_says_what_is_found() {
    check(&tables_below("## What we measured")[2], |way| Comparison { way: way_of(way), cost: Cost::LeastEffort, pace: None });
}
