//! Who may be near whom: agents sorted by the cells of a grid without borders.
//!
//! The rows of cells are wound around a ring of buckets, so that agents far away cost nothing, and neighbors along a row lie side by
//! side in memory. Cells that share a bucket are told apart by distance, which is looked at anyway; the rows next to a cell never
//! share its buckets, so no pair is met twice.

use std::ops::Range;

/// Buckets of the smallest ring: below this those that a cell looks into would not differ.
const LEAST_BUCKETS: usize = 64;

/// Buckets an agent, at least.
const BUCKETS_PER_AGENT: usize = 2;

/// How far along the ring the next row begins, as a share of it: neither once nor twice that share is near a whole turn.
const ROW_SHARE: f64 = 0.382;

/// Agents by cell.
#[derive(Clone, Debug)]
pub struct Cells {
    row: usize,
    /// Where each bucket starts among the members; the end at last.
    starts: Vec<u32>,
    bucket_of: Vec<u32>,
    members: Vec<u32>,
}

/// Places among the members that hold everybody who may be near those of one bucket and come after them on the ring.
pub struct Around {
    /// The bucket itself.
    pub own: Range<usize>,
    /// Its row: from its own start on.
    pub row: [Range<usize>; 2],
    /// The row behind.
    pub behind: [Range<usize>; 2],
}

impl Cells {
    pub fn new(agent_count: usize) -> Self {
        let buckets = (BUCKETS_PER_AGENT * agent_count).next_power_of_two().max(LEAST_BUCKETS);
        Self {
            row: (ROW_SHARE * buckets as f64) as usize | 1,
            starts: vec![0; buckets + 1],
            bucket_of: vec![0; agent_count],
            members: vec![0; agent_count],
        }
    }

    /// Agents by bucket.
    pub fn members(&self) -> &[u32] {
        &self.members
    }

    /// Sorts agents anew, for pairs nearer than the cells' `size`.
    pub fn sort(&mut self, x: &[f64], y: &[f64], size: f64) {
        let (mask, row) = (self.mask(), self.row as u64);
        self.starts.fill(0);
        for (bucket_of, (x, y)) in self.bucket_of.iter_mut().zip(x.iter().zip(y)) {
            // Around the ring a number below zero is one from its end.
            let [column, line] = [x, y].map(|along| ((along / size).floor() as i64).cast_unsigned());
            let bucket = column.wrapping_add(line.wrapping_mul(row)) as usize & mask;
            *bucket_of = bucket as u32;
            self.starts[bucket] += 1;
        }
        let mut start = 0;
        for count in &mut self.starts {
            let own = std::mem::replace(count, start);
            start += own;
        }
        for (agent, bucket) in self.bucket_of.iter().enumerate() {
            let next = &mut self.starts[*bucket as usize];
            self.members[*next as usize] = agent as u32;
            *next += 1;
        }
        // Each start has become the next one's.
        self.starts.rotate_right(1);
        self.starts[0] = 0;
    }

    /// For every bucket that is not empty where to look for pairs: each pair is met once.
    pub fn around(&self) -> impl Iterator<Item = Around> {
        let run = |from: u32, end: u32| from as usize..end as usize;
        let buckets = self.starts.windows(2).enumerate().filter(|(_, ends)| ends[0] < ends[1]);
        buckets.map(move |(bucket, ends)| Around {
            own: run(ends[0], ends[1]),
            row: self.stretch(bucket, 2),
            behind: self.stretch(bucket + self.row - 1, 3),
        })
    }

    /// So many buckets from one on; two runs where they pass the ring's end.
    fn stretch(&self, from: usize, buckets: usize) -> [Range<usize>; 2] {
        let (mask, start) = (self.mask(), |bucket: usize| self.starts[bucket] as usize);
        let (from, end) = (from & mask, (from & mask) + buckets);
        if end <= mask + 1 { [start(from)..start(end), 0..0] } else { [start(from)..self.members.len(), 0..start(end & mask)] }
    }

    fn mask(&self) -> usize {
        self.starts.len() - 2
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    proptest! {
        #[test]
        fn every_near_pair_is_met_once(places in prop::collection::vec((-9_i32..9, -9_i32..9), 0..90), far in prop_oneof![Just(0.0), Just(9e5)]) {
            const RANGE: f64 = 1.5;
            let mut x: Vec<f64> = places.iter().map(|place| 0.7 * f64::from(place.0)).collect();
            let mut y: Vec<f64> = places.iter().map(|place| 0.7 * f64::from(place.1)).collect();
            x.push(far);
            y.push(-far);
            let is_near = |a: usize, b: usize| (x[a] - x[b]).powi(2) + (y[a] - y[b]).powi(2) < RANGE * RANGE;
            let mut cells = Cells::new(x.len());
            cells.sort(&x, &y, RANGE);
            let mut met = Vec::new();
            for Around { own, row: [row, rest], behind } in cells.around() {
                for here in own {
                    let others = (here + 1..row.end).chain(rest.clone()).chain(behind.iter().cloned().flatten());
                    let pairs = others.map(|there| [here, there].map(|place| cells.members()[place] as usize));
                    met.extend(pairs.filter(|[a, b]| is_near(*a, *b)).map(|[a, b]| (a.min(b), a.max(b))));
                }
            }
            met.sort_unstable();
            let all = (0..x.len()).flat_map(|a| (a + 1..x.len()).map(move |b| (a, b)));
            prop_assert_eq!(met, all.filter(|&(a, b)| is_near(a, b)).collect::<Vec<_>>());
        }
    }
}
