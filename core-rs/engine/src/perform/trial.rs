//! Auto's trial of one segment: every candidate on its own, whatever it will be joined to.
//!
//! How segments meet bends each candidate alike, so a segment alone tells them apart; and its table stays when a neighbor changes.

use std::sync::Arc;

use glam::DVec2;

use super::auto;
use super::performed::Candidate;
use crate::choice::Choice;
use crate::measure::{self, Score};
use crate::motion::Motion;
use crate::recent::Recent;
use crate::transition::{Chain, End, Planner, Transition, Way, Ways};

/// Tables keep formations alive; a show of 200 × 23 has 0.1 MB of them.
const BYTE_LIMIT: usize = 16 << 20;

/// What a table is the answer to. Keyframes are compared by identity.
#[derive(Clone, Debug, PartialEq)]
struct Question {
    source: End,
    target: End,
    keeps_size: bool,
    minimum_distance: f64,
}

/// Tables found lately.
pub(super) struct Tables(Recent<Question, Arc<Vec<Candidate>>>);

impl Default for Tables {
    fn default() -> Self {
        Self(Recent::new(BYTE_LIMIT))
    }
}

/// The candidates of one segment, tried one after the other.
pub(super) struct Trial {
    question: Question,
    chain: Chain,
    /// Ways still to try, last first.
    left: Vec<Choice>,
    tried: Vec<(Choice, Score)>,
}

impl Trial {
    /// Between two keyframes.
    pub(super) fn new(source: End, target: End, keeps_size: bool, minimum_distance: f64) -> Self {
        let mut left = auto::choices(source.formation.agent_count());
        left.reverse();
        let chain = Chain::between(source.clone(), target.clone());
        Self { question: Question { source, target, keeps_size, minimum_distance }, chain, left, tried: Vec::new() }
    }

    /// Works for a while; the table when it is known.
    pub(super) fn step(&mut self, planner: &mut Planner, tables: &mut Tables) -> Option<Arc<Vec<Candidate>>> {
        if let Some(known) = tables.0.get(&self.question) {
            return Some(known);
        }
        let Some(&choice) = self.left.last() else {
            let table = Arc::new(auto::decide(std::mem::take(&mut self.tried)));
            let bytes = 4 * size_of_val(self.question.source.formation.positions());
            tables.0.put(self.question.clone(), table.clone(), bytes);
            return Some(table);
        };
        let transition = planner.step(&self.chain, &Ways::all(Way::of(choice, self.question.keeps_size)))?;
        self.left.pop();
        self.tried.push((choice, self.judge(&*transition)));
        None
    }

    /// How many ways are left.
    pub(super) fn left(&self) -> usize {
        self.left.len()
    }

    fn judge(&self, transition: &dyn Transition) -> Score {
        let ts = auto::trial_parameters();
        let mut positions = vec![DVec2::ZERO; ts.len() * transition.agent_count()];
        transition.evaluate_into(&ts, &mut positions);
        let motion = Motion::new(ts.clone(), transition.agent_count(), positions);
        let Question { source, target, minimum_distance, .. } = &self.question;
        measure::score(&motion, &ts, [&source.adjacency, &target.adjacency], *minimum_distance)
    }
}

/// The choice that a table marks.
pub(super) fn chosen(table: &[Candidate]) -> Choice {
    table.iter().find(|candidate| candidate.is_chosen).expect("a table marks one").choice
}
