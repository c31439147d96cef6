//! Agents keep their distance, and the keyframes stay where they are.
//!
//! Sound: a motion is called solved only after an exact check of every straight piece between its samples. Whoever is nearer in
//! a keyframe is named and never moved.

mod attempt;
mod breaches;
mod climb;
mod gaps;
mod hull;
mod job;
mod meetings;
mod obstacles;
mod open;
mod problem;
mod reroute;
mod rungs;
mod sampling;
mod shut;
mod spread;
mod streams;
mod warp;
mod ways;

use eigenform_apart::Paths;
use glam::DVec2;

use crate::motion::{Approach, Motion, clashes};

use super::NO_GROUP;
use super::deviation::Deviation;
use reroute::Parting;

pub use breaches::{Breach, Other};
pub use eigenform_apart::Outline;
pub use job::{AvoidanceJob, AvoidanceStep};
pub use obstacles::{Blocked, Hold, nearest_to};
pub use shut::ShutOff;
pub use spread::{SpreadJob, SpreadStep};
pub use warp::is_modest;

/// What the exact check lets pass, meters: positions are exact to a thousandth of it.
const SLACK: f64 = 1e-6;

/// A pile of agents in one place has more breaches than anyone reads.
const BREACH_LIMIT: usize = 1_000;

/// What to keep apart, and how freely.
#[derive(Clone, Debug, PartialEq)]
pub struct Avoidance {
    /// Nobody may be nearer than this to another or to an obstacle, center to center and center to outline; meters.
    pub minimum_distance: f64,
    /// Whether the motion runs through at its start and its end, so that velocities must stay there too; else it stops.
    pub is_clamped: [bool; 2],
    /// Decides the way out of one and the same place.
    pub seed: u32,
    /// What stands in the way.
    pub obstacles: Vec<Outline>,
    /// Who must not come nearer to which of them than they are, farther than everybody keeps; by agent, then by obstacle.
    pub holds: Vec<Hold>,
    /// By agent the group that it passes obstacles with, or [`super::NO_GROUP`]; empty where there are none.
    pub groups: Vec<u32>,
}

/// A motion after avoidance.
pub struct Edited {
    /// The guide itself when nobody clashed.
    pub motion: Motion,
    /// What was added to the guide; none when nothing was.
    pub deviation: Option<Deviation>,
    /// What it came to.
    pub report: AvoidanceReport,
}

/// What avoidance came to.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct AvoidanceReport {
    /// How far agents are from the guide, over agents and samples: mean and greatest, meters.
    pub deviation: [f64; 2],
    /// Every meeting that is still too near, by time; empty when it is solved.
    pub unsolved: Vec<Approach>,
    /// Everybody still too near to an obstacle, at the nearest.
    pub blocked: Vec<Blocked>,
    /// Who is too near at which end already.
    pub breaches: Vec<Breach>,
    /// Whom no way leads around obstacles; they stay on the guide.
    pub shut_off: Vec<ShutOff>,
    /// Which attempt this is, from 1; 0 when the guide needed none.
    pub rung: usize,
}

impl AvoidanceReport {
    /// Proved: nobody is too near at any moment.
    pub fn is_solved(&self) -> bool {
        self.unsolved.is_empty() && self.blocked.is_empty() && self.breaches.is_empty()
    }

    /// Who comes too near on the way in the motion that this is of: what no keyframe is to blame for.
    pub fn unsolved_on_the_way(&self, motion: &Motion) -> impl Iterator<Item = &Approach> {
        open::open_clashes(&self.unsolved, &self.breaches, motion)
    }

    /// Who is blocked on the way: whom neither a keyframe nor what shuts them off has to blame.
    pub fn blocked_on_the_way(&self) -> impl Iterator<Item = &Blocked> {
        open::open_blocks(&self.blocked, &self.breaches, &self.shut_off)
    }
}

