//! The stable names of refusals, and where each points.

use super::{Counted, Error};

impl Error {
    /// Stable, kebab-case.
    pub fn code(&self) -> &'static str {
        match self {
            Self::Empty => "empty",
            Self::NotText { .. } => "not-text",
            Self::FileTooLarge { .. } => "file-too-large",
            Self::NotALink => "not-a-link",
            Self::LinkCut => "link-cut",
            Self::LinkDamaged => "link-damaged",
            Self::LinkTooLarge => "link-too-large",
            Self::Unrecognized | Self::NotAScene { .. } => "not-a-scene",
            Self::NewerVersion { .. } => "newer-version",
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
            Self::OneKeyframe => "one-keyframe",
            Self::TimesDoNotRise { .. } => "times-do-not-rise",
            Self::UnknownAgent { .. } => "unknown-agent",
            Self::UnknownSlot { .. } => "unknown-slot",
            Self::SelfTie { .. } => "self-tie",
            Self::RepeatedPair { .. } | Self::RepeatedObstacleTie { .. } => "repeated-pair",
            Self::RepeatedMember { .. } => "repeated-member",
            Self::SharedMember { .. } => "shared-member",
            Self::GroupsTooDeep { .. } => "groups-too-deep",
            Self::MixedDimensions { .. } => "mixed-dimensions",
            Self::UnknownObstacle { .. } => "unknown-obstacle",
            Self::UnknownGroup { .. } => "unknown-group",
            Self::RepeatedNode { .. } => "repeated-node",
            Self::TwoSlots { .. } | Self::SlotTaken { .. } => "contradictory-locks",
            Self::NothingToPredictFrom => "nothing-to-predict-from",
            Self::NoWay { .. } => "no-way",
            Self::TooManyBends { .. } => "too-many-corners",
            Self::NoArea { .. } => "no-area",
            Self::NoLength { .. } => "no-length",
            Self::SelfCrossing { .. } => "self-crossing",
            Self::TooManyTies { .. } => "too-many-ties",
            Self::IsRecording => "recording",
            Self::PictureSize { .. } => "picture-size",
            Self::BlankPicture { .. } => "blank-picture",
            Self::TooCrowded { .. } => "too-crowded",
            Self::Json(error) => error.code(),
            Self::Table(error) => error.code(),
            Self::Recording(error) => error.code(),
        }
    }

    /// Where in the input, in words; empty when it is the whole.
    pub fn place(&self) -> String {
        match self {
            Self::Empty
            | Self::Unrecognized
            | Self::NotALink
            | Self::LinkCut
            | Self::LinkDamaged
            | Self::LinkTooLarge
            | Self::FileTooLarge { .. }
            | Self::IsRecording
            | Self::PictureSize { .. }
            | Self::BlankPicture { .. }
            | Self::TooCrowded { .. }
            | Self::TooManyFrames { .. } => String::new(),
            Self::NotText { byte } => format!("byte {byte}"),
            Self::NotAScene { .. } => "format".to_owned(),
            Self::NewerVersion { .. } => "version".to_owned(),
            Self::NoKeyframes | Self::OneKeyframe => "keyframes".to_owned(),
            Self::NothingToPredictFrom => "locks".to_owned(),
            Self::NoWay { obstacle, .. } => format!("obstacles[{obstacle}]"),
            Self::TooManyBends { .. } => "obstacles".to_owned(),
            Self::TooManyTies { keyframe, .. } => format!("keyframes[{keyframe}]"),
            Self::Json(error) => error.place(),
            Self::Table(error) => error.place(),
            Self::Recording(error) => error.place(),
            Self::UnknownValue { place, .. }
            | Self::Unsupported { place, .. }
            | Self::NotFinite { place }
            | Self::OutOfRange { place, .. }
            | Self::TooLong { place, .. }
            | Self::InvalidColor { place, .. }
            | Self::TooMany { place, .. }
            | Self::WrongCount { place, .. }
            | Self::TimesDoNotRise { place, .. }
            | Self::UnknownAgent { place, .. }
            | Self::UnknownSlot { place, .. }
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
            | Self::SelfCrossing { place, .. }
            | Self::TwoSlots { place, .. }
            | Self::SlotTaken { place, .. }
            | Self::NoLength { place }
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
        Counted::Locks => "too-many-locks",
        Counted::Obstacles => "too-many-obstacles",
        Counted::Corners => "too-many-corners",
        Counted::PathPoints => "too-many-points",
        Counted::Rows => "too-many-rows",
    }
}
