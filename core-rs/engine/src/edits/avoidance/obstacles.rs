//! Who comes too near to what stands still, between samples too.

use eigenform_apart::Outline;
use glam::DVec2;
use serde::Serialize;

use super::Avoidance;
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

/// An agent that keeps more than the minimum distance to an obstacle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hold {
    /// Who.
    pub agent: u32,
    /// To what, by number.
    pub obstacle: u32,
    /// Meters, above the minimum distance.
    pub distance: f64,
}

impl Avoidance {
    /// All outlines that paths keep the minimum distance to: the obstacles, then for every hold its obstacle, grown.
    pub(super) fn outlines(&self) -> Vec<Outline> {
        let grown = |hold: &Hold| {
            let outline = &self.obstacles[hold.obstacle as usize];
            Outline { radius: outline.radius + hold.distance - self.minimum_distance, ..outline.clone() }
        };
        self.obstacles.iter().cloned().chain(self.holds.iter().map(grown)).collect()
    }

    /// Everybody whose way comes nearer to an obstacle than the minimum distance, or than they hold, by more than `slack` meters, at
    /// the nearest; by agent, then by obstacle. Exact for the straight pieces between samples.
    pub(super) fn blocked(&self, motion: &Motion, slack: f64) -> Vec<Blocked> {
        let rounds: Vec<Round> = self.obstacles.iter().map(Round::about).collect();
        let mut blocked = Vec::new();
        for agent in 0..motion.agent_count() as u32 {
            for (obstacle, (outline, round)) in (0..).zip(self.obstacles.iter().zip(&rounds)) {
                let hold = self.holds.binary_search_by_key(&(agent, obstacle), |hold| (hold.agent, hold.obstacle));
                let least = hold.map_or(self.minimum_distance, |place| self.holds[place].distance) - slack;
                let nearest = nearest_within(motion, (agent, obstacle), (outline, round), least);
                blocked.extend((nearest.distance < least).then_some(nearest));
            }
        }
        blocked
    }
}

/// An agent where it is nearest to an outline. Exact for the straight pieces between samples.
pub fn nearest_to(motion: &Motion, agent: u32, obstacle: u32, outline: &Outline) -> Blocked {
    nearest_within(motion, (agent, obstacle), (outline, &Round::about(outline)), f64::INFINITY)
}

/// At `least` from it where it stays as far away.
fn nearest_within(motion: &Motion, (agent, obstacle): (u32, u32), (outline, round): (&Outline, &Round), least: f64) -> Blocked {
    let mut nearest = Blocked { distance: least, time: 0.0, agent, obstacle };
    for k in 1..motion.times().len() {
        let ends = [k - 1, k].map(|k| motion.sample(k)[agent as usize]);
        // Whoever is farther from the middle than that and one step cannot come so near.
        if !round.reaches(ends[0].x, ends[0].y, nearest.distance + ends[0].distance(ends[1])) {
            continue;
        }
        let (distance, t) = outline.least_clearance(ends[0].to_array(), ends[1].to_array());
        if distance < nearest.distance {
            let [start, end] = [motion.times()[k - 1], motion.times()[k]];
            (nearest.distance, nearest.time) = (distance, start + t * (end - start));
        }
    }
    nearest
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
