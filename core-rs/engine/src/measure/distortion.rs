//! How far ties are from the lengths that are due.

use crate::adjacency::Adjacency;
use crate::formation::Places;
use crate::motion::Motion;
use crate::order;

/// A tie that is due this short, relative to the extent, has no length to be true to.
const NO_LENGTH: f64 = 1e-9;

/// The ties of both ends with their mean weights; a tie that one end lacks has weight 0 there.
pub(super) struct Distortion {
    ties: Vec<Due>,
    least_length: f64,
}

/// A tie and its lengths at both ends.
struct Due {
    a: usize,
    b: usize,
    weight: f64,
    start: f64,
    end: f64,
}

impl Distortion {
    /// Reference lengths are those of the motion's first and last sample.
    pub(super) fn new(motion: &Motion, graphs: [&Adjacency; 2]) -> Self {
        let [first, last] = [0, motion.times().len() - 1].map(|k| motion.places(k));
        let mut halves: Vec<(u32, u32, f64)> =
            graphs.iter().flat_map(|graph| graph.ties()).map(|tie| (tie.a, tie.b, 0.5 * tie.weight)).collect();
        order::sort_by_key(&mut halves, |&(a, b, _)| order::key_of_pair((a, b)));
        let ties = halves
            .chunk_by(|p, q| (p.0, p.1) == (q.0, q.1))
            .map(|same| {
                let (a, b) = (same[0].0 as usize, same[0].1 as usize);
                let weight = same.iter().map(|half| half.2).sum();
                Due { a, b, weight, start: first.distance(a, b), end: last.distance(a, b) }
            })
            .collect();
        Self { ties, least_length: NO_LENGTH * motion.extent() }
    }

    /// D(t) at every sample: Σ w |length / due length − 1| / Σ w, the due length running straight from end to end; 0 without ties.
    pub(super) fn curve(&self, motion: &Motion, ts: &[f64]) -> Vec<f64> {
        ts.iter().enumerate().map(|(k, t)| self.at(motion.places(k), *t)).collect()
    }

    fn at(&self, places: Places<'_>, t: f64) -> f64 {
        let (mut sum, mut weights) = (0.0, 0.0);
        for tie in &self.ties {
            let due = (1.0 - t) * tie.start + t * tie.end;
            if due < self.least_length || due == 0.0 {
                continue;
            }
            sum += tie.weight * (places.distance(tie.a, tie.b) / due - 1.0).abs();
            weights += tie.weight;
        }
        if weights > 0.0 { sum / weights } else { 0.0 }
    }
}
