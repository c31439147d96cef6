//! Which room may know which: the arrows of ARCHITECTURE.md, held by a test.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

/// What each room may name of the others.
const MAY_KNOW: [(&str, &[&str]); 16] = [
    ("adjacency", &["error", "formation"]),
    ("assignment", &["adjacency", "error", "formation", "obstacle"]),
    ("choice", &[]),
    ("edits", &["formation", "motion", "obstacle"]),
    // `scene` only in the words of its limits.
    ("error", &["scene"]),
    ("formation", &[]),
    ("grouping", &["adjacency", "formation", "spectral"]),
    ("measure", &["adjacency", "assignment", "formation", "motion"]),
    ("motion", &["formation"]),
    ("obstacle", &[]),
    (
        "perform",
        &[
            "adjacency",
            "assignment",
            "choice",
            "edits",
            "error",
            "formation",
            "grouping",
            "measure",
            "motion",
            "obstacle",
            "scene",
            "spectral",
            "text",
            "transition",
        ],
    ),
    ("scene", &["adjacency", "assignment", "choice", "error", "formation", "obstacle", "text"]),
    // `scene` only for how many agents it has at the most.
    ("shape", &["error", "formation", "scene"]),
    ("spectral", &["adjacency", "assignment", "choice", "formation"]),
    ("text", &[]),
    ("transition", &["adjacency", "choice", "formation", "grouping", "obstacle", "spectral"]),
];

fn sources(path: &Path) -> Vec<PathBuf> {
    if path.is_file() {
        return vec![path.to_owned()];
    }
    let entries = fs::read_dir(path).into_iter().flatten().map(|entry| entry.expect("the folder can be read").path());
    entries.flat_map(|path| sources(&path)).collect()
}

/// Rooms named as `crate::room` anywhere in the code of `room`.
fn known_to(room: &str) -> BTreeSet<String> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let files = [sources(&root.join(room)), sources(&root.join(format!("{room}.rs")))].concat();
    assert!(!files.is_empty(), "there is no room {room}");
    let mut known = BTreeSet::new();
    for file in files {
        let text = fs::read_to_string(&file).expect("sources are text");
        for rest in text.split("crate::").skip(1) {
            known.insert(rest.chars().take_while(char::is_ascii_lowercase).collect::<String>());
        }
    }
    known.remove(room);
    known.retain(|name| MAY_KNOW.iter().any(|(room, _)| room == name));
    known
}

#[test]
fn rooms_know_only_what_lies_below_them() {
    for (room, allowed) in MAY_KNOW {
        for known in known_to(room) {
            assert!(allowed.contains(&known.as_str()), "{room} names {known}, which it must not know");
        }
    }
}

#[test]
fn every_room_is_listed() {
    let library = fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("src/lib.rs")).expect("sources are text");
    let rooms: BTreeSet<&str> = library.lines().filter_map(|line| line.strip_prefix("pub mod ")?.strip_suffix(';')).collect();
    assert_eq!(rooms, MAY_KNOW.iter().map(|(room, _)| *room).collect());
}

#[test]
fn only_the_boundary_speaks_javascript() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    for file in sources(&root.join("src")) {
        let text = fs::read_to_string(&file).expect("sources are text");
        assert!(!text.contains("wasm_bindgen") && !text.contains("js_sys"), "{} speaks JavaScript", file.display());
    }
}
