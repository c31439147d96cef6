//! Plans transitions between the same two ends, step by step, and keeps what they have in common.

use std::sync::Arc;

use faer::Mat;

use super::linear::Linear;
use super::polar::Polar;
use super::shared::Shared;
use super::spectral::Spectral;
use super::{Ends, Transition};
use crate::choice::{Choice, MethodName, Order};
use crate::spectral::{Eigenbasis, Matched, ModeMatch, Pair, Pairing, is_degenerate, nearness, reversals, turn_between, with_tie_break};

/// The work of one segment, each piece done once however many choices are tried.
///
/// A step is one piece of at most a few n³: the caller may report progress, or stop for good, between any two.
pub struct Planner {
    ends: Ends,
    tie_break: Option<TieBreak>,
    pair: Option<Pair>,
    pairings: Vec<(Order, Pairing)>,
    matched: Vec<Match>,
    mean: Option<Arc<Eigenbasis>>,
}

/// The bases of both ends with the tie-break mixed in.
#[derive(Default)]
struct TieBreak {
    source: Option<Arc<Eigenbasis>>,
    target: Option<Arc<Eigenbasis>>,
}

struct Match {
    order: Order,
    reversals: Vec<bool>,
    matched: Arc<Matched>,
}

/// Plans a choice in one go. `auto` is no choice of its own: it tries others.
///
/// # Panics
/// When the method is `auto`: a bug of the caller.
pub fn plan(choice: &Choice, keep_size: bool, ends: &Ends) -> Box<dyn Transition> {
    Planner::new(ends.clone()).plan(choice, keep_size)
}

impl Planner {
    /// Nothing is done yet.
    pub fn new(ends: Ends) -> Self {
        Self { ends, tie_break: None, pair: None, pairings: Vec::new(), matched: Vec::new(), mean: None }
    }

    /// The ends, with the eigenbases found so far.
    pub fn ends(&self) -> &Ends {
        &self.ends
    }

    /// Plans a choice in one go.
    ///
    /// # Panics
    /// When the method is `auto`: a bug of the caller.
    pub fn plan(&mut self, choice: &Choice, keep_size: bool) -> Box<dyn Transition> {
        loop {
            if let Some(transition) = self.step(choice, keep_size) {
                return transition;
            }
        }
    }

    /// How alike the modes of both ends are, with ties between equal eigenvalues decided as for a motion.
    pub fn mode_match(&mut self) -> ModeMatch {
        loop {
            if let Some(pair) = &self.pair {
                return ModeMatch::of(pair);
            }
            self.step_to_pair();
        }
    }

    /// Does the next piece of work toward a choice; the transition once nothing is missing.
    ///
    /// # Panics
    /// When the method is `auto`: a bug of the caller.
    pub fn step(&mut self, choice: &Choice, keep_size: bool) -> Option<Box<dyn Transition>> {
        match choice.method {
            MethodName::Auto => panic!("auto chooses among methods and is none"),
            MethodName::Linear => Some(Box::new(Linear::new(&self.ends))),
            MethodName::Polar => Some(Box::new(Polar::new(&self.ends, choice.alignment))),
            MethodName::Shared => {
                let basis = self.mean.clone();
                if let Some(basis) = basis {
                    return Some(Box::new(Shared::new(&self.ends, basis, choice.alignment, keep_size)));
                }
                self.mean = Some(Arc::new(self.mean_basis()));
                None
            }
            MethodName::Spectral => {
                let matched = self.step_to_match(choice)?;
                Some(Box::new(Spectral::new(&self.ends, matched, choice.alignment, choice.sharing, keep_size)))
            }
        }
    }

    fn step_to_match(&mut self, choice: &Choice) -> Option<Arc<Matched>> {
        if self.pair.is_none() {
            self.step_to_pair();
            return None;
        }
        let pair = self.pair.as_ref()?;
        let Some((_, pairing)) = self.pairings.iter().find(|(order, _)| *order == choice.order) else {
            self.pairings.push((choice.order, Pairing::of(pair, choice.order)));
            return None;
        };
        let formations = self.ends.formations();
        let turn = turn_between(formations[0], formations[1], choice.alignment);
        let reversals = reversals(pair, pairing, formations, turn);
        if let Some(known) = self.matched.iter().find(|known| known.order == choice.order && known.reversals == reversals) {
            return Some(known.matched.clone());
        }
        let matched = Arc::new(Matched::new(pair, pairing, reversals.clone()));
        self.matched.push(Match { order: choice.order, reversals, matched });
        None
    }

