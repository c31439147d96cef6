//! How a refusal lists words and counts things.

use std::fmt::{self, Display, Formatter};

/// What a limit counts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Counted {
    /// Agents of the scene.
    Agents,
    /// Keyframes of the scene.
    Keyframes,
    /// Agents × keyframes.
    Positions,
    /// Groups of the whole tree.
    Groups,
    /// Members of one group.
    Members,
    /// Ties of one list.
    Ties,
    /// Ties of all keyframes, groups expanded.
    TiesInAll,
    /// Cuts of one list.
    Cuts,
    /// Segments of the scene.
    Segments,
    /// Groups with a method of their own in one segment.
    Nodes,
    /// Levels of the way to a group.
    Levels,
    /// Locks of one assignment.
    Locks,
    /// Obstacles of the scene.
    Obstacles,
    /// Corners of one polygon.
    Corners,
    /// Points of one path.
    PathPoints,
    /// Rows of a recording.
    Rows,
}

impl Display for Counted {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Agents => "agents",
            Self::Keyframes => "keyframes",
            Self::Positions => "positions (agents × keyframes)",
            Self::Groups => "groups",
            Self::Members => "members of one group",
            Self::Ties => "ties in one list",
            Self::TiesInAll => "ties at all keyframes together, those of groups included",
            Self::Cuts => "cuts in one list",
            Self::Segments => "segments",
            Self::Nodes => "groups with a method of their own",
            Self::Levels => "levels of groups",
            Self::Locks => "locks",
            Self::Obstacles => "obstacles",
            Self::Corners => "corners of a polygon",
            Self::PathPoints => "points of a path",
            Self::Rows => "rows",
        })
    }
}

/// Why there is no shape in a picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Blank {
    /// Every pixel is transparent.
    Transparent,
    /// No threshold parts any pixel from the others.
    Alike,
    /// No pixel is taken for the shape, or every pixel is. Inverting makes the one of the other: another threshold is what helps.
    Undivided {
        /// Whether every pixel is taken.
        is_everything: bool,
        /// The threshold that was asked for.
        threshold: f64,
        /// One that parts them.
        better: f64,
    },
}

impl Display for Blank {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match self {
            Self::Transparent => f.write_str("all of it is transparent; take one in which something can be seen"),
            Self::Alike => f.write_str("all of it is alike, or nearly so; take one in which a shape stands out"),
            Self::Undivided { is_everything, threshold, better } => {
                let taken = if *is_everything { "all" } else { "nothing" };
                let way = if better > threshold { "raise" } else { "lower" };
                write!(f, "{taken} of it is taken for the shape; {way} the threshold, to {better} perhaps")
            }
        }
    }
}

/// Words as a sentence lists them.
pub(super) struct Listed<'a>(pub(super) &'a [&'static str]);

impl Display for Listed<'_> {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        self.0.iter().enumerate().try_for_each(|(index, word)| write!(f, "{}\"{word}\"", if index == 0 { "" } else { ", " }))
    }
}

/// A number in no more digits than a double has: beyond, the rest of them would be zeros.
pub(super) struct Brief(pub(super) f64);

impl Display for Brief {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let size = self.0.abs();
        if size == 0.0 || (1e-15..1e15).contains(&size) { write!(f, "{}", self.0) } else { write!(f, "{:e}", self.0) }
    }
}

pub(super) fn there_are(what: &str, count: usize) -> String {
    match count {
        0 => "the scene has none".to_owned(),
        count => format!("{what} are 0 to {}", count - 1),
    }
}

pub(super) fn two_slots(agent: u32, [first, second]: [u32; 2]) -> String {
    if first == second {
        return format!("agent {agent} is locked to slot {first} twice; once is enough");
    }
    format!("agent {agent} is locked to slots {first} and {second}; an agent has one")
}

#[cfg(test)]
mod tests {
    use super::Brief;

    #[test]
    fn numbers_are_as_long_as_their_digits() {
        let said = [0.0, -0.5, 1e5, 123_456.75, 1e300, -1e-200].map(|value| Brief(value).to_string());
        assert_eq!(said, ["0", "-0.5", "100000", "123456.75", "1e300", "-1e-200"]);
    }
}
