//! What is still to be mended: what no keyframe is to blame for.

use super::breaches::{Breach, Other};
use super::obstacles::Blocked;
use super::shut::ShutOff;
use super::{SLACK, is_among};
use crate::motion::{Approach, Motion};

/// Agents that an obstacle blocks, that no keyframe has too near to it, and that have a way.
pub(super) fn open_blocks<'a>(blocked: &'a [Blocked], breaches: &[Breach], shut_off: &[ShutOff]) -> impl Iterator<Item = &'a Blocked> {
    let is_breach = |at: &Blocked| breaches.iter().any(|breach| breach.agent == at.agent && breach.other == Other::Obstacle(at.obstacle));
    blocked.iter().filter(move |at| !is_breach(at) && !is_among(shut_off, at.agent as usize))
}

/// Clashes of pairs that no keyframe has too near, in the sixth next to it; and none of both keyframes, unless they come nearer yet.
pub(super) fn open_clashes<'a>(clashes: &'a [Approach], breaches: &[Breach], motion: &Motion) -> impl Iterator<Item = &'a Approach> {
    let times = motion.times();
    let (start, end) = (times[0], times[times.len() - 1]);
    let is_excused = move |clash: &Approach| {
        let fraction = (clash.time - start) / (end - start);
        let at = |end: usize| {
            let is_pair = |breach: &&Breach| breach.other == Other::Agent(clash.agents.1) && breach.agent == clash.agents.0;
            breaches.iter().filter(|breach| breach.end == end).find(is_pair).map(|breach| breach.distance)
        };
        let ends = [at(0), at(1)];
        match ends {
            [Some(from), Some(to)] if clash.distance >= from.min(to) - SLACK => true,
            _ => ends[0].is_some() && fraction <= 1.0 / 6.0 || ends[1].is_some() && fraction >= 5.0 / 6.0,
        }
    };
    clashes.iter().filter(move |clash| !is_excused(clash))
}
