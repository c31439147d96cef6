//! Coordinates to cells of a grid and back, and what that moves.

use std::sync::Arc;

use glam::{DVec2, DVec3};

use super::route::Cell;
use super::step::{ROUNDED_SPAN, Step, coarsest_first};
use crate::formation::Formation;
use crate::order;
use crate::scene::Scene;

/// How a link keeps coordinates.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Precision {
    /// Within 1e-6 m, which drawn scenes meet to the last bit.
    Exact,
    /// In 12 bits of the extent: a shorter link.
    Short,
}

/// A scene's coordinates on a grid.
pub struct Rounded {
    /// The grid.
    pub step: Step,
    /// By keyframe, then by agent.
    pub cells: Vec<Vec<Cell>>,
    /// Heights in steps, by keyframe, then by agent; no keyframes on the plane.
    pub heights: Vec<Vec<i64>>,
    /// The farthest that an agent was moved, meters; 0 where the step represents every coordinate.
    pub farthest: f64,
    /// Keyframes that only then break the minimum distance.
    pub broken_keyframes: Vec<usize>,
}

/// Puts a scene's coordinates on the coarsest grid that represents them or, for a shorter link, on one of 12 bits.
///
/// What comes out lies on its grid, and rounding it again changes nothing.
pub fn round(scene: &Scene, precision: Precision) -> Rounded {
    let before: Vec<Vec<DVec3>> = scene.tracks[0].keyframes.iter().map(|keyframe| points_of(&keyframe.positions)).collect();
    let mut points: Vec<DVec3> = before.concat();
    let mut step = settle(&mut points);
    let mut farthest = 0.0;
    let mut broken_keyframes = Vec::new();
    let (low, high) = bounds(&points);
    if precision == Precision::Short
        && step.span(low, high) > ROUNDED_SPAN
        && let Some(rounded) = Step::rounded(low, high)
    {
        points = before.concat();
        snap(rounded, &mut points);
        step = settle(&mut points);
        farthest = before.concat().iter().zip(&points).map(|(a, b)| a.distance(*b)).fold(0.0, f64::max);
        broken_keyframes = broken(&before, &points, scene.minimum_distance);
    }
    let mut rest = points.iter().map(|point| point.to_array().map(|coordinate| step.index(coordinate)));
    let indices: Vec<Vec<[i64; 3]>> = before.iter().map(|formation| rest.by_ref().take(formation.len()).collect()).collect();
    let cells = indices.iter().map(|formation| formation.iter().map(|[x, y, _]| [*x, *y]).collect()).collect();
    let is_spatial = scene.tracks[0].keyframes.iter().any(|keyframe| keyframe.positions.heights().is_some());
    let heights = indices.iter().filter(|_| is_spatial).map(|formation| formation.iter().map(|[_, _, z]| *z).collect()).collect();
    Rounded { step, cells, heights, farthest, broken_keyframes }
}

/// Moves places that are made from a scene's onto the scene's own grid, or one as fine as `longest` meters that holds it: its link
/// then grows by no more than it must. Where a link has rounded the scene before, they stay.
pub fn onto_grid(scene: &Scene, longest: f64, places: &mut [DVec3]) {
    let points: Vec<DVec3> = scene.main_track().keyframes.iter().flat_map(|keyframe| points_of(&keyframe.positions)).collect();
    let step = coarsest(&points).at_most(longest);
    if step.meters() <= longest {
        snap(step, places);
    }
}

/// The formation of a grid's cells, and of heights in space.
pub fn formation(step: Step, cells: &[Cell], heights: Option<&[i64]>) -> Arc<Formation> {
    let positions = cells.iter().map(|[x, y]| DVec2::new(step.value(*x), step.value(*y))).collect();
    Arc::new(match heights {
        Some(heights) => Formation::spatial(positions, heights.iter().map(|height| step.value(*height)).collect()),
        None => Formation::new(positions),
    })
}

/// On the plane at height 0, which every step represents.
fn points_of(formation: &Formation) -> Vec<DVec3> {
    formation.positions().iter().enumerate().map(|(agent, position)| position.extend(formation.height(agent))).collect()
}

/// Moves points, each by less than the tolerance, onto the coarsest step that represents them.
fn settle(points: &mut [DVec3]) -> Step {
    let mut step = coarsest(points);
    loop {
        snap(step, points);
        // Points on a step may now be within the tolerance of a coarser one.
        let next = coarsest(points);
        if next == step {
            return step;
        }
        step = next;
    }
}

fn snap(step: Step, points: &mut [DVec3]) {
    for point in points {
        *point = DVec3::from_array(point.to_array().map(|coordinate| step.value(step.index(coordinate))));
    }
}

fn coarsest(points: &[DVec3]) -> Step {
    let (low, high) = bounds(points);
    let mut steps = Step::catalog();
    // What 12 bits have rounded before is recognized: its step, or after that rounding moved the bounds inward, the next coarser.
    if let Some(rounded) = Step::rounded(low, high) {
        steps.extend([rounded, rounded.coarser(), rounded.coarser().coarser()]);
    }
    coarsest_first(&mut steps);
    let represents = |step: &Step| points.iter().flat_map(DVec3::to_array).all(|coordinate| step.represents(coordinate));
    steps.into_iter().find(represents).expect("the finest step represents every coordinate")
}

fn bounds(points: &[DVec3]) -> (DVec3, DVec3) {
    let first = points.first().copied().unwrap_or_default();
    points.iter().fold((first, first), |(low, high), point| (low.min(*point), high.max(*point)))
}

fn broken(before: &[Vec<DVec3>], after: &[DVec3], distance: f64) -> Vec<usize> {
    let mut start = 0;
    let mut broken = Vec::new();
    for (index, formation) in before.iter().enumerate() {
        let rounded = &after[start..start + formation.len()];
        start += formation.len();
        if !has_nearer(formation, distance) && has_nearer(rounded, distance) {
            broken.push(index);
        }
    }
    broken
}

/// Whether two points are nearer than `distance`, as near-collisions are counted: by more than 1e-6 m.
fn has_nearer(points: &[DVec3], distance: f64) -> bool {
    let limit = distance - 1e-6;
    let mut sorted = points.to_vec();
    order::sort_by_key(&mut sorted, |point| u128::from(order::of_real(point.x)));
    sorted.iter().enumerate().any(|(index, point)| {
        sorted[index + 1..].iter().take_while(|other| other.x - point.x < limit).any(|other| other.distance(*point) < limit)
    })
}
