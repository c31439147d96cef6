//! A deviation, and who is still too near under it.

use eigenform_apart::Paths;

use super::Avoidance;
use super::breaches::{Breach, Other};
use super::obstacles::Blocked;
use super::sampling::moved;
use crate::motion::{Approach, Motion, clashes};

/// What came of one rung.
pub(super) struct Attempt {
    pub(super) rung: usize,
    /// A knot a sample.
    pub(super) deviation: Paths,
    pub(super) motion: Motion,
    pub(super) clashes: Vec<Approach>,
    pub(super) blocked: Vec<Blocked>,
    /// How many of all those no keyframe is to blame for.
    pub(super) open_count: usize,
}

impl Attempt {
    /// The guide moved by a deviation, checked exactly.
    pub(super) fn new(rung: usize, guide: &Motion, deviation: Paths, avoidance: &Avoidance, slack: f64, breaches: &[Breach]) -> Self {
        let motion = moved(guide, &deviation);
        let clashes = clashes(&motion, avoidance.minimum_distance - slack);
        let blocked = avoidance.blocked(&motion, slack);
        let open_count = open_count(&clashes, breaches, &motion) + free_count(&blocked, breaches);
        Self { rung, deviation, motion, clashes, blocked, open_count }
    }

    /// Mean and greatest length of the deviation, meters.
    pub(super) fn deviation_lengths(&self) -> [f64; 2] {
        let deviation = &self.deviation;
        let (mut sum, mut greatest): (f64, f64) = (0.0, 0.0);
        for agent in 0..deviation.agent_count() {
            for k in 0..deviation.knot_count() {
                let [x, y, z] = deviation.place(agent, k);
                let length = (x * x + y * y + z * z).sqrt();
                sum += length;
                greatest = greatest.max(length);
            }
        }
        [sum / (deviation.agent_count() * deviation.knot_count()).max(1) as f64, greatest]
    }
}

/// Agents that an obstacle blocks and that no keyframe has too near to it.
pub(super) fn free_count(blocked: &[Blocked], breaches: &[Breach]) -> usize {
    let is_breach = |at: &Blocked| breaches.iter().any(|breach| breach.agent == at.agent && breach.other == Other::Obstacle(at.obstacle));
    blocked.iter().filter(|at| !is_breach(at)).count()
}

/// Clashes of pairs that no keyframe has too near, in the sixth next to it.
pub(super) fn open_count(clashes: &[Approach], breaches: &[Breach], motion: &Motion) -> usize {
    let times = motion.times();
    let (start, end) = (times[0], times[times.len() - 1]);
    let is_excused = |clash: &Approach| {
        let fraction = (clash.time - start) / (end - start);
        breaches.iter().any(|breach| {
            let is_pair = breach.other == Other::Agent(clash.agents.1) && breach.agent == clash.agents.0;
            is_pair && if breach.end == 0 { fraction <= 1.0 / 6.0 } else { fraction >= 5.0 / 6.0 }
        })
    };
    clashes.iter().filter(|clash| !is_excused(clash)).count()
}
