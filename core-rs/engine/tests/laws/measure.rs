//! Laws of the measures: what moving, scaling, relabeling or reversing a motion does to its numbers.

use eigenform::adjacency::{Adjacency, AdjacencySpec, Tie, build};
use eigenform::formation::Formation;
use eigenform::measure::{Measures, Score, measure, score};
use eigenform::motion::Motion;
use glam::DVec2;
use proptest::collection::vec;
use proptest::prelude::*;

const MINIMUM_DISTANCE: f64 = 1.23;

/// Everybody on a grid of half a meter at every sample, so that steps are zero or half a meter at least and no distance is the minimum
/// distance; a sample a second.
#[derive(Clone, Debug)]
struct Case {
    agent_count: usize,
    samples: Vec<Vec<DVec2>>,
}

fn cases() -> impl Strategy<Value = Case> {
    (1usize..14, 2usize..12).prop_flat_map(|(agent_count, sample_count)| {
        let place = (-20i32..=20, -20i32..=20).prop_map(|(x, y)| DVec2::new(f64::from(x), f64::from(y)) / 2.0);
        vec(vec(place, agent_count), sample_count).prop_map(move |samples| Case { agent_count, samples })
    })
}

impl Case {
    fn graphs(&self) -> [Adjacency; 2] {
        [&self.samples[0], &self.samples[self.samples.len() - 1]]
            .map(|places| build(&Formation::new(places.clone()), &AdjacencySpec::default(), &[]).unwrap())
    }

    fn map(&self, map: impl Fn(DVec2) -> DVec2) -> Self {
        let samples = self.samples.iter().map(|places| places.iter().map(|&place| map(place)).collect()).collect();
        Self { samples, ..*self }
    }

    /// Measured with ties that stay what they are.
    fn measured(&self, graphs: &[Adjacency; 2], minimum_distance: f64) -> (Measures, Score) {
        let count = self.samples.len();
        let ts: Vec<f64> = (0..count).map(|k| k as f64 / (count - 1) as f64).collect();
        let motion = Motion::new((0..count).map(|k| k as f64).collect(), self.agent_count, self.samples.concat());
        let graphs = [&graphs[0], &graphs[1]];
        (measure(&motion, &ts, graphs, minimum_distance).0, score(&motion, &ts, graphs, minimum_distance))
    }
}

/// Lengths and angles of `one` times these are those of `other`.
fn assert_alike(one: &Measures, other: &Measures, scale: f64) {
    // Coordinates are below 1e3 · scale and steps above 0.5 · scale, so a length errs by 1e-13 · scale and an angle by 1e-12; eleven
    // samples add up.
    let close = |p: f64, q: f64| assert!((p - q).abs() <= 1e-9 * q.abs().max(1.0), "{p} is not {q}: {one:?} {other:?}");
    close(other.distortion.mean, one.distortion.mean);
    close(other.distortion.max, one.distortion.max);
    close(other.turning.mean, one.turning.mean);
    close(other.turning.max, one.turning.max);
    assert_eq!(other.near_collisions, one.near_collisions);
    close(other.path_length.mean, scale * one.path_length.mean);
    close(other.path_length.max, scale * one.path_length.max);
    close(other.top_speed.speed, scale * one.top_speed.speed);
    close(other.rms_radius.min, scale * one.rms_radius.min);
    close(other.rms_radius.max, scale * one.rms_radius.max);
    assert_eq!(other.clearance.is_some(), one.clearance.is_some());
    if let (Some(other), Some(one)) = (other.clearance, one.clearance) {
        close(other.distance, scale * one.distance);
    }
}

proptest! {
    #[test]
    fn a_common_rigid_motion_changes_no_number(case in cases(), angle in 0.0..6.3f64, x in -500.0..500.0f64) {
        let graphs = case.graphs();
        let moved = case.map(|place| DVec2::from_angle(angle).rotate(place) + DVec2::new(x, -x));
        assert_alike(&case.measured(&graphs, MINIMUM_DISTANCE).0, &moved.measured(&graphs, MINIMUM_DISTANCE).0, 1.0);
    }

    #[test]
    fn a_mirror_changes_no_number(case in cases()) {
        let graphs = case.graphs();
        let mirrored = case.map(|place| DVec2::new(-place.x, place.y));
        assert_alike(&case.measured(&graphs, MINIMUM_DISTANCE).0, &mirrored.measured(&graphs, MINIMUM_DISTANCE).0, 1.0);
    }

    #[test]
    fn scale_scales_lengths_and_leaves_the_rest(case in cases(), scale in 0.01..100.0f64) {
        let graphs = case.graphs();
        let scaled = case.map(|place| place * scale);
        // Ten micrometers of tolerance at the smallest scale are less than what keeps distances off the minimum distance.
        let scaled = scaled.measured(&graphs, MINIMUM_DISTANCE * scale);
        let (measures, score) = case.measured(&graphs, MINIMUM_DISTANCE);
        assert_alike(&measures, &scaled.0, scale);
        prop_assert!((scaled.1.total - score.total).abs() < 2e-6, "equal up to a step of rounding");
    }

    #[test]
    fn relabeling_changes_no_number((case, labels) in cases().prop_flat_map(|case| {
        let labels: Vec<usize> = (0..case.agent_count).collect();
        (Just(case), Just(labels).prop_shuffle())
    })) {
        let relabel = |places: &Vec<DVec2>| {
            let mut moved = places.clone();
            labels.iter().zip(places).for_each(|(&label, &place)| moved[label] = place);
            moved
        };
        let graphs = case.graphs();
        let relabeled_graphs = graphs.each_ref().map(|graph| {
            let label = |agent: u32| labels[agent as usize] as u32;
            let mut ties: Vec<Tie> = graph.ties().iter().map(|tie| {
                let (a, b) = (label(tie.a), label(tie.b));
                Tie { a: a.min(b), b: a.max(b), ..*tie }
            }).collect();
            ties.sort_by_key(|tie| (tie.a, tie.b));
            Adjacency::new(case.agent_count, ties)
        });
        let relabeled = Case { samples: case.samples.iter().map(relabel).collect(), ..case };
        assert_alike(&case.measured(&graphs, MINIMUM_DISTANCE).0, &relabeled.measured(&relabeled_graphs, MINIMUM_DISTANCE).0, 1.0);
    }

    #[test]
    fn going_back_measures_as_going(case in cases()) {
        let graphs = case.graphs();
        let mut back = case.clone();
        back.samples.reverse();
        let back_graphs = [graphs[1].clone(), graphs[0].clone()];
        assert_alike(&case.measured(&graphs, MINIMUM_DISTANCE).0, &back.measured(&back_graphs, MINIMUM_DISTANCE).0, 1.0);
    }

    #[test]
    fn a_formation_that_only_turns_and_travels_is_not_distorted(points in crate::formations::apart(), angle in -3.0..3.0f64, x in -50.0..50.0f64) {
        prop_assume!(!points.is_empty());
        let at = |t: f64| points.iter().map(|&p| DVec2::from_angle(angle * t).rotate(p) + DVec2::new(x, 1.0) * t).collect::<Vec<_>>();
        let case = Case { agent_count: points.len(), samples: (0..6).map(|k| at(f64::from(k) / 5.0)).collect() };
        // Ties are 1 cm or longer and coordinates below 3 km: 1e-12 m of rounding is 1e-10 of a tie.
        prop_assert!(case.measured(&case.graphs(), 0.0).0.distortion.max < 1e-9);
    }
}
