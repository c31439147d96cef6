//! Laws of the assignment, and another solver's opinion.

mod around;

use crate::formations::{any_formation, grid, relabeled, ring, scattered};
use eigenform::assignment::{Assignment, AssignmentSpec, Cost, Job, Question, assign, cost_of, maximize, solve, squared};
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

const COSTS: [Cost; 5] = [Cost::Squared, Cost::LeastEffort, Cost::Euclidean, Cost::Manhattan, Cost::Keep];

fn question<'a>(source: &'a Formation, target: &'a Formation, spec: &'a AssignmentSpec) -> Question<'a> {
    Question { source, target, spec, sections: &[], is_flipped: false, is_predicted: false }
}

fn of_cost(cost: Cost) -> AssignmentSpec {
    AssignmentSpec { cost, ..AssignmentSpec::default() }
}

/// Every order of the numbers below `count`.
fn orders(count: u32) -> Vec<Vec<u32>> {
    if count == 0 {
        return vec![vec![]];
    }
    let with = |order: Vec<u32>| (0..=order.len()).map(move |at| [&order[..at], &[count - 1], &order[at..]].concat());
    orders(count - 1).into_iter().flat_map(with).collect()
}

/// Two formations of one number of agents, in plan or in space, and some locks.
fn small_questions(most: usize) -> impl Strategy<Value = (Formation, Formation, Vec<(u32, u32)>)> {
    (1..=most, any::<bool>()).prop_flat_map(|(count, is_spatial)| {
        let formation = move || {
            (scattered(count..count + 1), vec(-5..5_i32, count)).prop_map(move |(plan, heights)| {
                let heights = heights.into_iter().map(f64::from).collect();
                if is_spatial { Formation::spatial(plan, heights) } else { Formation::new(plan) }
            })
        };
        let everybody = Just((0..count as u32).collect::<Vec<_>>());
        let locks = (everybody.clone().prop_shuffle(), everybody.prop_shuffle(), 0..=count.min(2))
            .prop_map(|(agents, slots, count)| agents.into_iter().zip(slots).take(count).collect());
        (formation(), formation(), locks)
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(100))]

    #[test]
    fn of_all_assignments_with_these_locks_none_costs_less((source, target, locks) in small_questions(6)) {
        for cost in COSTS.into_iter().filter(|cost| *cost != Cost::Keep) {
            let spec = AssignmentSpec { lambda: 0.3, locks: locks.clone(), ..of_cost(cost) };
            let asked = question(&source, &target, &spec);
            let answer = assign(&asked).unwrap();
            let keeps = |order: &[u32]| locks.iter().all(|(agent, slot)| order[*agent as usize] == *slot);
            prop_assert!(keeps(answer.targets()));
            let all = orders(source.agent_count() as u32).into_iter().filter(|order| keeps(order));
            let least = all.map(|order| cost_of(&asked, &Assignment::new(order).unwrap(), &[])).fold(f64::INFINITY, f64::min);
            // Six costs below 10⁴: 1e-9 is hundreds of their roundings.
            prop_assert!(cost_of(&asked, &answer, &[]) <= least + 1e-9, "{cost:?}: {} {least}", cost_of(&asked, &answer, &[]));
        }
    }

    #[test]
    fn whoever_is_not_in_the_way_of_a_lock_keeps_their_place((source, target, locks) in small_questions(40)) {
        let spec = AssignmentSpec { locks: locks.clone(), ..of_cost(Cost::Keep) };
        let answer = assign(&question(&source, &target, &spec)).unwrap();
        prop_assert!(locks.iter().all(|(agent, slot)| answer.target(*agent as usize) == *slot as usize));
        let moved = answer.targets().iter().enumerate().filter(|(agent, slot)| *agent != **slot as usize).count();
        prop_assert!(moved <= 2 * locks.len());
    }

    #[test]
    fn least_squares_never_turn_two_agents_against_each_other((source, target, _) in small_questions(60)) {
        let answer = squared(&source, &target);
        let places = |agent: usize| (source.places().at(agent), target.places().at(answer.target(agent)));
        for i in 0..source.agent_count() {
            for j in 0..i {
                let ((from, to), (other_from, other_to)) = (places(i), places(j));
                // Prices are sums of costs of at most 900 m²: 1e-9 is thousands of their roundings.
                prop_assert!((from - other_from).dot(to - other_to) >= -1e-9);
            }
        }
    }

    /// Hundredths of a meter anywhere: two assignments of one cost would be chance.
    #[test]
    fn new_labels_relabel_the_answer((positions, labels) in relabeled(scattered(2..60))) {
        let target = Formation::new(ring(positions.len(), 9.0, 0.123));
        for cost in [Cost::Squared, Cost::LeastEffort, Cost::Euclidean] {
            let total = |positions: &[DVec2]| {
                let (source, spec) = (Formation::new(positions.to_vec()), of_cost(cost));
                let asked = question(&source, &target, &spec);
                cost_of(&asked, &assign(&asked).unwrap(), &[])
            };
            let mut moved = positions.clone();
            labels.iter().zip(&positions).for_each(|(label, p)| moved[*label as usize] = *p);
            let (first, second) = (total(&positions), total(&moved));
            prop_assert!((first - second).abs() <= 1e-12 * first.max(1.0), "{cost:?}: {first} {second}");
        }
    }

    /// Two groups and some by themselves: no slot of one group is nearer than one of the other to its barycenter, all in all.
    #[test]
    fn a_line_parts_the_regions_of_two_groups((source, target, _) in small_questions(40), seats in vec(0..3_u32, 40)) {
        let section = |agent: usize| (seats[agent] < 2).then_some(seats[agent]);
        let sections = [(0..source.agent_count()).map(section).collect::<Vec<_>>()];
        let spec = AssignmentSpec { keep_groups: true, ..of_cost(Cost::Manhattan) };
        let answer = assign(&Question { sections: &sections, ..question(&source, &target, &spec) }).unwrap();
        let members = |group: u32| (0..source.agent_count()).filter(|agent| seats[*agent] == group).collect::<Vec<_>>();
        let [first, second] = [members(0), members(1)];
        let middle = |agents: &[usize]| agents.iter().map(|a| source.places().at(*a)).sum::<glam::DVec3>() / agents.len() as f64;
        for (i, j) in first.iter().flat_map(|i| second.iter().map(move |j| (*i, *j))) {
            let away = target.places().at(answer.target(i)) - target.places().at(answer.target(j));
            // As above.
            prop_assert!((middle(&first) - middle(&second)).dot(away) >= -1e-9);
        }
    }
}

