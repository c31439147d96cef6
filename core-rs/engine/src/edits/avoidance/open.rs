//! What is still to be mended: what no keyframe is to blame for.

use super::breaches::{Breach, Other};
use super::is_among;
use super::obstacles::Blocked;
use super::shut::ShutOff;
use crate::motion::{Approach, Motion};

/// Agents that an obstacle blocks, that no keyframe has too near to it, and that have a way.
pub(super) fn open_blocks<'a>(blocked: &'a [Blocked], breaches: &[Breach], shut_off: &[ShutOff]) -> impl Iterator<Item = &'a Blocked> {
    let is_breach = |at: &Blocked| breaches.iter().any(|breach| breach.agent == at.agent && breach.other == Other::Obstacle(at.obstacle));
    blocked.iter().filter(move |at| !is_breach(at) && !is_among(shut_off, at.agent as usize))
}

/// Clashes of pairs that no keyframe has too near, in the sixth next to it.
pub(super) fn open_clashes<'a>(clashes: &'a [Approach], breaches: &[Breach], motion: &Motion) -> impl Iterator<Item = &'a Approach> {
    let times = motion.times();
    let (start, end) = (times[0], times[times.len() - 1]);
    let is_excused = move |clash: &Approach| {
        let fraction = (clash.time - start) / (end - start);
        breaches.iter().any(|breach| {
            let is_pair = breach.other == Other::Agent(clash.agents.1) && breach.agent == clash.agents.0;
            is_pair && if breach.end == 0 { fraction <= 1.0 / 6.0 } else { fraction >= 5.0 / 6.0 }
        })
    };
    clashes.iter().filter(move |clash| !is_excused(clash))
}
