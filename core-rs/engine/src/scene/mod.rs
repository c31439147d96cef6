//! The document: what the person made.
//!
//! Plain data with its defaults. Every file, link and autosave becomes a [`Scene`] through this room and no other:
//! sizes are checked before anything is allocated, and a scene that exists is valid.
//! Parts that the engine caches by identity are shared (`Arc`): an unchanged part is the same allocation.

mod cautions;
mod crowd;
mod csv;
mod defaults;
pub mod document;
mod groups;
mod json;
pub mod limits;
pub mod link;
mod normalize;
mod number;
mod open;
mod path;
pub(crate) mod place;
mod queries;
pub mod recording;
mod stretches;
mod unsupported;
mod validate;

use std::sync::Arc;

pub use cautions::cautions;
pub use crowd::CrowdSpec;
pub use csv::{Read, Written, read_csv, write_csv};
pub use defaults::{DEFAULT_FRAME_RATE, DEFAULT_RADIUS, DEFAULT_TENSION};
pub use groups::{group_levels, group_ties};
pub use json::{read_json, write_json};
pub use open::{Opened, Source, open, open_bytes, open_own};
pub use path::PathSpec;
pub use validate::validate;

use serde::{Deserialize, Serialize};

use crate::adjacency::AdjacencySpec;
use crate::assignment::AssignmentSpec;
use crate::choice::{Alignment, Blend, Choice, DEFAULT_SHARING, Join, MethodName, Order, Timing};
use crate::formation::Formation;
use crate::obstacle::ObstacleShape;

/// One scene, version 1. What version 1 names and this type lacks is refused as unsupported unless it has its default.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
#[serde(rename_all = "camelCase")]
pub struct Scene {
    /// At most 200 characters.
    pub title: String,
    /// Of every random choice made for this scene.
    pub seed: u32,
    /// The place it is shown on.
    pub stage: Stage,
    /// How seconds read as counts.
    pub tempo: Tempo,
    /// Frames per second, 1–120.
    pub frame_rate: f64,
    /// Agents nearer than this clash; meters, 0 for no limit.
    pub minimum_distance: f64,
    /// How segments meet.
    pub join: Join,
    /// Tension τ of smooth joins, 0–1; 0.5 is that of Catmull and Rom.
    pub tension: f64,
    /// The tree of groups; siblings share no agent.
    #[cfg_attr(feature = "types", ts(as = "Vec<Group>"))]
    pub groups: Arc<Vec<Group>>,
    /// Who belongs together throughout the show.
    #[cfg_attr(feature = "types", ts(as = "AdjacencySpec"))]
    pub adjacency: Arc<AdjacencySpec>,
    /// Version 1 has exactly one, of all agents.
    pub tracks: Vec<Track>,
    /// What agents go around.
    #[cfg_attr(feature = "types", ts(as = "Vec<Obstacle>"))]
    pub obstacles: Arc<Vec<Obstacle>>,
}

/// Agents that share a timeline.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
#[serde(rename_all = "camelCase")]
pub struct Track {
    /// One entry an agent.
    #[cfg_attr(feature = "types", ts(as = "Vec<Agent>"))]
    pub agents: Arc<Vec<Agent>>,
    /// By rising time; at least one.
    pub keyframes: Vec<Keyframe>,
    /// `segments[i]` runs from keyframe i to keyframe i + 1.
    pub segments: Vec<Segment>,
}

/// The stage, centered on the origin; it frames the view and is no wall.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
#[serde(rename_all = "camelCase")]
pub struct Stage {
    /// Along x, meters.
    pub width: f64,
    /// Along y, meters.
    pub depth: f64,
    /// Along z, meters.
    pub height: f64,
    /// What is painted on it.
    pub backdrop: Backdrop,
    /// What lengths are shown in; the scene itself is in meters.
    pub units: Units,
}

/// What is painted on the stage.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
#[serde(rename_all = "kebab-case")]
pub enum Backdrop {
    /// Nothing.
    None,
    /// A metric grid.
    #[default]
    Grid,
    /// A college football field.
    FootballCollege,
    /// A high-school football field.
    FootballHs,
    /// A soccer pitch.
    Soccer,
    /// A theater stage.
    Stage,
}

/// What lengths are shown in.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
#[serde(rename_all = "lowercase")]
pub enum Units {
    /// Meters.
    #[default]
    M,
    /// Feet.
    Ft,
    /// Yards.
    Yd,
    /// Marching steps, eight to five yards (0.5715 m).
    Steps,
}

/// How seconds read as counts and bars.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
#[serde(rename_all = "camelCase")]
pub struct Tempo {
    /// Counts a minute.
    pub beats_per_minute: f64,
    /// Counts a bar.
    pub beats_per_bar: u32,
    /// The time of the first count, seconds.
    pub start: f64,
}

