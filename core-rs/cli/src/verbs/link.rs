//! `eigenform link`: the scene as a link.

use eigenform::scene::Opened;
use eigenform::scene::link::{self, Precision, encode};

use crate::arguments::Link;
use crate::failure::Failure;
use crate::{input, output};

/// Where a page can be; a browser takes others for something else than a page, or runs them.
const SCHEMES: [&str; 3] = ["https://", "http://", "file://"];

pub fn run(arguments: &Link) -> Result<Vec<String>, Failure> {
    let base = arguments.base.as_str();
    if base.contains('#') || base.chars().any(|c| c.is_whitespace() || c.is_control()) {
        return Err(Failure::usage("the address must have no # and no space", "--base"));
    }
    if !base.is_empty() && !SCHEMES.iter().any(|scheme| has_start(base, scheme)) {
        return Err(Failure::usage("the address of a page starts with https://, http:// or file://", "--base"));
    }
    let Opened { scene, mut notes, .. } = input::read(&arguments.source)?;
    let link = encode(&scene, if arguments.short { Precision::Short } else { Precision::Exact });
    output::print(&format!("{base}{}", link.fragment))?;
    notes.extend(what_rounding_did(&link));
    Ok(notes)
}

fn has_start(base: &str, scheme: &str) -> bool {
    base.len() > scheme.len() && base.get(..scheme.len()).is_some_and(|start| start.eq_ignore_ascii_case(scheme))
}

fn what_rounding_did(link: &link::Link) -> Vec<String> {
    let mut notes = Vec::new();
    if link.rounding > 0.0 {
        notes.push(format!("positions are rounded by up to {:.4} m", link.rounding));
    }
    if !link.broken_keyframes.is_empty() {
        let list: Vec<String> = link.broken_keyframes.iter().map(usize::to_string).collect();
        notes.push(format!("rounded, these keyframes break the minimum distance: {}", list.join(", ")));
    }
    notes
}