#[test]
fn groups_get_regions_and_groups_within_them_regions_of_those() {
    // Four in a row, in two groups of two, in one group; two more by themselves. Slots in the other order, all 20 m off.
    let source = Formation::new((0..6).map(|x| DVec2::new(f64::from(x), 0.0)).collect());
    let target = Formation::new((0..6).map(|x| DVec2::new(f64::from(25 - x), 0.0)).collect());
    let sections = [[Some(0), Some(0), Some(0), Some(0), None, None], [Some(1), Some(2), Some(1), Some(2), None, None]].map(Vec::from);
    let spec = AssignmentSpec { keep_groups: true, ..AssignmentSpec::default() };
    let answer = assign(&Question { sections: &sections, ..question(&source, &target, &spec) }).unwrap();
    assert_eq!(answer.targets(), [5, 3, 4, 2, 1, 0]);
}

#[test]
fn a_large_crowd_keeps_its_groups_whatever_the_cost() {
    let (source, target) = (Formation::new(grid(20, 15)), Formation::new(ring(300, 12.0, 0.1)));
    let sections = [(0..300).map(|agent| Some(agent / 60)).collect::<Vec<_>>()];
    for cost in COSTS {
        let spec = AssignmentSpec { keep_groups: true, ..of_cost(cost) };
        let asked = Question { sections: &sections, ..question(&source, &target, &spec) };
        assert_eq!(assign(&asked), assign(&asked));
    }
}

#[test]
fn a_flip_mirrors_and_a_prediction_carries_everybody_along() {
    let line = Formation::new((0..9).map(|x| DVec2::new(f64::from(x), 0.0)).collect());
    let spec = AssignmentSpec::default();
    let flipped = assign(&Question { is_flipped: true, ..question(&line, &line, &spec) }).unwrap();
    assert_eq!(flipped.targets(), [8, 7, 6, 5, 4, 3, 2, 1, 0]);

    // A block turned by a quarter and stretched along one axis: three of its corners tell where all others go.
    let block = Formation::new(grid(5, 4));
    let turned = Formation::new(grid(5, 4).into_iter().map(|p| DVec2::new(-3.0 * p.y, 2.0 * p.x)).collect());
    let everyone_to_their_own: Vec<u32> = (0..20).collect();
    for locks in [&[0, 4, 15][..], &[0, 4, 15, 19]] {
        let spec = AssignmentSpec { locks: locks.iter().map(|corner| (*corner, *corner)).collect(), ..AssignmentSpec::default() };
        let predicted = assign(&Question { is_predicted: true, ..question(&block, &turned, &spec) }).unwrap();
        assert_eq!(predicted.targets(), everyone_to_their_own);
    }
    // Without stretching two tell as much, shifted by whatever one does.
    let turned = Formation::new(grid(5, 4).into_iter().map(|p| DVec2::new(-2.0 * p.y + 7.0, 2.0 * p.x)).collect());
    let spec = AssignmentSpec { locks: vec![(0, 0), (4, 4)], ..AssignmentSpec::default() };
    let predicted = assign(&Question { is_predicted: true, ..question(&block, &turned, &spec) }).unwrap();
    assert_eq!(predicted.targets(), everyone_to_their_own);
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

proptest! {
    #[test]
    fn slots_that_cost_nothing_leave_the_others_to_the_nearest((source, target) in whole_formations(), seed in any::<u64>()) {
        let spared: Vec<u32> = (0..source.len() as u32).filter(|slot| seed.rotate_left(*slot) % 4 == 0).collect();
        let costs: Vec<Vec<i64>> = source.iter().map(|from| {
            let cost = |(slot, to): (u32, &DVec2)| if spared.contains(&slot) { 0 } else { from.distance_squared(*to) as i64 };
            (0..).zip(&target).map(cost).collect()
        }).collect();
        let [source, target] = [source, target].map(Formation::new);
        let spec = AssignmentSpec::default();
        let mut job = Job::new(&question(&source, &target, &spec)).unwrap().sparing(&spared);
        while job.step().unwrap() < 1.0 {}
        assert_least(&costs, &job.into_assignment());
    }
}

#[test]
fn how_far_it_is_rises_with_every_step() {
    // A drawn line to a ring: prices come from problems with fewer and fewer agents.
    let count = 800;
    let line = (0..count).map(|at| DVec2::new(f64::from(at), 0.0)).collect();
    let [source, target] = [line, ring(count as usize, 300.0, 0.3)].map(Formation::new);
    let spec = AssignmentSpec { cost: Cost::Squared, ..AssignmentSpec::default() };
    let mut job = Job::new(&question(&source, &target, &spec)).unwrap();
    let mut said = vec![0.0];
    while *said.last().unwrap() < 1.0 {
        said.push(job.step().unwrap());
    }
    assert!(said.is_sorted_by(|before, after| before < after), "{said:?}");
}
