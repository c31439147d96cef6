//! Auto's trial of one segment: every candidate on its own, whatever it will be joined to.
//!
//! How segments meet bends each candidate alike, so a segment alone tells them apart; and its table stays when a neighbor changes.

use std::sync::Arc;

use glam::DVec2;

use super::auto;
use super::levels::node_way;
use super::performed::Candidate;
use crate::choice::Choice;
use crate::grouping::Tree;
use crate::measure::{self, Score};
use crate::motion::Motion;
use crate::recent::{Recent, Same};
use crate::scene::TransitionSpec;
use crate::transition::{Chain, End, Hierarchy, Planner, Transition, Way, Ways};

/// Tables keep formations alive; a show of 200 × 23 has 0.1 MB of them.
const BYTE_LIMIT: usize = 16 << 20;

/// What a table is the answer to. Keyframes are compared by identity.
#[derive(Clone, Debug, PartialEq)]
struct Question {
    source: End,
    target: End,
    keeps_size: bool,
    minimum_distance: f64,
    /// By groups: what they do of their own.
    by_groups: Option<(Same<Tree>, TransitionSpec)>,
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
    hierarchy: Option<Hierarchy>,
    /// Ways still to try, last first.
    left: Vec<Choice>,
    tried: Vec<(Choice, Score)>,
}

impl Trial {
    /// Of a segment without neighbors; `hierarchy` plans it where it goes by groups.
    pub(super) fn new(chain: Chain, hierarchy: Option<Hierarchy>, transition: &TransitionSpec, minimum_distance: f64) -> Self {
        let mut left = auto::choices(hierarchy.as_ref().map_or(chain.agent_count(), Hierarchy::most_parts));
        left.reverse();
        let [source, target] = [0, 1].map(|end: usize| chain.ends()[end].clone());
        let by_groups = hierarchy.as_ref().map(|hierarchy| (Same(hierarchy.tree().clone()), transition.clone()));
        let question = Question { source, target, keeps_size: transition.keep_size, minimum_distance, by_groups };
        Self { question, chain, hierarchy, left, tried: Vec::new() }
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
        let transition: Box<dyn Transition> = match (&mut self.hierarchy, &self.question.by_groups) {
            (Some(hierarchy), Some((_, spec))) => {
                Box::new(hierarchy.step(planner, |path| Ways::all(node_way(spec, path, choice)), &Arc::default())?)
            }
            _ => planner.step(&self.chain, &Ways::all(Way::of(choice, self.question.keeps_size)))?,
        };
        self.left.pop();
        self.tried.push((choice, judge(&self.chain, &*transition, self.question.minimum_distance)));
        None
    }

    /// How many ways are left.
    pub(super) fn left(&self) -> usize {
        self.left.len()
    }
}

/// A segment's score one way; `chain` begins with its two keyframes or stands at them.
fn judge(chain: &Chain, transition: &dyn Transition, minimum_distance: f64) -> Score {
    let ts = auto::trial_parameters();
    let count = ts.len() * transition.agent_count();
    let mut positions = vec![DVec2::ZERO; count];
    let mut heights = chain.has_heights().then(|| vec![0.0; count]);
    transition.evaluate_into(&ts, &mut positions, heights.as_deref_mut());
    let motion = Motion::sampled(ts.clone(), transition.agent_count(), positions, heights);
    let [source, target] = [chain.at(), chain.at() + 1].map(|end| &*chain.ends()[end].adjacency);
    measure::score(&motion, &ts, [source, target], minimum_distance)
}

/// The table with the way that was taken in the end marked: a row of its own where auto had not tried it.
pub(super) fn with_resort(
    table: &[Candidate],
    choice: Choice,
    chain: &Chain,
    transition: &dyn Transition,
    minimum_distance: f64,
) -> Vec<Candidate> {
    let mut table = table.to_vec();
    if table.is_empty() || chosen(&table) == choice {
        return table;
    }
    if !table.iter().any(|candidate| candidate.choice == choice) {
        let score = judge(chain, transition, minimum_distance);
        table.push(auto::candidate(choice, &score, true));
    }
    for candidate in &mut table {
        candidate.is_chosen = candidate.choice == choice;
    }
    table
}

/// The choice that a table marks.
pub(super) fn chosen(table: &[Candidate]) -> Choice {
    table.iter().find(|candidate| candidate.is_chosen).expect("a table marks one").choice
}
