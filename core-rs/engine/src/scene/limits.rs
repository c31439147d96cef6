//! How large a scene may be, and why.
//!
//! Limits keep untrusted input from asking for more time or memory than a person waits for; every show we know is far below them.

use std::ops::RangeInclusive;

use crate::adjacency::TIE_LIMIT;

/// A file, in bytes: the largest scene with 17 digits a number is near 20 MiB; three times that leaves room for white space and names.
pub const FILE_BYTES: usize = 64 << 20;

/// Agents: the eigenbasis of one keyframe takes n² doubles, 200 MB at this size.
pub const AGENTS: usize = 5_000;

/// Keyframes: a formation every few seconds for the longest show.
pub const KEYFRAMES: usize = 200;

/// Agents × keyframes: what undo copies and a link carries.
pub const POSITIONS: usize = 200_000;

/// Agents × frames: 320 MB of doubles, the largest motion a browser holds beside its copy for drawing.
pub const SAMPLES: usize = 20_000_000;

/// Frames per second: from one a second to a fast display.
pub const FRAME_RATE: RangeInclusive<f64> = 1.0..=120.0;

/// Ties that groups and the person add at one keyframe: ten an agent at the most agents.
pub const TIES_PER_KEYFRAME: usize = TIE_LIMIT;

/// The same, over all keyframes.
pub const TIES_IN_ALL: usize = 500_000;

/// Cuts in one list: as many as the ties they could cut.
pub const CUTS: usize = TIES_PER_KEYFRAME;

/// A tie's factor: beyond, the Laplacian's eigenvalues are lost in its round-off.
pub const FACTOR: RangeInclusive<f64> = 1e-6..=1e6;

/// Groups of the whole tree.
pub const GROUPS: usize = 1_000;

/// Levels of groups, the outermost included.
pub const GROUP_DEPTH: usize = 8;

/// Characters of the name of an agent, group or keyframe.
pub const NAME_CHARACTERS: usize = 64;

/// Characters of a row of keyframe CSV: numbers without exponents, names and a path of groups fit many times.
pub const ROW_CHARACTERS: usize = 10_000;

/// Characters of the title.
pub const TITLE_CHARACTERS: usize = 200;

/// A coordinate, in meters: 100 km from the center, where a double still tells 10⁻¹¹ m apart.
pub const COORDINATE: RangeInclusive<f64> = -1e5..=1e5;

/// The instant at which a keyframe is reached and, after its hold, left, in seconds: an hour.
pub const TIME: RangeInclusive<f64> = 0.0..=3_600.0;

/// The shortest way from the end of a keyframe to the next, in seconds: speeds over less would not be finite.
pub const SHORTEST_SEGMENT: f64 = 1e-100;

/// Lengths that must not be negative, in meters: the distance of two agents at the most.
pub const LENGTH: RangeInclusive<f64> = 0.0..=1e5;

/// Width and depth of the stage, in meters: from a tabletop to all admissible coordinates.
pub const STAGE_SIDE: RangeInclusive<f64> = 0.1..=2e5;

/// Counts a minute.
pub const BEATS_PER_MINUTE: RangeInclusive<f64> = 1.0..=1_000.0;

/// Counts a bar.
pub const BEATS_PER_BAR: RangeInclusive<f64> = 1.0..=64.0;

/// The time of the first count, in seconds; it may lie before the first keyframe.
pub const TEMPO_START: RangeInclusive<f64> = -3_600.0..=3_600.0;

/// Rows of a recording: 200 agents for a quarter of an hour, 25 times a second, and 200 MB.
pub const RECORDING_ROWS: usize = 5_000_000;

/// The number of a frame in a recording.
pub const FRAME_NUMBER: RangeInclusive<f64> = -1e9..=1e9;

/// Frames per second of a recording: from slow motion of clouds to fast cameras.
pub const RECORDING_RATE: RangeInclusive<f64> = 1e-3..=1e4;

/// Sharing ρ.
pub const SHARING: RangeInclusive<f64> = 0.0..=1.0;

/// Tension τ of smooth joins.
pub const TENSION: RangeInclusive<f64> = 0.0..=1.0;

/// How much of a group's motion is its second method's.
pub const BLEND: RangeInclusive<f64> = 0.0..=1.0;

/// The top speed of an agent, meters a second: from a crawl to a jet.
pub const MAX_SPEED: RangeInclusive<f64> = 0.01..=1_000.0;

/// Constants of a crowd's forces, by their names: a reaction must be longer than a step of 1/30 s, and a reach of many spacings makes
/// every agent everybody's neighbor.
pub const CROWD: [(&str, RangeInclusive<f64>); 8] = [
    ("reactionTime", 0.05..=10.0),
    ("lookAhead", 0.05..=10.0),
    ("strength", 0.0..=100.0),
    ("reach", 0.01..=5.0),
    ("groupStrength", 0.0..=100.0),
    ("groupReach", 0.01..=20.0),
    ("fluctuation", 0.0..=100.0),
    ("binSize", 0.1..=1_000.0),
];

/// K, sectors of a full turn.
pub const SECTORS: RangeInclusive<f64> = 1.0..=64.0;

/// λ of least effort.
pub const LAMBDA: RangeInclusive<f64> = 0.0..=1.0;

/// Groups with a method of their own in one segment: all of them, and the root.
pub const NODES: usize = GROUPS + 1;

/// Obstacles of the scene.
pub const OBSTACLES: usize = 200;

/// Corners of a polygon.
pub const CORNERS: RangeInclusive<usize> = 3..=200;

/// Points of a path: as many as corners.
pub const PATH_POINTS: usize = 200;

/// A path's length, from point to point, in meters: from what a link still tells apart.
pub const PATH_LENGTH: f64 = 1e-6;

/// Radius of a circle, in meters: from what a link still tells apart to all admissible coordinates.
pub const OBSTACLE_RADIUS: RangeInclusive<f64> = 1e-6..=1e5;

/// A polygon's area below this, relative to the square of its extent, is round-off of its corners on a line.
pub const LEAST_AREA: f64 = 1e-12;
