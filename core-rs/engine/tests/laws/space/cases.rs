//! Formations in space that break careless code, and how to move them.

use std::f64::consts::TAU;
use std::sync::Arc;

use eigenform::adjacency::{AdjacencySpec, build};
use eigenform::choice::Choice;
use eigenform::formation::Formation;
use eigenform::transition::{Chain, End, Planner, Way, Ways};
use glam::{DQuat, DVec2, DVec3};
use proptest::collection::vec;
use proptest::prelude::*;

use crate::formations::chance;
use crate::transition::cases::choices_sharing;

pub const SHARINGS: [f64; 2] = [0.0, 0.5];

pub fn formation(points: &[DVec3]) -> Formation {
    Formation::spatial(points.iter().map(|point| point.truncate()).collect(), points.iter().map(|point| point.z).collect())
}

pub fn end(formation: &Formation) -> End {
    let adjacency = build(formation, &AdjacencySpec::default(), &[]).expect("few ties");
    End { formation: Arc::new(formation.clone()), adjacency: Arc::new(adjacency) }
}

pub fn chain(source: &Formation, target: &Formation) -> Chain {
    Chain::between(end(source), end(target))
}

/// Every method with every option that it knows.
pub fn choices() -> Vec<Choice> {
    choices_sharing(&SHARINGS)
}

/// Places at each t, one row a t.
pub fn motion(planner: &mut Planner, chain: &Chain, choice: &Choice, keep_size: bool, ts: &[f64]) -> Vec<Vec<DVec3>> {
    motion_of(planner, chain, &Ways::all(Way::of(*choice, keep_size)), ts)
}

pub fn motion_of(planner: &mut Planner, chain: &Chain, ways: &Ways, ts: &[f64]) -> Vec<Vec<DVec3>> {
    let transition = planner.plan(chain, ways);
    let agent_count = transition.agent_count();
    let mut positions = vec![DVec2::NAN; agent_count * ts.len()];
    let mut heights = vec![f64::NAN; agent_count * ts.len()];
    transition.evaluate_into(ts, &mut positions, Some(&mut heights));
    let places: Vec<DVec3> = positions.iter().zip(heights).map(|(position, height)| position.extend(height)).collect();
    (0..ts.len()).map(|k| places[k * agent_count..][..agent_count].to_vec()).collect()
}

pub fn farthest(p: &[DVec3], q: &[DVec3]) -> f64 {
    assert_eq!(p.len(), q.len());
    p.iter().zip(q).map(|(p, q)| if p.is_finite() && q.is_finite() { p.distance(*q) } else { f64::INFINITY }).fold(0.0, f64::max)
}

pub fn center(points: &[DVec3]) -> DVec3 {
    points.iter().sum::<DVec3>() / points.len() as f64
}

/// Columns, rows and layers one meter apart.
pub fn block(columns: usize, rows: usize, layers: usize) -> Vec<DVec3> {
    let at = |i: usize| [i % columns, i / columns % rows, i / (columns * rows)].map(|step| step as f64);
    (0..columns * rows * layers).map(|i| DVec3::from_array(at(i))).collect()
}

/// Agents about evenly on a sphere: all in one sphere, so that no triangulation is unique by rights.
pub fn sphere(count: usize, radius: f64) -> Vec<DVec3> {
    let golden = TAU * (5.0_f64.sqrt() - 1.0) / 2.0;
    let at = |i: usize| {
        let height = 1.0 - (2.0 * i as f64 + 1.0) / count as f64;
        (DVec2::from_angle(golden * i as f64) * (1.0 - height * height).sqrt()).extend(height) * radius
    };
    (0..count).map(at).collect()
}

/// A rising spiral.
pub fn helix(count: usize) -> Vec<DVec3> {
    (0..count).map(|i| (DVec2::from_angle(0.7 * i as f64) * 5.0).extend(0.4 * i as f64)).collect()
}

/// Agents at random in a box of 20 m, the same for the same seed.
pub fn scattered(count: usize, seed: u64) -> Vec<DVec3> {
    let mut next = chance(seed);
    (0..count).map(|_| DVec3::new(next(), next(), next())).collect()
}

/// A turn about any axis, then a shift.
#[derive(Clone, Copy, Debug)]
pub struct Rigid {
    pub turn: DQuat,
    pub shift: DVec3,
}

impl Rigid {
    pub fn new(axis: [f64; 3], angle: f64, shift: [f64; 3]) -> Self {
        Self { turn: DQuat::from_axis_angle(DVec3::from_array(axis).normalize(), angle), shift: DVec3::from_array(shift) }
    }

    pub fn apply(self, points: &[DVec3]) -> Vec<DVec3> {
        points.iter().map(|&point| self.turn * point + self.shift).collect()
    }
}

/// Any turn, shifts as far as a scene reaches.
pub fn rigid() -> impl Strategy<Value = Rigid> {
    let axis = [-1.0..1.0f64, -1.0..1.0, -1.0..1.0].prop_filter("an axis has a direction", |axis| DVec3::from_array(*axis).length() > 0.1);
    (axis, 0.0..TAU, [-5e4..5e4f64, -5e4..5e4, -5e4..5e4]).prop_map(|(axis, angle, shift)| Rigid::new(axis, angle, shift))
}

/// Agents in a box on whole centimeters, in blocks, on spheres, in two layers, in a tilted plane or on a tilted line; all apart.
pub fn apart() -> impl Strategy<Value = Vec<DVec3>> {
    let coordinate = || (-1000i32..=1000).prop_map(|step| f64::from(step) / 100.0);
    let place = move || (coordinate(), coordinate(), coordinate()).prop_map(|(x, y, z)| DVec3::new(x, y, z));
    let scattered = vec(place(), 0..30).prop_map(|mut points| {
        points.sort_by(|p, q| p.x.total_cmp(&q.x).then(p.y.total_cmp(&q.y)).then(p.z.total_cmp(&q.z)));
        points.dedup();
        points
    });
    let tilted = (rigid(), 2usize..6, 1usize..6)
        .prop_map(|(rigid, columns, rows)| Rigid { shift: DVec3::ZERO, ..rigid }.apply(&block(columns, rows, 1)));
    let layers = (2usize..5, 2usize..5, 0.3..3.0f64).prop_map(|(columns, rows, gap)| {
        let mut points = block(columns, rows, 1);
        points.extend(block(columns, rows, 1).into_iter().map(|point| point + DVec3::new(0.25, 0.1, gap)));
        points
    });
    prop_oneof![
        3 => scattered,
        1 => (1usize..5, 1usize..5, 1usize..5).prop_map(|(columns, rows, layers)| block(columns, rows, layers)),
        1 => (4usize..60).prop_map(|count| sphere(count, 6.0)),
        1 => (2usize..40).prop_map(helix),
        1 => tilted,
        1 => layers,
    ]
}
