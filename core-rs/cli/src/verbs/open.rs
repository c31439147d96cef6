//! `eigenform open`: the scene of a link.

use eigenform::error::Error;
use eigenform::scene::link::decode;
use eigenform::scene::write_json;

use crate::arguments::Open;
use crate::failure::Failure;
use crate::{input, output};

pub fn run(arguments: &Open) -> Result<Vec<String>, Failure> {
    let scene = if arguments.link == "-" { decode(&from_standard_input()?)? } else { decode(&arguments.link)? };
    output::print(&write_json(&scene))?;
    Ok(Vec::new())
}

fn from_standard_input() -> Result<String, Failure> {
    String::from_utf8(input::read_bytes("-")?).map_err(|error| Error::NotText { byte: error.utf8_error().valid_up_to() }.into())
}
