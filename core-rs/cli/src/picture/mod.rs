//! From a picture, a drawing or text to pixels.

mod drawing;
mod photograph;
mod text;

use std::path::Path;

use eigenform::shape::{Picture, Reading, Region, Room, THRESHOLD};

use crate::arguments::Shape;
use crate::failure::Failure;
use crate::input::{self, within};

/// Pixels of the longer side of what is drawn here: twice what an edge is seen by.
const SIDE: f32 = 1_000.0;

/// Bytes of an SVG: hundreds of times an icon, and quick to read.
const SVG_BYTES: usize = 8 << 20;

/// Endings of what is a file even where there is none of that name.
const ENDINGS: [&str; 5] = ["png", "jpg", "jpeg", "webp", "svg"];

/// Red, green, blue and opacity of each pixel, row by row from the top.
struct Pixels {
    width: usize,
    height: usize,
    rgba: Vec<u8>,
}

/// The region that was given: a picture or drawing by its file, path data, or text.
pub fn region(arguments: &Shape, room: Room) -> Result<Region, Failure> {
    let Pixels { width, height, rgba } = pixels(arguments)?;
    let threshold = within(arguments.threshold, &THRESHOLD, "--threshold")?;
    let reading = Reading { threshold, is_inverted: arguments.invert };
    Ok(Region::from_picture(Picture { width, height, rgba: &rgba }, reading, room)?)
}

/// Whether a file is meant, and not text.
pub fn is_file(arguments: &Shape) -> bool {
    let path = Path::new(&arguments.input);
    let ending = path.extension().map(|ending| ending.to_string_lossy().to_lowercase());
    !arguments.text && (arguments.input == "-" || path.exists() || ending.is_some_and(|ending| ENDINGS.contains(&ending.as_str())))
}

fn pixels(arguments: &Shape) -> Result<Pixels, Failure> {
    let Shape { input, font, text, .. } = arguments;
    if !is_file(arguments) {
        return if !text && drawing::is_path_data(input) { drawing::path(input) } else { text::write(input, font.as_deref()) };
    }
    let bytes = input::read_bytes(input)?;
    match photograph::decode(&bytes, input) {
        Some(decoded) => decoded,
        None => drawing::draw(&bytes, input),
    }
}

/// A refusal of a picture that the engine never sees.
fn refused(code: &'static str, what: impl Into<String>, place: &str) -> Failure {
    Failure::Given { code, what: what.into(), place: place.to_owned() }
}
