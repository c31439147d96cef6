//! The rows of a CSV one by one, with the limits and refusals that every table has.

use csv::{ReaderBuilder, StringRecord};

use super::columns::{Columns, Row, Shape};
use crate::error::Error;
use crate::scene::limits;
use crate::scene::validate::length;

/// Reads a header of the shape's columns and visits every row with something in it.
pub(in crate::scene) fn for_each_row(
    text: &str,
    shape: &'static Shape,
    visit: &mut dyn FnMut(&Row) -> Result<(), Error>,
) -> Result<(), Error> {
    rows_are_short(text)?;
    // Flexible: a row of another length is our own error, with its row number.
    let mut reader = ReaderBuilder::new().flexible(true).has_headers(false).from_reader(text.as_bytes());
    let mut record = StringRecord::new();
    let mut next = |record: &mut StringRecord| reader.read_record(record).expect("rows of a text may have any length");
    next(&mut record);
    let columns = Columns::of(&record, shape)?;
    let mut rows = RowNumbers { text: text.as_bytes(), byte: 0, number: 1 };
    while next(&mut record) {
        // Spreadsheets leave rows of nothing but commas behind.
        if record.iter().all(|field| field.trim().is_empty()) {
            continue;
        }
        let number = rows.at(record.position().map_or(0, csv::Position::byte) as usize);
        visit(&columns.row(&record, number)?)?;
    }
    Ok(())
}

/// Refuses rows that no agent needs before the parser makes room for their fields.
fn rows_are_short(text: &str) -> Result<(), Error> {
    for (number, line) in (1_u64..).zip(text.lines()) {
        // Old files end their rows with a carriage return alone.
        line.split('\r').try_for_each(|row| length(row, limits::ROW_CHARACTERS, format_args!("row {number}")))?;
    }
    Ok(())
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
