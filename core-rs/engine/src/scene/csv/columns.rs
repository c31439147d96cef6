//! Which column is which.

use std::fmt::{self, Display, Formatter};

use csv::StringRecord;

use crate::error::Error;
use crate::scene::shown;

/// The columns there are, in the order they are written.
pub(super) const COLUMNS: &[&str] = &["keyframe", "time", "agent", "group", "x", "y", "z", "name", "color"];

const REQUIRED: &[&str] = &["keyframe", "time", "agent", "x", "y"];

/// Where each column of [`COLUMNS`] stands in this file.
pub(super) struct Columns {
    places: [Option<usize>; COLUMNS.len()],
    count: usize,
}

impl Columns {
    /// From the header; names in any case and order.
    pub(super) fn of(header: &StringRecord) -> Result<Self, Error> {
        let mut places = [None; COLUMNS.len()];
        for (place, name) in header.iter().enumerate() {
            let name = name.trim();
            let Some(column) = COLUMNS.iter().position(|known| known.eq_ignore_ascii_case(name)) else {
                return Err(Error::UnknownColumn { column: shown(name), admissible: COLUMNS });
            };
            if places[column].replace(place).is_some() {
                return Err(Error::RepeatedColumn { column: COLUMNS[column] });
            }
        }
        match COLUMNS.iter().zip(places).find(|(name, place)| place.is_none() && REQUIRED.contains(name)) {
            Some((column, _)) => Err(Error::MissingColumn { column }),
            None => Ok(Self { places, count: header.len() }),
        }
    }

    /// A row of as many fields as the header; its `number` is for refusals.
    pub(super) fn row<'a>(&'a self, record: &'a StringRecord, number: u64) -> Result<Row<'a>, Error> {
        let row = Row { number, columns: self, record };
        if record.len() == self.count { Ok(row) } else { Err(Error::CutRow { row: row.number, found: record.len(), expected: self.count }) }
    }
}

/// One row; the header is row 1.
pub(super) struct Row<'a> {
    pub(super) number: u64,
    columns: &'a Columns,
    record: &'a StringRecord,
}

impl<'a> Row<'a> {
    /// The field of a column without the white space around it; empty where the file lacks the column.
    pub(super) fn text(&self, column: &'static str) -> &'a str {
        let index = COLUMNS.iter().position(|known| *known == column).expect("a column that is read is known");
        self.columns.places[index].and_then(|place| self.record.get(place)).unwrap_or("").trim()
    }

    pub(super) fn has(&self, column: &'static str) -> bool {
        COLUMNS.iter().zip(self.columns.places).any(|(known, place)| *known == column && place.is_some())
    }

    /// The finite number of a column.
    pub(super) fn number(&self, column: &'static str) -> Result<f64, Error> {
        let text = self.text(column);
        let value: f64 = text.parse().map_err(|_| Error::NotANumber { value: shown(text), column, row: self.number })?;
        if value.is_finite() { Ok(value) } else { Err(Error::NotFinite { place: self.place(column).to_string() }) }
    }

    pub(super) fn place(&self, column: &'static str) -> Cell {
        Cell { row: self.number, column }
    }
}

/// Where a field stands, shown as `row 214, column x`.
pub(super) struct Cell {
    pub(super) row: u64,
    pub(super) column: &'static str,
}

impl Display for Cell {
    fn fmt(&self, f: &mut Formatter) -> fmt::Result {
        write!(f, "row {}, column {}", self.row, self.column)
    }
}
