//! Who is too near in a keyframe already.

use glam::DVec2;
use serde::Serialize;

use super::Avoidance;
use crate::formation::PairSearch;
use crate::motion::Motion;
use crate::order;

/// An agent too near to another or to an obstacle at one end.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[serde(rename_all = "camelCase")]
pub struct Breach {
    /// 0 at the start, 1 at the end.
    pub end: usize,
    /// Who; of two agents the lower.
    pub agent: u32,
    /// To whom.
    pub other: Other,
    /// Meters; negative inside an obstacle.
    pub distance: f64,
}

/// What an agent is too near to.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "camelCase")]
pub enum Other {
    /// Another agent.
    Agent(u32),
    /// An obstacle, by number.
    Obstacle(u32),
}

/// Every breach at both ends of a motion, nearer than the minimum distance by more than `slack` meters; at most `limit` of them.
pub(super) fn breaches(motion: &Motion, avoidance: &Avoidance, slack: f64, limit: usize) -> Vec<Breach> {
    let mut breaches = Vec::new();
    let least = avoidance.minimum_distance - slack;
    let mut search = PairSearch::default();
    for (end, k) in [0, motion.times().len() - 1].into_iter().enumerate() {
        let at = motion.places(k);
        let first = breaches.len();
        search.for_each_within(at.plan(), least, |a, b, _| {
            let distance = at.distance(a as usize, b as usize);
            if distance < least && breaches.len() < limit {
                breaches.push(Breach { end, agent: a, other: Other::Agent(b), distance });
            }
        });
        order::sort_by_key(&mut breaches[first..], |breach| order::key_of_pair((breach.agent, other_number(breach.other))));
        covered(at.plan(), avoidance, least, |agent, obstacle, distance| {
            if breaches.len() < limit {
                breaches.push(Breach { end, agent, other: Other::Obstacle(obstacle), distance });
            }
        });
    }
    breaches
}

fn covered(at: &[DVec2], avoidance: &Avoidance, least: f64, mut visit: impl FnMut(u32, u32, f64)) {
    for (obstacle, outline) in (0..).zip(&avoidance.obstacles) {
        for (agent, place) in (0..).zip(at) {
            let (distance, _) = outline.clearance(place.to_array());
            if distance < least {
                visit(agent, obstacle, distance);
            }
        }
    }
}

fn other_number(other: Other) -> u32 {
    match other {
        Other::Agent(number) | Other::Obstacle(number) => number,
    }
}
