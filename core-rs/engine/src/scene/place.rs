//! Where in a document a value stands.

use std::fmt::{self, Display, Formatter};

/// The way to a value, shown as `keyframes[2].positions[14]`; costs nothing until it is shown.
#[derive(Clone, Copy)]
pub(crate) enum Place<'a> {
    /// The document itself.
    Top,
    /// A field of an object.
    Field(&'a Place<'a>, &'a str),
    /// An entry of a list.
    Item(&'a Place<'a>, usize),
}

impl<'a> Place<'a> {
    pub(crate) fn field(&'a self, name: &'a str) -> Self {
        Self::Field(self, name)
    }

    pub(crate) fn item(&'a self, index: usize) -> Self {
        Self::Item(self, index)
    }
}

impl Display for Place<'_> {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match self {
            Self::Top => Ok(()),
            Self::Field(Self::Top, name) => f.write_str(name),
            Self::Field(parent, name) => write!(f, "{parent}.{name}"),
            Self::Item(parent, index) => write!(f, "{parent}[{index}]"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Place;

    #[test]
    fn a_place_reads_like_a_path() {
        let keyframes = Place::Top.field("keyframes");
        let keyframe = keyframes.item(2);
        let positions = keyframe.field("positions");
        assert_eq!(positions.item(14).to_string(), "keyframes[2].positions[14]");
        assert_eq!(Place::Top.to_string(), "");
    }
}
