//! What may be typed of scenes as they are kept: files and links.

use std::path::PathBuf;

use clap::Args;

use super::{Source, number};

/// `link`.
#[derive(Args, Debug)]
#[command(after_help = "\
A link holds the whole scene and never reaches a server. It keeps every coordinate to 1e-6 m; what is drawn on a
grid comes back exactly. --short rounds coordinates to 12 bits of the extent and says by how much on stderr.

Examples:
  eigenform link show.eigenform.json
  eigenform link show.eigenform.json --short --base https://example.org/eigenform/")]
pub struct Link {
    #[command(flatten)]
    pub source: Source,
    /// Round coordinates for a shorter link
    #[arg(long)]
    pub short: bool,
    /// The page's address to put before it
    #[arg(long, value_name = "URL", default_value = "")]
    pub base: String,
}

/// `open`.
#[derive(Args, Debug)]
#[command(after_help = "\
Example:
  eigenform open 'https://example.org/#s=1.…' > show.eigenform.json")]
pub struct Open {
    /// A link in quotes, or - for standard input
    #[arg(allow_hyphen_values = true)]
    pub link: String,
}

/// `convert`.
#[derive(Args, Debug)]
#[command(after_help = "\
The extension of OUT says what is written: .json or .csv. With - it is printed: a keyframe CSV of a scene file, a
scene file of anything else. What a CSV cannot hold is said on stderr.

With --frames SCENE is a recording of motion: motion CSV (frame,time,agent,x,y,z) or the text format of JuPedSim and
PedPy (# framerate: 25.00 fps, then rows of id frame x y). Its frames become keyframes, the first of them at 0 s, of the
agents that are there at all of them.

Examples:
  eigenform convert show.eigenform.json keyframes.csv
  eigenform convert keyframes.csv show.eigenform.json
  eigenform convert crowd.txt show.eigenform.json --frames 0,120,300")]
pub struct Convert {
    #[command(flatten)]
    pub source: Source,
    /// Make a scene of these frames of a recording, by their numbers in it
    #[arg(long, value_name = "FRAMES", value_parser = number::whole, value_delimiter = ',', allow_negative_numbers = true)]
    pub frames: Option<Vec<i64>>,
    /// A file named .json or .csv, or - for standard output
    pub out: PathBuf,
}

/// `check`.
#[derive(Args, Debug)]
#[command(after_help = "\
Prints ok: N agents, K keyframes — or what is wrong and where, with exit code 2.

Example:
  eigenform check show.eigenform.json")]
pub struct Check {
    #[command(flatten)]
    pub source: Source,
}
