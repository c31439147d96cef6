//! From what was typed to a scene.

use std::fs::File;
use std::io::{self, Read as _};
use std::ops::RangeInclusive;
use std::path::Path;

use eigenform::choice::{Join, MethodName};
use eigenform::error::Error;
use eigenform::scene::{self, Opened, Read, Scene, Segment, limits, open, open_bytes, recording, validate};

use crate::arguments::Source;
use crate::failure::Failure;

/// Words that may be typed, and what each means.
pub type Words<T> = (&'static [&'static str], &'static [T]);

const METHODS: Words<MethodName> = (
    &["auto", "spectral", "shared", "polar", "linear", "crowd"],
    &[MethodName::Auto, MethodName::Spectral, MethodName::Shared, MethodName::Polar, MethodName::Linear, MethodName::Crowd],
);
const JOINS: Words<Join> = (&["separate", "smooth", "product"], &[Join::Separate, Join::Smooth, Join::Product]);
const BOOLEANS: Words<bool> = (&["true", "false"], &[true, false]);

/// Reads the scene and applies what is to be otherwise.
pub fn read(source: &Source) -> Result<Opened, Failure> {
    let mut opened = if is_link(&source.scene) { open(&source.scene)? } else { open_bytes(&read_bytes(&source.scene)?)? };
    override_parts(&mut opened.scene, source)?;
    validate(&opened.scene)?;
    Ok(opened)
}

/// Reads a recording, makes a scene of the frames with these numbers, and applies what is to be otherwise.
pub fn read_recording(source: &Source, numbers: &[i64]) -> Result<Opened, Failure> {
    let bytes = read_bytes(&source.scene)?;
    let text = std::str::from_utf8(&bytes).map_err(|error| Error::NotText { byte: error.valid_up_to() })?;
    let recording = recording::read_recording(text)?;
    let (first, last) = recording.numbers();
    let frame = |number: &i64| {
        let (value, low, high) = (*number as f64, first as f64, last as f64);
        recording.frame_numbered(*number).ok_or(Error::OutOfRange { value, low, high, place: "--frames".to_owned() })
    };
    let frames = numbers.iter().map(frame).collect::<Result<Vec<_>, _>>()?;
    let Read { mut scene, mut notes } = recording.scene(&frames)?;
    let mut taken = numbers.to_vec();
    taken.sort_unstable();
    taken.dedup();
    if taken != numbers {
        let taken: Vec<String> = taken.iter().map(i64::to_string).collect();
        notes.push(format!("Frames are taken as they follow each other, each once: {}.", taken.join(", ")));
    }
    override_parts(&mut scene, source)?;
    validate(&scene)?;
    // As a keyframe CSV: printed, it is a scene file.
    Ok(Opened { scene, source: scene::Source::Csv, notes })
}

/// The bytes of a file, or of standard input for `-`. No more than a valid scene needs is read.
pub fn read_bytes(name: &str) -> Result<Vec<u8>, Failure> {
    let path = Path::new(name);
    let limit = limits::FILE_BYTES as u64 + 1;
    let mut bytes = Vec::new();
    let outcome = if name == "-" {
        io::stdin().lock().take(limit).read_to_end(&mut bytes)
    } else {
        File::open(path).and_then(|file| file.take(limit).read_to_end(&mut bytes))
    };
    match outcome {
        Ok(_) => Ok(bytes),
        Err(error) => Err(Failure::reading(error, path)),
    }
}

/// The keyframe that an option names.
pub fn keyframe(scene: &Scene, number: i64, option: &str) -> Result<usize, Failure> {
    whole_within(number, &(0..=scene.main_track().keyframes.len() - 1), option)
}

/// A whole number that an option gives, if it is admissible.
pub fn whole_within(number: i64, admissible: &RangeInclusive<usize>, option: &str) -> Result<usize, Failure> {
    let (low, high) = (*admissible.start() as f64, *admissible.end() as f64);
    let found = usize::try_from(number).ok().filter(|number| admissible.contains(number));
    found.ok_or_else(|| Error::OutOfRange { value: number as f64, low, high, place: option.to_owned() }.into())
}

/// A number that an option gives, if it is admissible.
pub fn within(value: f64, admissible: &RangeInclusive<f64>, option: &str) -> Result<f64, Failure> {
    if admissible.contains(&value) {
        return Ok(value);
    }
    let (low, high) = (*admissible.start(), *admissible.end());
    Err(Error::OutOfRange { value, low, high, place: option.to_owned() }.into())
}

fn is_link(text: &str) -> bool {
    text.contains("#s=") || ["#", "http://", "https://"].iter().any(|start| text.starts_with(start))
}

fn override_parts(scene: &mut Scene, source: &Source) -> Result<(), Failure> {
    if let Some(join) = &source.join {
        scene.join = word(join, &JOINS, "--join")?;
    }
    if let Some(distance) = source.minimum_distance {
        scene.minimum_distance = within(distance, &limits::LENGTH, "--minimum-distance")?;
    }
    let avoidance = source.avoidance.as_ref().map(|typed| word(typed, &BOOLEANS, "--avoidance")).transpose()?;
    let method = source.method.as_ref().map(|typed| word(typed, &METHODS, "--method")).transpose()?;
    for Segment::Transition(transition) in &mut scene.tracks[0].segments {
        transition.avoidance = avoidance.unwrap_or(transition.avoidance);
        if let Some(method) = method {
            transition.method = method;
            // What auto took before, and what groups move by, belongs to the scene as it was saved.
            transition.chosen = None;
            transition.nodes.clear();
        }
    }
    Ok(())
}

/// The meaning of the one of `words` that was typed.
pub fn word<T: Copy>(typed: &str, (words, meanings): &Words<T>, place: &str) -> Result<T, Failure> {
    match words.iter().position(|known| *known == typed) {
        Some(at) => Ok(meanings[at]),
        None => Err(Error::UnknownValue { value: quoted(typed), admissible: words, place: place.to_owned() }.into()),
    }
}

/// A word as it was typed, fit for one line of a message.
pub fn quoted(word: &str) -> String {
    let mut short: String = word.chars().take(40).collect();
    if short.len() < word.len() {
        short.push('…');
    }
    format!("\"{short}\"")
}