/// What leads a guide around obstacles.
pub(super) struct WayAround {
    /// A knot a sample: nothing at both ends, value and velocity.
    pub(super) detour: Paths,
    /// Whom no way leads around them; they stay on the guide.
    pub(super) shut_off: Vec<ShutOff>,
}

impl WayAround {
    /// At a distance from obstacles, each of the `groups` on one side; nothing without obstacles or distance, and for a guide that does
    /// not move.
    pub(super) fn of(guide: &Motion, obstacles: &[Outline], distance: f64, groups: &[u32]) -> Self {
        let ways = rungs::Ways::of(guide);
        let sample_count = guide.times().len();
        if obstacles.is_empty() || distance <= 0.0 || ways.longest <= 0.0 {
            return Self { detour: Paths::new(guide.agent_count(), sample_count, 2), shut_off: Vec::new() };
        }
        let straight = sampling::at_knots(guide, rungs::RUNGS[0].knot_count(ways, distance, sample_count));
        let avoidance = Avoidance {
            minimum_distance: distance,
            is_clamped: [true; 2],
            seed: 0,
            obstacles: obstacles.to_vec(),
            holds: Vec::new(),
            groups: groups.to_vec(),
        };
        let (shut_off, _) = shut::survey(guide, &avoidance.blocked(guide, SLACK), obstacles, distance);
        let free = free(guide.agent_count(), &shut_off);
        let around = |parting: Parting| {
            let mut paths = straight.clone();
            reroute::reroute(&mut paths, &avoidance, parting, &free);
            paths
        };
        let detour = |paths: &Paths| sampling::difference(paths, &straight);
        let mut paths = around(Parting::Ungrouped);
        if avoidance.has_groups() && warp::is_astray(sampling::lengths(&detour(&paths))[1], ways, distance) {
            paths = around(Parting::Groups);
        }
        // Where walls stand on all sides, what leads around one leads into another.
        let goes_through = |agent: &usize| obstacles.iter().any(|outline| reroute::is_blocked(&paths, *agent, outline, 0.0));
        if obstacles.len() > 1 && free.iter().any(goes_through) {
            paths = straight.clone();
            ways::lead_each(&mut paths, &avoidance, &free);
        }
        Self { detour: sampling::lifted(&detour(&paths), guide.times(), [true; 2]), shut_off }
    }
}

impl Avoidance {
    /// The group that an agent passes obstacles with.
    fn group_of(&self, agent: usize) -> u32 {
        self.groups.get(agent).copied().unwrap_or(NO_GROUP)
    }

    /// Whether anybody goes around obstacles with a group.
    fn has_groups(&self) -> bool {
        !self.obstacles.is_empty() && self.groups.iter().any(|group| *group != NO_GROUP)
    }
}

/// Whether no way leads an agent around obstacles.
fn is_among(shut_off: &[ShutOff], agent: usize) -> bool {
    shut_off.binary_search_by_key(&agent, |shut| shut.agent as usize).is_ok()
}

/// Everybody else, in order.
fn free(agent_count: usize, shut_off: &[ShutOff]) -> Vec<usize> {
    (0..agent_count).filter(|agent| !is_among(shut_off, *agent)).collect()
}

/// The exact check alone, of a motion that something else keeps apart; the deviation is the caller's.
pub fn judge(avoidance: &Avoidance, motion: &Motion) -> AvoidanceReport {
    let least = avoidance.minimum_distance - SLACK;
    AvoidanceReport {
        deviation: [0.0; 2],
        unsolved: clashes(motion, least),
        blocked: avoidance.blocked(motion, SLACK),
        breaches: if motion.agent_count() > 0 { breaches::breaches(motion, avoidance, SLACK, BREACH_LIMIT) } else { Vec::new() },
        shut_off: Vec::new(),
        rung: 0,
    }
}

/// Where an agent is as seen from above.
fn at(paths: &Paths, agent: usize, knot: usize) -> DVec2 {
    let [x, y, _] = paths.place(agent, knot);
    DVec2::new(x, y)
}
