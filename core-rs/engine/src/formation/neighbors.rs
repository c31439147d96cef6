//! Pairs of points near one another.
//!
//! A sparse grid: cells are kept by sorting, so a point far away from all others costs nothing. It lies in plan: in space nobody is
//! nearer than seen from above, so what is near is among what it visits.

use glam::DVec2;

use super::{Places, bounds};
use crate::order;

/// Cells a side at most: row and column take 20 bits each.
const CELLS_A_SIDE: f64 = (1u32 << 19) as f64;

/// What is left of a key for the agent.
const AGENT_BITS: u32 = 24;

/// The same in bytes.
const AGENT_BYTES: usize = 3;

/// Keys of cells that are neighbors in a row differ by this.
const COLUMN: u64 = 1 << AGENT_BITS;

/// Keys of cells that are neighbors in a column differ by this.
const ROW: u64 = 1 << (AGENT_BITS + 20);

/// Finds near pairs; its buffers serve every search.
#[derive(Default)]
pub struct PairSearch {
    /// Row, column and agent of every point, ascending: plain numbers sort fastest.
    keys: Vec<u64>,
    /// For sorting them.
    spare: Vec<u64>,
    /// Points in the order of the keys.
    places: Vec<DVec2>,
}

impl PairSearch {
    /// Visits every pair a < b of `points` at most `radius` meters apart once, always in the same order, with its squared distance.
    ///
    /// O(n + pairs within two radii), whatever lies far away.
    pub fn for_each_within(&mut self, points: &[DVec2], radius: f64, mut visit: impl FnMut(u32, u32, f64)) {
        self.sort_into_cells(points, radius);
        let radius_squared = radius * radius;
        let agent = |key: u64| (key % COLUMN) as u32;
        // From the cell above and before; row and column 0 stay free, so that nothing wraps.
        let mut above = 0;
        for (here, (&key, &at)) in self.keys.iter().zip(&self.places).enumerate() {
            let cell = key - key % COLUMN;
            while self.keys.get(above).is_some_and(|&other| other < cell + ROW - COLUMN) {
                above += 1;
            }
            let mut meet = |from: usize, end: u64| {
                for (&other_key, &other) in self.keys[from..].iter().zip(&self.places[from..]) {
                    if other_key >= end {
                        break;
                    }
                    let distance_squared = at.distance_squared(other);
                    if distance_squared <= radius_squared {
                        let (a, b) = (agent(key), agent(other_key));
                        visit(a.min(b), a.max(b), distance_squared);
                    }
                }
            };
            meet(here + 1, cell + 2 * COLUMN);
            meet(above, cell + ROW + 2 * COLUMN);
        }
    }

    fn sort_into_cells(&mut self, points: &[DVec2], radius: f64) {
        assert!(points.len() as u64 <= COLUMN, "agents fit their bits");
        let (low, high) = bounds(points);
        // A hair wider than the radius, or rounding could put a pair just that far apart two cells apart.
        let size = (1.0 + 1e-9) * radius.max((high - low).max_element() / CELLS_A_SIDE);
        let per_meter = if size > 0.0 { 1.0 / size } else { 0.0 };
        self.keys.clear();
        self.keys.extend((0..).zip(points).map(|(agent, &at)| {
            let cell = (at - low) * per_meter;
            (cell.y as u64 + 1) * ROW + (cell.x as u64 + 1) * COLUMN + agent
        }));
        // By row and column; agents ascend already.
        order::sort_by_bytes(&mut self.keys, &mut self.spare, AGENT_BYTES..size_of::<u64>(), |key, place| key.to_le_bytes()[place]);
        self.places.clear();
        self.places.extend(self.keys.iter().map(|&key| points[(key % COLUMN) as usize]));
    }
}

/// Two agents that are near one another, though not always the nearest: what they are apart bounds the least distance from above.
/// The lower index first; none below two agents.
pub fn near_pair(places: Places<'_>) -> Option<(u32, u32)> {
    let at = |agent: u32| places.at(agent as usize);
    let mut order = order::by_key(places.iter().map(|at| u128::from(order::of_real(at.z))));
    order::sort_by_key(&mut order, |&agent| order::key_of_two(order::of_real(at(agent).x), order::of_real(at(agent).y)));
    let distance = |pair: (u32, u32)| at(pair.0).distance_squared(at(pair.1));
    let pairs = order.windows(2).map(|pair| (pair[0].min(pair[1]), pair[0].max(pair[1])));
    pairs.min_by(|&p, &q| distance(p).total_cmp(&distance(q)))
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn near_pairs(points: &[DVec2], radius: f64) -> Vec<(u32, u32)> {
        let mut pairs = Vec::new();
        PairSearch::default().for_each_within(points, radius, |a, b, _| pairs.push((a, b)));
        pairs.sort_unstable();
        pairs
    }

    fn near_pairs_by_trying_all(points: &[DVec2], radius: f64) -> Vec<(u32, u32)> {
        let all = (0..points.len()).flat_map(|a| (a + 1..points.len()).map(move |b| (a, b)));
        all.filter(|&(a, b)| points[a].distance_squared(points[b]) <= radius * radius).map(|(a, b)| (a as u32, b as u32)).collect()
    }

    proptest! {
        #[test]
        fn every_near_pair_is_visited_once(
            points in prop::collection::vec((-20i32..20, -20i32..20), 0..60),
            (step, far) in (prop_oneof![Just(0.25), Just(1e-7)], prop_oneof![Just(0.0), Just(9e4)]),
            radius in 0.0..30.0f64,
        ) {
            // Whole radii put pairs exactly at the radius and points exactly at the edge of a cell.
            let radius = radius.floor() * step;
            let mut points: Vec<DVec2> = points.iter().map(|&(x, y)| DVec2::new(f64::from(x), f64::from(y)) * step).collect();
            points.push(DVec2::new(far, -far));
            prop_assert_eq!(near_pairs(&points, radius), near_pairs_by_trying_all(&points, radius));
        }
    }
}
