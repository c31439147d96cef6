//! Plans transitions step by step, and remembers the pieces that others have in common with them.

use super::bent::bent;
use super::chain::{Chain, Couple, Way, Ways};
use super::linear::Linear;
use super::piece::{Piece, Recipe};
use super::polar::Polar;
use super::shared::Shared;
use super::spectral::Spectral;
use super::{Blend, Transition};
use crate::choice::{Choice, Join, MethodName};
use crate::recent::Recent;

/// Pieces are matrices of agents × agents: 12 MB each for 1,260.
const BYTE_LIMIT: usize = 256 << 20;

/// Plans any segment of any show; each piece of work is done once however many choices and neighbors need it, for as long as the
/// formations and ties it came from are the same objects.
///
/// A step is one piece of at most a few n³: the caller may report progress, or stop for good, between any two.
pub struct Planner {
    pieces: Recent<Recipe, Piece>,
}

impl Default for Planner {
    fn default() -> Self {
        Self { pieces: Recent::new(BYTE_LIMIT) }
    }
}

impl Planner {
    /// Plans a segment in one go.
    ///
    /// # Panics
    /// When a method is `auto` or `crowd`, or a neighbor has no way: a bug of the caller.
    pub fn plan(&mut self, chain: &Chain, ways: &Ways) -> Box<dyn Transition> {
        self.tidy();
        loop {
            if let Some(transition) = self.step(chain, ways) {
                return transition;
            }
        }
    }

    /// Does the next piece of work toward a segment; the transition once nothing is missing.
    ///
    /// # Panics
    /// When a method is `auto`, or a neighbor has no way: a bug of the caller.
    pub fn step(&mut self, chain: &Chain, ways: &Ways) -> Option<Box<dyn Transition>> {
        if chain.is_alone() {
            return self.alone(chain, chain.at(), &ways.own);
        }
        if !chain.is_level() {
            return self.in_space(chain, ways);
        }
        let (parts, keeps_size) = (ways.own.parts(), ways.own.keeps_size);
        let mut routes = Vec::new();
        for (choice, share) in parts {
            let route = match chain.join() {
                Join::Product => self.product(chain, &choice, keeps_size)?,
                Join::Smooth | Join::Separate => self.smooth(chain, &choice, keeps_size)?,
            };
            routes.push((route, share));
        }
        let lacks = self.velocity_lacks(chain, ways)?;
        let path = blended(routes.into_iter().map(|(route, share)| (route.path(chain), share)).collect());
        Some(bent(chain, path, lacks))
    }

    /// Forgets what has not been used for long. Between two segments only: a step counts on the pieces of the steps before.
    pub fn tidy(&mut self) {
        self.pieces.trim();
    }

    /// A piece done before.
    pub(super) fn known(&mut self, recipe: &Recipe) -> Option<Piece> {
        self.pieces.get(recipe)
    }

    /// Remembers a piece of about `matrices` matrices of agents × agents.
    pub(super) fn keep(&mut self, recipe: Recipe, piece: Piece, agent_count: usize, matrices: usize) {
        self.pieces.add(recipe, piece, matrices * agent_count * agent_count * size_of::<f64>());
    }

    /// The segment from keyframe `pair` to the next as if it had no neighbors.
    pub(super) fn alone(&mut self, chain: &Chain, pair: usize, way: &Way) -> Option<Box<dyn Transition>> {
        let couple = chain.couple(pair);
        let parts = way.parts().into_iter().map(|(choice, share)| Some((self.between(&couple, &choice, way.keeps_size)?, share)));
        Some(blended(parts.collect::<Option<_>>()?))
    }

    fn between(&mut self, couple: &Couple, choice: &Choice, keeps_size: bool) -> Option<Box<dyn Transition>> {
        Some(match choice.method {
            MethodName::Auto | MethodName::Crowd => panic!("auto chooses among methods, and a crowd follows one"),
            MethodName::Linear => Box::new(Linear::new(couple)),
            MethodName::Polar => Box::new(Polar::new(couple.formations(), choice.alignment)),
            MethodName::Shared => Box::new(Shared::new(couple.formations(), self.mean_basis(couple)?, choice.alignment, keeps_size)),
            MethodName::Spectral => {
                let matched = self.matched(couple, choice)?;
                Box::new(Spectral::new(couple.formations(), matched, choice.alignment, choice.sharing, keeps_size))
            }
        })
    }
}

/// One transition of several with shares.
fn blended(mut parts: Vec<(Box<dyn Transition>, f64)>) -> Box<dyn Transition> {
    if parts.len() == 1 { parts.swap_remove(0).0 } else { Box::new(Blend::new(parts)) }
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use glam::DVec2;

    use super::*;
    use crate::adjacency::{AdjacencySpec, build};
    use crate::choice::{Alignment, Order};
    use crate::formation::Formation;
    use crate::transition::End;

    fn spiral(pitch: f64) -> End {
        let formation = Formation::new((1..10).map(|i| DVec2::from_angle(f64::from(i)) * (1.0 + pitch * f64::from(i))).collect::<Vec<_>>());
        let adjacency = build(&formation, &AdjacencySpec::default(), &[]).expect("few ties");
        End { formation: Arc::new(formation), adjacency: Arc::new(adjacency) }
    }

    fn way(order: Order, sharing: f64, alignment: Alignment) -> Ways {
        Ways::all(Way::of(Choice { method: MethodName::Spectral, order, alignment, sharing }, false))
    }

    fn steps(planner: &mut Planner, chain: &Chain, ways: &Ways) -> usize {
        (1..100).find(|_| planner.step(chain, ways).is_some()).expect("it ends")
    }

    #[test]
    fn a_second_choice_starts_where_the_first_left_off() {
        let mut planner = Planner::default();
        let chain = Chain::between(spiral(0.7), spiral(1.9));
        // Two spectra, two eigenbases, the pair, the pairing, the planes, the transition.
        assert_eq!(steps(&mut planner, &chain, &way(Order::Greedy, 0.0, Alignment::None)), 8);
        assert_eq!(steps(&mut planner, &chain, &way(Order::Greedy, 0.5, Alignment::None)), 1);
        assert_eq!(steps(&mut planner, &chain, &way(Order::Greedy, 0.5, Alignment::Procrustes)), 1);
        assert_eq!(steps(&mut planner, &chain, &way(Order::Hungarian, 0.5, Alignment::Procrustes)), 3);
    }

    #[test]
    fn a_keyframe_seen_before_has_its_eigenbasis() {
        let mut planner = Planner::default();
        let [first, second, third] = [0.7, 1.9, 1.1].map(spiral);
        let ways = way(Order::Greedy, 0.5, Alignment::Pca);
        steps(&mut planner, &Chain::between(first, second.clone()), &ways);
        assert_eq!(steps(&mut planner, &Chain::between(second, third), &ways), 6);
    }
}
