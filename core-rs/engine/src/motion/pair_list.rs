//! Near pairs, listed once for many pieces of a motion.

use glam::DVec2;

use super::Motion;
use crate::formation::PairSearch;

/// Lists of more pairs an agent are not kept.
const PAIRS_PER_AGENT: usize = 24;

/// Pairs that were near at one sample. The list serves as long as nobody has moved far enough for another pair to come near.
#[derive(Default)]
pub(super) struct PairList {
    search: PairSearch,
    pairs: Vec<(u32, u32)>,
    /// The sample of the list; none when there is no list.
    listed_at: Option<usize>,
    /// The list has every pair at most this far apart there.
    reach: f64,
    /// How far anyone has moved since, at the start of the next piece.
    moved: f64,
}

impl PairList {
    /// Visits at least every pair that comes within `radius` between two samples, once each. Pieces must be visited in order.
    pub(super) fn for_each(&mut self, motion: &Motion, [start, end]: [usize; 2], radius: f64, mut visit: impl FnMut(u32, u32)) {
        let moved = self.listed_at.map_or(f64::INFINITY, |listed| greatest_shift(motion.sample(listed), motion.sample(end)));
        // Straight pieces stay between their ends, and both of a pair may move.
        let is_complete = radius + 2.0 * self.moved.max(moved) <= self.reach;
        self.moved = moved;
        if !is_complete && !self.list(motion, [start, end], radius) {
            self.search.for_each_within(motion.sample(start), self.reach, |a, b, _| visit(a, b));
            return;
        }
        for &(a, b) in &self.pairs {
            visit(a, b);
        }
    }

    /// Lists anew with some reach to spare; whether there are few enough pairs to keep.
    fn list(&mut self, motion: &Motion, [start, end]: [usize; 2], radius: f64) -> bool {
        self.moved = greatest_shift(motion.sample(start), motion.sample(end));
        self.reach = (radius + f64::max(2.0 * self.moved, radius / 2.0)) * (1.0 + 1e-9);
        let limit = PAIRS_PER_AGENT * motion.agent_count();
        let (pairs, mut count) = (&mut self.pairs, 0);
        pairs.clear();
        self.search.for_each_within(motion.sample(start), self.reach, |a, b, _| {
            count += 1;
            if count <= limit {
                pairs.push((a, b));
            }
        });
        self.listed_at = (count <= limit).then_some(start);
        self.listed_at.is_some()
    }
}

/// How far anyone moves beyond what all do together.
fn greatest_shift(from: &[DVec2], to: &[DVec2]) -> f64 {
    let common = from.iter().zip(to).map(|(&from, &to)| to - from).sum::<DVec2>() / from.len() as f64;
    from.iter().zip(to).map(|(&from, &to)| (to - from - common).length_squared()).fold(0.0, f64::max).sqrt()
}
