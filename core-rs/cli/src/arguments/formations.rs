//! What may be typed of a single formation, and of who goes where.

use clap::Args;

use super::{Source, number};

/// `modes`.
#[derive(Args, Debug)]
#[command(after_help = "\
JSON: {\"eigenvalues\": [0, …], \"ties\": [[a, b, weight], …]}, eigenvalues ascending, ties sorted with a < b, of those who
are there: an eigenvalue for each of them, and none for who is absent at keyframe K;
with --vectors also
  vectors           vectors[k][i] is agent i's entry in the unit mode of eigenvalues[k], 0 for who is absent; signs are arbitrary
  coefficients      coefficients[k] = [x, y], the sum over i of vectors[k][i] · position i, meters
so that position i is the sum over k of vectors[k][i] · coefficients[k]; with --next also, of keyframe K and the one after it,
of all who walk from one to the other
  likeness          likeness[k][l] = |mode k · mode l of the next|, 0 to 1
  pairs             {\"eigenvalue\": [l of k = 1, …], \"greedy\", \"maxmin\", \"hungarian\"}: the mode of the next that each order
                    pairs with mode k; the constant mode 0 is left out of both. Who is absent at one of both keyframes
                    walks and counts, as in the motion; at both, not
  between           {\"t\": [0, …, 1], \"eigenvalues\": [[0, …], …]} of the graph that runs straight from one to the other

Examples:
  eigenform modes show.eigenform.json --keyframe 0 --json --vectors
  eigenform modes show.eigenform.json --keyframe 0 --json --next")]
pub struct Modes {
    #[command(flatten)]
    pub source: Source,
    /// Which keyframe, from 0
    #[arg(long, value_name = "K", value_parser = number::whole, allow_negative_numbers = true)]
    pub keyframe: i64,
    /// Print JSON; without it the eigenvalues, one a line
    #[arg(long)]
    pub json: bool,
    /// Also the modes and the formation's coefficients in them (with --json)
    #[arg(long, requires = "json")]
    pub vectors: bool,
    /// Also how they become those of the keyframe after it (with --json)
    #[arg(long, requires = "json")]
    pub next: bool,
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
    #[arg(long, value_name = "K", value_parser = number::whole, allow_negative_numbers = true)]
    pub from: i64,
    /// The keyframe whose places they take, from 0
    #[arg(long, value_name = "K", value_parser = number::whole, allow_negative_numbers = true)]
    pub to: i64,
    /// What is to be least in sum: squared, least-effort, euclidean, manhattan, or keep
    #[arg(long, value_name = "COST", default_value = "squared")]
    pub cost: String,
    /// How much the way counts in least-effort, 0 to 1; 0.9 without it, and nothing to other costs
    #[arg(long, value_name = "LAMBDA", value_parser = number::real, allow_negative_numbers = true)]
    pub lambda: Option<f64>,
    /// An agent and the place it takes whatever it costs; may be given again and again
    #[arg(long, value_name = "AGENT:PLACE", allow_hyphen_values = true)]
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
    #[arg(long, value_name = "N", value_parser = number::whole, allow_negative_numbers = true)]
    pub agents: i64,
    /// Of every random choice
    #[arg(long, value_name = "S", value_parser = number::whole, default_value_t = 0, allow_negative_numbers = true)]
    pub seed: i64,
    /// What is darker than this is the shape, 0.01 to 0.99; with transparency, what is more opaque than 1 minus it
    #[arg(long, value_name = "BRIGHTNESS", value_parser = number::real, default_value_t = 0.5, allow_negative_numbers = true)]
    pub threshold: f64,
    /// What is not, instead
    #[arg(long)]
    pub invert: bool,
    /// Along its edge, not all over it
    #[arg(long)]
    pub outline: bool,
    /// From left to right, meters; its depth follows
    #[arg(long, value_name = "METERS", value_parser = number::real, allow_negative_numbers = true)]
    pub width: Option<f64>,
    /// How near two may stand, meters; the scene's minimum distance, too
    #[arg(long, value_name = "METERS", value_parser = number::real, default_value_t = 0.0, allow_negative_numbers = true)]
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
    #[arg(long, value_name = "K", value_parser = number::whole, allow_negative_numbers = true)]
    pub keyframe: i64,
    /// How readily an agent stands for a group, square meters; nearer to 0, more groups. Without it the median
    /// similarity, which is minus a squared change of distance
    #[arg(long, value_name = "P", value_parser = number::real, allow_negative_numbers = true)]
    pub preference: Option<f64>,
    /// How distances are measured: euclidean or manhattan
    #[arg(long, value_name = "METRIC", default_value = "euclidean")]
    pub metric: String,
    /// Print JSON; without it a group a line
    #[arg(long)]
    pub json: bool,
}
