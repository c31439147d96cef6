//! Keyframe CSV → scene.

use std::sync::Arc;

use super::columns::Shape;
use super::groups::tree;
use super::rows::for_each_row;
use super::table::{AgentRow, Table};
use crate::error::Error;
use crate::scene::{Agent, Keyframe, Scene, Segment, Stage, Track, limits, validate};

/// How much wider the stage is than what stands on it.
const STAGE_MARGIN: f64 = 1.1;

/// A fitted stage is a whole number of these wide and deep, meters; at least two.
const STAGE_STEP: f64 = 5.0;

/// A scene out of a keyframe CSV.
#[derive(Clone, Debug, PartialEq)]
pub struct Read {
    /// What no column says has its default, except the stage, which is fitted.
    pub scene: Scene,
    /// What the file says that the scene does not follow, a sentence each.
    pub notes: Vec<String>,
}

/// The scene of a keyframe CSV.
///
/// Agents and keyframes are numbered as they first appear. An agent without a `name` is called by its id, unless all ids are whole
/// numbers; so is a keyframe by its label. The minimum distance stays 0: a file says nothing of it.
pub fn read_csv(text: &str) -> Result<Read, Error> {
    if text.len() > limits::FILE_BYTES {
        return Err(Error::FileTooLarge { bytes: text.len(), limit: limits::FILE_BYTES });
    }
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    if text.trim().is_empty() {
        return Err(Error::Empty);
    }
    if !SHAPE.is_begun_by(text) {
        return Err(text.find('\0').map_or(Error::Unrecognized, |byte| Error::NotText { byte }));
    }
    scene(&table(text)?)
}

const SHAPE: Shape = Shape {
    columns: &["keyframe", "time", "agent", "group", "x", "y", "z", "name", "color"],
    required: &["keyframe", "time", "agent", "x", "y"],
    example: "keyframe,time,agent,group,x,y",
};

fn table(text: &str) -> Result<Table, Error> {
    let mut table = Table::default();
    for_each_row(text, &SHAPE, &mut |row| table.add(row))?;
    Ok(table)
}

fn scene(table: &Table) -> Result<Read, Error> {
    let keyframes = keyframes(table)?;
    let groups = tree(table.agents.iter().map(|agent| agent.group.as_str()))?;
    let scene = Scene {
        stage: fitted_stage(&keyframes),
        groups: Arc::new(groups),
        tracks: vec![Track {
            agents: Arc::new(agents(&table.agents)),
            segments: vec![Segment::default(); keyframes.len().saturating_sub(1)],
            keyframes,
        }],
        ..Scene::default()
    };
    let mut notes = Vec::new();
    let changing = table.agents.iter().filter(|agent| agent.changes_group).count();
    if changing > 0 {
        notes.push(format!("{changing} of the agents change their group between keyframes; each keeps its first."));
    }
    checked(scene, notes)
}

/// A valid scene, at the highest frame rate that fits where its own does not: nobody chose that, so nobody could follow a refusal.
pub(in crate::scene) fn checked(mut scene: Scene, mut notes: Vec<String>) -> Result<Read, Error> {
    let mut checked = validate(&scene);
    if let Err(Error::TooManyFrames { fitting_rate, .. }) = checked {
        scene.frame_rate = f64::from(fitting_rate);
        notes.push(format!("The frame rate is {fitting_rate} a second, the highest that fits so many agents for so long."));
        checked = validate(&scene);
    }
    checked.map(|()| Read { scene, notes })
}

fn keyframes(table: &Table) -> Result<Vec<Keyframe>, Error> {
    table.dimensions_agree()?;
    let are_numbered = table.keyframes.iter().all(|keyframe| is_whole_number(&keyframe.label));
    table
        .keyframes
        .iter()
        .map(|rows| {
            let name = if are_numbered { String::new() } else { rows.label.clone() };
            let positions = Arc::new(table.formation(rows)?);
            Ok(Keyframe { name, time: rows.time, positions, ..Keyframe::default() })
        })
        .collect()
}

fn agents(rows: &[AgentRow]) -> Vec<Agent> {
    let are_numbered = rows.iter().all(|agent| is_whole_number(&agent.id));
    let called = |agent: &AgentRow| if are_numbered { String::new() } else { agent.id.clone() };
    rows.iter()
        .map(|agent| Agent { name: agent.name.clone().unwrap_or_else(|| called(agent)), color: agent.color.clone(), ..Agent::default() })
        .collect()
}

/// Whether a text is a number for a thing rather than a name.
pub(in crate::scene) fn is_whole_number(text: &str) -> bool {
    !text.is_empty() && text.bytes().all(|b| b.is_ascii_digit())
}

/// Wide, deep and high enough for everybody, centered on the ground.
pub(in crate::scene) fn fitted_stage(keyframes: &[Keyframe]) -> Stage {
    let positions = keyframes.iter().flat_map(|keyframe| keyframe.positions.positions());
    let reach = positions.fold(glam::DVec2::ZERO, |reach, position| reach.max(position.abs()));
    let steps = |length: f64| (STAGE_MARGIN * length / STAGE_STEP).ceil();
    let side = |reach: f64| (steps(2.0 * reach).max(2.0) * STAGE_STEP).min(*limits::STAGE_SIDE.end());
    let heights = keyframes.iter().flat_map(|keyframe| keyframe.positions.heights().unwrap_or_default());
    let top = heights.copied().fold(0.0, f64::max);
    let height = (steps(top) * STAGE_STEP).min(*limits::LENGTH.end());
    Stage { width: side(reach.x), depth: side(reach.y), height, ..Stage::default() }
}
