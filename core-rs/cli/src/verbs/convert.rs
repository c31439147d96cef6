//! `eigenform convert`: a scene file from a keyframe CSV or a recording, or a keyframe CSV from a scene.

use std::path::Path;

use eigenform::scene::{Opened, Source, write_csv, write_json};

use crate::arguments::Convert;
use crate::failure::Failure;
use crate::{input, output};

#[derive(Clone, Copy)]
enum Format {
    Scene,
    Csv,
}

pub fn run(arguments: &Convert) -> Result<Vec<String>, Failure> {
    let named = named_format(&arguments.out)?;
    let Opened { scene, source, mut notes } = match &arguments.frames {
        Some(frames) => input::read_recording(&arguments.source, frames)?,
        None => input::read(&arguments.source)?,
    };
    let text = match named.unwrap_or_else(|| other_format(source)) {
        Format::Scene => write_json(&scene),
        Format::Csv => {
            let written = write_csv(&scene);
            notes.extend(written.notes);
            written.text
        }
    };
    if named.is_some() {
        output::write(&arguments.out, &text)?;
    } else {
        output::print(&text)?;
    }
    Ok(notes)
}

/// None for standard output.
fn named_format(out: &Path) -> Result<Option<Format>, Failure> {
    if out == Path::new("-") {
        return Ok(None);
    }
    match out.extension().and_then(|extension| extension.to_str()) {
        Some("json") => Ok(Some(Format::Scene)),
        Some("csv") => Ok(Some(Format::Csv)),
        _ => Err(Failure::usage("the file must be named .json or .csv", "OUT")),
    }
}

fn other_format(source: Source) -> Format {
    match source {
        Source::Scene => Format::Csv,
        Source::Csv | Source::Link => Format::Scene,
    }
}
