//! Measures in space: what moving, turning or scaling a motion does to its numbers, and a level motion's numbers.

use eigenform::adjacency::{Adjacency, AdjacencySpec, build};
use eigenform::measure::{Measures, measure, score};
use eigenform::motion::Motion;
use glam::DVec3;
use proptest::collection::vec;
use proptest::prelude::*;

use super::cases::{formation, rigid};

const MINIMUM_DISTANCE: f64 = 1.23;

/// Everybody on a grid of half a meter at every sample, a sample a second.
fn cases() -> impl Strategy<Value = Vec<Vec<DVec3>>> {
    (1usize..10, 2usize..8).prop_flat_map(|(agent_count, sample_count)| {
        let place = (-12i32..=12, -12i32..=12, -4i32..=4).prop_map(|(x, y, z)| DVec3::new(f64::from(x), f64::from(y), f64::from(z)) / 2.0);
        vec(vec(place, agent_count), sample_count)
    })
}

fn graphs(samples: &[Vec<DVec3>]) -> [Adjacency; 2] {
    [&samples[0], &samples[samples.len() - 1]].map(|points| build(&formation(points), &AdjacencySpec::default(), &[]).unwrap())
}

fn measured(samples: &[Vec<DVec3>], graphs: &[Adjacency; 2], minimum_distance: f64) -> Measures {
    let ts: Vec<f64> = (0..samples.len()).map(|k| k as f64 / (samples.len() - 1) as f64).collect();
    let (plan, heights) = samples.iter().flatten().map(|place| (place.truncate(), place.z)).unzip();
    let motion = Motion::spatial((0..samples.len()).map(|k| k as f64).collect(), samples[0].len(), plan, heights);
    let graphs = [&graphs[0], &graphs[1]];
    let measures = measure(&motion, &ts, graphs, minimum_distance).0;
    // Sampled, the least distance cannot be less than between samples too.
    let sampled = score(&motion, &ts, graphs, minimum_distance).clearance;
    assert!(sampled.is_none_or(|least| least >= measures.clearance.expect("two agents").distance - 1e-9));
    measures
}

fn assert_alike(one: &Measures, other: &Measures, scale: f64) {
    // As on the plane: lengths err by 1e-13 · scale, angles by 1e-12, and a shift of 50 km costs both 1e-5 of that.
    let close = |p: f64, q: f64| assert!((p - q).abs() <= 1e-8 * q.abs().max(1.0), "{p} is not {q}: {one:?} {other:?}");
    close(other.distortion.mean, one.distortion.mean);
    close(other.turning.mean, one.turning.mean);
    close(other.path_length.mean, scale * one.path_length.mean);
    close(other.top_speed.speed, scale * one.top_speed.speed);
    close(other.rms_radius.max, scale * one.rms_radius.max);
    assert_eq!(other.near_collisions, one.near_collisions);
    if let (Some(other), Some(one)) = (other.clearance, one.clearance) {
        close(other.distance, scale * one.distance);
    }
}

proptest! {
    #[test]
    fn a_common_rigid_motion_changes_no_number(samples in cases(), rigid in rigid()) {
        let graphs = graphs(&samples);
        let moved: Vec<_> = samples.iter().map(|points| rigid.apply(points)).collect();
        assert_alike(&measured(&samples, &graphs, MINIMUM_DISTANCE), &measured(&moved, &graphs, MINIMUM_DISTANCE), 1.0);
    }

    #[test]
    fn a_level_motion_measures_as_on_the_plane(samples in cases(), height in -9.0..9.0f64) {
        let level: Vec<Vec<DVec3>> = samples.iter().map(|points| points.iter().map(|point| point.with_z(height)).collect()).collect();
        let graphs = graphs(&level);
        let ts: Vec<f64> = (0..level.len()).map(|k| k as f64 / (level.len() - 1) as f64).collect();
        let plan = level.iter().flatten().map(|place| place.truncate()).collect();
        let on_the_plane = Motion::new((0..level.len()).map(|k| k as f64).collect(), level[0].len(), plan);
        let expected = measure(&on_the_plane, &ts, [&graphs[0], &graphs[1]], MINIMUM_DISTANCE).0;
        assert_alike(&expected, &measured(&level, &graphs, MINIMUM_DISTANCE), 1.0);
    }
}
