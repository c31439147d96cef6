//! The pieces of a chain: the rotations between keyframes, and what sharing leaves of them.

use std::sync::Arc;

use faer::Mat;

use super::chain::Chain;
use super::piece::{Piece, Recipe};
use super::planner::Planner;
use crate::choice::Choice;
use crate::recent::Same;
use crate::spectral::{Planes, combination, product};

/// Where the greatest angle of a rotation beside a keyframe is above this, the keyframe shares half as much: nearer to a half turn a
/// small change of a formation turns the rotation's logarithm over, and with it the keyframe's basis.
const NEAR_HALF_TURN: f64 = 0.95 * std::f64::consts::PI;

/// Each answers with a piece that is known, or does one step toward it.
impl Planner {
    /// The rotation of all agents from keyframe `pair` to the next.
    pub(super) fn turn(&mut self, chain: &Chain, pair: usize, choice: &Choice) -> Option<Arc<Planes>> {
        let matched = self.matched(&chain.couple(pair), choice)?;
        self.planes(chain, Recipe::Turn(Same(matched.clone())), &|| matched.turn_of_agents())
    }

    /// The rotation that takes the basis of keyframe `end` toward those of its neighbors, by half the sharing in all: keyframes that
    /// have met part of the way leave less to turn.
    pub(super) fn meeting(&mut self, chain: &Chain, end: usize, choice: &Choice) -> Option<Arc<Planes>> {
        let around = chain.around(end);
        let before = if *around.start() < end { Some(self.turn(chain, end - 1, choice)?) } else { None };
        let after = if *around.end() > end { Some(self.turn(chain, end, choice)?) } else { None };
        let greatest = before.iter().chain(&after).map(|planes| planes.greatest_angle()).fold(0.0, f64::max);
        let amount = if greatest > NEAR_HALF_TURN { 0.25 } else { 0.5 } * choice.sharing;
        let recipe = Recipe::Meeting { before: before.clone().map(Same), after: after.clone().map(Same), amount };
        self.planes(chain, recipe, &|| match (&before, &after) {
            (Some(before), Some(after)) => {
                let (after, before) = (after.logarithm(), before.logarithm());
                Planes::of_logarithm(combination(amount, after.as_ref(), -amount, before.as_ref()).as_ref())
            }
            (Some(before), None) => before.scaled(-amount),
            (None, Some(after)) => after.scaled(amount),
            (None, None) => unreachable!("a chain has two keyframes"),
        })
    }

    /// What is left to turn from keyframe `pair` to the next.
    pub(super) fn rest(&mut self, chain: &Chain, pair: usize, choice: &Choice) -> Option<Arc<Planes>> {
        let turn = self.turn(chain, pair, choice)?;
        if choice.sharing == 0.0 {
            return Some(turn);
        }
        let source = self.meeting(chain, pair, choice)?;
        let target = self.meeting(chain, pair + 1, choice)?;
        let recipe = Recipe::Rest { turn: Same(turn.clone()), source: Same(source.clone()), target: Same(target.clone()) };
        if let Some(Piece::Planes(known)) = self.known(&recipe) {
            return Some(known);
        }
        // Two segments meet at a keyframe.
        let from_source = self.power(chain, &source, 1.0)?;
        let to_target = self.power(chain, &target, 1.0)?;
        let turned = product(turn.matrix(1.0).as_ref(), from_source.transpose());
        let left = product(to_target.as_ref().as_ref(), turned.as_ref());
        let planes = Arc::new(Planes::of(left.as_ref()));
        self.keep(Recipe::Power(Same(planes.clone()), 1.0), Piece::Matrix(Arc::new(left)), chain.agent_count(), 1);
        self.keep(recipe, Piece::Planes(planes), chain.agent_count(), 1);
        None
    }

