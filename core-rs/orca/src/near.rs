//! Who is near whom: agents by the cell they are in, cells as wide as sight.

use std::collections::BTreeMap;

/// Agents by cell.
pub struct Near {
    sight: f64,
    cells: BTreeMap<(i64, i64), Vec<usize>>,
    places: Vec<[f64; 2]>,
}

impl Near {
    /// Nobody is there yet.
    pub fn new(sight: f64) -> Self {
        Self { sight, cells: BTreeMap::new(), places: Vec::new() }
    }

    /// Everybody is where they are now.
    pub fn sort(&mut self, x: &[f64], y: &[f64]) {
        self.places = x.iter().zip(y).map(|(x, y)| [*x, *y]).collect();
        self.cells.clear();
        for (agent, at) in self.places.iter().enumerate() {
            self.cells.entry(self.cell(*at)).or_default().push(agent);
        }
    }

    fn cell(&self, [x, y]: [f64; 2]) -> (i64, i64) {
        ((x / self.sight).floor() as i64, (y / self.sight).floor() as i64)
    }

    /// The nearest others within sight, at most so many, the nearest first; of equally near ones the lowest index.
    pub fn nearest(&self, agent: usize, most: usize) -> Vec<usize> {
        let at = self.places[agent];
        let (column, row) = self.cell(at);
        let cells = (row - 1..=row + 1).flat_map(|row| (column - 1..=column + 1).filter_map(move |column| self.cells.get(&(column, row))));
        let mut near: Vec<(f64, usize)> = cells
            .flatten()
            .filter(|other| **other != agent)
            .map(|other| (distance_squared(at, self.places[*other]), *other))
            .filter(|(distance, _)| *distance < self.sight * self.sight)
            .collect();
        near.sort_unstable_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        near.truncate(most);
        near.into_iter().map(|(_, other)| other).collect()
    }
}

fn distance_squared(a: [f64; 2], b: [f64; 2]) -> f64 {
    (a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_nearest_within_sight_are_found_across_cells_and_no_others() {
        let x = [0.9, 1.1, -0.9, 2.8, 0.9, 1.8];
        let mut near = Near::new(1.0);
        near.sort(&x, &[0.0; 6]);
        assert_eq!(near.nearest(0, 9), [4, 1, 5]);
        assert_eq!(near.nearest(0, 2), [4, 1]);
        assert!(near.nearest(2, 9).is_empty());
    }
}
