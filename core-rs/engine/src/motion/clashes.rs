//! Every meeting of two agents that is too near, between samples too.

use super::Motion;
use super::closest::{Approach, apart_in_space, nearest_approach};
use super::pair_list::PairList;
use crate::order;

/// A list of more would tell a person nothing; meters and seconds of the first ones do.
const LIMIT: usize = 10_000;

/// A pair that was too near in the piece before.
struct Open {
    pair: (u32, u32),
    nearest: Approach,
}

/// Every meeting nearer than `limit` meters at its nearest: one for a pair and a run of pieces in which it stays so near. By time,
/// then by pair; only the first 10,000 to end are kept.
///
/// Exact for the straight pieces between samples: an empty list is a proof.
pub fn clashes(motion: &Motion, limit: f64) -> Vec<Approach> {
    let mut clashes = Vec::new();
    let sample_count = motion.times().len();
    if sample_count < 2 || motion.agent_count() < 2 || limit <= 0.0 {
        return clashes;
    }
    let mut list = PairList::default();
    let (mut open, mut still_open): (Vec<Open>, Vec<Open>) = (Vec::new(), Vec::new());
    let mut near: Vec<Approach> = Vec::new();
    for k in 1..sample_count {
        let ends = [motion.places(k - 1), motion.places(k)];
        let [start, end] = [motion.times()[k - 1], motion.times()[k]];
        near.clear();
        list.for_each(motion, [k - 1, k], limit, |a, b| {
            let (distance_squared, t) = nearest_approach(apart_in_space(ends, (a, b)));
            if distance_squared < limit * limit {
                near.push(Approach { distance: distance_squared.sqrt(), time: start + t * (end - start), agents: (a, b) });
            }
        });
        order::sort_by_key(&mut near, |approach| order::key_of_pair(approach.agents));
        let mut before = open.drain(..).peekable();
        for approach in near.drain(..) {
            while let Some(ended) = before.next_if(|known| known.pair < approach.agents) {
                keep(&mut clashes, ended.nearest);
            }
            let known = before.next_if(|known| known.pair == approach.agents).map(|known| known.nearest);
            let nearest = known.filter(|known| known.distance <= approach.distance).unwrap_or(approach);
            still_open.push(Open { pair: approach.agents, nearest });
        }
        before.for_each(|ended| keep(&mut clashes, ended.nearest));
        std::mem::swap(&mut open, &mut still_open);
    }
    for last in open {
        keep(&mut clashes, last.nearest);
    }
    order::sort_by_key(&mut clashes, |clash| {
        let (a, b) = clash.agents;
        order::key_of_two(order::of_real(clash.time), u64::from(a) << 32 | u64::from(b))
    });
    clashes
}

fn keep(clashes: &mut Vec<Approach>, clash: Approach) {
    if clashes.len() < LIMIT {
        clashes.push(clash);
    }
}

#[cfg(test)]
mod tests {
    use glam::DVec2;

    use super::*;

    fn line(ways: &[&[f64]]) -> Motion {
        let count = ways[0].len();
        let positions = (0..count).flat_map(|k| ways.iter().map(move |way| DVec2::new(way[k], 0.0))).collect();
        Motion::new((0..count).map(|k| k as f64).collect(), ways.len(), positions)
    }

    #[test]
    fn a_pair_that_parts_and_meets_again_clashes_twice() {
        let motion = line(&[&[0.0, 0.0, 0.0, 0.0, 0.0, 0.0], &[0.4, 0.3, 0.35, 2.0, 2.0, 0.2]]);
        let found = clashes(&motion, 0.5);
        let expected = [(0.3, 1.0), (0.2, 5.0)].map(|(distance, time)| Approach { distance, time, agents: (0, 1) });
        assert_eq!(found, expected);
    }

    #[test]
    fn a_clash_between_samples_is_found_and_touching_is_none() {
        assert_eq!(clashes(&line(&[&[0.0, 2.0], &[2.0, 0.0]]), 0.5), [Approach { distance: 0.0, time: 0.5, agents: (0, 1) }]);
        assert_eq!(clashes(&line(&[&[0.0, 2.0], &[0.5, 2.5]]), 0.5), []);
        assert_eq!(clashes(&line(&[&[0.0, 2.0], &[0.0, 2.0]]), 0.0), []);
    }
}
