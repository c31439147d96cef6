//! What came to links with crowds: top speeds, and what a segment's forces are told.
//!
//! It stands behind the closing flag of `additions` and ends with a flag of its own. Here, too, the order is the format.

use std::sync::Arc;

use super::fields::{Fields, METHODS, as_integer};
use super::models::Number;
use super::range::Bit;
use super::recipes::has_recipes;
use crate::error::Error;
use crate::scene::{Agent, CrowdSpec, Segment, Track};

/// Whether a track says any of it.
pub fn has_crowds(track: &Track) -> bool {
    let tells = |Segment::Transition(transition): &Segment| transition.crowd != CrowdSpec::default();
    track.agents.iter().any(|agent| agent.max_speed.is_some()) || track.segments.iter().any(tells)
}

impl Fields<'_> {
    pub(super) fn code_crowds(&mut self, track: &mut Track) -> Result<(), Error> {
        self.code_top_speeds(Arc::make_mut(&mut track.agents));
        let mut alike = Bit::likely(true);
        let mut last = CrowdSpec::default();
        for Segment::Transition(transition) in &mut track.segments {
            let mut is_alike = transition.crowd == last;
            self.coder.bit(&mut alike, &mut is_alike);
            if is_alike {
                transition.crowd = last;
            } else {
                self.code_crowd(&mut transition.crowd)?;
                last = transition.crowd;
            }
        }
        let mut has_more = has_recipes(track);
        self.coder.bit(&mut Bit::likely(false), &mut has_more);
        if has_more { self.code_recipes(track) } else { Ok(()) }
    }

    /// Agents are mostly alike: each says whether it is as fast as the one before.
    fn code_top_speeds(&mut self, agents: &mut Vec<Agent>) {
        let (mut alike, mut limited, mut speeds) = (Bit::likely(true), Bit::default(), Number::default());
        let mut last = None;
        for Agent { max_speed, .. } in agents {
            let mut is_alike = *max_speed == last;
            self.coder.bit(&mut alike, &mut is_alike);
            if is_alike {
                *max_speed = last;
            } else {
                let mut is_limited = max_speed.is_some();
                self.coder.bit(&mut limited, &mut is_limited);
                if is_limited {
                    speeds.code(self.coder, max_speed.get_or_insert_default());
                } else {
                    *max_speed = None;
                }
                last = *max_speed;
            }
        }
    }

    fn code_crowd(&mut self, crowd: &mut CrowdSpec) -> Result<(), Error> {
        let mut usual = CrowdSpec::default();
        self.code_word(&METHODS, &mut crowd.guide)?;
        self.coder.bit(&mut Bit::likely(true), &mut crowd.direction_feedback);
        self.coder.bit(&mut Bit::likely(true), &mut crowd.speed_feedback);
        for ((_, value), (_, usual)) in crowd.numbers_mut().into_iter().zip(usual.numbers_mut()) {
            self.code_usual(*usual, value);
        }
        let mut sectors = f64::from(crowd.constants.sectors);
        self.code_usual(f64::from(usual.constants.sectors), &mut sectors);
        crowd.constants.sectors = as_integer(sectors)?;
        Ok(())
    }
}
