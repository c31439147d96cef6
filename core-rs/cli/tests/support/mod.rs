//! The program as a person runs it. Cargo builds each file of tests apart, and none uses all of this.
#![allow(dead_code)]

use std::path::PathBuf;

use assert_cmd::Command;
use tempfile::TempDir;

/// What a run gave.
#[derive(Debug, PartialEq)]
pub struct Outcome {
    pub code: i32,
    pub stdout: String,
    pub stderr: String,
}

/// A folder of its own to run in.
pub struct Desk {
    folder: TempDir,
}

impl Desk {
    /// With `show.json` (a square of four that turns, 2 s) and `keyframes.csv` (the same) on it.
    pub fn new() -> Self {
        let desk = Self { folder: TempDir::new().expect("a temporary folder") };
        desk.put("show.json", SHOW);
        desk.put("keyframes.csv", KEYFRAMES);
        desk
    }

    pub fn put(&self, name: &str, text: &str) {
        std::fs::write(self.path(name), text).expect("a file on the desk");
    }

    pub fn read(&self, name: &str) -> String {
        std::fs::read_to_string(self.path(name)).expect("a file on the desk")
    }

    pub fn path(&self, name: &str) -> PathBuf {
        self.folder.path().join(name)
    }

    /// What lies on it, sorted.
    pub fn names(&self) -> Vec<String> {
        let entries = std::fs::read_dir(self.folder.path()).expect("the folder");
        let mut names: Vec<String> = entries.map(|entry| entry.expect("an entry").file_name().to_string_lossy().into_owned()).collect();
        names.sort();
        names
    }

    pub fn run(&self, arguments: &[&str]) -> Outcome {
        self.run_with(arguments, "")
    }

    pub fn run_with(&self, arguments: &[&str], input: &str) -> Outcome {
        let mut command = Command::cargo_bin("eigenform").expect("the program is built");
        let output = command.current_dir(self.folder.path()).args(arguments).write_stdin(input).output().expect("it runs");
        Outcome {
            code: output.status.code().expect("an exit code"),
            stdout: String::from_utf8(output.stdout).expect("text"),
            stderr: String::from_utf8(output.stderr).expect("text"),
        }
    }

    /// Standard output of a run that succeeds and has nothing to note.
    pub fn answer(&self, arguments: &[&str]) -> String {
        let outcome = self.run(arguments);
        assert_eq!((outcome.code, outcome.stderr.as_str()), (0, ""), "{arguments:?}");
        outcome.stdout
    }
}

pub const SHOW: &str = r#"{
    "format": "eigenform", "version": 1, "frameRate": 2,
    "keyframes": [
        { "positions": [[0, 0], [2, 0], [2, 2], [0, 2]] },
        { "time": 2, "positions": [[2, 0], [2, 2], [0, 2], [0, 0]] }
    ],
    "segments": [{ "method": "linear" }]
}"#;

const KEYFRAMES: &str = "keyframe,time,agent,group,x,y
0,0,Ada,,0,0
0,0,Ben,,2,0
1,2,Ada,,2,0
1,2,Ben,,0,0
";
