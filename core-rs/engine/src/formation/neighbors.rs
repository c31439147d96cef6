//! Pairs of points near one another.
//!
//! A sparse grid: cells are kept by sorting, so a point far away from all others costs nothing.

use glam::DVec2;

use super::bounds;

/// Cells a side at most, so that a cell's row and column fit one key.
const CELLS_A_SIDE: f64 = (1u32 << 20) as f64;

/// Finds near pairs; its buffer serves every search.
#[derive(Default)]
pub struct PairSearch {
    slots: Vec<Slot>,
}

struct Slot {
    /// Row and column: neighbors in a row differ by 1, neighbors in a column by [`ROW`].
    cell: u64,
    agent: u32,
    at: DVec2,
}

const ROW: u64 = 1 << 32;

impl PairSearch {
    /// Visits every pair a < b of `points` at most `radius` meters apart once, always in the same order, with its squared distance.
    ///
    /// O(n log n + pairs within two radii), whatever lies far away.
    pub fn for_each_within(&mut self, points: &[DVec2], radius: f64, mut visit: impl FnMut(u32, u32, f64)) {
        self.sort_into_cells(points, radius);
        let radius_squared = radius * radius;
        let slots = &self.slots[..];
        let mut above = 0;
        for (place, slot) in slots.iter().enumerate() {
            let here = slots[place + 1..].iter().take_while(|other| other.cell <= slot.cell + 1);
            while slots.get(above).is_some_and(|other| other.cell + 1 < slot.cell + ROW) {
                above += 1;
            }
            let next_row = slots[above..].iter().take_while(|other| other.cell <= slot.cell + ROW + 1);
            for other in here.chain(next_row) {
                let distance_squared = slot.at.distance_squared(other.at);
                if distance_squared <= radius_squared {
                    visit(slot.agent.min(other.agent), slot.agent.max(other.agent), distance_squared);
                }
            }
        }
    }

    fn sort_into_cells(&mut self, points: &[DVec2], radius: f64) {
        let (low, high) = bounds(points);
        // A hair wider than the radius, or rounding could put a pair just that far apart two cells apart.
        let size = (1.0 + 1e-9) * radius.max((high - low).max_element() / CELLS_A_SIDE);
        let per_meter = if size > 0.0 { 1.0 / size } else { 0.0 };
        self.slots.clear();
        self.slots.extend((0..).zip(points).map(|(agent, &at)| {
            let cell = (at - low) * per_meter;
            Slot { cell: cell.y as u64 * ROW + cell.x as u64, agent, at }
        }));
        self.slots.sort_unstable_by_key(|slot| (slot.cell, slot.agent));
    }
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
