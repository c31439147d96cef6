//! What is settled before a segment moves.

use std::sync::Arc;

use super::outcome::Crowded;
use super::part::Part;
use super::performed::Candidate;
use crate::choice::Choice;
use crate::transition::{Chain, Hierarchy, Travel, Way, Ways};

pub(super) struct Plan {
    pub(super) chain: Chain,
    /// Where the segment goes along paths.
    pub(super) travel: Option<Arc<Travel>>,
    pub(super) ways: Ways,
    /// Where the segment is a part of one that is performed already.
    pub(super) part: Option<Arc<Part>>,
    /// Where the segment goes by groups.
    pub(super) hierarchy: Option<Hierarchy>,
    /// Where the samples will be, as far as the clock is known.
    pub(super) ts: Arc<[f64]>,
    pub(super) candidates: Arc<Vec<Candidate>>,
    /// What forces came to, once they have led.
    pub(super) crowded: Option<Box<Crowded>>,
}

impl Plan {
    /// The chain as methods see it.
    pub(super) fn chart(&self) -> &Chain {
        self.travel.as_ref().map_or(&self.chain, |travel| travel.chart())
    }

    /// The same segment as a whole by another way, whatever is beside it.
    pub(super) fn by(&self, choice: Choice, keeps_size: bool) -> Self {
        Self {
            chain: self.chain.clone(),
            travel: self.travel.clone(),
            part: None,
            ways: Ways::all(Way::of(choice, keeps_size)),
            hierarchy: None,
            ts: self.ts.clone(),
            candidates: self.candidates.clone(),
            crowded: None,
        }
    }
}
