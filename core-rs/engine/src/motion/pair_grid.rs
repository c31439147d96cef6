//! Which agents are near each other, found by a uniform grid.

use glam::DVec2;

/// Cells of a grid, at most, per agent: a few far agents must not cost memory.
const CELLS_PER_AGENT: f64 = 4.0;

/// Visits near pairs. Its buffers serve every sample of a motion.
#[derive(Debug, Default)]
pub struct PairGrid {
    low: DVec2,
    cell: f64,
    columns: usize,
    rows: usize,
    /// Agents by cell, in runs that start at `starts`.
    agents: Vec<u32>,
    starts: Vec<u32>,
    cell_of: Vec<u32>,
}

impl PairGrid {
    /// Visits every pair a < b that may be at most `radius` apart, each once, in an order that depends on the positions alone.
    /// Some pairs that are farther apart are visited too.
    pub fn for_each_pair(&mut self, positions: &[DVec2], radius: f64, mut visit: impl FnMut(u32, u32)) {
        if positions.len() < 2 {
            return;
        }
        self.fill(positions, radius);
        for row in 0..self.rows {
            for column in 0..self.columns {
                let here = self.run(column, row);
                for (k, &a) in here.iter().enumerate() {
                    here[k + 1..].iter().for_each(|&b| visit(a.min(b), a.max(b)));
                }
                // Half of the neighbors: the other half visits this cell.
                for (right, up) in [(1, 0), (-1, 1), (0, 1), (1, 1)] {
                    let Some(other) = column.checked_add_signed(right).filter(|c| *c < self.columns) else { continue };
                    if row + up >= self.rows {
                        continue;
                    }
                    for &a in here {
                        self.run(other, row + up).iter().for_each(|&b| visit(a.min(b), a.max(b)));
                    }
                }
            }
        }
    }

    fn run(&self, column: usize, row: usize) -> &[u32] {
        let cell = row * self.columns + column;
        &self.agents[self.starts[cell] as usize..self.starts[cell + 1] as usize]
    }

    fn fill(&mut self, positions: &[DVec2], radius: f64) {
        let (low, high) = positions.iter().fold((positions[0], positions[0]), |(low, high), p| (low.min(*p), high.max(*p)));
        let size = high - low;
        let cells = CELLS_PER_AGENT * positions.len() as f64;
        // Of a long thin box the longer side alone may ask for too many cells.
        self.cell = radius.max((size.x * size.y / cells).sqrt()).max(size.max_element() / cells).max(f64::MIN_POSITIVE);
        self.low = low;
        self.columns = (size.x / self.cell) as usize + 1;
        self.rows = (size.y / self.cell) as usize + 1;
        self.cell_of.clear();
        self.starts.clear();
        self.starts.resize(self.columns * self.rows + 1, 0);
        for p in positions {
            let at = (*p - self.low) / self.cell;
            let cell = (at.y as usize).min(self.rows - 1) * self.columns + (at.x as usize).min(self.columns - 1);
            self.cell_of.push(cell as u32);
            self.starts[cell + 1] += 1;
        }
        for cell in 1..self.starts.len() {
            self.starts[cell] += self.starts[cell - 1];
        }
        self.agents.clear();
        self.agents.resize(positions.len(), 0);
        // Backward, so that each run ascends and its start ends where it belongs.
        let mut next: Vec<u32> = self.starts[1..].to_vec();
        for (agent, &cell) in self.cell_of.iter().enumerate().rev() {
            next[cell as usize] -= 1;
            self.agents[next[cell as usize] as usize] = agent as u32;
        }
    }
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use proptest::prelude::*;

    use super::*;

    proptest! {
        #[test]
        fn every_near_pair_is_visited_once(
            points in prop::collection::vec((-50.0..50.0f64, -3.0..3.0f64), 0..60),
            radius in 0.0..20.0f64,
        ) {
            let points: Vec<DVec2> = points.into_iter().map(|(x, y)| DVec2::new(x, y)).collect();
            let mut seen = Vec::new();
            PairGrid::default().for_each_pair(&points, radius, |a, b| seen.push((a, b)));
            let distinct: BTreeSet<_> = seen.iter().copied().collect();
            prop_assert_eq!(distinct.len(), seen.len());
            for a in 0..points.len() {
                for b in a + 1..points.len() {
                    let is_near = points[a].distance(points[b]) <= radius;
                    prop_assert!(!is_near || distinct.contains(&(a as u32, b as u32)), "{} and {}", a, b);
                }
            }
        }
    }

    #[test]
    fn coincident_and_far_agents_are_no_trouble() {
        let points = [DVec2::ZERO, DVec2::ZERO, DVec2::new(1e5, -1e5), DVec2::new(1e5, 1e5)];
        let mut seen = Vec::new();
        PairGrid::default().for_each_pair(&points, 0.0, |a, b| seen.push((a, b)));
        assert!(seen.contains(&(0, 1)));
    }
}
