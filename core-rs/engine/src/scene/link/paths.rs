//! What a scene says beyond recipes: the paths that formations travel along.
//!
//! It stands behind the closing flag of `recipes` and ends with a flag of its own. Here, too, the order is the format.

use super::absences::has_absences;
use super::fields::Fields;
use super::graph::code_count;
use super::models::{Integer, Number};
use super::range::Bit;
use crate::error::Error;
use crate::scene::{PathSpec, Segment, Track, limits};
use glam::DVec3;

/// Whether a track says any of it, or of what stands behind it.
pub fn has_paths(track: &Track) -> bool {
    track.segments.iter().any(|Segment::Transition(transition)| transition.path.is_some()) || has_absences(track)
}

impl Fields<'_> {
    pub(super) fn code_paths(&mut self, track: &mut Track) -> Result<(), Error> {
        let (mut is_there, mut counts, mut coordinates) = (Bit::likely(false), Integer::default(), Number::default());
        for Segment::Transition(transition) in &mut track.segments {
            let mut is_there_here = transition.path.is_some();
            self.coder.bit(&mut is_there, &mut is_there_here);
            if is_there_here {
                let path = transition.path.get_or_insert(PathSpec { points: Vec::new(), is_spatial: false });
                self.code_path((&mut counts, &mut coordinates), path)?;
            }
        }
        let mut has_more = has_absences(track);
        self.coder.bit(&mut Bit::likely(false), &mut has_more);
        if has_more { self.code_absences(track) } else { Ok(()) }
    }

    /// Every digit of every point: a path has few, and a link must not bend it.
    fn code_path(&mut self, (counts, coordinates): (&mut Integer, &mut Number), path: &mut PathSpec) -> Result<(), Error> {
        self.coder.bit(&mut Bit::likely(false), &mut path.is_spatial);
        let count = code_count(counts, self.coder, path.points.len(), limits::PATH_POINTS)?;
        path.points.resize(count, DVec3::ZERO);
        for point in &mut path.points {
            for coordinate in &mut point.as_mut()[..if path.is_spatial { 3 } else { 2 }] {
                coordinates.code(self.coder, coordinate);
            }
        }
        Ok(())
    }
}
