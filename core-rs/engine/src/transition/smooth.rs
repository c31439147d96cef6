//! Segments that meet at keyframes with one velocity (paper A, section 4.1, made continuous).
//!
//! A velocity at a keyframe comes from the keyframe and its two neighbors (Catmull-Rom for uneven times), in the terms of each
//! method: places, radii and angles, rotations. Where the methods on both sides differ, or equal eigenvalues give a keyframe two
//! bases, the mean of both velocities is the one, and each path is bent to it.

use glam::DVec3;

use super::carried::Power;
use super::chain::{Chain, Way, Ways};
use super::planner::Planner;
use super::route::Route;
use super::straight::{goes_straight, straight_velocities};
use crate::choice::{Choice, Join, MethodName};

impl Planner {
    /// What the segment of a chain takes.
    pub(super) fn smooth<'a>(&mut self, chain: &'a Chain, choice: &Choice, keeps_size: bool) -> Option<Route<'a>> {
        let at = chain.at();
        if goes_straight(chain, choice) {
            return Some(Route::Straight);
        }
        let strand = self.strand(chain, choice, keeps_size, at, at..=at + 1)?;
        if choice.method != MethodName::Spectral {
            return Some(Route::Fixed(strand));
        }
        let whole = self.rest(chain, at, choice)?;
        let third = chain.duration(at) / 3.0;
        let (first, first_rate) = self.passing_turn(chain, at, choice)?;
        let (last, last_rate) = self.passing_turn(chain, at + 1, choice)?;
        let middle = self.middle(chain, &whole, (&first, third * first_rate), (&last, third * last_rate))?;
        let turns =
            vec![(first, Power::Leaving(third * first_rate)), (middle, Power::Crossing), (last, Power::Arriving(third * last_rate))];
        Some(Route::Turning { strand, from: None, turns })
    }

    /// What the velocities at both ends lack to be the mean of the segment's and its neighbor's, meters a second; none at a stop.
    pub(super) fn velocity_lacks(&mut self, chain: &Chain, ways: &Ways) -> Option<[Option<Vec<DVec3>>; 2]> {
        if chain.join() != Join::Smooth {
            return Some([None, None]);
        }
        let at = chain.at();
        let mut lacks = [None, None];
        if at > 0 {
            lacks[0] = Some(self.velocity_lack(chain, (ways.own, at), (neighbor(ways.before), at - 1), at)?);
        }
        if at + 2 < chain.ends().len() {
            lacks[1] = Some(self.velocity_lack(chain, (ways.own, at), (neighbor(ways.after), at + 1), at + 1)?);
        }
        Some(lacks)
    }

    fn velocity_lack(&mut self, chain: &Chain, own: (Way, usize), other: (Way, usize), end: usize) -> Option<Vec<DVec3>> {
        // The neighbor's pieces may be missing yet; the segment's own are not.
        let other = self.velocities(chain, &other.0, other.1, end)?;
        let own = self.velocities(chain, &own.0, own.1, end)?;
        Some(own.into_iter().zip(other).map(|(own, other)| 0.5 * (other - own)).collect())
    }

    /// How fast each agent passes keyframe `end` in the modes of `pair`, meters a second.
    fn velocities(&mut self, chain: &Chain, way: &Way, pair: usize, end: usize) -> Option<Vec<DVec3>> {
        let mut sum = vec![DVec3::ZERO; chain.agent_count()];
        for (choice, share) in way.parts() {
            let velocities = if goes_straight(chain, &choice) {
                straight_velocities(chain, end)
            } else {
                self.strand(chain, &choice, way.keeps_size, pair, end..=end)?.velocities(end)
            };
            sum.iter_mut().zip(velocities).for_each(|(sum, velocity)| *sum += share * velocity);
        }
        Some(sum)
    }
}

fn neighbor(way: Option<Way>) -> Way {
    way.expect("a segment that passes a keyframe has a neighbor there")
}
