//! Files that were damaged by chance end in a typed refusal or a valid scene.

use std::time::{Duration, Instant};

use crate::scenes::arbitrary_scene;
use eigenform::scene::{open_bytes, validate, write_csv, write_json};
use proptest::prelude::*;
use proptest::strategy::ValueTree;
use proptest::test_runner::{Config, RngAlgorithm, TestRng, TestRunner};

const MUTATIONS: usize = 10_000;

/// A hang is what a person notices; a mutated file of a few kilobytes takes well under a millisecond.
const HANG: Duration = Duration::from_secs(1);

/// What text files are made of, and what breaks them.
const SNIPPETS: &[&str] = &[
    "",
    "0",
    "-",
    "1e999",
    "-0.0",
    "99999999999999999999",
    "0.1e-400",
    "null",
    "true",
    "NaN",
    "\"",
    "\"\"",
    ",",
    ":",
    "[",
    "]",
    "{",
    "}",
    "[[",
    "]]",
    "\n",
    "\r\n",
    "\u{feff}",
    "\0",
    "\\",
    "\\ud800",
    "é",
    "/",
    "#",
    "#s=1.",
    "\"version\": 2",
    "\"positions\": []",
    "keyframe",
    "nan",
    "inf",
];

fn runner() -> TestRunner {
    TestRunner::new_with_rng(Config::default(), TestRng::from_seed(RngAlgorithm::ChaCha, &[7; 32]))
}

/// Changes a file at up to four places: bytes flipped, cut, repeated, swapped for a snippet, or everything after dropped.
fn mutated(file: &[u8], runner: &mut TestRunner) -> Vec<u8> {
    let mut draw = |bound: usize| (0..bound.max(1)).new_tree(runner).expect("a range has values").current();
    let mut file = file.to_vec();
    for _ in 0..=draw(4) {
        let at = draw(file.len() + 1);
        let end = (at + draw(12)).min(file.len());
        match draw(6) {
            0 if at < file.len() => file[at] ^= 1 << draw(8),
            1 => drop(file.drain(at..end)),
            2 => {
                let again = file[at..end].to_vec();
                file.splice(at..at, again);
            }
            3 => file.truncate(at),
            _ => drop(file.splice(at..end, SNIPPETS[draw(SNIPPETS.len())].bytes())),
        }
    }
    file
}

/// Some files are spared by chance; that far most are not says that the mutations reach something.
fn check(write: impl Fn(&eigenform::scene::Scene) -> String) {
    let mut runner = runner();
    let files: Vec<String> =
        (0..50).map(|_| write(&arbitrary_scene().new_tree(&mut runner).expect("scenes are not rejected").current())).collect();
    let mut refused = 0;
    for index in 0..MUTATIONS {
        let file = mutated(files[index % files.len()].as_bytes(), &mut runner);
        let start = Instant::now();
        match open_bytes(&file) {
            Ok(opened) => assert_eq!(validate(&opened.scene), Ok(())),
            Err(error) => {
                refused += 1;
                assert!(!error.code().is_empty() && !error.to_string().is_empty());
            }
        }
        assert!(start.elapsed() < HANG, "{}", String::from_utf8_lossy(&file));
    }
    assert!(refused > MUTATIONS / 2, "{refused}");
}

#[test]
fn a_damaged_scene_file_is_refused_or_valid() {
    check(write_json);
}

#[test]
fn a_damaged_keyframe_csv_is_refused_or_valid() {
    check(|scene| write_csv(scene).text);
}
