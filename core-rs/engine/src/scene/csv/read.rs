//! Keyframe CSV → scene.

use std::sync::Arc;

use csv::{ReaderBuilder, StringRecord};

use super::columns::Columns;
use super::groups::tree;
use super::table::{AgentRow, Table};
use crate::error::Error;
use crate::scene::validate::length;
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
    scene(&table(text)?)
}

/// Refuses rows that no agent needs before the parser makes room for their fields.
fn rows_are_short(text: &str) -> Result<(), Error> {
    for (number, line) in (1_u64..).zip(text.lines()) {
        // Old files end their rows with a carriage return alone.
        line.split('\r').try_for_each(|row| length(row, limits::ROW_CHARACTERS, format_args!("row {number}")))?;
    }
    Ok(())
}

fn table(text: &str) -> Result<Table, Error> {
    rows_are_short(text)?;
    // Flexible: a row of another length is our own error, with its row number.
    let mut reader = ReaderBuilder::new().flexible(true).has_headers(false).from_reader(text.as_bytes());
    let mut record = StringRecord::new();
    let mut next = |record: &mut StringRecord| reader.read_record(record).expect("rows of a text may have any length");
    next(&mut record);
    let columns = Columns::of(&record)?;
    let mut table = Table::default();
    let mut rows = RowNumbers { text: text.as_bytes(), byte: 0, number: 1 };
    while next(&mut record) {
        // Spreadsheets leave rows of nothing but commas behind.
        if record.iter().all(|field| field.trim().is_empty()) {
            continue;
        }
        let number = rows.at(record.position().map_or(0, csv::Position::byte) as usize);
        table.add(&columns.row(&record, number)?)?;
    }
    Ok(table)
}

/// Counts rows as an editor does. The parser's own numbers fall behind at empty lines, which it skips after it has counted.
struct RowNumbers<'a> {
    text: &'a [u8],
    byte: usize,
    number: u64,
}

impl RowNumbers<'_> {
    /// The number of the first row with something in it from `byte` on.
    fn at(&mut self, byte: usize) -> u64 {
        let is_line_end = |b: &u8| matches!(b, b'\r' | b'\n');
        while self.byte < self.text.len() && (self.byte < byte || is_line_end(&self.text[self.byte])) {
            let is_end = match self.text[self.byte] {
                b'\n' => true,
                b'\r' => self.text.get(self.byte + 1) != Some(&b'\n'),
                _ => false,
            };
            self.number += u64::from(is_end);
            self.byte += 1;
        }
        self.number
    }
}

fn scene(table: &Table) -> Result<Read, Error> {
    let keyframes = keyframes(table)?;
    let groups = tree(table.agents.iter().map(|agent| agent.group.as_str()))?;
    let mut scene = Scene {
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
    let mut checked = validate(&scene);
    if let Err(Error::TooManyFrames { fitting_rate, .. }) = checked {
        // No column says the frame rate, so nobody could follow a refusal.
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
pub(super) fn is_whole_number(text: &str) -> bool {
    !text.is_empty() && text.bytes().all(|b| b.is_ascii_digit())
}

/// Wide, deep and high enough for everybody, centered on the ground.
pub(super) fn fitted_stage(keyframes: &[Keyframe]) -> Stage {
    let positions = keyframes.iter().flat_map(|keyframe| keyframe.positions.positions());
    let reach = positions.fold(glam::DVec2::ZERO, |reach, position| reach.max(position.abs()));
    let steps = |length: f64| (STAGE_MARGIN * length / STAGE_STEP).ceil();
    let side = |reach: f64| (steps(2.0 * reach).max(2.0) * STAGE_STEP).min(*limits::STAGE_SIDE.end());
    let heights = keyframes.iter().flat_map(|keyframe| keyframe.positions.heights().unwrap_or_default());
    let top = heights.copied().fold(0.0, f64::max);
    let height = (steps(top) * STAGE_STEP).min(*limits::LENGTH.end());
    Stage { width: side(reach.x), depth: side(reach.y), height, ..Stage::default() }
}
