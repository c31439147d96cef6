//! What is wrong in the text of a scene file, whatever it says.

use super::words::Listed;

/// A refusal of JSON: its form, or the names and kinds of its fields.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum JsonError {
    /// The text breaks the rules of JSON.
    #[error("this is not well-formed JSON: {message}")]
    InvalidJson {
        /// What the parser met.
        message: String,
        /// Line and column, or the field.
        place: String,
    },
    /// A required field is absent.
    #[error("\"{field}\" is missing; it is required")]
    MissingField {
        /// Its name.
        field: String,
        /// The object that lacks it.
        place: String,
    },
    /// A field that version 1 does not have.
    #[error("\"{field}\" is no field here; the fields are {}", Listed(admissible))]
    UnknownField {
        /// Its name, shortened.
        field: String,
        /// The names there are.
        admissible: &'static [&'static str],
        /// The object that has it.
        place: String,
    },
    /// A field given twice in one object.
    #[error("\"{field}\" is given twice")]
    RepeatedField {
        /// Its name.
        field: String,
        /// The object.
        place: String,
    },
    /// A value of another kind.
    #[error("this is {found}; it must be {expected}")]
    WrongType {
        /// What is there.
        found: String,
        /// What must be.
        expected: &'static str,
        /// The value.
        place: String,
    },
}

impl JsonError {
    /// Stable, kebab-case.
    pub(super) fn code(&self) -> &'static str {
        match self {
            Self::InvalidJson { .. } => "invalid-json",
            Self::MissingField { .. } => "missing-field",
            Self::UnknownField { .. } => "unknown-field",
            Self::RepeatedField { .. } => "repeated-field",
            Self::WrongType { .. } => "wrong-type",
        }
    }

    /// Line and column, the field, or the object that has it.
    pub(super) fn place(&self) -> String {
        match self {
            Self::InvalidJson { place, .. }
            | Self::MissingField { place, .. }
            | Self::UnknownField { place, .. }
            | Self::RepeatedField { place, .. }
            | Self::WrongType { place, .. } => place.clone(),
        }
    }
}