    fn step_to_pair(&mut self) {
        let Some(source) = self.ends.source.basis.clone() else {
            self.ends.source.basis = Some(Arc::new(Eigenbasis::of(self.ends.source.adjacency.laplacian().as_ref())));
            return;
        };
        let Some(target) = self.ends.target.basis.clone() else {
            self.ends.target.basis = Some(Arc::new(Eigenbasis::of(self.ends.target.adjacency.laplacian().as_ref())));
            return;
        };
        if !is_degenerate(source.eigenvalues()) && !is_degenerate(target.eigenvalues()) {
            self.pair = Some(Pair::of_simple(self.ends.formations(), source, target));
            return;
        }
        let ends = &self.ends;
        let broken = self.tie_break.get_or_insert_default();
        let basis = |own: Mat<f64>, other: Mat<f64>| {
            let [source, target] = ends.formations();
            Arc::new(Eigenbasis::of(with_tie_break(&own, Some(&other), &nearness(source, target)).as_ref()))
        };
        match (&broken.source, &broken.target) {
            (None, _) => broken.source = Some(basis(ends.source.adjacency.laplacian(), ends.target.adjacency.laplacian())),
            (_, None) => broken.target = Some(basis(ends.target.adjacency.laplacian(), ends.source.adjacency.laplacian())),
            (Some(source), Some(target)) => {
                self.pair = Some(Pair::of_tie_broken(ends.formations(), source.clone(), target));
                self.tie_break = None;
            }
        }
    }

    /// Two eigenproblems where the mean graph's eigenvalues repeat, else one.
    fn mean_basis(&self) -> Eigenbasis {
        let mut mean = self.ends.source.adjacency.laplacian();
        mean += self.ends.target.adjacency.laplacian();
        mean *= faer::Scale(0.5);
        let basis = Eigenbasis::of(mean.as_ref());
        if !is_degenerate(basis.eigenvalues()) {
            return basis;
        }
        let [source, target] = self.ends.formations();
        Eigenbasis::of(with_tie_break(&mean, None, &nearness(source, target)).as_ref())
    }
}

#[cfg(test)]
mod tests {
    use glam::DVec2;

    use super::*;
    use crate::adjacency::{AdjacencySpec, build};
    use crate::choice::Alignment;
    use crate::formation::Formation;
    use crate::transition::End;

    fn end(positions: Vec<DVec2>) -> End {
        let formation = Formation::new(positions);
        let adjacency = build(&formation, &AdjacencySpec::default(), &[]).expect("few ties");
        End { formation: Arc::new(formation), adjacency: Arc::new(adjacency), basis: None }
    }

    fn ends() -> Ends {
        let spiral = |pitch: f64| (1..10).map(|i| DVec2::from_angle(f64::from(i)) * (1.0 + pitch * f64::from(i))).collect();
        Ends::new(end(spiral(0.7)), end(spiral(1.9)))
    }

    fn steps(planner: &mut Planner, choice: &Choice) -> usize {
        (1..100).find(|_| planner.step(choice, false).is_some()).expect("it ends")
    }

    #[test]
    fn a_second_choice_starts_where_the_first_left_off() {
        let mut planner = Planner::new(ends());
        let choice = |order, sharing, alignment| Choice { method: MethodName::Spectral, order, alignment, sharing };
        // Two eigenbases, the pair, the pairing, the planes, the transition.
        assert_eq!(steps(&mut planner, &choice(Order::Greedy, 0.0, Alignment::None)), 6);
        assert_eq!(steps(&mut planner, &choice(Order::Greedy, 0.5, Alignment::None)), 1);
        assert_eq!(steps(&mut planner, &choice(Order::Greedy, 0.5, Alignment::Procrustes)), 1);
        assert_eq!(steps(&mut planner, &choice(Order::Hungarian, 0.5, Alignment::Procrustes)), 3);
    }

    #[test]
    fn a_known_eigenbasis_is_not_sought_again() {
        let mut first = Planner::new(ends());
        let choice = Choice { method: MethodName::Spectral, order: Order::Greedy, alignment: Alignment::Pca, sharing: 0.5 };
        steps(&mut first, &choice);
        let known = first.ends().clone();
        assert_eq!(steps(&mut Planner::new(known), &choice), 4);
    }
}
