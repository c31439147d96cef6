//! How near any two agents come, between samples too.

use glam::DVec2;

use super::{Motion, PairGrid};

/// Two agents at their nearest.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Approach {
    /// Meters.
    pub distance: f64,
    /// Seconds.
    pub time: f64,
    /// Lower index first.
    pub agents: (u32, u32),
}

/// The nearest approach of any two agents in each interval between samples, exact for the straight pieces: `result[k]` is between
/// samples k and k + 1. Of equal distances the earlier, then the pair of lower indices. Empty for fewer than two agents or samples.
pub fn approaches(motion: &Motion) -> Vec<Approach> {
    if motion.agent_count() < 2 || motion.times().len() < 2 {
        return Vec::new();
    }
    let mut grid = PairGrid::default();
    let mut last: Option<Approach> = None;
    (1..motion.times().len())
        .map(|k| {
            let piece = Piece { from: motion.sample(k - 1), to: motion.sample(k), times: [motion.times()[k - 1], motion.times()[k]] };
            let nearest = piece.nearest(&mut grid, last);
            last = Some(nearest);
            nearest
        })
        .collect()
}

/// One interval: everybody moves straight.
struct Piece<'a> {
    from: &'a [DVec2],
    to: &'a [DVec2],
    times: [f64; 2],
}

impl Piece<'_> {
    /// The last interval's pair bounds the distance from above, so only pairs that start near enough to beat it are looked at.
    fn nearest(&self, grid: &mut PairGrid, last: Option<Approach>) -> Approach {
        let longest = self.from.iter().zip(self.to).map(|(from, to)| from.distance(*to)).fold(0.0, f64::max);
        let mut best = self.approach(last.map_or((0, 1), |last| last.agents));
        if last.is_none() {
            self.improve(grid, self.typical_spacing(), &mut best);
        }
        let bound = best.distance + 2.0 * longest;
        self.improve(grid, bound, &mut best);
        best
    }

    fn improve(&self, grid: &mut PairGrid, radius: f64, best: &mut Approach) {
        grid.for_each_pair(self.from, radius, |a, b| {
            let candidate = self.approach((a, b));
            let rank = |approach: &Approach| (approach.distance, approach.time, approach.agents);
            if rank(&candidate) < rank(best) {
                *best = candidate;
            }
        });
    }

    /// The side of the square that an agent has to itself if all share their box evenly.
    fn typical_spacing(&self) -> f64 {
        let (low, high) = self.from.iter().fold((self.from[0], self.from[0]), |(low, high), p| (low.min(*p), high.max(*p)));
        let size = high - low;
        (size.x * size.y / self.from.len() as f64).sqrt()
    }

    fn approach(&self, (a, b): (u32, u32)) -> Approach {
        let start = self.from[a as usize] - self.from[b as usize];
        let way = self.to[a as usize] - self.to[b as usize] - start;
        let length_squared = way.length_squared();
        let t = if length_squared > 0.0 { (-start.dot(way) / length_squared).clamp(0.0, 1.0) } else { 0.0 };
        let time = self.times[0] + t * (self.times[1] - self.times[0]);
        Approach { distance: (start + t * way).length(), time, agents: (a, b) }
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn motion(samples: &[Vec<(f64, f64)>]) -> Motion {
        let times = (0..samples.len()).map(|k| k as f64).collect();
        Motion::new(times, samples[0].len(), samples.iter().flatten().map(|&(x, y)| DVec2::new(x, y)).collect())
    }

    #[test]
    fn two_agents_that_swap_places_meet_halfway_although_no_sample_sees_it() {
        let swap = motion(&[vec![(0.0, 0.0), (2.0, 0.0)], vec![(2.0, 0.0), (0.0, 0.0)]]);
        assert_eq!(approaches(&swap), [Approach { distance: 0.0, time: 0.5, agents: (0, 1) }]);
    }

    #[test]
    fn a_lone_agent_approaches_nobody() {
        assert_eq!(approaches(&motion(&[vec![(0.0, 0.0)], vec![(1.0, 0.0)]])), []);
    }

    proptest! {
        #[test]
        fn the_nearest_of_all_pairs_is_found(
            samples in (2usize..9).prop_flat_map(|agents| prop::collection::vec(prop::collection::vec((-9.0..9.0f64, -9.0..9.0f64), agents), 2..5)),
        ) {
            let motion = motion(&samples);
            for (k, found) in approaches(&motion).into_iter().enumerate() {
                let piece = Piece { from: motion.sample(k), to: motion.sample(k + 1), times: [k as f64, k as f64 + 1.0] };
                let agent_count = motion.agent_count() as u32;
                let least = (0..agent_count)
                    .flat_map(|a| (a + 1..agent_count).map(move |b| (a, b)))
                    .map(|pair| piece.approach(pair).distance)
                    .fold(f64::INFINITY, f64::min);
                prop_assert_eq!(found.distance, least);
            }
        }
    }
}
