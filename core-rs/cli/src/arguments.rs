//! What may be typed, and the help that teaches it.

use std::ffi::OsString;
use std::path::PathBuf;

use clap::{Args, Parser, Subcommand};

/// Meters a second: the mean of pedestrians that paper D's forces are made for (Helbing and Molnár 1995).
const WALKING_PACE: &str = "1.34";

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
    #[arg(long, value_name = "METERS", allow_negative_numbers = true)]
    pub minimum_distance: Option<f64>,
    /// In place of every transition's avoidance: true or false; alone it means true
    #[arg(long, value_name = "BOOLEAN")]
    pub avoidance: Option<String>,
}

/// What was typed. `--avoidance` alone means `--avoidance true`, and must not take the scene for its value.
pub fn typed() -> Vec<OsString> {
    let mut typed: Vec<OsString> = std::env::args_os().collect();
    for at in 0..typed.len() {
        let has_value = typed.get(at + 1).is_some_and(|next| next == "true" || next == "false");
        if typed[at] == "--avoidance" && !has_value {
            typed[at].push("=true");
        }
    }
    typed
}

/// `motion`.
#[derive(Args, Debug)]
#[command(after_help = "\
CSV, one row a frame and agent, agents by name where all names differ, else by number:
  frame,time,agent,x,y,z
