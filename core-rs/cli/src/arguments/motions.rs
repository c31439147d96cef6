//! What may be typed of motions and the numbers to judge them.

use std::path::PathBuf;

use clap::Args;

use super::{Source, number};

/// Meters a second: the mean of pedestrians that paper D's forces are made for (Helbing and Molnár 1995).
const WALKING_PACE: &str = "1.34";

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
    #[arg(long, value_name = "TIMES", value_parser = number::real, value_delimiter = ',', allow_negative_numbers = true)]
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
    #[arg(long, value_name = "NUMBER", value_parser = number::real, allow_negative_numbers = true)]
    pub lambda: Option<f64>,
    /// Everybody goes at this pace, in meters a second, and arrives when they do; without it at the keyframe's time
    #[arg(long, value_name = "PACE", value_parser = number::real, num_args = 0..=1, require_equals = true, default_missing_value = WALKING_PACE)]
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
    #[arg(long, value_name = "K", value_parser = number::whole, allow_negative_numbers = true)]
    pub segment: Option<i64>,
    /// Also what goes far from the transition as it was
    #[arg(long)]
    pub wild: bool,
}
