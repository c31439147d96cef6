//! Segments in space that meet at keyframes with one velocity.
//!
//! Directions in space have no angles to unwrap, so there is no one curve to run through several keyframes. Each segment goes the way
//! it goes on its own and is bent to a common velocity: the mean of those with which the segment before arrives and the segment after
//! leaves, weighted as on the plane (Catmull-Rom for uneven times). Straight ways become the cubics that they are on the plane.

use glam::DVec3;

use super::Transition;
use super::bent::{bent, places_at};
use super::chain::{Chain, Way, Ways};
use super::planner::Planner;

/// The step of the difference that tells a velocity, of the whole way.
///
/// The formula is short by step⁴/5 of the fifth derivative, which for a half turn is 300 times the radius: 6e-11; and round-off of
/// eps over the step is less.
const STEP: f64 = 1e-3;

/// The weights of places 0 to 4 steps from an end in the velocity there.
const WEIGHTS: [f64; 5] = [-25.0 / 12.0, 4.0, -3.0, 4.0 / 3.0, -0.25];

impl Planner {
    /// The segment of a chain that is not level.
    pub(super) fn in_space(&mut self, chain: &Chain, ways: &Ways) -> Option<Box<dyn Transition>> {
        let at = chain.at();
        let own = self.alone(chain, at, &ways.own)?;
        let [leaving, arriving] = [0.0, 1.0].map(|end| velocities(&*own, end));
        let before = self.velocities_beside(chain, at.checked_sub(1), ways.before, 1.0)?;
        let after = self.velocities_beside(chain, (at + 2 < chain.ends().len()).then_some(at + 1), ways.after, 0.0)?;
        let duration = chain.duration(at);
        let lacks = |own: &[DVec3], own_pace: f64, beside: Vec<DVec3>, beside_pace: f64| {
            own.iter().zip(beside).map(|(own, beside)| *own * (own_pace - 1.0 / duration) + beside * beside_pace).collect::<Vec<_>>()
        };
        let ([before_pace, leaving_pace], [arriving_pace, after_pace]) = (chain.pace(at), chain.pace(at + 1));
        let leaving = lacks(&leaving, leaving_pace, before, before_pace);
        let arriving = lacks(&arriving, arriving_pace, after, after_pace);
        Some(bent(chain, own, [Some(leaving), Some(arriving)]))
    }

    /// How fast a neighbor on its own passes its end, a whole way a unit of time; nobody moves where there is no neighbor.
    fn velocities_beside(&mut self, chain: &Chain, pair: Option<usize>, way: Option<Way>, end: f64) -> Option<Vec<DVec3>> {
        let Some(pair) = pair else { return Some(vec![DVec3::ZERO; chain.agent_count()]) };
        let way = way.expect("a segment that passes a keyframe has a neighbor there");
        Some(velocities(&*self.alone(chain, pair, &way)?, end))
    }
}

/// The change of places with t at an end, 0 or 1.
fn velocities(path: &dyn Transition, end: f64) -> Vec<DVec3> {
    let inward = STEP * (1.0 - 2.0 * end);
    let ts: Vec<f64> = (0..WEIGHTS.len()).map(|k| end + k as f64 * inward).collect();
    let mut sum = vec![DVec3::ZERO; path.agent_count()];
    for (places, weight) in places_at(path, &ts).chunks_exact(path.agent_count().max(1)).zip(WEIGHTS) {
        sum.iter_mut().zip(places).for_each(|(sum, place)| *sum += *place * (weight / inward));
    }
    sum
}