/// One member of the group.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
#[serde(rename_all = "camelCase")]
pub struct Agent {
    /// At most 64 characters; empty: shown by number.
    pub name: String,
    /// `#rrggbb`, or empty for its group's color.
    pub color: String,
    /// Body radius, meters.
    pub radius: f64,
    /// The fastest it moves in a crowd, meters a second; none: no limit.
    pub max_speed: Option<f64>,
}

/// A named subset; its set is its members and its children's sets.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
#[serde(rename_all = "camelCase")]
pub struct Group {
    /// At most 64 characters.
    pub name: String,
    /// `#rrggbb`, or empty for the next of the palette.
    pub color: String,
    /// Agents of its own, beside its children's.
    pub members: Vec<u32>,
    /// Factor of the ties among its set; none: no ties of its own.
    pub tie_weight: Option<f64>,
    /// Groups within.
    pub children: Vec<Group>,
}

/// A formation that the motion passes, and when.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
#[serde(rename_all = "camelCase")]
pub struct Keyframe {
    /// At most 64 characters; empty: shown by number.
    pub name: String,
    /// Seconds.
    pub time: f64,
    /// How long the agents stand from `time` on, seconds.
    pub hold: f64,
    /// Stop here although segments join smoothly.
    pub corner: bool,
    /// How deep it lies in a transition, which it bends instead of ending it; 0 where it ends one: see [`Track::depths`].
    pub between: u32,
    /// `positions[i]` is always agent i.
    #[cfg_attr(feature = "types", ts(type = "Formation"))]
    #[serde(serialize_with = "document::flat")]
    pub positions: Arc<Formation>,
    /// Who is not there while the others stand here, ascending: their positions are where they leave to and come from.
    pub absent: Vec<u32>,
    /// Replaces the scene's adjacency here.
    #[cfg_attr(feature = "types", ts(as = "Option<AdjacencySpec>"))]
    pub adjacency: Option<Arc<AdjacencySpec>>,
}

/// What happens between two keyframes. Transitions are the first kind.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
#[serde(tag = "kind", rename_all = "lowercase")]
pub enum Segment {
    /// From one formation to the next.
    Transition(TransitionSpec),
}

/// How one formation becomes the next.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
#[serde(rename_all = "camelCase")]
pub struct TransitionSpec {
    /// The method asked for.
    pub method: MethodName,
    /// What `auto` took when the person saved or shared; when present nothing is chosen again.
    pub chosen: Option<Choice>,
    /// How modes are paired (spectral).
    pub order: Order,
    /// Which turn is taken out before the modes interpolate (spectral, shared, polar).
    pub alignment: Alignment,
    /// Sharing ρ, 0–1: how much the two bases meet halfway (spectral).
    pub sharing: f64,
    /// Scale the mode coefficients so that the formation keeps its size (spectral, shared).
    pub keep_size: bool,
    /// How the parameter runs with time.
    pub timing: Timing,
    /// Keep the minimum distance on the way.
    pub avoidance: bool,
    /// Let the groups move as wholes.
    pub hierarchy: bool,
    /// Groups that move by a method of their own, each once.
    pub nodes: Vec<NodeSpec>,
    /// What the formation travels along, turning with it.
    #[cfg_attr(feature = "types", ts(type = "Array<[number, number] | [number, number, number]> | null"))]
    pub path: Option<PathSpec>,
    /// What the forces are told (crowd).
    pub crowd: CrowdSpec,
    /// How it was found who goes where; the positions have it already.
    pub assignment: Option<AssignmentSpec>,
}

/// How one group moves within a hierarchy.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
#[serde(rename_all = "camelCase")]
pub struct NodeSpec {
    /// The group, as child indices from the root; empty: the root.
    pub group: Vec<u32>,
    /// Never `auto`.
    pub method: MethodName,
    /// A second method beside it.
    pub blend: Option<Blend>,
}

/// Something on the stage that agents go around.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
#[serde(rename_all = "camelCase")]
pub struct Obstacle {
    /// At most 64 characters.
    pub name: String,
    /// Its outline.
    pub shape: ObstacleShape,
}

impl Default for TransitionSpec {
    fn default() -> Self {
        Self {
            method: MethodName::default(),
            chosen: None,
            order: Order::default(),
            alignment: Alignment::default(),
            sharing: DEFAULT_SHARING,
            keep_size: false,
            timing: Timing::default(),
            avoidance: false,
            hierarchy: false,
            nodes: Vec::new(),
            path: None,
            crowd: CrowdSpec::default(),
            assignment: None,
        }
    }
}

/// What a person typed, fit for one line of a message: at most 40 characters, no line ends.
pub(crate) fn shown(text: &str) -> String {
    const LONGEST: usize = 40;
    let mut shown: String = text.chars().take(LONGEST).map(|c| if c.is_control() { ' ' } else { c }).collect();
    if text.chars().nth(LONGEST).is_some() {
        shown.push('…');
    }
    shown
}
