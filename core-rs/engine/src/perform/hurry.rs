//! Who has to be faster than they can, to be where a keyframe has them in time: keyframes are never moved, so it is said.

use serde::Serialize;

use crate::motion::Motion;
use crate::scene::Agent;

/// A hundredth more than one can is nothing that anybody sees: the last stretch of a crowd leads back onto its guide, a little faster.
const UNSEEN: f64 = 1.01;

/// Durations are offered in tenths of a second.
const TENTHS: f64 = 10.0;

/// An agent that is faster than it can be.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[serde(rename_all = "camelCase")]
pub struct Hurry {
    /// Who.
    pub agent: u32,
    /// At its fastest, meters a second.
    pub speed: f64,
    /// Its top speed, meters a second.
    pub max_speed: f64,
    /// How long the segment would take without hurry, seconds.
    pub duration: f64,
}

/// Everybody whose greatest speed in a motion is above their own limit, by number.
pub(super) fn hurried(motion: &Motion, agents: &[Agent]) -> Vec<Hurry> {
    let times = motion.times();
    let speed = |agent: usize| {
        let step = |k: usize| motion.places(k).at(agent).distance(motion.places(k - 1).at(agent)) / (times[k] - times[k - 1]);
        (1..times.len()).map(step).fold(0.0, f64::max)
    };
    let limited = agents.iter().enumerate().filter_map(|(agent, body)| Some((agent, body.max_speed?)));
    let hurried = limited.map(|(agent, max_speed)| (agent, speed(agent), max_speed)).filter(|(_, speed, most)| *speed > UNSEEN * most);
    let seconds = times[times.len() - 1] - times[0];
    hurried
        .map(|(agent, speed, max_speed)| {
            let duration = (seconds * speed / max_speed * TENTHS).ceil() / TENTHS;
            Hurry { agent: agent as u32, speed, max_speed, duration }
        })
        .collect()
}
