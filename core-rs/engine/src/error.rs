//! Everything a person can get wrong, in one closed list.
//!
//! Each variant says what is admissible; its code is stable. Bugs are assertions, never errors.
//! `place` is where in the input: a field as `keyframes[2].positions[14]`, a line and column, a row; empty when it is the whole.

mod code;
mod json;
mod recording;
mod table;
mod words;

pub use json::JsonError;
pub use recording::RecordingError;
pub use table::TableError;
pub use words::{Blank, Counted};
use words::{Brief, Listed, there_are, two_slots};

use crate::scene::limits;

/// A refusal of input: what, where, and a stable code.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum Error {
    /// Nothing but white space.
    #[error("there is nothing to read; give a scene file, a keyframe CSV, a recording or a link")]
    Empty,
    /// Bytes that are no UTF-8 text.
    #[error("this is not text, so it is no scene; a scene file, a keyframe CSV, a recording and a link are UTF-8 text")]
    NotText {
        /// The first byte that does not fit.
        byte: usize,
    },
    /// More bytes than any valid scene needs.
    #[error("{bytes} bytes; a file has at most {limit}")]
    FileTooLarge {
        /// How many there are.
        bytes: usize,
        /// How many are allowed.
        limit: usize,
    },

    /// Text of something else.
    #[error(
        "this is no scene; what opens is a scene file (JSON), a keyframe CSV (its first row is keyframe,time,agent,group,x,y), \
         a recording of motion or a link"
    )]
    Unrecognized,

    /// What is wrong in the text of a scene file.
    #[error(transparent)]
    Json(#[from] JsonError),
    /// A recording where a scene is wanted.
    #[error("this is a recording of motion, not a scene; some of its frames can become the keyframes of one")]
    IsRecording,
    /// Text without a link in it.
    #[error("there is no scene in this address; a link to a scene has #s=1. and many letters behind it")]
    NotALink,
    /// The end of the link is missing.
    #[error("the end of the link is missing; copy the whole link again")]
    LinkCut,
    /// Something in the link was changed.
    #[error("the link was changed on its way and its checksum does not fit; copy the whole link again")]
    LinkDamaged,
    /// A link that asks for more than the limits.
    #[error("the link holds more than a scene may, as {} agents and {} keyframes", limits::AGENTS, limits::KEYFRAMES)]
    LinkTooLarge,
    /// JSON of something else.
    #[error("this is not a scene: its format is {found}, not \"eigenform\"")]
    NotAScene {
        /// What `format` says.
        found: String,
    },
    /// A later version of the format.
    #[error("this was made by a newer version of Eigenform (format version {version}); this one reads version 1")]
    NewerVersion {
        /// What `version` says.
        version: String,
    },
    /// A word that is not one of the admissible ones.
    #[error("{value} is not known here; it must be one of {}", Listed(admissible))]
    UnknownValue {
        /// The word, shortened.
        value: String,
        /// The words there are.
        admissible: &'static [&'static str],
        /// The value.
        place: String,
    },
    /// Version 1 names it, this program does not do it.
    #[error("{value} is not supported yet; give {supported} or leave the field out")]
    Unsupported {
        /// What was given, shortened.
        value: String,
        /// What is supported in its place.
        supported: String,
        /// The field.
        place: String,
    },

    /// Infinite, not a number, or too large for a double.
    #[error("this is not a finite number")]
    NotFinite {
        /// The number.
        place: String,
    },
    /// A number outside its limits.
    #[error("{} is out of range; it must be from {low} to {high}", Brief(*value))]
    OutOfRange {
        /// The number.
        value: f64,
        /// The least admissible.
        low: f64,
        /// The greatest admissible.
        high: f64,
        /// The number's place.
        place: String,
    },
    /// More characters than a name or title has.
    #[error("{length} characters; at most {limit}")]
    TooLong {
        /// How many there are.
        length: usize,
        /// How many are allowed.
        limit: usize,
        /// The text.
        place: String,
    },
    /// A color in another notation.
    #[error("{value} is no color; it must be #rrggbb or empty")]
    InvalidColor {
        /// What was given, shortened.
        value: String,
        /// The color.
        place: String,
    },
    /// More of something than its limit.
    #[error("{count} {what}; at most {limit}")]
    TooMany {
        /// Of what.
        what: Counted,
        /// How many there are, at least.
        count: usize,
        /// How many are allowed.
        limit: usize,
        /// Where they are.
        place: String,
    },
    /// A list that must match another.
    #[error("{found} {what}; there must be {expected}")]
    WrongCount {
        /// Of what.
        what: &'static str,
        /// How many there are.
        found: usize,
        /// How many there must be.
        expected: usize,
        /// The list.
        place: String,
    },
    /// A motion of more agents × frames than fits.
    #[error("{agent_count} agents × {frames} frames; at most {limit} in all, which fits at {fitting_rate} frames per second")]
    TooManyFrames {
        /// How many agents.
        agent_count: usize,
        /// How many frames.
        frames: usize,
        /// Agents × frames allowed.
        limit: usize,
        /// The highest whole frame rate that fits.
        fitting_rate: u32,
    },

    /// A scene without any formation.
    #[error("there is no keyframe; a scene has at least one")]
    NoKeyframes,
    /// A question about a way, and no way.
    #[error("there is one keyframe; who keeps together on the way to another shows when there are two")]
    OneKeyframe,
    /// Keyframes that do not follow one another.
    #[error("{time} s is not after {end} s, when the keyframe before ends (its time and hold); times must rise")]
    TimesDoNotRise {
        /// The keyframe's time.
        time: f64,
        /// Time and hold of the one before.
        end: f64,
        /// The keyframe's time.
        place: String,
    },
    /// An index that no place of the target has.
    #[error("there is no slot {slot}; {}", there_are("slots", *agent_count))]
    UnknownSlot {
        /// The index.
        slot: u32,
        /// How many agents there are, and places.
        agent_count: usize,
        /// The index's place.
        place: String,
    },
    /// An index that no agent has.
    #[error("there is no agent {agent}; {}", there_are("agents", *agent_count))]
    UnknownAgent {
        /// The index.
        agent: u32,
        /// How many agents there are.
        agent_count: usize,
        /// The index's place.
        place: String,
    },
    /// A pair of one agent.
    #[error("agent {agent} is paired with itself; a pair has two agents")]
    SelfTie {
        /// The agent.
        agent: u32,
        /// The pair.
        place: String,
    },
    /// A pair twice in one list, in either order.
    #[error("agents {a} and {b} are listed twice; a pair occurs once in a list")]
    RepeatedPair {
        /// The lower agent.
        a: u32,
        /// The higher agent.
        b: u32,
        /// The later of the two.
        place: String,
    },
    /// An agent twice in one group, or twice absent.
    #[error("agent {agent} is listed twice here; once is enough")]
    RepeatedMember {
        /// The agent.
        agent: u32,
        /// Its list.
        place: String,
    },
    /// An agent in two groups, neither within the other.
    #[error("agent {agent} is in {other} already; groups beside each other share no agent")]
    SharedMember {
        /// The agent.
        agent: u32,
        /// The group that has it.
        other: String,
        /// The group that lists it again.
        place: String,
    },
    /// Groups within groups beyond the limit.
    #[error("groups are nested more than {limit} deep")]
    GroupsTooDeep {
        /// How many levels are allowed.
        limit: usize,
        /// The group that is too deep.
        place: String,
    },
    /// Positions on the plane and in space in one scene.
    #[error("this position has {found} numbers where others have {expected}; all positions of a scene have two, or all have three")]
    MixedDimensions {
        /// How many numbers it has.
        found: usize,
        /// How many others have.
        expected: usize,
        /// The position, or the positions of its keyframe.
        place: String,
    },
    /// An index that no obstacle has.
    #[error("there is no obstacle {obstacle}; {}", there_are("obstacles", *obstacle_count))]
    UnknownObstacle {
        /// The index.
        obstacle: u32,
        /// How many obstacles there are.
        obstacle_count: usize,
        /// The index's place.
        place: String,
    },
    /// An agent and an obstacle twice in one list.
    #[error("agent {agent} and obstacle {obstacle} are listed twice; a pair occurs once in a list")]
    RepeatedObstacleTie {
        /// The agent.
        agent: u32,
        /// The obstacle.
        obstacle: u32,
        /// The later of the two.
        place: String,
    },
    /// Child indices that lead to no group.
    #[error("there is no such group; the indices go from the outermost group to its children, from 0, and [] is all groups")]
    UnknownGroup {
        /// The indices.
        place: String,
    },
    /// A group with two methods in one segment.
    #[error("this group has a method in {other} already; each group has one, and a blend for a second")]
    RepeatedNode {
        /// Where it has one.
        other: String,
        /// Where it has the other.
        place: String,
    },
    /// An agent locked to two slots.
    #[error("{}", two_slots(*agent, *slots))]
    TwoSlots {
        /// The agent.
        agent: u32,
        /// In the order given.
        slots: [u32; 2],
        /// The later lock.
        place: String,
    },
    /// A slot locked for two agents.
    #[error("slot {slot} is locked for agents {} and {}; a slot has one", agents[0], agents[1])]
    SlotTaken {
        /// The slot.
        slot: u32,
        /// In the order given.
        agents: [u32; 2],
        /// The later lock.
        place: String,
    },
    /// Obstacles that leave an agent no way to a slot.
    #[error(
        "no way leads agent {agent} to a place that is left for it: obstacle {obstacle} shuts it off; move the obstacle, \
         leave a gap of {} m, or lock the agent to a place beyond",
        2.0 * distance
    )]
    NoWay {
        /// One who is left over where it stands.
        agent: u32,
        /// What is between it and a slot that is left over.
        obstacle: u32,
        /// What ways keep from obstacles, meters.
        distance: f64,
    },
    /// More places beside obstacles than ways can be looked for between.
    #[error("ways around these obstacles may bend at {count} places; at most {limit} for so many agents; draw fewer or simpler obstacles")]
    TooManyBends {
        /// How many there are.
        count: usize,
        /// How many are allowed.
        limit: usize,
    },
    /// A prediction from no pair.
    #[error("there is no pair to predict the others from; lock one agent to its slot, better two or three")]
    NothingToPredictFrom,
    /// A polygon that is a line or a point.
    #[error("the corners lie on a line or cross it to no area; a polygon has at least three that do not")]
    NoArea {
        /// Its corners.
        place: String,
    },

    /// A path that leads nowhere.
    #[error("this path has no length; give it two points apart or more, or null for the straight way")]
    NoLength {
        /// The path.
        place: String,
    },
    /// A polygon whose sides cross one another.
    #[error("the sides after corners {first} and {second} cross; give the corners in the order in which they lie around the obstacle")]
    SelfCrossing {
        /// The corner that the first of them starts from.
        first: usize,
        /// The corner that the other starts from.
        second: usize,
        /// Its corners.
        place: String,
    },

    /// What is wrong in a table.
    #[error(transparent)]
    Table(#[from] TableError),
    /// What is wrong in a recording of motion.
    #[error(transparent)]
    Recording(#[from] RecordingError),

    /// More ties at one keyframe than the limit, groups expanded.
    #[error("{count} ties at one keyframe, those of groups included; at most {limit}")]
    TooManyTies {
        /// Which keyframe.
        keyframe: usize,
        /// How many there would be, at least.
        count: usize,
        /// How many are allowed.
        limit: usize,
    },

    /// A picture of too few pixels to hold a shape, or of more than a camera's.
    #[error("{width} × {height} pixels; a picture has {low} to {high} a side")]
    PictureSize {
        /// Pixels in a row.
        width: usize,
        /// Rows.
        height: usize,
        /// The fewest a side.
        low: usize,
        /// The most a side.
        high: usize,
    },
    /// A picture without a shape in it.
    #[error("there is no shape in this picture: {why}")]
    BlankPicture {
        /// What it is instead, and what to do.
        why: Blank,
    },
    /// More agents than stand in a shape without being too near.
    #[error("{count} agents do not fit {distance} m apart, {largest} do; ask for fewer, a larger shape or a smaller minimum distance")]
    TooCrowded {
        /// How many were asked for.
        count: usize,
        /// The least distance, meters.
        distance: f64,
        /// The largest number that fits.
        largest: usize,
    },
}
