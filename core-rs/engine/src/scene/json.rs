//! The scene file, version 1: UTF-8 JSON.
//!
//! Reading parses the text once without keeping anything, then goes down level by level over slices of it: no list is kept beyond
//! its limit, every refusal knows its place, and hostile nesting costs no stack.

mod crowd;
mod fields;
mod layout;
mod places;
mod read;
mod split;
mod unescape;
mod value;
mod write;
mod written;

pub use read::{read_assignment, read_choices, read_json, read_rest};
pub use write::write_json;
