//! Any text a person brings: a scene file, a keyframe CSV or a link.

use super::recording::is_recording;
use super::{Scene, limits, link, read_csv, read_json};
use crate::error::Error;

/// A scene that came through the door.
#[derive(Clone, Debug, PartialEq)]
pub struct Opened {
    /// Valid.
    pub scene: Scene,
    /// What it was read from.
    pub source: Source,
    /// What the source says that the scene does not follow, a sentence each.
    pub notes: Vec<String>,
}

/// What a scene was read from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Source {
    /// A scene file.
    Scene,
    /// A keyframe CSV.
    Csv,
    /// A link.
    Link,
}

/// The scene of a text, whichever kind it is.
pub fn open(text: &str) -> Result<Opened, Error> {
    if text.len() > limits::FILE_BYTES {
        return Err(Error::FileTooLarge { bytes: text.len(), limit: limits::FILE_BYTES });
    }
    if is_recording(text) {
        return Err(Error::IsRecording);
    }
    let opened = |scene, source| Opened { scene, source, notes: Vec::new() };
    match source(text) {
        Source::Scene => Ok(opened(read_json(text)?, Source::Scene)),
        Source::Link => Ok(opened(link::decode(text)?, Source::Link)),
        Source::Csv => read_csv(text).map(|read| Opened { scene: read.scene, source: Source::Csv, notes: read.notes }),
    }
}

/// The scene of what this program writes by itself, a scene file or a link, as [`open`] reads it; none for any other text, a table or
/// a recording maybe, which is [`open`]'s: whoever opens nothing else carries no reader of tables.
pub fn open_own(text: &str) -> Option<Result<Opened, Error>> {
    let opened = |scene, source| Opened { scene, source, notes: Vec::new() };
    match source(text) {
        _ if text.len() > limits::FILE_BYTES => None,
        Source::Scene => Some(read_json(text).map(|scene| opened(scene, Source::Scene))),
        Source::Link if text.contains("#s=") => Some(link::decode(text).map(|scene| opened(scene, Source::Link))),
        Source::Link | Source::Csv => None,
    }
}

/// The scene of a file's bytes, which must be UTF-8 text.
pub fn open_bytes(bytes: &[u8]) -> Result<Opened, Error> {
    if bytes.len() > limits::FILE_BYTES {
        return Err(Error::FileTooLarge { bytes: bytes.len(), limit: limits::FILE_BYTES });
    }
    let text = std::str::from_utf8(bytes).map_err(|error| Error::NotText { byte: error.valid_up_to() })?;
    open(text)
}

/// What a text looks like. A link may stand in brackets, quotes or a sentence; a scene file cannot start like one.
fn source(text: &str) -> Source {
    let text = text.trim_start_matches('\u{feff}').trim_start();
    let first_line = text.lines().next().unwrap_or("");
    // Of a link that was cut, #s may be left; behind another # stands a heading or a comment.
    let is_cut = first_line == "#" || first_line.starts_with("#s");
    let is_link = is_cut || first_line.contains("#s=") || ["http://", "https://"].iter().any(|start| first_line.starts_with(start));
    match text.bytes().next() {
        Some(b'{') => Source::Scene,
        _ if is_link => Source::Link,
        Some(b'[') => Source::Scene,
        _ => Source::Csv,
    }
}

#[cfg(test)]
mod tests {
    use super::{Source, open, open_own, source};

    #[test]
    fn a_text_is_known_by_how_it_begins() {
        let cases = [
            ("{\"format\": \"eigenform\"}", Source::Scene),
            ("\u{feff} \n {", Source::Scene),
            ("[]", Source::Scene),
            ("{\"title\": \"#s=1.\"}", Source::Scene),
            ("keyframe,time,agent,group,x,y\n", Source::Csv),
            ("", Source::Csv),
            ("# Notes\n", Source::Csv),
            ("#!/bin/sh\n", Source::Csv),
            ("#", Source::Link),
            ("#s=1.AAAA", Source::Link),
            ("  https://example.org/eigenform/#s=1.AAAA", Source::Link),
            ("https://example.org/eigenform/", Source::Link),
            ("See (https://example.org/#s=1.AAAA).", Source::Link),
            ("[my show](https://example.org/#s=1.AAAA)", Source::Link),
        ];
        for (text, expected) in cases {
            assert_eq!(source(text), expected, "{text}");
        }
    }

    #[test]
    fn what_is_its_own_is_opened_as_anything_is() {
        let own = ["{\"format\": \"eigenform\"}", "[]", "\u{feff} {\"format\": 1}", "#s=1.AAAA", "See (https://example.org/#s=1.AAAA)."];
        for text in own {
            assert_eq!(open_own(text), Some(open(text)), "{text}");
        }
        for other in ["", "keyframe,time,agent,group,x,y\n", "# framerate: 10\n1 0 0 0\n", "frame,time,agent,x,y\n", "https://example.org/"]
        {
            assert_eq!(open_own(other), None, "{other}");
        }
    }
}
