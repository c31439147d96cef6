//! The text format of `JuPedSim` and `PedPy`: comments, then rows of `id frame x y z` with white space between.
//!
//! A comment gives the frame rate (`# framerate: 25.00 fps`), another may name the columns and their unit (`# id frame x/m y/m z/m`).

use glam::DVec2;

use super::Recording;
use super::samples::{Sample, Samples};
use crate::error::{Error, RecordingError, TableError};
use crate::scene::validate::{length, within};
use crate::scene::{limits, shown};

/// What is read of a row, in the order of [`Head::places`].
const COLUMNS: [&str; 5] = ["id", "frame", "x", "y", "z"];

/// The columns that every row has.
const REQUIRED: usize = 4;

/// What the comments say.
struct Head {
    frame_rate: Option<f64>,
    /// Where each column stands.
    places: [Option<usize>; COLUMNS.len()],
    /// Meters a unit.
    unit: f64,
}

/// Whether the text begins with the comments of a recording, or with a row of one.
pub(super) fn has_head(text: &str) -> bool {
    // Other texts may be one endless line.
    let is_short = |line: &&str| line.len() <= limits::ROW_CHARACTERS;
    let mut lines = text.lines().take_while(is_short).map(str::trim).filter(|line| !line.is_empty());
    let comments = lines.clone().take_while(|line| line.starts_with('#'));
    let is_said = comments.filter_map(|line| line.strip_prefix('#')).any(|line| rate_of(line).is_some() || columns_of(line).is_some());
    is_said || lines.find(|line| !line.starts_with('#')).is_some_and(|line| columns_of(line).is_some() || is_row(line))
}

pub(super) fn read(text: &str) -> Result<Recording, Error> {
    let mut head = Head { frame_rate: None, places: [Some(0), Some(1), Some(2), Some(3), Some(4)], unit: 1.0 };
    let mut samples = Samples::default();
    let (mut field_count, mut has_heights) = (None, false);
    for (number, line) in (1_u64..).zip(text.lines()) {
        length(line, limits::ROW_CHARACTERS, format_args!("row {number}"))?;
        let line = line.trim();
        if let Some(comment) = line.strip_prefix('#') {
            head.learn(comment, number)?;
        } else if field_count.is_none() && columns_of(line).is_some() {
            // Some programs leave the mark of a comment out.
            head.learn(line, number)?;
        } else if !line.is_empty() {
            let fields: Vec<&str> = line.split_ascii_whitespace().collect();
            let expected = *field_count.get_or_insert(fields.len().max(head.field_count()));
            if fields.len() != expected {
                return Err(TableError::CutRow { row: number, found: fields.len(), expected }.into());
            }
            let row = TextRow { fields: &fields, number, head: &head };
            let sample = row.sample()?;
            has_heights |= row.field(4).is_some() && row.number(4)? != 0.0;
            samples.add(row.field(0).unwrap_or(""), sample)?;
        }
    }
    let frame_rate = head.frame_rate.ok_or(RecordingError::NoFrameRate)?;
    let mut notes = Vec::new();
    if has_heights {
        notes.push("Heights are left out: in recordings of people they are those of their heads.".to_owned());
    }
    samples.finish(frame_rate, notes)
}

impl Head {
    fn learn(&mut self, comment: &str, row: u64) -> Result<(), Error> {
        if let Some(text) = rate_of(comment) {
            let rate = text.parse().map_err(|_| TableError::NotANumber { value: shown(text), column: "framerate", row })?;
            within(rate, &limits::RECORDING_RATE, format_args!("row {row}, framerate"))?;
            self.frame_rate = Some(rate);
        }
        if let Some(places) = columns_of(comment) {
            self.places = places;
            let is_in = |unit: &str| comment.to_ascii_lowercase().split_ascii_whitespace().any(|word| word.ends_with(unit));
            self.unit = if is_in("x/cm") || is_in("x[cm]") { 0.01 } else { 1.0 };
        }
        Ok(())
    }

    /// How many fields a row has at the least.
    fn field_count(&self) -> usize {
        self.places[..REQUIRED].iter().flatten().max().map_or(REQUIRED, |last| last + 1)
    }
}

/// The number behind `framerate`, as it stands there.
fn rate_of(comment: &str) -> Option<&str> {
    let lower = comment.to_ascii_lowercase();
    let at = ["framerate", "frame rate"].iter().find_map(|name| lower.find(name).map(|at| at + name.len()))?;
    let rest = comment[at..].trim_start_matches([':', '=', ' ', '\t']);
    let number = rest.split(|c: char| c.is_whitespace() || c.is_ascii_alphabetic()).next();
    // Where no number stands, what does is told.
    number.filter(|number| !number.is_empty()).or(Some(rest))
}

/// Where the columns stand, if this line names them; units and case do not matter.
fn columns_of(line: &str) -> Option<[Option<usize>; COLUMNS.len()]> {
    let lower = line.to_ascii_lowercase();
    let names: Vec<&str> = lower.split_ascii_whitespace().map(|word| word.split(['/', '[']).next().unwrap_or(word)).collect();
    let place = |wanted: &str| names.iter().position(|name| *name == wanted || (wanted == "frame" && *name == "fr"));
    let places = COLUMNS.map(place);
    places[..REQUIRED].iter().all(Option::is_some).then_some(places)
}

/// Whether a line is numbers, as many as a row has.
fn is_row(line: &str) -> bool {
    let fields: Vec<&str> = line.split_ascii_whitespace().collect();
    fields.len() >= REQUIRED && fields.iter().take(REQUIRED).all(|field| field.parse::<f64>().is_ok())
}

struct TextRow<'a> {
    fields: &'a [&'a str],
    number: u64,
    head: &'a Head,
}

impl<'a> TextRow<'a> {
    fn field(&self, column: usize) -> Option<&'a str> {
        self.head.places[column].and_then(|place| self.fields.get(place)).copied()
    }

    fn number(&self, column: usize) -> Result<f64, Error> {
        let text = self.field(column).unwrap_or("");
        let (row, column) = (self.number, COLUMNS[column]);
        let value: f64 = text.parse().map_err(|_| TableError::NotANumber { value: shown(text), column, row })?;
        if value.is_finite() { Ok(value) } else { Err(Error::NotFinite { place: format!("row {row}, column {column}") }) }
    }

    fn sample(&self) -> Result<Sample, Error> {
        let frame = self.number(1)?;
        within(frame, &limits::FRAME_NUMBER, format_args!("row {}, column frame", self.number))?;
        if frame.fract() != 0.0 {
            return Err(TableError::NotANumber { value: shown(self.field(1).unwrap_or("")), column: "frame", row: self.number }.into());
        }
        let position = DVec2::new(self.number(2)?, self.number(3)?) * self.head.unit;
        within(position.x, &limits::COORDINATE, format_args!("row {}, column x", self.number))?;
        within(position.y, &limits::COORDINATE, format_args!("row {}, column y", self.number))?;
        Ok(Sample { frame: frame as i64, agent: 0, row: self.number, position, height: 0.0 })
    }
}
