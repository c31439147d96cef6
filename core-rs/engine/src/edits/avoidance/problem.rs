//! A guide, what to keep apart on it, and what is in the way.

use super::breaches::Breach;
use super::meetings::Lister;
use super::obstacles::Blocked;
use super::open::{open_blocks, open_clashes};
use super::rungs::Ways;
use super::shut::{ShutOff, survey};
use super::{Avoidance, AvoidanceReport, BREACH_LIMIT, judge};
use crate::motion::{Approach, Motion};

/// What every attempt at one guide shares.
pub(super) struct Problem {
    pub(super) avoidance: Avoidance,
    pub(super) guide: Motion,
    pub(super) ways: Ways,
    /// Of the guide.
    pub(super) clashes: Vec<Approach>,
    /// Of the guide.
    pub(super) blocked: Vec<Blocked>,
    pub(super) breaches: Vec<Breach>,
    /// By number.
    pub(super) shut_off: Vec<ShutOff>,
    /// Of those whom obstacles block and who have a way around them, the longest, meters.
    pub(super) longest_way: f64,
    pub(super) lister: Lister,
}

impl Problem {
    /// Checks the guide exactly.
    pub(super) fn of(avoidance: Avoidance, guide: Motion) -> Self {
        let AvoidanceReport { unsolved, blocked, breaches, .. } = judge(&avoidance, &guide);
        let (shut_off, longest_way) = survey(&guide, &blocked, &avoidance.obstacles, avoidance.minimum_distance);
        Self {
            ways: Ways::of(&guide),
            clashes: unsolved,
            blocked,
            breaches,
            shut_off,
            longest_way,
            lister: Lister::default(),
            avoidance,
            guide,
        }
    }

    /// Whether somebody comes too near whom no keyframe is to blame for, and can be moved.
    pub(super) fn can_be_mended(&self) -> bool {
        let is_open = open_clashes(&self.clashes, &self.breaches, &self.guide).next().is_some()
            || open_blocks(&self.blocked, &self.breaches, &self.shut_off).next().is_some();
        // Three samples have one between the keyframes; a bump needs two.
        is_open && self.ways.mean > 0.0 && self.guide.times().len() >= 4 && self.breaches.len() < BREACH_LIMIT
    }
}
