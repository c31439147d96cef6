//! The shortest ways around obstacles, each agent by itself: through doors that a formation cannot pass in its ranks.

use eigenform_apart::Paths;
use glam::DVec2;

use super::reroute::{is_blocked, smooth, walked};
use super::shut::{shapes, surveyed};
use super::{Avoidance, at};

/// Beyond the minimum distance, of it: room for the smoothing, or as much of it as leaves a way.
const MARGINS: [f64; 3] = [0.3, 0.08, 0.0];

/// Leads those who are free to go and whom obstacles block along the shortest way from their start to their end.
pub(super) fn lead_each(paths: &mut Paths, avoidance: &Avoidance, free: &[usize]) {
    let Avoidance { obstacles, minimum_distance: distance, .. } = avoidance;
    let (guide, last) = (paths.clone(), paths.knot_count() - 1);
    let shapes = shapes(obstacles);
    let mut is_moved = vec![false; paths.agent_count()];
    let is_in_the_way = |agent: &usize| obstacles.iter().any(|outline| is_blocked(&guide, *agent, outline, *distance));
    let mut left: Vec<usize> = free.iter().copied().filter(is_in_the_way).collect();
    for margin in MARGINS {
        let detours = if left.is_empty() { None } else { surveyed(&shapes, distance * (1.0 + margin)) };
        let Some(detours) = detours else { break };
        left.retain(|&agent| {
            let places: Vec<DVec2> = (0..=last).map(|knot| at(&guide, agent, knot)).collect();
            let way = detours.way(places[0], places[last]);
            for (knot, place) in way.iter().flat_map(|way| walked(&places, way)).enumerate().take(last).skip(1) {
                paths.path_mut(0, agent)[knot] = place.x;
                paths.path_mut(1, agent)[knot] = place.y;
            }
            is_moved[agent] = way.is_some();
            way.is_none()
        });
    }
    smooth(paths, &guide, avoidance, &is_moved);
}
