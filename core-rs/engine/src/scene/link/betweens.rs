//! What a scene says beyond absences: how deep keyframes lie in a transition instead of ending it.
//!
//! It stands behind the closing flag of `absences` and ends with a flag of its own. Here, too, the order is the format.

use super::fields::{Fields, newer};
use super::graph::code_count;
use super::models::Integer;
use super::range::Bit;
use crate::error::Error;
use crate::scene::{Track, limits};

/// Whether a track says any of it.
pub fn has_betweens(track: &Track) -> bool {
    track.keyframes.iter().any(|keyframe| keyframe.between > 0)
}

impl Fields<'_> {
    pub(super) fn code_betweens(&mut self, track: &mut Track) -> Result<(), Error> {
        let mut depths = Integer::default();
        for keyframe in &mut track.keyframes {
            keyframe.between = code_count(&mut depths, self.coder, keyframe.between as usize, limits::KEYFRAMES)? as u32;
        }
        // Set by a later version that has more to say.
        let mut has_more = false;
        self.coder.bit(&mut Bit::likely(false), &mut has_more);
        if has_more { Err(newer()) } else { Ok(()) }
    }
}
