//! What is wrong in a table of values: a keyframe CSV, or the rows of a recording.

use super::words::Listed;

/// A refusal of a table. The header is row 1.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum TableError {
    /// A CSV without one of the columns.
    #[error("there is no column \"{column}\"; the first row names the columns, such as {example}")]
    MissingColumn {
        /// Its name.
        column: &'static str,
        /// A first row that is right.
        example: &'static str,
    },
    /// A column that a CSV of this kind does not have.
    #[error("\"{column}\" is no column here; the columns are {}", Listed(admissible))]
    UnknownColumn {
        /// Its name, shortened.
        column: String,
        /// The names there are.
        admissible: &'static [&'static str],
    },
    /// Columns with something else between them than commas.
    #[error("there are {separators} between the columns; a CSV has commas there, and points in its numbers")]
    NotCommas {
        /// What there is, in words.
        separators: &'static str,
    },
    /// A column twice.
    #[error("there are two columns \"{column}\"; each occurs once")]
    RepeatedColumn {
        /// Its name.
        column: &'static str,
    },
    /// A row of fewer or more fields than the header.
    #[error("row {row} has {found} fields; like the first row it must have {expected}")]
    CutRow {
        /// Which row; the header is row 1.
        row: u64,
        /// How many it has.
        found: usize,
        /// How many the header has.
        expected: usize,
    },
    /// A field that must be a number.
    #[error("row {row} gives \"{value}\" for {column}; it must be a number, such as 2.5")]
    NotANumber {
        /// What is there, shortened.
        value: String,
        /// The column.
        column: &'static str,
        /// The row.
        row: u64,
    },
    /// One agent twice at one keyframe.
    #[error("row {row} gives agent {agent} twice in keyframe {keyframe}; each agent has one row a keyframe")]
    RepeatedRow {
        /// The later row.
        row: u64,
        /// The agent's id.
        agent: String,
        /// The keyframe's label.
        keyframe: String,
    },
    /// An agent that a keyframe lacks.
    #[error("keyframe {keyframe} has no row of agent {agent}; every agent stands in every keyframe")]
    MissingRow {
        /// The agent's id.
        agent: String,
        /// The keyframe's label.
        keyframe: String,
    },
    /// Rows of one keyframe at different times.
    #[error("row {row} puts keyframe {keyframe} at {time} s; the rows before put it at {expected} s")]
    TimesDiffer {
        /// The later row.
        row: u64,
        /// The keyframe's label.
        keyframe: String,
        /// What it says, seconds.
        time: f64,
        /// What was said before, seconds.
        expected: f64,
    },
}

impl TableError {
    /// Stable, kebab-case.
    pub(super) fn code(&self) -> &'static str {
        match self {
            Self::MissingColumn { .. } => "missing-column",
            Self::UnknownColumn { .. } => "unknown-column",
            Self::NotCommas { .. } => "not-commas",
            Self::RepeatedColumn { .. } => "repeated-column",
            Self::CutRow { .. } => "cut-row",
            Self::NotANumber { .. } => "not-a-number",
            Self::RepeatedRow { .. } => "repeated-row",
            Self::MissingRow { .. } => "missing-row",
            Self::TimesDiffer { .. } => "times-differ",
        }
    }

    /// Where in the table, in words.
    pub(super) fn place(&self) -> String {
        match self {
            Self::MissingColumn { .. } | Self::UnknownColumn { .. } | Self::NotCommas { .. } | Self::RepeatedColumn { .. } => {
                "row 1".to_owned()
            }
            Self::NotANumber { column, row, .. } => format!("row {row}, column {column}"),
            Self::CutRow { row, .. } | Self::RepeatedRow { row, .. } | Self::TimesDiffer { row, .. } => format!("row {row}"),
            Self::MissingRow { keyframe, .. } => format!("keyframe {keyframe}"),
        }
    }
}
