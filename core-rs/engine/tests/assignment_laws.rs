//! Laws of the assignment, and another solver's opinion.

mod common;

use common::{any_formation, grid, ring, scattered};
use eigenform::assignment::{Assignment, maximize, solve, squared};
use eigenform::formation::Formation;
use glam::DVec2;
use pathfinding::kuhn_munkres::kuhn_munkres_min;
use pathfinding::matrix::Matrix;
use proptest::collection::vec;
use proptest::prelude::*;

/// Square matrices of small whole numbers: many ties, and sums are exact.
fn whole_costs() -> impl Strategy<Value = Vec<Vec<i64>>> {
    (1usize..24, 1i64..1000).prop_flat_map(|(count, greatest)| vec(vec(-greatest..=greatest, count), count))
}

/// Two formations of one number of agents on whole meters.
fn whole_formations() -> impl Strategy<Value = (Vec<DVec2>, Vec<DVec2>)> {
    let point = || (-9i32..=9, -9i32..=9).prop_map(|(x, y)| DVec2::new(f64::from(x), f64::from(y)));
    (1usize..120).prop_flat_map(move |count| (vec(point(), count), vec(point(), count)))
}

fn squared_cost<'a>(source: &'a [DVec2], target: &'a [DVec2]) -> impl Fn(usize, usize) -> f64 + 'a {
    |i, j| source[i].distance_squared(target[j])
}

#[allow(clippy::float_cmp)]
fn assert_least(costs: &[Vec<i64>], assignment: &Assignment) {
    let (least, _) = kuhn_munkres_min(&Matrix::from_rows(costs.iter().cloned()).unwrap());
    let total = assignment.total(|i, j| costs[i][j] as f64);
    assert_eq!(total, least as f64, "sums of whole numbers are exact");
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(300))]

    #[test]
    fn no_assignment_costs_less(costs in whole_costs()) {
        assert_least(&costs, &solve(costs.len(), |i, j| costs[i][j] as f64));
    }

    #[test]
    fn no_assignment_gains_more(gains in whole_costs()) {
        let costs: Vec<Vec<i64>> = gains.iter().map(|row| row.iter().map(|gain| -gain).collect()).collect();
        assert_least(&costs, &maximize(gains.len(), |i, j| gains[i][j] as f64));
    }

    #[test]
    fn no_assignment_has_less_squared_distance((source, target) in whole_formations()) {
        let costs: Vec<Vec<i64>> = source.iter().map(|s| target.iter().map(|t| s.distance_squared(*t) as i64).collect()).collect();
        assert_least(&costs, &squared(&Formation::new(source), &Formation::new(target)));
    }

    #[test]
    fn everyone_gets_a_place_however_agents_stand(source in any_formation(), target in any_formation()) {
        let count = source.len().min(target.len());
        let assignment = squared(&Formation::new(source[..count].to_vec()), &Formation::new(target[..count].to_vec()));
        prop_assert_eq!(assignment.targets().len(), count);
        prop_assert!(Assignment::new(assignment.targets().to_vec()).is_some());
    }

    #[test]
    fn no_two_agents_gain_by_exchanging_places(source in scattered(2..90), target in scattered(90..91)) {
        let cost = squared_cost(&source, &target);
        let assignment = squared(&Formation::new(source.clone()), &Formation::new(target[..source.len()].to_vec()));
        for i in 0..source.len() {
            for j in 0..i {
                let (to_i, to_j) = (assignment.target(i), assignment.target(j));
                // Prices are sums of costs of at most 800 m² each: 1e-9 is thousands of their roundings.
                prop_assert!(cost(i, to_i) + cost(j, to_j) <= cost(i, to_j) + cost(j, to_i) + 1e-9);
            }
        }
    }

    #[test]
    fn a_shifted_copy_is_not_shuffled(points in scattered(1..120), x in -100i32..100) {
        let mut points = points;
        points.sort_by(|p, q| p.x.total_cmp(&q.x).then(p.y.total_cmp(&q.y)));
        points.dedup();
        let shifted = points.iter().map(|&p| p + DVec2::splat(f64::from(x))).collect();
        let everyone_to_their_own: Vec<u32> = (0..points.len() as u32).collect();
        let assignment = squared(&Formation::new(points), &Formation::new(shifted));
        prop_assert_eq!(assignment.targets(), everyone_to_their_own);
    }
}

#[test]
fn shapes_that_need_a_coarse_start_are_optimal_too() {
    let count = 256;
    let shapes = [grid(16, 16), grid(32, 8), ring(count, 15.0, 0.1), (0..count).map(|i| DVec2::new(i as f64, 0.5)).collect()];
    for source in &shapes {
        for target in &shapes {
            let cost = squared_cost(source, target);
            let plain = solve(count, &cost).total(&cost);
            let coarse = squared(&Formation::new(source.clone()), &Formation::new(target.clone())).total(&cost);
            // Each total is a sum of rounded prices; 1e-12 is thousands of roundings of it.
            assert!((plain - coarse).abs() <= 1e-12 * plain.max(1.0), "{plain} {coarse}");
        }
    }
}

#[test]
fn equal_costs_give_everyone_their_own_index() {
    assert_eq!(solve(5, |_, _| 3.0).targets(), [0, 1, 2, 3, 4]);
}

#[test]
fn nobody_is_assigned_to_nothing() {
    assert_eq!(solve(0, |_, _| 1.0).targets(), [0u32; 0]);
}

#[test]
fn a_target_taken_twice_or_missing_is_no_assignment() {
    assert_eq!(Assignment::new(vec![0, 0]), None);
    assert_eq!(Assignment::new(vec![1, 2]), None);
    assert!(Assignment::new(vec![2, 0, 1]).is_some());
}
