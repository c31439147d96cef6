//! `eigenform motion`: where everybody is over time.

use eigenform::error::Error;
use eigenform::perform::{Performance, perform};
use eigenform::scene::{Opened, Scene, limits};

use crate::arguments::Motion;
use crate::failure::Failure;
use crate::{input, output};

#[derive(Clone, Copy, PartialEq, Eq)]
enum Format {
    Csv,
    Json,
}

pub fn run(arguments: &Motion) -> Result<Vec<String>, Failure> {
    let format = format(arguments)?;
    let Opened { scene, notes, .. } = input::read(&arguments.source)?;
    check_times(&scene, arguments.at.as_deref().unwrap_or_default())?;
    let text = text(&perform(&scene)?, arguments.at.as_deref(), format);
    match &arguments.out {
        Some(path) => output::write(path, &text)?,
        None => output::print(&text)?,
    }
    Ok(notes)
}

fn format(arguments: &Motion) -> Result<Format, Failure> {
    let by_name = match &arguments.out {
        Some(path) => match path.extension().and_then(|extension| extension.to_str()) {
            Some("csv") => Some(Format::Csv),
            Some("json") => Some(Format::Json),
            _ => return Err(Failure::usage("the file must be named .csv or .json", "--out")),
        },
        None => None,
    };
    let needs_json = arguments.json || arguments.at.is_some();
    if needs_json && by_name == Some(Format::Csv) {
        return Err(Failure::usage("a .csv holds every frame as CSV; name the file .json", "--out"));
    }
    Ok(by_name.unwrap_or(if needs_json { Format::Json } else { Format::Csv }))
}

fn check_times(scene: &Scene, times: &[f64]) -> Result<(), Failure> {
    if let Some(at) = times.iter().position(|time| !time.is_finite()) {
        return Err(Error::NotFinite { place: format!("--at, time {at}") }.into());
    }
    let agents = scene.main_track().agents.len();
    if agents * times.len() > limits::SAMPLES {
        return Err(Failure::usage(format!("agents × times are more than {}; ask for fewer", limits::SAMPLES), "--at"));
    }
    Ok(())
}

fn text(performance: &Performance, at: Option<&[f64]>, format: Format) -> String {
    match (at, format) {
        (Some(times), _) => performance.to_json_at(times),
        (None, Format::Csv) => performance.to_csv(),
        (None, Format::Json) => performance.to_json(),
    }
}
