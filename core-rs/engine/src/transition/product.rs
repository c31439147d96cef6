//! Paper A's own way through several keyframes (section 4.1, equation 5), as printed, to compare with.
//!
//! It passes every keyframe, but not with one velocity: powers of products of rotations do not commute, and their logarithms wrap.
//! It knows neither uneven times nor sharing.

use super::carried::Power;
use super::chain::Chain;
use super::planner::Planner;
use super::route::Route;
use super::straight::goes_straight;
use crate::choice::{Choice, MethodName};

impl Planner {
    /// What the segment of a chain takes: M(t) = (R₂R₁R₀)^c₂ (R₁R₀)^c₁ R₀^c₀ M₀ from the keyframe before it.
    pub(super) fn product<'a>(&mut self, chain: &'a Chain, choice: &Choice, keeps_size: bool) -> Option<Route<'a>> {
        if goes_straight(chain, choice) {
            return Some(Route::Straight);
        }
        let choice = &Choice { sharing: 0.0, ..*choice };
        let (at, tension) = (chain.at(), chain.tension());
        let strand = self.strand(chain, choice, keeps_size, at, at..=at + 1)?;
        if choice.method != MethodName::Spectral {
            return Some(Route::Fixed(strand));
        }
        let own = self.turn(chain, at, choice)?;
        // At a stop the keyframe is its own neighbor: the rotation beyond it is the identity.
        let before = if at > 0 { Some(self.turn(chain, at - 1, choice)?) } else { None };
        let target = match &before {
            Some(before) => self.successive(chain, before, &own)?,
            None => own,
        };
        let beyond = if at + 2 < chain.ends().len() {
            let after = self.turn(chain, at + 1, choice)?;
            self.successive(chain, &target, &after)?
        } else {
            target.clone()
        };
        let source = before.iter().map(|before| (before.clone(), Power::Source(tension)));
        let turns = source.chain([(target, Power::Target(tension)), (beyond, Power::Beyond(tension))]).collect();
        Some(Route::Turning { strand, from: before, turns })
    }
}
