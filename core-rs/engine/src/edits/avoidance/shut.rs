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

/// Of those whom obstacles block, everybody whom no way leads around them, by number; and the longest way of the others, meters, or
/// infinite where nobody looked.
pub(super) fn survey(guide: &Motion, blocked: &[Blocked], obstacles: &[Outline], distance: f64) -> (Vec<ShutOff>, f64) {
    if blocked.is_empty() {
        return (Vec::new(), 0.0);
    }
    let shapes = shapes(obstacles);
    let Some(detours) = surveyed(&shapes, distance) else { return (Vec::new(), f64::INFINITY) };
    let last = guide.times().len() - 1;
    let (mut shut, mut longest) = (Vec::<ShutOff>::new(), 0.0);
    let mut asked = None;
    for Blocked { agent, .. } in blocked.iter().filter(|at| asked.replace(at.agent) != Some(at.agent)) {
        let [from, to] = [0, last].map(|k| guide.sample(k)[*agent as usize]);
        let way = detours.way(from, to);
        if way.is_none() {
            let obstacle = detours.barrier(&shapes, distance, [from, to]) as u32;
            shut.push(ShutOff { agent: *agent, obstacle, distance });
        }
        longest = way.unwrap_or_default().windows(2).map(|piece| piece[0].distance(piece[1])).sum::<f64>().max(longest);
    }
    (shut, longest)
}

/// Every way around obstacles at a distance; none where there are too many.
pub(super) fn surveyed(shapes: &[ObstacleShape], distance: f64) -> Option<Detours> {
    let mut detours = Detours::new(shapes, distance);
    if detours.bend_count() > MOST_BENDS {
        return None;
    }
    while !detours.find_row() {}
    Some(detours)
}

/// Obstacles as those know them who go around.
pub(super) fn shapes(obstacles: &[Outline]) -> Vec<ObstacleShape> {
    obstacles.iter().map(shape).collect()
}

fn shape(outline: &Outline) -> ObstacleShape {
    let points = || outline.points.iter().map(|p| DVec2::from_array(*p));
    match outline.points[..] {
        [center] => ObstacleShape::Circle { center: DVec2::from_array(center), radius: outline.radius },
        _ => ObstacleShape::Polygon { points: points().collect() },
    }
}
