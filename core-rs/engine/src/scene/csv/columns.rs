//! Which column is which.

use std::fmt::{self, Display, Formatter};

use csv::StringRecord;

use crate::error::{Error, TableError};
use crate::scene::shown;

/// Which columns a kind of table has.
pub(in crate::scene) struct Shape {
    pub(in crate::scene) columns: &'static [&'static str],
    pub(in crate::scene) required: &'static [&'static str],
    /// A header as an example.
    pub(in crate::scene) example: &'static str,
}

/// What else spreadsheets write between columns: where numbers have commas, semicolons.
const SEPARATORS: [(char, &str); 2] = [(';', "semicolons"), ('\t', "tabs")];

impl Shape {
    /// Whether the first row of a text names a column, whatever stands between them.
    pub(super) fn is_begun_by(&self, text: &str) -> bool {
        let first = text.trim_start().split(['\r', '\n']).next().unwrap_or("");
        first.split([',', ';', '\t']).any(|name| self.has(name))
    }

    fn has(&self, name: &str) -> bool {
        let name = name.trim().trim_matches('"').trim();
        self.columns.iter().any(|known| known.eq_ignore_ascii_case(name))
    }

    /// What stands between columns in place of commas, in words.
    fn other_separators(&self, name: &str) -> Option<&'static str> {
        let parts = |separator: char| name.contains(separator) && name.split(separator).any(|name| self.has(name));
        SEPARATORS.iter().find(|(separator, _)| parts(*separator)).map(|(_, words)| *words)
    }
}

/// Where each column of the shape stands in this file.
pub(super) struct Columns {
    shape: &'static Shape,
    places: Vec<Option<usize>>,
    count: usize,
}

impl Columns {
    /// From the header; names in any case and order.
    pub(super) fn of(header: &StringRecord, shape: &'static Shape) -> Result<Self, Error> {
        let Shape { columns, required, example } = shape;
        let mut places = vec![None; columns.len()];
        for (place, name) in header.iter().enumerate() {
            let name = name.trim();
            let Some(column) = columns.iter().position(|known| known.eq_ignore_ascii_case(name)) else {
                if let Some(separators) = shape.other_separators(name) {
                    return Err(TableError::NotCommas { separators }.into());
                }
                return Err(TableError::UnknownColumn { column: shown(name), admissible: columns }.into());
            };
            if places[column].replace(place).is_some() {
                return Err(TableError::RepeatedColumn { column: columns[column] }.into());
            }
        }
        match columns.iter().zip(&places).find(|(name, place)| place.is_none() && required.contains(name)) {
            Some((column, _)) => Err(TableError::MissingColumn { column, example }.into()),
            None => Ok(Self { shape, places, count: header.len() }),
        }
    }

    /// A row of as many fields as the header; its `number` is for refusals.
    pub(super) fn row<'a>(&'a self, record: &'a StringRecord, number: u64) -> Result<Row<'a>, Error> {
        let row = Row { number, columns: self, record };
        if record.len() == self.count {
            Ok(row)
        } else {
            Err(TableError::CutRow { row: row.number, found: record.len(), expected: self.count }.into())
        }
    }
}

/// One row; the header is row 1.
pub(in crate::scene) struct Row<'a> {
    pub(in crate::scene) number: u64,
    columns: &'a Columns,
    record: &'a StringRecord,
}

impl<'a> Row<'a> {
    /// The field of a column without the white space around it; empty where the file lacks the column.
    pub(in crate::scene) fn text(&self, column: &'static str) -> &'a str {
        self.place_of(column).and_then(|place| self.record.get(place)).unwrap_or("").trim()
    }

    pub(super) fn has(&self, column: &'static str) -> bool {
        self.place_of(column).is_some()
    }

    fn place_of(&self, column: &'static str) -> Option<usize> {
        let index = self.columns.shape.columns.iter().position(|known| *known == column).expect("a column that is read is known");
        self.columns.places[index]
    }

    /// The finite number of a column.
    pub(in crate::scene) fn number(&self, column: &'static str) -> Result<f64, Error> {
        let text = self.text(column);
        let value: f64 = text.parse().map_err(|_| TableError::NotANumber { value: shown(text), column, row: self.number })?;
        if value.is_finite() { Ok(value) } else { Err(Error::NotFinite { place: self.place(column).to_string() }) }
    }

    pub(in crate::scene) fn place(&self, column: &'static str) -> Cell {
        Cell { row: self.number, column }
    }
}

/// Where a field stands, shown as `row 214, column x`.
pub(in crate::scene) struct Cell {
    pub(super) row: u64,
    pub(super) column: &'static str,
}

impl Display for Cell {
    fn fmt(&self, f: &mut Formatter) -> fmt::Result {
        write!(f, "row {}, column {}", self.row, self.column)
    }
}
