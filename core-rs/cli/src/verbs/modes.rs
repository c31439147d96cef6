//! `eigenform modes`: eigenvalues and ties of one keyframe.

use std::fmt::Write as _;

use eigenform::formation::Formation;
use eigenform::perform::Performer;
use eigenform::scene::Opened;
use eigenform::spectral::Eigenbasis;
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
}

#[derive(Serialize)]
struct Vectors {
    /// One unit mode an eigenvalue, one entry an agent.
    vectors: Vec<Vec<f64>>,
    /// One (x, y) a mode, meters; (x, y, z) of a formation with heights.
    coefficients: Vec<Vec<f64>>,
}

pub fn run(arguments: &Modes) -> Result<Vec<String>, Failure> {
    let Opened { scene, notes, .. } = input::read(&arguments.source)?;
    let formation = input::formation(&scene, arguments.keyframe, "--keyframe")?;
    let mut performer = Performer::default();
    let adjacency = performer.graph(&scene, arguments.keyframe)?;
    let basis = performer.eigenbasis(&scene, arguments.keyframe)?;
    let report = Report {
        eigenvalues: basis.eigenvalues().to_vec(),
        ties: adjacency.ties().iter().map(|tie| (tie.a, tie.b, tie.weight)).collect(),
        vectors: arguments.vectors.then(|| vectors(&basis, formation)),
    };
    let json = || serde_json::to_string(&report).expect("numbers are JSON");
    output::print(&if arguments.json { json() } else { lines(&report.eigenvalues) })?;
    Ok(notes)
}

/// The basis leaves the constant mode out; it carries the barycenter.
fn vectors(basis: &Eigenbasis, formation: &Formation) -> Vectors {
    let agent_count = basis.agent_count();
    if agent_count == 0 {
        return Vectors { vectors: Vec::new(), coefficients: Vec::new() };
    }
    let size = (agent_count as f64).sqrt();
    let constant = vec![1.0 / size; agent_count];
    let modes = basis.modes().col_iter().map(|mode| mode.iter().copied().collect());
    let center = formation.places().barycenter() * size;
    let dimensions = if formation.heights().is_some() { 3 } else { 2 };
    let coefficients = std::iter::once(center).chain(basis.coefficients(formation)).map(|c| c.to_array()[..dimensions].to_vec());
    Vectors { vectors: std::iter::once(constant).chain(modes).collect(), coefficients: coefficients.collect() }
}

fn lines(eigenvalues: &[f64]) -> String {
    eigenvalues.iter().fold(String::new(), |mut text, value| {
        writeln!(text, "{value}").expect("a string takes any text");
        text
    })
}