JSON, one entry a frame or a time asked for; positions[k][i] is agent i at times[k]:
  {\"times\": [0, …], \"positions\": [[[x, y], …], …]}

Examples:
  eigenform motion show.eigenform.json > show.csv
  eigenform motion show.eigenform.json --out show.json
  eigenform motion show.eigenform.json --at 0,0.5,1 --json")]
pub struct Motion {
    #[command(flatten)]
    pub source: Source,
    /// Write to FILE, CSV or JSON by its extension; without it CSV is printed
    #[arg(long, value_name = "FILE")]
    pub out: Option<PathBuf>,
    /// Only at these instants, seconds, in full precision from the method itself; as JSON
    #[arg(long, value_name = "TIMES", value_delimiter = ',', allow_negative_numbers = true)]
    pub at: Option<Vec<f64>>,
    /// Print JSON
    #[arg(long)]
    pub json: bool,
}

/// `measure`.
#[derive(Args, Debug)]
#[command(after_help = "\
JSON: {\"segments\": [{ … }]}, one entry a transition, with
  method, options   what moved it (under auto: what was chosen)
  distortion        {mean, max} over the frames of how far ties leave their due lengths
  turning           {mean, max} over the agents, radians
  clearance         {distance, time, agents} of the nearest approach, or null
  nearCollisions    pairs and frames nearer than the minimum distance
  pathLength        {mean, max} over the agents, meters
  topSpeed          {speed, time, agent}
  rmsRadius         {min, max} about the barycenter, meters
  candidates        what auto compared: method, options, score, chosen
and {mean, max} over time of
  mutualInformation how much place tells of direction, bits; speedInformation: of speed
  structureDeviation, effortDeviation: standard deviations of nearest distances and of ways from the source, meters
  targetDeviation   mean distance to the target's places, whoever takes them, meters
with roughness, the median jerk, m/s³; with method crowd
  guideDeviation    {mean, max} of how far forces lead agents from their guide, meters
  arrivalError      {mean, max} of how far forces alone leave them from the target, meters
  hurried           [{agent, speed, maxSpeed, duration}] of who is faster than its maxSpeed, m/s, to arrive in time, and
                    the seconds that would do; left out when nobody is
and with avoidance
  deviation         {mean, max} over agents and samples of how far they leave the method's way, meters
  unsolved          [{distance, time, agents}] of every meeting still too near; [] when it is proved that there is none
  guideClearance    the nearest approach before
  blocked           [{distance, time, agent, obstacle}] still too near to an obstacle, from its outline
  shutOff           [{agent, obstacle, distance}] of whom no way leads around obstacles, at that distance from them; left
                    out when there is one for everybody
  breaches          who stands too near in a keyframe: end (0 source, 1 target), agent, other, distance
  rung, suggestions which attempt was kept; what may help where it is not solved

Example:
  eigenform measure show.eigenform.json --minimum-distance 0.5 --json")]
pub struct Measure {
    #[command(flatten)]
    pub source: Source,
    /// Print JSON; without it a table
    #[arg(long)]
    pub json: bool,
}

/// `compare`.
#[derive(Args, Debug)]
#[command(after_help = "\
METHODS are auto, linear, polar, shared, spectral and crowd; crowd-no-feedback and crowd-no-groups; and three that no
scene has: social-force-guide (forces on the method's own way, then smoothed), social-force (forces toward the target alone,
arriving wherever they do) and orca (optimal reciprocal collision avoidance toward the target, likewise). The minimum
distance and avoidance are the scene's.

With --costs every way is tried under every cost: from the transition's target on, agents have the places found for them.
With --free-arrival there is no keyframe's time: everybody goes their way at one pace, or their own top speed, and stops.

The table gives means over time: time (seconds until everybody is there, by forces alone where there are any; - for
never), I_d and I_v (bits), structure, effort and target deviation, least distance, turning, path, roughness (median
jerk, m/s³), late (how far forces alone leave somebody from the target, meters).
JSON: {\"segments\": [{\"from\", \"to\", \"methods\": [{\"method\", \"cost\", \"time\", …, \"curves\"}]}]}, keys as measure says them.

Example:
  eigenform compare show.eigenform.json --methods linear,spectral,crowd,social-force
  eigenform compare show.eigenform.json --methods crowd --costs least-effort,euclidean,manhattan --free-arrival")]
pub struct Compare {
    #[command(flatten)]
    pub source: Source,
    /// Which ways, in this order
    #[arg(long, value_name = "METHODS", value_delimiter = ',')]
    #[arg(default_value = "linear,polar,spectral,crowd,crowd-no-feedback,crowd-no-groups")]
    pub methods: Vec<String>,
    /// Who goes where, by what: keep (as in the scene), least-effort, squared, euclidean, manhattan
    #[arg(long, value_name = "COSTS", value_delimiter = ',', default_value = "keep")]
    pub costs: Vec<String>,
    /// How much the way counts in least effort, 0–1; that of the transition's recipe, else 0.9
    #[arg(long, value_name = "NUMBER")]
    pub lambda: Option<f64>,
    /// Everybody goes at this pace, in meters a second, and arrives when they do; without it at the keyframe's time
    #[arg(long, value_name = "PACE", num_args = 0..=1, require_equals = true, default_missing_value = WALKING_PACE)]
    pub free_arrival: Option<f64>,
    /// Print JSON, with curves over time; without it a table
    #[arg(long)]
    pub json: bool,
}

/// `spread`.
#[derive(Args, Debug)]
#[command(after_help = "\
Prints the scene with keyframes in every transition whose agents avoidance leaves too near, where such keyframes are
found: everybody keeps the minimum distance there then. What they cost is said on stderr. Motions that go farther aside
than 2 m and three minimum distances, or are more than 1.5 times as fast, are left out without --wild.

Example:
  eigenform spread show.eigenform.json > apart.eigenform.json")]
pub struct Spread {
    #[command(flatten)]
    pub source: Source,
    /// Only this transition, from 0
    #[arg(long, value_name = "K")]
    pub segment: Option<usize>,
    /// Also what goes far from the transition as it was
    #[arg(long)]
    pub wild: bool,
}

/// `modes`.
#[derive(Args, Debug)]
#[command(after_help = "\
JSON: {\"eigenvalues\": [0, …], \"ties\": [[a, b, weight], …]}, eigenvalues ascending, ties sorted with a < b;
with --vectors also
  vectors           vectors[k][i] is agent i's entry in the unit mode of eigenvalues[k]; signs are arbitrary
  coefficients      coefficients[k] = [x, y], the sum over i of vectors[k][i] · position i, meters
so that position i is the sum over k of vectors[k][i] · coefficients[k].

Example:
  eigenform modes show.eigenform.json --keyframe 0 --json --vectors")]
pub struct Modes {
    #[command(flatten)]
    pub source: Source,
    /// Which keyframe, from 0
    #[arg(long, value_name = "K")]
    pub keyframe: usize,
    /// Print JSON; without it the eigenvalues, one a line
    #[arg(long)]
    pub json: bool,
    /// Also the modes and the formation's coefficients in them (with --json)
    #[arg(long, requires = "json")]
    pub vectors: bool,
}

/// `assign`.
#[derive(Args, Debug)]
#[command(after_help = "\
JSON: {\"assignment\": […], \"cost\": …}; assignment[i] is the place of keyframe --to that agent i of keyframe --from
takes, cost the sum, square meters (of euclidean and manhattan meters). It is the exact optimum; of equal ones the same
on every machine.

Costs: squared (of the distance), least-effort (lambda · squared + (1 − lambda) · squared change of the mean distance to
neighbors), euclidean, manhattan, or keep: everybody takes the place of their number.

Examples:
  eigenform assign show.eigenform.json --from 0 --to 1 --json
  eigenform assign show.eigenform.json --from 0 --to 1 --cost least-effort --lambda 0.5 --lock 0:7 --keep-groups")]
#[expect(clippy::struct_excessive_bools, reason = "a switch of the command line is a bool")]
pub struct Assign {
    #[command(flatten)]
    pub source: Source,
    /// The keyframe the agents leave, from 0
    #[arg(long, value_name = "K")]
    pub from: usize,
    /// The keyframe whose places they take, from 0
    #[arg(long, value_name = "K")]
    pub to: usize,
    /// What is to be least in sum: squared, least-effort, euclidean, manhattan, or keep
    #[arg(long, value_name = "COST", default_value = "squared")]
    pub cost: String,
    /// How much the way counts in least-effort, 0 to 1; 0.9 without it, and nothing to other costs
    #[arg(long, value_name = "LAMBDA", allow_negative_numbers = true)]
    pub lambda: Option<f64>,
    /// An agent and the place it takes whatever it costs; may be given again and again
    #[arg(long, value_name = "AGENT:PLACE")]
    pub lock: Vec<String>,
    /// Give groups regions first, and their agents places within them
    #[arg(long)]
    pub keep_groups: bool,
    /// As if everybody (of a group, with --keep-groups) stood mirrored end to end
    #[arg(long)]
    pub flip: bool,
    /// As if everybody were carried as the locked agents are to their places
    #[arg(long)]
    pub predict: bool,
    /// Those who take the places of the absent at --to: leave, stay where they are, or wait there at a bench
    #[arg(long, value_name = "REST", default_value = "leave")]
    pub rest: String,
    /// Print JSON; without it one place a line, then the cost
    #[arg(long)]
    pub json: bool,
}

/// `shape`.
#[derive(Args, Debug)]
#[command(after_help = "\
INPUT is a PNG, JPEG, WebP or SVG file, - for one on standard input, the d of a path, or else text. Of a picture the
dark parts are the shape; where it has transparent parts, all that can be seen. Agents stand evenly all over the shape,
which is as large as the stage of 100 by 60 m allows; the same seed gives the same places.

Examples:
  eigenform shape bird.png --agents 400 --threshold 0.6 > bird.eigenform.json
  eigenform shape 'M 0 0 L 4 0 L 2 3 Z' --agents 66 --width 20 --minimum-distance 1
  eigenform shape GO --agents 200 --outline --font 'DejaVu Serif'")]
pub struct Shape {
    /// A picture or drawing, - for standard input, path data, or text
    pub input: String,
    /// How many agents, 1 to 5,000
    #[arg(long, value_name = "N")]
    pub agents: usize,
    /// Of every random choice
    #[arg(long, value_name = "S", default_value_t = 0)]
    pub seed: u32,
    /// What is darker than this is the shape, 0.01 to 0.99; with transparency, what is more opaque than 1 minus it
    #[arg(long, value_name = "BRIGHTNESS", default_value_t = 0.5, allow_negative_numbers = true)]
    pub threshold: f64,
    /// What is not, instead
    #[arg(long)]
    pub invert: bool,
    /// Along its edge, not all over it
    #[arg(long)]
    pub outline: bool,
    /// From left to right, meters; its depth follows
    #[arg(long, value_name = "METERS", allow_negative_numbers = true)]
    pub width: Option<f64>,
    /// How near two may stand, meters; the scene's minimum distance, too
    #[arg(long, value_name = "METERS", default_value_t = 0.0, allow_negative_numbers = true)]
    pub minimum_distance: f64,
    /// For text: a family of fonts on this machine
    #[arg(long, value_name = "FAMILY")]
    pub font: Option<String>,
    /// INPUT is text, whatever it looks like
    #[arg(long)]
    pub text: bool,
}

/// `groups`.
#[derive(Args, Debug)]
#[command(after_help = "\
Affinity propagation: two agents are alike as their distance changes little from keyframe K to the next (of the last
keyframe, from the one before). Every agent is in one group.

JSON: {\"groups\": [[agent, …], …], \"preference\": …}, agents ascending, groups by their lowest agent.

Examples:
  eigenform groups show.eigenform.json --keyframe 0
  eigenform groups show.eigenform.json --keyframe 0 --preference -20 --metric manhattan --json")]
pub struct Groups {
    #[command(flatten)]
    pub source: Source,
    /// Which keyframe, from 0
    #[arg(long, value_name = "K")]
    pub keyframe: usize,
    /// How readily an agent stands for a group, square meters; nearer to 0, more groups. Without it the median
    /// similarity, which is minus a squared change of distance
    #[arg(long, value_name = "P", allow_negative_numbers = true)]
    pub preference: Option<f64>,
    /// How distances are measured: euclidean or manhattan
    #[arg(long, value_name = "METRIC", default_value = "euclidean")]
    pub metric: String,
    /// Print JSON; without it a group a line
    #[arg(long)]
    pub json: bool,
}

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
    #[arg(long, value_name = "FRAMES", value_delimiter = ',', allow_negative_numbers = true)]
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

#[cfg(test)]
mod tests {
    use clap::CommandFactory as _;

    use super::Arguments;

    #[test]
    fn the_arguments_are_consistent() {
        Arguments::command().debug_assert();
    }
}
