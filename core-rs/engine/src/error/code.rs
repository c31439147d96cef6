//! The stable names of refusals, and where each points.

use super::{Counted, Error};

impl Error {
    /// Stable, kebab-case.
    pub fn code(&self) -> &'static str {
        match self {
            Self::Empty => "empty",
            Self::NotText { .. } => "not-text",
            Self::FileTooLarge { .. } => "file-too-large",
            Self::InvalidJson { .. } => "invalid-json",
            Self::NotALink => "not-a-link",
            Self::LinkCut => "link-cut",
            Self::LinkDamaged => "link-damaged",
            Self::LinkTooLarge => "link-too-large",
            Self::NotAScene { .. } => "not-a-scene",
            Self::NewerVersion { .. } => "newer-version",
            Self::MissingField { .. } => "missing-field",
            Self::UnknownField { .. } => "unknown-field",
            Self::RepeatedField { .. } => "repeated-field",
            Self::WrongType { .. } => "wrong-type",
            Self::UnknownValue { .. } => "unknown-value",
            Self::Unsupported { .. } => "unsupported",
            Self::NotFinite { .. } => "not-finite",
            Self::OutOfRange { .. } => "out-of-range",
            Self::TooLong { .. } => "too-long",
            Self::InvalidColor { .. } => "invalid-color",
            Self::TooMany { what, .. } => too_many(*what),
            Self::WrongCount { .. } => "wrong-count",
            Self::TooManyFrames { .. } => "too-many-frames",
            Self::NoKeyframes => "no-keyframes",
            Self::TimesDoNotRise { .. } => "times-do-not-rise",
            Self::UnknownAgent { .. } => "unknown-agent",
            Self::SelfTie { .. } => "self-tie",
            Self::RepeatedPair { .. } | Self::RepeatedObstacleTie { .. } => "repeated-pair",
            Self::RepeatedMember { .. } => "repeated-member",
            Self::SharedMember { .. } => "shared-member",
            Self::GroupsTooDeep { .. } => "groups-too-deep",
            Self::MixedDimensions { .. } => "mixed-dimensions",
            Self::UnknownObstacle { .. } => "unknown-obstacle",
            Self::UnknownGroup { .. } => "unknown-group",
            Self::RepeatedNode { .. } => "repeated-node",
            Self::NoArea { .. } => "no-area",
            Self::TooManyTies { .. } => "too-many-ties",
            Self::MissingColumn { .. } => "missing-column",
            Self::UnknownColumn { .. } => "unknown-column",
            Self::RepeatedColumn { .. } => "repeated-column",
            Self::CutRow { .. } => "cut-row",
            Self::NotANumber { .. } => "not-a-number",
            Self::RepeatedRow { .. } => "repeated-row",
            Self::MissingRow { .. } => "missing-row",
            Self::TimesDiffer { .. } => "times-differ",
            Self::IsRecording => "recording",
            Self::NoFrameRate => "no-frame-rate",
            Self::OneFrame => "one-frame",
            Self::UnevenFrames { .. } => "uneven-frames",
            Self::RepeatedSample { .. } => "repeated-sample",
            Self::Gap { .. } => "gap",
            Self::TooManySamples { .. } => "too-many-samples",
            Self::NobodyThere => "nobody-there",
            Self::PictureSize { .. } => "picture-size",
            Self::BlankPicture { .. } => "blank-picture",
            Self::TooCrowded { .. } => "too-crowded",
        }
    }

    /// Where in the input, in words; empty when it is the whole.
    pub fn place(&self) -> String {
        match self {
            Self::Empty
            | Self::NotALink
            | Self::LinkCut
            | Self::LinkDamaged
            | Self::LinkTooLarge
            | Self::FileTooLarge { .. }
            | Self::IsRecording
            | Self::NoFrameRate
            | Self::OneFrame
            | Self::TooManySamples { .. }
            | Self::NobodyThere
            | Self::PictureSize { .. }
            | Self::BlankPicture { .. }
            | Self::TooCrowded { .. }
            | Self::TooManyFrames { .. } => String::new(),
            Self::NotText { byte } => format!("byte {byte}"),
            Self::NotAScene { .. } => "format".to_owned(),
            Self::NewerVersion { .. } => "version".to_owned(),
            Self::NoKeyframes => "keyframes".to_owned(),
            Self::TooManyTies { keyframe, .. } => format!("keyframes[{keyframe}]"),
            Self::MissingColumn { .. } | Self::UnknownColumn { .. } | Self::RepeatedColumn { .. } => "row 1".to_owned(),
            Self::NotANumber { column, row, .. } => format!("row {row}, column {column}"),
            Self::CutRow { row, .. }
            | Self::RepeatedRow { row, .. }
            | Self::TimesDiffer { row, .. }
            | Self::UnevenFrames { row, .. }
            | Self::RepeatedSample { row, .. }
            | Self::Gap { row, .. } => format!("row {row}"),
            Self::MissingRow { keyframe, .. } => format!("keyframe {keyframe}"),
            Self::InvalidJson { place, .. }
            | Self::MissingField { place, .. }
            | Self::UnknownField { place, .. }
            | Self::RepeatedField { place, .. }
            | Self::WrongType { place, .. }
            | Self::UnknownValue { place, .. }
            | Self::Unsupported { place, .. }
            | Self::NotFinite { place }
            | Self::OutOfRange { place, .. }
            | Self::TooLong { place, .. }
            | Self::InvalidColor { place, .. }
            | Self::TooMany { place, .. }
            | Self::WrongCount { place, .. }
            | Self::TimesDoNotRise { place, .. }
            | Self::UnknownAgent { place, .. }
            | Self::SelfTie { place, .. }
            | Self::RepeatedPair { place, .. }
            | Self::RepeatedMember { place, .. }
            | Self::SharedMember { place, .. }
            | Self::GroupsTooDeep { place, .. }
            | Self::MixedDimensions { place, .. }
            | Self::UnknownObstacle { place, .. }
            | Self::RepeatedObstacleTie { place, .. }
            | Self::UnknownGroup { place }
            | Self::RepeatedNode { place, .. }
            | Self::NoArea { place } => place.clone(),
        }
    }
}

fn too_many(what: Counted) -> &'static str {
    match what {
        Counted::Agents => "too-many-agents",
        Counted::Keyframes => "too-many-keyframes",
        Counted::Positions => "too-many-positions",
        Counted::Groups => "too-many-groups",
        Counted::Members => "too-many-members",
        Counted::Ties | Counted::TiesInAll => "too-many-ties",
        Counted::Cuts => "too-many-cuts",
        Counted::Segments => "too-many-segments",
        Counted::Nodes => "too-many-nodes",
        Counted::Levels => "groups-too-deep",
        Counted::Obstacles => "too-many-obstacles",
        Counted::Corners => "too-many-corners",
        Counted::Rows => "too-many-rows",
    }
}
