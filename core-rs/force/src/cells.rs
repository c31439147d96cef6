//! Who is near whom: a uniform grid without borders.
//!
//! The rows of cells are wound around a ring of buckets, so that agents far away cost nothing. Cells that share a bucket are told apart
//! by distance, which is looked at anyway; the rows next to a cell never share its buckets, so no pair is met twice.

/// Buckets of the smallest ring: below this the five that a cell looks into would not differ.
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
    /// Agents by bucket, and where they are.
    members: Vec<u32>,
    x: Vec<f64>,
    y: Vec<f64>,
}

/// Two agents near one another: `way` leads from the second to the first.
pub struct Near {
    pub agents: [usize; 2],
    pub way: [f64; 2],
    pub distance_squared: f64,
}

impl Cells {
    pub fn new(agent_count: usize) -> Self {
        let buckets = (BUCKETS_PER_AGENT * agent_count).next_power_of_two().max(LEAST_BUCKETS);
        Self {
            row: (ROW_SHARE * buckets as f64) as usize | 1,
            starts: vec![0; buckets + 1],
            bucket_of: vec![0; agent_count],
            members: vec![0; agent_count],
            x: vec![0.0; agent_count],
            y: vec![0.0; agent_count],
        }
    }

    /// Visits every pair nearer than `range` once, always in the same order.
    pub fn for_each_pair(&mut self, x: &[f64], y: &[f64], range: f64, mut visit: impl FnMut(Near)) {
        self.sort(x, y, range);
        let buckets = self.starts.len() - 1;
        let row = self.row;
        let range_squared = range * range;
        for bucket in 0..buckets {
            let (from, end) = (self.starts[bucket] as usize, self.starts[bucket + 1] as usize);
            for here in from..end {
                let (at_x, at_y) = (self.x[here], self.y[here]);
                let mut meet = |range: std::ops::Range<usize>| {
                    for there in range {
                        let way = [at_x - self.x[there], at_y - self.y[there]];
                        let distance_squared = way[0] * way[0] + way[1] * way[1];
                        if distance_squared < range_squared {
                            let agents = [here, there].map(|place| self.members[place] as usize);
                            visit(Near { agents, way, distance_squared });
                        }
                    }
                };
                meet(here + 1..end);
                for step in [1, row - 1, row, row + 1] {
                    let next = (bucket + step) & (buckets - 1);
                    meet(self.starts[next] as usize..self.starts[next + 1] as usize);
                }
            }
        }
    }

    fn sort(&mut self, x: &[f64], y: &[f64], size: f64) {
        let mask = self.starts.len() - 2;
        self.starts.fill(0);
        for (bucket_of, (x, y)) in self.bucket_of.iter_mut().zip(x.iter().zip(y)) {
            // Around the ring a number below zero is one from its end.
            let [column, line] = [x, y].map(|along| ((along / size).floor() as i64).cast_unsigned());
            let bucket = column.wrapping_add(line.wrapping_mul(self.row as u64)) as usize & mask;
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
            let place = *next as usize;
            (self.members[place], self.x[place], self.y[place]) = (agent as u32, x[agent], y[agent]);
            *next += 1;
        }
        // Each start has become the next one's.
        self.starts.rotate_right(1);
        self.starts[0] = 0;
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    proptest! {
        #[test]
        fn every_near_pair_is_met_once(places in prop::collection::vec((-9_i32..9, -9_i32..9), 0..90), far in prop_oneof![Just(0.0), Just(9e5)]) {
            let mut x: Vec<f64> = places.iter().map(|place| 0.7 * f64::from(place.0)).collect();
            let mut y: Vec<f64> = places.iter().map(|place| 0.7 * f64::from(place.1)).collect();
            x.push(far);
            y.push(-far);
            let mut met = Vec::new();
            Cells::new(x.len()).for_each_pair(&x, &y, 1.5, |near| {
                let [a, b] = near.agents;
                met.push((a.min(b), a.max(b)));
            });
            met.sort_unstable();
            let is_near = |a: usize, b: usize| (x[a] - x[b]).powi(2) + (y[a] - y[b]).powi(2) < 2.25;
            let all = (0..x.len()).flat_map(|a| (a + 1..x.len()).map(move |b| (a, b)));
            prop_assert_eq!(met, all.filter(|&(a, b)| is_near(a, b)).collect::<Vec<_>>());
        }
    }
}
