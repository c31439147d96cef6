//! What a scene says beyond crowds: how it was found who goes where.
//!
//! It stands behind the closing flag of `crowds` and ends with a flag of its own. Here, too, the order is the format.

use super::fields::Fields;
use super::graph::Pairs;
use super::paths::has_paths;
use super::range::Bit;
use crate::assignment::{AssignmentSpec, Cost, DEFAULT_LAMBDA};
use crate::error::Error;
use crate::scene::{Segment, Track, limits};

// The place in this list is the value in the link: append only.
const COSTS: [Cost; 5] = [Cost::Squared, Cost::LeastEffort, Cost::Euclidean, Cost::Manhattan, Cost::Keep];

/// Whether a track says any of it, or of what stands behind it.
pub fn has_recipes(track: &Track) -> bool {
    track.segments.iter().any(|Segment::Transition(transition)| transition.assignment.is_some()) || has_paths(track)
}

impl Fields<'_> {
    pub(super) fn code_recipes(&mut self, track: &mut Track) -> Result<(), Error> {
        let (mut is_there, mut pairs) = (Bit::likely(false), Pairs::default());
        for Segment::Transition(transition) in &mut track.segments {
            let mut is_there_here = transition.assignment.is_some();
            self.coder.bit(&mut is_there, &mut is_there_here);
            if is_there_here {
                self.code_recipe(&mut pairs, transition.assignment.get_or_insert_default())?;
            }
        }
        let mut has_more = has_paths(track);
        self.coder.bit(&mut Bit::likely(false), &mut has_more);
        if has_more { self.code_paths(track) } else { Ok(()) }
    }

    fn code_recipe(&mut self, pairs: &mut Pairs, recipe: &mut AssignmentSpec) -> Result<(), Error> {
        let AssignmentSpec { cost, lambda, locks, keep_groups } = recipe;
        self.code_word(&COSTS, cost)?;
        self.code_usual(DEFAULT_LAMBDA, lambda);
        self.coder.bit(&mut Bit::likely(false), keep_groups);
        let count = pairs.code_count(self.coder, locks.len(), limits::AGENTS)?;
        locks.resize(count, (0, 0));
        let mut last = (0, 0);
        for lock in locks {
            pairs.code_pair(self.coder, last, (&mut lock.0, &mut lock.1))?;
            last = *lock;
        }
        Ok(())
    }
}
