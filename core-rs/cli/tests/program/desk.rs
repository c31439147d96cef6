//! The program as a person runs it.

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

    pub fn put_bytes(&self, name: &str, bytes: &[u8]) {
        std::fs::write(self.path(name), bytes).expect("a file on the desk");
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

/// A picture as small as they come: 8 × 8 pixels, the left half black, as JPEG.
pub fn jpeg() -> Vec<u8> {
    bytes(
        "ffd8ffdb0043001b12141714111b1716171e1c1b2028422b28252528513a3d3042605565645f555d5b6a7899816a7190735b5d85b586909ea3abadab\
         6780bcc9baa6c799a8aba4ffdb0043011c1e1e2823284e2b2b4ea46e5d6ea4a4a4a4a4a4a4a4a4a4a4a4a4a4a4a4a4a4a4a4a4a4a4a4a4a4a4a4a4a4\
         a4a4a4a4a4a4a4a4a4a4a4a4a4a4a4a4a4a4a4a4ffc00011080008000803012200021101031101ffc400140001000000000000000000000000000000\
         00ffc40018100100030100000000000000000000000000064482c2ffc40014010100000000000000000000000000000000ffc4001411010000000000\
         0000000000000000000000ffda000c03010002110311003f00432e63a001ffd9",
    )
}

/// The same as WebP.
pub fn webp() -> Vec<u8> {
    bytes("524946462a00000057454250565038201e0000009001009d012a0800080004006825a400029d47235000fef7827f87c00000")
}

/// The picture of `width` × `height` pixels as PNG, each pixel red, green, blue and opacity.
pub fn png(width: u32, height: u32, pixel: impl Fn(u32, u32) -> [u8; 4]) -> Vec<u8> {
    let mut file = Vec::new();
    let mut encoder = png::Encoder::new(&mut file, width, height);
    encoder.set_color(png::ColorType::Rgba);
    let pixels: Vec<u8> = (0..height).flat_map(|y| (0..width).map(move |x| (x, y))).flat_map(|(x, y)| pixel(x, y)).collect();
    let mut writer = encoder.write_header().expect("a header");
    writer.write_image_data(&pixels).expect("pixels");
    writer.finish().expect("an end");
    file
}

fn bytes(hex: &str) -> Vec<u8> {
    (0..hex.len() / 2).map(|at| u8::from_str_radix(&hex[2 * at..2 * at + 2], 16).expect("two hexadecimal digits")).collect()
}
