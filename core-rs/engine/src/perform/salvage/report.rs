//! What letting them spread out comes to, in numbers.

use serde::Serialize;

use super::super::performed::Performed;
use crate::edits::{Blocked, is_modest};
use crate::measure::{Clearance, Extreme};
use crate::motion::{Motion, closeness};

use super::super::avoid;

/// The motion of a whole segment, in one part or several, beside the motion that its method makes.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(rename_all = "camelCase")]
pub struct SalvageReport {
    /// The nearest that any two come; none for fewer than two agents.
    pub clearance: Option<Clearance>,
    /// How far agents are from where the method has them, over agents and samples, meters.
    pub deviation: Extreme,
    /// The fastest that anybody goes, meters a second.
    pub top_speed: f64,
    /// The same of the method's own motion.
    pub guide_top_speed: f64,
    /// Too far from it or too much faster than it to be taken without a second look.
    pub is_wild: bool,
    /// Every meeting that is still too near.
    pub unsolved: Vec<Clearance>,
    /// Everybody still too near to an obstacle.
    pub blocked: Vec<Blocked>,
}

impl SalvageReport {
    /// Of the motions that follow one another in place of a segment's; `unsolved` and `blocked` are theirs.
    pub(super) fn new(
        segment: &Performed,
        motions: &[&Motion],
        unsolved: Vec<Clearance>,
        blocked: Vec<Blocked>,
        minimum_distance: f64,
    ) -> Self {
        let (mut sum, mut count, mut max) = (0.0, 0_usize, 0.0_f64);
        let mut nearest = None;
        for motion in motions {
            let guide = segment.guide(motion.times().to_vec());
            for k in 0..motion.times().len() {
                for (place, was) in motion.places(k).iter().zip(guide.places(k).iter()) {
                    let length = place.distance(was);
                    (sum, count, max) = (sum + length, count + 1, max.max(length));
                }
            }
            let near = closeness(motion, 0.0).nearest().map(avoid::clearance);
            nearest = near.into_iter().chain(nearest).min_by(|a: &Clearance, b| a.distance.total_cmp(&b.distance));
        }
        let top_speed = motions.iter().map(|motion| motion.top_speed()).fold(0.0, f64::max);
        let guide_top_speed = segment.guide(segment.motion.times().to_vec()).top_speed();
        Self {
            clearance: nearest,
            deviation: Extreme { mean: sum / count.max(1) as f64, max },
            top_speed,
            guide_top_speed,
            is_wild: !is_modest(max, top_speed / guide_top_speed, minimum_distance),
            unsolved,
            blocked,
        }
    }
}
