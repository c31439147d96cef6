//! Formations that break careless code, for the laws.

use std::f64::consts::TAU;

use eigenform::formation::Formation;
use glam::DVec2;
use proptest::collection::vec;
use proptest::prelude::*;

/// Rows and columns one meter apart.
pub fn grid(columns: usize, rows: usize) -> Vec<DVec2> {
    (0..columns * rows).map(|i| DVec2::new((i % columns) as f64, (i / columns) as f64)).collect()
}

/// Agents evenly on a circle of the given radius, counterclockwise from `start` radians.
pub fn ring(count: usize, radius: f64, start: f64) -> Vec<DVec2> {
    (0..count).map(|i| DVec2::from_angle(start + TAU * i as f64 / count as f64) * radius).collect()
}

/// Numbers from −10 to 10, the same for the same seed.
pub fn chance(seed: u64) -> impl FnMut() -> f64 {
    let mut state = seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) | 1;
    move || {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        (state >> 11) as f64 / (1_u64 << 53) as f64 * 20.0 - 10.0
    }
}

/// Agents anywhere in a square of 20 m, on whole centimeters as the page snaps them.
pub fn scattered(count: std::ops::Range<usize>) -> impl Strategy<Value = Vec<DVec2>> {
    vec((-1000i32..=1000, -1000i32..=1000).prop_map(|(x, y)| DVec2::new(f64::from(x), f64::from(y)) / 100.0), count)
}

/// Symmetric, collinear, thin, clustered and common formations of agents that all stand apart.
pub fn apart() -> impl Strategy<Value = Vec<DVec2>> {
    let line = (vec(1u32..400, 1..30), 0.0..TAU).prop_map(|(gaps, angle)| {
        let along = DVec2::from_angle(angle);
        let places = gaps.iter().scan(0.0, |sum, &gap| {
            *sum += f64::from(gap) / 100.0;
            Some(along * *sum)
        });
        places.collect()
    });
    let two_rings = (3usize..16, 3usize..16, 0.0..TAU).prop_map(|(inner, outer, start)| {
        let mut points = ring(inner, 2.0, 0.0);
        points.extend(ring(outer, 5.0, start));
        points
    });
    let far_blocks = (2usize..5, 2usize..5, 20.0..2000.0f64).prop_map(|(columns, rows, away)| {
        let mut points = grid(columns, rows);
        points.extend(grid(rows, columns).into_iter().map(|p| p + DVec2::new(away, away / 3.0)));
        points
    });
    prop_oneof![
        scattered(0..40).prop_map(without_twins),
        (1usize..8, 1usize..8).prop_map(|(columns, rows)| grid(columns, rows)),
        (3usize..40, 0.0..TAU).prop_map(|(count, start)| ring(count, 7.0, start)),
        line,
        two_rings,
        far_blocks,
    ]
}

/// As [`apart`], and with agents in one place or nearly so.
pub fn any_formation() -> impl Strategy<Value = Vec<DVec2>> {
    let twins = (apart(), vec((any::<prop::sample::Index>(), -14i32..-3, 0.0..TAU), 1..6)).prop_map(|(mut points, twins)| {
        for (of, exponent, angle) in twins {
            if !points.is_empty() {
                points.push(points[of.index(points.len())] + DVec2::from_angle(angle) * 10f64.powi(exponent));
            }
        }
        points
    });
    let one_place = (1usize..80, -1e5..1e5f64).prop_map(|(count, x)| vec![DVec2::new(x, -x); count]);
    prop_oneof![apart(), twins, one_place]
}

fn without_twins(mut points: Vec<DVec2>) -> Vec<DVec2> {
    points.sort_by(|p, q| p.x.total_cmp(&q.x).then(p.y.total_cmp(&q.y)));
    points.dedup();
    points
}

/// A turn, then a shift as far as a scene reaches.
#[derive(Clone, Copy, Debug)]
pub struct RigidMotion {
    pub angle: f64,
    pub shift: DVec2,
}

impl RigidMotion {
    pub fn apply(self, point: DVec2) -> DVec2 {
        DVec2::from_angle(self.angle).rotate(point) + self.shift
    }
}

/// Any turn, shifts up to 50 km.
pub fn rigid_motion() -> impl Strategy<Value = RigidMotion> {
    (0.0..TAU, -5e4..5e4f64, -5e4..5e4f64).prop_map(|(angle, x, y)| RigidMotion { angle, shift: DVec2::new(x, y) })
}

/// A formation with every point mapped.
pub fn mapped(points: &[DVec2], map: impl Fn(DVec2) -> DVec2) -> Formation {
    Formation::new(points.iter().map(|&point| map(point)).collect())
}

/// Points together with an order of them: `order[i]` is the new label of agent i.
pub fn relabeled(points: impl Strategy<Value = Vec<DVec2>>) -> impl Strategy<Value = (Vec<DVec2>, Vec<u32>)> {
    points.prop_flat_map(|points| {
        let labels: Vec<u32> = (0..points.len() as u32).collect();
        (Just(points), Just(labels).prop_shuffle())
    })
}
