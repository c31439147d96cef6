//! The pieces of two keyframes: their bases, how these are matched, and the rotation between them.

use std::sync::Arc;

use faer::Mat;

use super::chain::{Couple, End};
use super::piece::{Piece, Recipe};
use super::planner::Planner;
use crate::adjacency::Adjacency;
use crate::choice::{Choice, Order};
use crate::recent::Same;
use crate::spectral::{Eigenbasis, Matched, ModeMatch, Pair, Pairing, Spectrum, Turn, is_degenerate, nearness, reversals, with_tie_break};

impl Planner {
    /// The eigenbasis of a graph, in one go.
    pub fn eigenbasis(&mut self, adjacency: &Arc<Adjacency>) -> Arc<Eigenbasis> {
        loop {
            if let Some(basis) = self.basis(adjacency) {
                return basis;
            }
        }
    }

    /// How alike the modes of two keyframes are, with ties between equal eigenvalues decided as for a motion; in one go.
    pub fn mode_match(&mut self, source: End, target: End) -> ModeMatch {
        let couple = Couple { source, target };
        loop {
            if let Some(pair) = self.pair(&couple) {
                return ModeMatch::of(&pair);
            }
        }
    }
}

/// Each answers with a piece that is known, or does one step toward it.
impl Planner {
    /// The eigenbasis of a graph.
    pub(super) fn basis(&mut self, adjacency: &Arc<Adjacency>) -> Option<Arc<Eigenbasis>> {
        let recipe = Recipe::Basis(Same(adjacency.clone()));
        if let Some(Piece::Basis(known)) = self.known(&recipe) {
            return Some(known);
        }
        let spectrum = self.spectrum(adjacency)?;
        self.basis_of(recipe, || spectrum.basis())
    }

    /// The eigenvalues of a graph.
    fn spectrum(&mut self, adjacency: &Arc<Adjacency>) -> Option<Arc<Spectrum>> {
        let recipe = Recipe::Spectrum(Same(adjacency.clone()));
        if let Some(Piece::Spectrum(known)) = self.known(&recipe) {
            return Some(known);
        }
        let spectrum = Arc::new(Spectrum::of(adjacency.laplacian().as_ref()));
        self.keep(recipe, Piece::Spectrum(spectrum), adjacency.agent_count(), 1);
        None
    }

    /// Whether a graph has equal eigenvalues.
    fn is_degenerate(&mut self, adjacency: &Arc<Adjacency>) -> Option<bool> {
        Some(is_degenerate(self.spectrum(adjacency)?.eigenvalues()))
    }

    /// The eigenbasis of the mean graph, ties between equal eigenvalues decided.
    pub(super) fn mean_basis(&mut self, couple: &Couple) -> Option<Arc<Eigenbasis>> {
        self.basis_of(Recipe::Mean(couple.clone()), || {
            let mut mean = couple.source.adjacency.laplacian();
            mean += couple.target.adjacency.laplacian();
            mean *= faer::Scale(0.5);
            let spectrum = Spectrum::of(mean.as_ref());
            if !is_degenerate(spectrum.eigenvalues()) {
                return spectrum.basis();
            }
            let [source, target] = couple.formations();
            Eigenbasis::of(with_tie_break(&mean, None, &nearness(source, target)).as_ref())
        })
    }

    /// Both bases side by side, ties between equal eigenvalues decided.
    pub(super) fn pair(&mut self, couple: &Couple) -> Option<Arc<Pair>> {
        let recipe = Recipe::Pair(couple.clone());
        if let Some(Piece::Pair(known)) = self.known(&recipe) {
            return Some(known);
        }
        let formations = couple.formations();
        // Large graphs mostly have equal eigenvalues, and then neither basis is worth its price.
        let has_ties = self.is_degenerate(&couple.source.adjacency)? || self.is_degenerate(&couple.target.adjacency)?;
        let pair = if has_ties {
            let laplacians = || (couple.source.adjacency.laplacian(), couple.target.adjacency.laplacian());
            let broken = |own: Mat<f64>, other: Mat<f64>| {
                Eigenbasis::of(with_tie_break(&own, Some(&other), &nearness(formations[0], formations[1])).as_ref())
            };
            let source = self.basis_of(Recipe::BrokenSource(couple.clone()), || {
                let (source, target) = laplacians();
                broken(source, target)
            })?;
            let target = self.basis_of(Recipe::BrokenTarget(couple.clone()), || {
                let (source, target) = laplacians();
                broken(target, source)
            })?;
            Pair::of_tie_broken(formations, source, &target)
        } else {
            let source = self.basis(&couple.source.adjacency)?;
            let target = self.basis(&couple.target.adjacency)?;
            Pair::of_simple(formations, source, target)
        };
        self.keep(recipe, Piece::Pair(Arc::new(pair)), formations[0].agent_count(), 2);
        None
    }

    /// The rotation of the source modes into the target modes.
    pub(super) fn matched(&mut self, couple: &Couple, choice: &Choice) -> Option<Arc<Matched>> {
        let pair = self.pair(couple)?;
        let pairing = self.pairing(&pair, choice.order)?;
        let formations = couple.formations();
        let turn = Turn::between(formations, choice.alignment);
        let reversals = reversals(&pair, &pairing, formations, turn);
        let recipe = Recipe::Matched(Same(pair.clone()), choice.order, reversals.clone());
        if let Some(Piece::Matched(known)) = self.known(&recipe) {
            return Some(known);
        }
        let matched = Matched::new(pair, &pairing, reversals);
        self.keep(recipe, Piece::Matched(Arc::new(matched)), formations[0].agent_count(), 1);
        None
    }

    fn pairing(&mut self, pair: &Arc<Pair>, order: Order) -> Option<Arc<Pairing>> {
        let recipe = Recipe::Pairing(Same(pair.clone()), order);
        if let Some(Piece::Pairing(known)) = self.known(&recipe) {
            return Some(known);
        }
        self.keep(recipe, Piece::Pairing(Arc::new(Pairing::of(pair, order))), 0, 0);
        None
    }

    fn basis_of(&mut self, recipe: Recipe, make: impl FnOnce() -> Eigenbasis) -> Option<Arc<Eigenbasis>> {
        if let Some(Piece::Basis(known)) = self.known(&recipe) {
            return Some(known);
        }
        let basis = make();
        let agent_count = basis.agent_count();
        self.keep(recipe, Piece::Basis(Arc::new(basis)), agent_count, 1);
        None
    }
}
