//! What is wrong in a recording of motion.

/// A refusal of a recording, or of the frames that are to become keyframes.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum RecordingError {
    /// Text of something else.
    #[error(
        "this is no recording of motion; one has the columns frame,time,agent,x,y,z, or rows of id frame x y \
         and a line such as \"# framerate: 25.00 fps\" before them"
    )]
    Unrecognized,
    /// A recording that does not say how fast it is.
    #[error("there is no frame rate; give it in a line such as \"# framerate: 25.00 fps\" before the rows")]
    NoFrameRate,
    /// A recording without any time in it.
    #[error("the recording has one frame at the most; a motion has two or more")]
    OneFrame,
    /// A frame whose time is not where its number says.
    #[error("frame {frame} is at {time} s, where the other frames would have it at {expected} s; frames are evenly apart")]
    UnevenFrames {
        /// Its number.
        frame: i64,
        /// What the row says, seconds.
        time: f64,
        /// What the first and last frame make of it, seconds.
        expected: f64,
        /// The row.
        row: u64,
    },
    /// An agent twice at one frame.
    #[error("row {row} gives agent {agent} twice at frame {frame}; each agent has one row a frame")]
    RepeatedSample {
        /// The later row.
        row: u64,
        /// The agent's id.
        agent: String,
        /// The frame's number.
        frame: i64,
    },
    /// An agent that is away and comes back.
    #[error("agent {agent} is there until frame {frame} and again from frame {back}; an agent enters once and leaves once")]
    Gap {
        /// The agent's id.
        agent: String,
        /// The last frame before the gap.
        frame: i64,
        /// The first frame after it.
        back: i64,
        /// The row of that.
        row: u64,
    },
    /// A recording of more agents × frames than fits.
    #[error("{agent_count} agents × {frames} frames; at most {limit} in all: record fewer frames a second, or cut it in parts")]
    TooManySamples {
        /// How many agents.
        agent_count: usize,
        /// How many frames.
        frames: usize,
        /// Agents × frames allowed.
        limit: usize,
    },
    /// Frames that no agent is in all of.
    #[error("no agent is there at all of these frames; choose frames nearer to one another")]
    NobodyThere,
}

impl RecordingError {
    /// Stable, kebab-case.
    pub(super) fn code(&self) -> &'static str {
        match self {
            Self::Unrecognized => "not-a-recording",
            Self::NoFrameRate => "no-frame-rate",
            Self::OneFrame => "one-frame",
            Self::UnevenFrames { .. } => "uneven-frames",
            Self::RepeatedSample { .. } => "repeated-sample",
            Self::Gap { .. } => "gap",
            Self::TooManySamples { .. } => "too-many-samples",
            Self::NobodyThere => "nobody-there",
        }
    }

    /// Where in the recording, in words; empty when it is the whole.
    pub(super) fn place(&self) -> String {
        match self {
            Self::UnevenFrames { row, .. } | Self::RepeatedSample { row, .. } | Self::Gap { row, .. } => format!("row {row}"),
            Self::Unrecognized | Self::NoFrameRate | Self::OneFrame | Self::TooManySamples { .. } | Self::NobodyThere => String::new(),
        }
    }
}
