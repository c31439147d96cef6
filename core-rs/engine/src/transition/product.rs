//! Paper A's own way through several keyframes (section 4.1, equation 5), as printed, to compare with.
//!
//! It passes every keyframe, but not with one velocity: powers of products of rotations do not commute, and their logarithms wrap.
//! It knows neither uneven times nor sharing.

use std::sync::Arc;

use super::Transition;
use super::carried::{Carried, Power};
use super::chain::Chain;
use super::modal::Drift;
use super::planner::Planner;
use super::smooth::{goes_straight, straight};
use crate::choice::{Choice, MethodName};
use crate::spectral::Planes;

impl Planner {
    /// The segment of a chain: M(t) = (R₂R₁R₀)^c₂ (R₁R₀)^c₁ R₀^c₀ M₀ from the keyframe before it.
    pub(super) fn product(&mut self, chain: &Chain, choice: &Choice, keeps_size: bool) -> Option<Box<dyn Transition>> {
        if goes_straight(chain, choice) {
            return Some(Box::new(straight(chain)));
        }
        if choice.method != MethodName::Spectral {
            return Some(Box::new(self.fixed(chain, choice, keeps_size)?));
        }
        let choice = &Choice { sharing: 0.0, ..*choice };
        let (at, tension) = (chain.at(), chain.tension());
        let strand = self.strand(chain, choice, keeps_size, at, at..=at + 1)?;
        let own = self.turn(chain, at, choice)?;
        let before = if at > 0 { Some(self.turn(chain, at - 1, choice)?) } else { None };
        let modes = strand.modes_at_origin();
        let target = match &before {
            Some(before) => self.successive(chain, before, &own)?,
            None => own,
        };
        // At a stop the keyframe is its own neighbor: that rotation is the identity.
        let beyond = if at + 2 < chain.ends().len() {
            let after = self.turn(chain, at + 1, choice)?;
            self.successive(chain, &target, &after)?
        } else {
            target.clone()
        };
        let mut turns: Vec<(Arc<Planes>, Power)> = Vec::new();
        let mut first = modes;
        if let Some(before) = before {
            first = crate::spectral::product(before.matrix(-1.0).as_ref(), first.as_ref());
            turns.push((before, Power::Source(tension)));
        }
        turns.extend([(target, Power::Target(tension)), (beyond, Power::Beyond(tension))]);
        Some(Box::new(Carried::new(first.as_ref(), turns, strand.passage(at), Drift::of(chain))))
    }
}
