//! How a segment's crowd moves: the guide it follows and the table of its forces.

use eigenform_force::Constants;
use serde::ser::{Serialize, SerializeMap, Serializer};

use crate::choice::MethodName;

/// What method `crowd` is told. Lengths are in median spacings of the formations; every scalar is its default where it is absent.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "types", derive(ts_rs::TS), ts(rename_all = "camelCase"))]
pub struct CrowdSpec {
    /// The interpolation that agents follow, with the segment's own options: never `auto` nor `crowd`.
    pub guide: MethodName,
    /// Feedback of direction, by `I_d`.
    pub direction_feedback: bool,
    /// Feedback of speed, by `I_v`.
    pub speed_feedback: bool,
    /// The table; in a file its numbers stand beside the others.
    #[cfg_attr(feature = "types", ts(flatten))]
    pub constants: Constants,
}

impl Default for CrowdSpec {
    fn default() -> Self {
        Self { guide: MethodName::Linear, direction_feedback: true, speed_feedback: true, constants: Constants::default() }
    }
}

impl CrowdSpec {
    /// Its real numbers by their names in the scene file. Links keep this order for ever: append only.
    pub(super) fn numbers_mut(&mut self) -> [(&'static str, &mut f64); 8] {
        let Constants { reaction_time, look_ahead, strength, reach, group_strength, group_reach, fluctuation, bin_size, .. } =
            &mut self.constants;
        [
            ("reactionTime", reaction_time),
            ("lookAhead", look_ahead),
            ("strength", strength),
            ("reach", reach),
            ("groupStrength", group_strength),
            ("groupReach", group_reach),
            ("fluctuation", fluctuation),
            ("binSize", bin_size),
        ]
    }
}

impl Serialize for CrowdSpec {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut spec = *self;
        let numbers = spec.numbers_mut();
        let mut map = serializer.serialize_map(Some(numbers.len() + 4))?;
        map.serialize_entry("guide", &self.guide)?;
        map.serialize_entry("directionFeedback", &self.direction_feedback)?;
        map.serialize_entry("speedFeedback", &self.speed_feedback)?;
        for (name, number) in numbers {
            map.serialize_entry(name, number)?;
        }
        map.serialize_entry("sectors", &self.constants.sectors)?;
        map.end()
    }
}
