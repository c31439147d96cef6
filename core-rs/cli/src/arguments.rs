//! What may be typed, and the help that teaches it.

mod files;
mod formations;
mod motions;
mod number;

use std::ffi::{OsStr, OsString};
use std::path::Path;

use clap::{Args, Parser, Subcommand};

pub use files::{Check, Convert, Link, Open};
pub use formations::{Assign, Groups, Modes, Shape};
pub use motions::{Compare, Measure, Motion, Spread};

const ABOUT: &str = "Moves a group from formation to formation with its subgroups kept together.";

const INTRODUCTION: &str = "\
Moves a group from formation to formation with its subgroups kept together.

SCENE is a scene file (.eigenform.json), a keyframe CSV (keyframe,time,agent,group,x,y), a link in quotes,
or - for standard input. Keyframes and agents count from 0; meters, seconds, radians.";

const EXAMPLES: &str = "\
Examples:
  eigenform check show.eigenform.json
  eigenform motion show.eigenform.json --out show.csv
  eigenform motion keyframes.csv --at 0,0.5,1 --json
  eigenform measure show.eigenform.json --method spectral --json
  eigenform shape bird.png --agents 400 > bird.eigenform.json
  eigenform link show.eigenform.json --base https://example.org/
  eigenform open '#s=1.…' > show.eigenform.json

Errors are one line on stderr: error: code: what (where).
Exit codes: 0 done, 1 a file cannot be read or written, 2 bad input or usage.";

/// The command line.
#[derive(Debug, Parser)]
#[command(name = "eigenform", version, about = ABOUT, long_about = INTRODUCTION, after_help = EXAMPLES, subcommand_required = true)]
#[command(arg_required_else_help = true, disable_help_subcommand = true)]
pub struct Arguments {
    /// What to do.
    #[command(subcommand)]
    pub verb: Verb,
}

/// What to do.
#[derive(Debug, Subcommand)]
pub enum Verb {
    /// Where everybody is over time, as CSV or JSON
    Motion(Motion),
    /// How good each transition is: distortion, turning, clearance, …
    Measure(Measure),
    /// Each transition several ways, with the numbers to judge them
    Compare(Compare),
    /// Keyframes that let those who are stuck spread out, where avoidance alone does not keep them apart
    Spread(Spread),
    /// Eigenvalues and ties of one keyframe
    Modes(Modes),
    /// Who takes which place of another keyframe at the least cost
    Assign(Assign),
    /// A formation of so many agents from a picture, a drawing or text, as a scene file
    Shape(Shape),
    /// Groups of those who keep their distances on the way to the next keyframe
    Groups(Groups),
    /// The scene as a link
    Link(Link),
    /// The scene of a link, as a scene file
    Open(Open),
    /// A scene file from a keyframe CSV or a recording, or a keyframe CSV from a scene
    Convert(Convert),
    /// Whether a scene is sound
    Check(Check),
}

/// A scene and what is to be otherwise.
#[derive(Args, Debug)]
pub struct Source {
    /// A scene file, a keyframe CSV, a link in quotes, or - for standard input
    pub scene: String,
    /// In place of every method, those of groups included: auto, spectral, shared, polar, linear or crowd
    #[arg(long, value_name = "METHOD")]
    pub method: Option<String>,
    /// In place of the scene's join: separate, smooth or product
    #[arg(long, value_name = "JOIN")]
    pub join: Option<String>,
    /// In place of the scene's minimum distance, meters
    #[arg(long, value_name = "METERS", value_parser = number::real, allow_negative_numbers = true)]
    pub minimum_distance: Option<f64>,
    /// In place of every transition's avoidance: true or false; alone it means true
    #[arg(long, value_name = "BOOLEAN")]
    pub avoidance: Option<String>,
}

/// What was typed. `--avoidance` alone means `--avoidance true`, and must not take the scene for its value.
pub fn typed() -> Vec<OsString> {
    let mut typed: Vec<OsString> = std::env::args_os().collect();
    for at in 0..typed.len() {
        let has_value = typed.get(at + 1).is_some_and(|next| is_word(next));
        if typed[at] == "--avoidance" && !has_value {
            typed[at].push("=true");
        }
    }
    typed
}

/// Whether this can be no scene: a word without any sign in it, and no file.
fn is_word(typed: &OsStr) -> bool {
    let is_plain = typed.to_str().is_some_and(|text| text.chars().all(char::is_alphanumeric));
    typed == "true" || typed == "false" || is_plain && !Path::new(typed).exists()
}

#[cfg(test)]
mod tests {
    use clap::CommandFactory as _;

    use super::Arguments;

    #[test]
    fn the_arguments_are_consistent() {
        Arguments::command().debug_assert();
    }
}
