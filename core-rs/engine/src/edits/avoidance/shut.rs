//! Who has no way around what stands between both ends: they keep the guide, through it, and are named.

use glam::DVec2;
use serde::Serialize;

use super::{Blocked, Outline};
use crate::motion::Motion;
use crate::obstacle::{Detours, ObstacleShape};

/// Among more places where ways may bend nobody looks: it would take longer than a step may.
const MOST_BENDS: usize = 1_000;

/// An agent that an obstacle shuts off from its place.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct ShutOff {
    /// Who.
    pub agent: u32,
    /// What, by number.
    pub obstacle: u32,
    /// What ways keep from obstacles, meters.
    pub distance: f64,
}

/// Of those whom obstacles block, everybody whom no way leads around them, by number.
pub(super) fn shut_off(guide: &Motion, blocked: &[Blocked], obstacles: &[Outline], distance: f64) -> Vec<ShutOff> {
    if blocked.is_empty() {
        return Vec::new();
    }
    let shapes: Vec<ObstacleShape> = obstacles.iter().map(shape).collect();
    let mut detours = Detours::new(&shapes, distance);
    if detours.bend_count() > MOST_BENDS {
        return Vec::new();
    }
    while !detours.find_row() {}
    let last = guide.times().len() - 1;
    let mut shut = Vec::<ShutOff>::new();
    for Blocked { agent, .. } in blocked {
        let [from, to] = [0, last].map(|k| guide.sample(k)[*agent as usize]);
        if shut.last().is_none_or(|last| last.agent != *agent) && !detours.lead(from, to) {
            let obstacle = detours.barrier(&shapes, distance, [from, to]) as u32;
            shut.push(ShutOff { agent: *agent, obstacle, distance });
        }
    }
    shut
}

fn shape(outline: &Outline) -> ObstacleShape {
    let points = || outline.points.iter().map(|p| DVec2::from_array(*p));
    match outline.points[..] {
        [center] => ObstacleShape::Circle { center: DVec2::from_array(center), radius: outline.radius },
        _ => ObstacleShape::Polygon { points: points().collect() },
    }
}
