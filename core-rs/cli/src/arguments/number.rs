//! Numbers as they are typed; whether they are admissible is said once the scene is known.

use std::num::{IntErrorKind, ParseIntError};

/// One with or without a point.
pub fn real(typed: &str) -> Result<f64, String> {
    typed.trim().parse().map_err(|_| "is no number; give one such as 2.5".to_owned())
}

/// One without.
pub fn whole(typed: &str) -> Result<i64, String> {
    typed.trim().parse().map_err(|error: ParseIntError| match error.kind() {
        IntErrorKind::PosOverflow | IntErrorKind::NegOverflow => "is far out of range".to_owned(),
        _ => "is no whole number; give one such as 2".to_owned(),
    })
}
