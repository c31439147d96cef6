//! Who comes too near to what stands still, between samples too.

use eigenform_apart::Outline;
use glam::DVec2;
use serde::Serialize;

use crate::motion::Motion;

/// An agent at its nearest to an obstacle.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Blocked {
    /// Meters from the outline; at most 0 when the way crosses it.
    pub distance: f64,
    /// Seconds.
    pub time: f64,
    /// Who.
    pub agent: u32,
    /// What, by number.
    pub obstacle: u32,
}

/// Everybody whose way comes nearer to an outline than `least` meters, at the nearest; by agent, then by obstacle. Exact for the
/// straight pieces between samples.
pub(super) fn blocked(motion: &Motion, outlines: &[Outline], least: f64) -> Vec<Blocked> {
    let mut blocked = Vec::new();
    let rounds: Vec<Round> = outlines.iter().map(Round::about).collect();
    for agent in 0..motion.agent_count() {
        for (obstacle, (outline, round)) in outlines.iter().zip(&rounds).enumerate() {
            let mut nearest = Blocked { distance: least, time: 0.0, agent: agent as u32, obstacle: obstacle as u32 };
            for k in 1..motion.times().len() {
                let ends = [k - 1, k].map(|k| motion.sample(k)[agent]);
                // Whoever is farther from the middle than that and one step cannot come so near.
                if !round.reaches(ends[0].x, ends[0].y, least + ends[0].distance(ends[1])) {
                    continue;
                }
                let (distance, t) = outline.least_clearance(ends[0].to_array(), ends[1].to_array());
                if distance < nearest.distance {
                    let [start, end] = [motion.times()[k - 1], motion.times()[k]];
                    (nearest.distance, nearest.time) = (distance, start + t * (end - start));
                }
            }
            if nearest.distance < least {
                blocked.push(nearest);
            }
        }
    }
    blocked
}

/// A circle about an outline: most agents are far from most obstacles.
pub(super) struct Round {
    center: DVec2,
    radius: f64,
}

impl Round {
    pub(super) fn about(outline: &Outline) -> Self {
        let points = || outline.points.iter().map(|p| DVec2::from_array(*p));
        let center = points().sum::<DVec2>() / outline.points.len() as f64;
        Self { center, radius: outline.radius + points().map(|p| p.distance(center)).fold(0.0, f64::max) }
    }

    /// Whether a place may be nearer to the outline than `reach`.
    pub(super) fn reaches(&self, x: f64, y: f64, reach: f64) -> bool {
        self.center.distance_squared(DVec2::new(x, y)) < (self.radius + reach) * (self.radius + reach)
    }
}
