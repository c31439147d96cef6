//! `eigenform modes`: eigenvalues and ties of one keyframe, and how its modes become those of the next.

use std::collections::BTreeMap;
use std::fmt::Write as _;

use eigenform::choice::Order;
use eigenform::formation::Formation;
use eigenform::perform::Performer;
use eigenform::scene::{Opened, Scene};
use eigenform::spectral::{Eigenbasis, ModeMatch};
use serde::Serialize;

use crate::arguments::Modes;
use crate::failure::Failure;
use crate::{input, output};

#[derive(Serialize)]
struct Report {
    eigenvalues: Vec<f64>,
    ties: Vec<(u32, u32, f64)>,
    #[serde(flatten)]
    vectors: Option<Vectors>,
    #[serde(flatten)]
    change: Option<Change>,
}

#[derive(Serialize)]
struct Vectors {
    /// One unit mode an eigenvalue, one entry an agent of the scene.
    vectors: Vec<Vec<f64>>,
    /// One (x, y) a mode, meters; (x, y, z) of a formation with heights.
    coefficients: Vec<Vec<f64>>,
}

/// How modes become those of the next keyframe (paper A, figure 7).
#[derive(Serialize)]
struct Change {
    /// A row a mode of this keyframe, an entry a mode of the next; the constant ones are left out.
    likeness: Vec<Vec<f64>>,
    /// By the word for an order; modes count from 1.
    pairs: BTreeMap<&'static str, Vec<usize>>,
    between: Between,
}

#[derive(Serialize)]
struct Between {
    t: Vec<f64>,
    eigenvalues: Vec<Vec<f64>>,
}

/// Pieces of the way from one keyframe's graph to the next: as fine as a plot is looked at.
const STEPS: usize = 32;

pub fn run(arguments: &Modes) -> Result<Vec<String>, Failure> {
    let Opened { scene, notes, .. } = input::read(&arguments.source)?;
    let keyframe = input::keyframe(&scene, arguments.keyframe, "--keyframe")?;
    let formation = &*scene.main_track().keyframes[keyframe].positions;
    let mut performer = Performer::default();
    let adjacency = performer.graph(&scene, keyframe)?;
    let (basis, there) = performer.eigenbasis(&scene, keyframe)?;
    let report = Report {
        eigenvalues: basis.eigenvalues().to_vec(),
        ties: adjacency.ties().iter().map(|tie| (tie.a, tie.b, tie.weight)).collect(),
        vectors: arguments.vectors.then(|| vectors(&basis, formation, &there)),
        change: if arguments.next { Some(change(&scene, keyframe, &mut performer)?) } else { None },
    };
    let json = || serde_json::to_string(&report).expect("numbers are JSON");
    output::print(&if arguments.json { json() } else { lines(&report.eigenvalues) })?;
    Ok(notes)
}

/// The basis leaves the constant mode out; it carries the barycenter. Who is not there has no part in any mode.
fn vectors(basis: &Eigenbasis, formation: &Formation, there: &[u32]) -> Vectors {
    if there.is_empty() {
        return Vectors { vectors: Vec::new(), coefficients: Vec::new() };
    }
    let of_all = |entries: &mut dyn Iterator<Item = f64>| {
        let mut vector = vec![0.0; formation.agent_count()];
        there.iter().zip(entries).for_each(|(agent, entry)| vector[*agent as usize] = entry);
        vector
    };
    let size = (there.len() as f64).sqrt();
    let constant = of_all(&mut std::iter::repeat(1.0 / size));
    let modes = basis.modes().col_iter().map(|mode| of_all(&mut mode.iter().copied()));
    let standing = formation.only(there);
    let center = standing.places().barycenter() * size;
    let dimensions = if formation.heights().is_some() { 3 } else { 2 };
    let coefficients = std::iter::once(center).chain(basis.coefficients(&standing)).map(|c| c.to_array()[..dimensions].to_vec());
    Vectors { vectors: std::iter::once(constant).chain(modes).collect(), coefficients: coefficients.collect() }
}

fn change(scene: &Scene, keyframe: usize, performer: &mut Performer) -> Result<Change, Failure> {
    if keyframe >= scene.main_track().segments.len() {
        return Err(Failure::usage(format!("keyframe {keyframe} is the last one; none comes after it"), "--next"));
    }
    let ModeMatch { mode_count, amounts, targets } = performer.mode_match(scene, keyframe)?;
    let named = ModeMatch::ORDERS.into_iter().zip(targets);
    Ok(Change {
        likeness: (0..mode_count).map(|k| amounts[k * mode_count..][..mode_count].to_vec()).collect(),
        pairs: named.map(|(order, targets)| (word_of(order), targets.iter().map(|target| target + 1).collect())).collect(),
        between: Between {
            t: (0..=STEPS).map(|step| step as f64 / STEPS as f64).collect(),
            eigenvalues: performer.eigenvalues_between(scene, keyframe, STEPS)?,
        },
    })
}

fn word_of(order: Order) -> &'static str {
    match order {
        Order::Eigenvalue => "eigenvalue",
        Order::Greedy => "greedy",
        Order::Maxmin => "maxmin",
        Order::Hungarian => "hungarian",
    }
}

fn lines(eigenvalues: &[f64]) -> String {
    eigenvalues.iter().fold(String::new(), |mut text, value| {
        writeln!(text, "{value}").expect("a string takes any text");
        text
    })
}
