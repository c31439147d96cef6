//! Everything a person can get wrong, in one closed list.
//!
//! Each variant says what is admissible; its code is stable. Bugs are assertions, never errors.

/// A refusal of input: what, where, and a stable code.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum Error {
    /// More ties at one keyframe than the limit, groups expanded.
    #[error("{count} ties at one keyframe; at most {limit}")]
    TooManyTies {
        /// Which keyframe.
        keyframe: usize,
        /// How many there would be, at least.
        count: usize,
        /// How many are allowed.
        limit: usize,
    },
}

impl Error {
    /// Stable, kebab-case.
    pub fn code(&self) -> &'static str {
        match self {
            Self::TooManyTies { .. } => "too-many-ties",
        }
    }

    /// Where in the input, in words; empty when it is the whole.
    pub fn place(&self) -> String {
        match self {
            Self::TooManyTies { keyframe, .. } => format!("keyframe {keyframe}"),
        }
    }
}
