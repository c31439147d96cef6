//! What a crowd is told, as an object of a segment.

use super::layout::Layout;
use super::value::Value;
use super::written::{number, required_word};
use crate::error::Error;
use crate::scene::CrowdSpec;

const CROWD: &[&str] = &[
    "guide",
    "directionFeedback",
    "speedFeedback",
    "reactionTime",
    "lookAhead",
    "strength",
    "reach",
    "groupStrength",
    "groupReach",
    "fluctuation",
    "binSize",
    "sectors",
];

pub(super) fn crowd(value: Value) -> Result<CrowdSpec, Error> {
    let fields = value.object(CROWD)?;
    let mut crowd = CrowdSpec::default();
    if let Some(guide) = fields.get("guide") {
        crowd.guide = guide.word(&[])?;
    }
    crowd.direction_feedback = fields.set_flag("directionFeedback")?;
    crowd.speed_feedback = fields.set_flag("speedFeedback")?;
    for (name, number) in crowd.numbers_mut() {
        *number = fields.number(name, *number)?;
    }
    crowd.constants.sectors = fields.whole("sectors", crowd.constants.sectors)?;
    Ok(crowd)
}

/// What differs from the defaults.
pub(super) fn write_crowd(out: &mut Layout, crowd: &CrowdSpec) {
    let (mut crowd, mut default) = (*crowd, CrowdSpec::default());
    out.object_line(|out| {
        if crowd.guide != default.guide {
            required_word(out, "guide", &crowd.guide);
        }
        for (name, is_set) in [("directionFeedback", crowd.direction_feedback), ("speedFeedback", crowd.speed_feedback)] {
            if !is_set {
                out.key(name).raw("false");
            }
        }
        for ((name, value), (_, usual)) in crowd.numbers_mut().into_iter().zip(default.numbers_mut()) {
            number(out, name, *value, *usual);
        }
        number(out, "sectors", f64::from(crowd.constants.sectors), f64::from(default.constants.sectors));
    });
}
