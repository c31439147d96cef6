//! The scene file, version 1: UTF-8 JSON.
//!
//! Reading goes down the document level by level over slices of the text, so that every list is counted before it is kept,
//! every refusal knows its place, and hostile nesting costs no stack.

mod fields;
mod layout;
mod read;
mod value;
mod write;

pub use read::read_json;
pub use write::write_json;
