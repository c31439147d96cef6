//! What a scene says beyond paths: who is absent at its keyframes.
//!
//! It stands behind the closing flag of `paths` and ends with a flag of its own. Here, too, the order is the format.

use super::betweens::has_betweens;
use super::fields::Fields;
use super::graph::code_count;
use super::models::Integer;
use super::range::Bit;
use crate::error::Error;
use crate::scene::{Track, limits};

/// Whether a track says any of it, or of what stands behind it.
pub fn has_absences(track: &Track) -> bool {
    track.keyframes.iter().any(|keyframe| !keyframe.absent.is_empty()) || has_betweens(track)
}

impl Fields<'_> {
    /// Mostly as at the keyframe before; else every absent agent by how many stand before it.
    pub(super) fn code_absences(&mut self, track: &mut Track) -> Result<(), Error> {
        let (mut alike, mut counts, mut gaps) = (Bit::default(), Integer::default(), Integer::default());
        let mut last = Vec::new();
        for keyframe in &mut track.keyframes {
            let mut is_alike = keyframe.absent == last;
            self.coder.bit(&mut alike, &mut is_alike);
            if is_alike {
                keyframe.absent.clone_from(&last);
                continue;
            }
            let count = code_count(&mut counts, self.coder, keyframe.absent.len(), limits::AGENTS)?;
            keyframe.absent.resize(count, 0);
            let mut next = 0;
            for agent in &mut keyframe.absent {
                let gap = code_count(&mut gaps, self.coder, agent.saturating_sub(next) as usize, limits::AGENTS)?;
                *agent = next + gap as u32;
                next = *agent + 1;
            }
            last.clone_from(&keyframe.absent);
        }
        let mut has_more = has_betweens(track);
        self.coder.bit(&mut Bit::likely(false), &mut has_more);
        if has_more { self.code_betweens(track) } else { Ok(()) }
    }
}
