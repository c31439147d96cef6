//! Laws of the graph that places in space suggest.

use eigenform::adjacency::propose;
use glam::DVec3;
use proptest::prelude::*;

use super::cases::{apart, formation, rigid};

/// Whether a ball through both, about a center near enough, keeps everybody else out: tried at random, so it can only confirm.
fn has_empty_ball(points: &[DVec3], a: usize, b: usize, around: usize) -> bool {
    let middle = points[a].midpoint(points[b]);
    let (e, f) = (points[b] - points[a]).normalize().any_orthonormal_pair();
    let half = points[a].distance(points[b]) / 2.0;
    (0..around * around).any(|i| {
        let [x, y] = [i % around, i / around].map(|step| (step as f64 / (around - 1) as f64 - 0.5) * 6.0 * half);
        let center = middle + x * e + y * f;
        let radius = center.distance(points[a]);
        points.iter().enumerate().all(|(c, point)| c == a || c == b || point.distance(center) > radius * (1.0 + 1e-4))
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(150))]

    #[test]
    fn relabeling_relabels_the_edges((points, labels) in apart().prop_flat_map(|points| {
        let labels: Vec<u32> = (0..points.len() as u32).collect();
        (Just(points), Just(labels).prop_shuffle())
    })) {
        let mut moved = points.clone();
        labels.iter().zip(&points).for_each(|(&label, &point)| moved[label as usize] = point);
        let label = |agent: u32| labels[agent as usize];
        let mut expected: Vec<(u32, u32)> =
            propose(&formation(&points)).into_iter().map(|(a, b)| (label(a).min(label(b)), label(a).max(label(b)))).collect();
        expected.sort_unstable();
        prop_assert_eq!(propose(&formation(&moved)), expected);
    }

    #[test]
    fn a_rigid_motion_keeps_the_edges(points in apart(), rigid in rigid()) {
        prop_assert_eq!(propose(&formation(&rigid.apply(&points))), propose(&formation(&points)));
    }

    #[test]
    fn a_mirror_keeps_the_edges(points in apart(), axis in 0usize..3) {
        let mirrored: Vec<DVec3> = points.iter().map(|point| point.with_mirror(axis)).collect();
        prop_assert_eq!(propose(&formation(&mirrored)), propose(&formation(&points)));
    }

    #[test]
    fn scaling_keeps_the_edges(points in apart(), exponent in -6.0..4.0f64) {
        let scaled: Vec<DVec3> = points.iter().map(|point| point * 10f64.powf(exponent)).collect();
        prop_assert_eq!(propose(&formation(&scaled)), propose(&formation(&points)));
    }

    #[test]
    fn everybody_is_connected(points in apart(), rigid in rigid(), twin in any::<prop::sample::Index>(), exponent in -14i32..-3) {
        let mut points = rigid.apply(&points);
        if !points.is_empty() {
            points.push(points[twin.index(points.len())] + DVec3::Z * 10f64.powi(exponent));
        }
        let mut reached = vec![false; points.len()];
        let edges = propose(&formation(&points));
        let mut frontier = vec![0u32];
        while let Some(agent) = frontier.pop().filter(|_| !points.is_empty()) {
            if !std::mem::replace(&mut reached[agent as usize], true) {
                frontier.extend(edges.iter().filter(|edge| edge.0 == agent).map(|edge| edge.1));
                frontier.extend(edges.iter().filter(|edge| edge.1 == agent).map(|edge| edge.0));
            }
        }
        prop_assert!(reached.into_iter().all(|reached| reached));
        prop_assert!(edges.is_sorted_by(|p, q| p < q) && edges.iter().all(|(a, b)| a < b));
    }

    /// Against the definition, asked in another way.
    #[test]
    fn who_shares_an_empty_ball_is_tied(seed in any::<u64>()) {
        let points = super::cases::scattered(14, seed);
        let edges = propose(&formation(&points));
        for b in 0..points.len() {
            for a in 0..b {
                let is_tied = edges.contains(&(a as u32, b as u32));
                prop_assert!(is_tied || !has_empty_ball(&points, a, b, 13), "{a} and {b} share an empty ball");
            }
        }
    }
}

trait WithMirror {
    fn with_mirror(&self, axis: usize) -> DVec3;
}

impl WithMirror for DVec3 {
    fn with_mirror(&self, axis: usize) -> DVec3 {
        let mut mirrored = *self;
        mirrored[axis] = -mirrored[axis];
        mirrored
    }
}

/// Nobody else is inside the ball whose diameter two agents are: then they are tied whatever else is true.
#[test]
fn the_nearest_are_always_tied() {
    for seed in 0..40 {
        let points = super::cases::scattered(40, seed);
        let edges = propose(&formation(&points));
        for a in 0..points.len() {
            let nearest = (0..points.len())
                .filter(|&b| b != a)
                .min_by(|&p, &q| points[p].distance(points[a]).total_cmp(&points[q].distance(points[a])));
            let b = nearest.expect("there are others");
            assert!(edges.contains(&(a.min(b) as u32, a.max(b) as u32)), "{a} and its nearest {b} of seed {seed}");
        }
    }
}