    /// The rotation by which the modes pass keyframe `end`, and how often a second: the mean of what is left on either side, by the
    /// chain's pace.
    pub(super) fn passing_turn(&mut self, chain: &Chain, end: usize, choice: &Choice) -> Option<(Arc<Planes>, f64)> {
        let around = chain.around(end);
        let [slow, fast] = chain.pace(end);
        if *around.start() == end {
            return Some((self.rest(chain, end, choice)?, fast));
        }
        if *around.end() == end {
            return Some((self.rest(chain, end - 1, choice)?, slow));
        }
        let before = self.rest(chain, end - 1, choice)?;
        let after = self.rest(chain, end, choice)?;
        // The share without the tension, which may be 0.
        let [slow_share, fast_share] = chain.tensest_pace(end);
        let share = fast_share / (slow_share + fast_share);
        let recipe = Recipe::Halfway { before: Same(before.clone()), after: Same(after.clone()), share };
        let planes = self.planes(chain, recipe, &|| {
            let (after, before) = (after.logarithm(), before.logarithm());
            Planes::of_logarithm(combination(share, after.as_ref(), 1.0 - share, before.as_ref()).as_ref())
        })?;
        Some((planes, slow + fast))
    }

    /// What `whole` leaves to do between the start of `first` and the end of `last`, each with its power.
    pub(super) fn middle(
        &mut self,
        chain: &Chain,
        whole: &Arc<Planes>,
        first: (&Arc<Planes>, f64),
        last: (&Arc<Planes>, f64),
    ) -> Option<Arc<Planes>> {
        let same = |(planes, power): (&Arc<Planes>, f64)| (Same(planes.clone()), power);
        let recipe = Recipe::Middle { whole: Same(whole.clone()), first: same(first), last: same(last) };
        if let Some(Piece::Planes(known)) = self.known(&recipe) {
            return Some(known);
        }
        // At a stop the segment's own rotation leads: that part of its power is only left out.
        let is_whole = |part: &Arc<Planes>| Arc::ptr_eq(part, whole);
        let done: f64 = [first, last].into_iter().filter(|(part, _)| is_whole(part)).map(|(_, power)| power).sum();
        let before = if is_whole(first.0) { None } else { Some(self.power(chain, first.0, first.1)?) };
        let after = if is_whole(last.0) { None } else { Some(self.power(chain, last.0, last.1)?) };
        let left = self.power(chain, whole, 1.0 - done)?;
        let left = before.map_or(left.clone(), |before| Arc::new(product(left.as_ref().as_ref(), before.transpose())));
        let left = after.map_or(left.clone(), |after| Arc::new(product(after.transpose(), left.as_ref().as_ref())));
        self.planes(chain, recipe, &|| Planes::of(left.as_ref().as_ref()))
    }

    /// One rotation after another, as one.
    pub(super) fn successive(&mut self, chain: &Chain, first: &Arc<Planes>, second: &Arc<Planes>) -> Option<Arc<Planes>> {
        let recipe = Recipe::Product { first: Same(first.clone()), second: Same(second.clone()) };
        self.planes(chain, recipe, &|| Planes::of(product(second.matrix(1.0).as_ref(), first.matrix(1.0).as_ref()).as_ref()))
    }

    /// A rotation to a power, as a matrix; to the opposite power it is the transpose.
    pub(super) fn power(&mut self, chain: &Chain, planes: &Arc<Planes>, power: f64) -> Option<Arc<Mat<f64>>> {
        let recipe = Recipe::Power(Same(planes.clone()), power);
        if let Some(Piece::Matrix(known)) = self.known(&recipe) {
            return Some(known);
        }
        self.keep(recipe, Piece::Matrix(Arc::new(planes.matrix(power))), chain.agent_count(), 1);
        None
    }

    fn planes(&mut self, chain: &Chain, recipe: Recipe, make: &dyn Fn() -> Planes) -> Option<Arc<Planes>> {
        if let Some(Piece::Planes(known)) = self.known(&recipe) {
            return Some(known);
        }
        let planes = Arc::new(make());
        self.keep(recipe, Piece::Planes(planes), chain.agent_count(), 1);
        None
    }
}
