//! The messages of affinity propagation (Frey and Dueck, "Clustering by passing messages between data points", 2007).

/// Who would stand for whom: responsibilities and availabilities of every agent (row) toward every other and itself (column).
pub struct Messages {
    size: usize,
    similarities: Vec<f64>,
    responsibilities: Vec<f64>,
    availabilities: Vec<f64>,
    /// By column: its own responsibility, and the positive ones of others.
    sums: Vec<f64>,
    /// Room for one row.
    row: Vec<f64>,
}

impl Messages {
    /// No message yet. `similarities`: row by row, at most 0 beside the diagonal, on which each agent's preference stands.
    ///
    /// # Panics
    /// When they are no square of two or more: a bug, not input.
    pub fn new(size: usize, similarities: Vec<f64>) -> Self {
        assert!(size > 1 && similarities.len() == size * size, "two or more agents, each with all");
        let zeros = vec![0.0; size * size];
        let (sums, row) = (vec![0.0; size], vec![0.0; size]);
        Self { size, similarities, responsibilities: zeros.clone(), availabilities: zeros, sums, row }
    }

    /// One round: every message becomes `damping` of itself and the rest of what the others make it.
    ///
    /// A row's availabilities follow from the responsibilities before, so both are passed in one sweep.
    pub fn pass(&mut self, damping: f64) {
        let (size, fresh) = (self.size, 1.0 - damping);
        let mut sums = vec![0.0; size];
        let rows = self.responsibilities.chunks_exact_mut(size).zip(self.availabilities.chunks_exact_mut(size));
        for (own, ((r, a), s)) in rows.zip(self.similarities.chunks_exact(size)).enumerate() {
            let self_availability = availability(damping, a[own], self.sums[own] - r[own]);
            for ((a, r), sum) in a.iter_mut().zip(&*r).zip(&self.sums) {
                let others = sum - positive(*r);
                *a = availability(damping, *a, if others < 0.0 { others } else { 0.0 });
            }
            a[own] = self_availability;
            for ((out, a), s) in self.row.iter_mut().zip(&*a).zip(s) {
                *out = a + s;
            }
            let best = greatest(&self.row);
            let at = self.row.iter().position(|value| *value == best).unwrap_or(own);
            self.row[at] = f64::NEG_INFINITY;
            let toward_best = damping * r[at] + fresh * (s[at] - greatest(&self.row));
            for (r, s) in r.iter_mut().zip(s) {
                *r = damping * *r + fresh * (s - best);
            }
            r[at] = toward_best;
            for (sum, r) in sums.iter_mut().zip(&*r) {
                *sum += positive(*r);
            }
            sums[own] += r[own] - positive(r[own]);
        }
        self.sums = sums;
    }

    /// How much speaks for each agent to stand for itself and others: above 0 it does.
    pub fn evidence(&self, damping: f64) -> impl Iterator<Item = f64> {
        (0..self.size).map(move |own| {
            let at = own * (self.size + 1);
            let responsibility = self.responsibilities[at];
            responsibility + availability(damping, self.availabilities[at], self.sums[own] - responsibility)
        })
    }
}

fn availability(damping: f64, before: f64, now: f64) -> f64 {
    damping * before + (1.0 - damping) * now
}

fn positive(value: f64) -> f64 {
    if value > 0.0 { value } else { 0.0 }
}

/// In lanes, so that it becomes vector instructions.
fn greatest(values: &[f64]) -> f64 {
    let (chunks, rest) = values.as_chunks::<8>();
    let mut lanes = [f64::NEG_INFINITY; 8];
    for chunk in chunks {
        for (lane, &value) in lanes.iter_mut().zip(chunk) {
            *lane = if value > *lane { value } else { *lane };
        }
    }
    lanes.iter().chain(rest).copied().fold(f64::NEG_INFINITY, f64::max)
}
