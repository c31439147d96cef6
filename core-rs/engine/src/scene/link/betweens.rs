//! What a scene says beyond absences: which keyframes lie in a transition instead of ending it.
//!
//! It stands behind the closing flag of `absences` and ends with a flag of its own. Here, too, the order is the format.

use super::fields::{Fields, newer};
use super::range::Bit;
use crate::error::Error;
use crate::scene::Track;

/// Whether a track says any of it.
pub fn has_betweens(track: &Track) -> bool {
    track.keyframes.iter().any(|keyframe| keyframe.between)
}

impl Fields<'_> {
    pub(super) fn code_betweens(&mut self, track: &mut Track) -> Result<(), Error> {
        let mut is_between = Bit::default();
        for keyframe in &mut track.keyframes {
            self.coder.bit(&mut is_between, &mut keyframe.between);
        }
        // Set by a later version that has more to say.
        let mut has_more = false;
        self.coder.bit(&mut Bit::likely(false), &mut has_more);
        if has_more { Err(newer()) } else { Ok(()) }
    }
}
