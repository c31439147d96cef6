//! Proposals for groups: who stands together, whatever the labels, and an answer for every graph.

use eigenform::adjacency::{Adjacency, AdjacencySpec, Base, build};
use eigenform::formation::Formation;
use eigenform::grouping::{AffinityJob, Branch, Metric, Preference, Way, propose};
use glam::DVec2;
use proptest::prelude::*;

use crate::formations::{any_formation, grid, relabeled, ring};

fn graph(positions: &[DVec2], spec: &AdjacencySpec) -> (Formation, Adjacency) {
    let formation = Formation::new(positions.to_vec());
    let adjacency = build(&formation, spec, &[]).expect("few ties");
    (formation, adjacency)
}

fn proposed(positions: &[DVec2], spec: &AdjacencySpec, way: Way) -> Vec<Branch> {
    let (formation, adjacency) = graph(positions, spec);
    let everyone: Vec<u32> = (0..positions.len() as u32).collect();
    propose(&formation, &adjacency, &everyone, way)
}

/// Every set of the tree, outer before inner.
fn sets(branches: &[Branch]) -> Vec<Vec<u32>> {
    fn set(branch: &Branch) -> Vec<u32> {
        let mut all: Vec<u32> = branch.members.iter().copied().chain(branch.children.iter().flat_map(set)).collect();
        all.sort_unstable();
        all
    }
    branches.iter().flat_map(|branch| [vec![set(branch)], sets(&branch.children)].concat()).collect()
}

/// Blocks of 3 × 2 around the centers.
fn blocks(centers: &[[f64; 2]]) -> Vec<DVec2> {
    centers.iter().flat_map(|center| grid(3, 2).into_iter().map(|p| DVec2::from_array(*center) + p)).collect()
}

const THREE: [[f64; 2]; 3] = [[0.0, 0.0], [9.0, 1.0], [3.0, 8.0]];

#[test]
fn three_blocks_are_three_parts() {
    let expected: Vec<Vec<u32>> = (0..3).map(|block| (6 * block..6 * block + 6).collect()).collect();
    assert_eq!(sets(&proposed(&blocks(&THREE), &AdjacencySpec::default(), Way::Parts { count: 3 })), expected);
}

#[test]
fn three_lines_are_three_parts_although_many_long_ties_lead_across() {
    let line = |x: f64, y: f64| (0..12).map(move |i| DVec2::new(x + 0.5 * f64::from(i), y));
    let lines: Vec<DVec2> = [(0.0, 0.0), (15.0, 0.0), (27.0, -10.0)].into_iter().flat_map(|(x, y)| line(x, y)).collect();
    let expected: Vec<Vec<u32>> = (0..3).map(|block| (12 * block..12 * block + 12).collect()).collect();
    assert_eq!(sets(&proposed(&lines, &AdjacencySpec::default(), Way::Parts { count: 3 })), expected);
}

#[test]
fn two_pairs_of_blocks_are_bisected_twice() {
    let four = blocks(&[[0.0, 0.0], [5.0, 0.5], [30.0, 0.0], [35.0, 1.0]]);
    let range = |from: u32, to: u32| (from..to).collect::<Vec<_>>();
    let expected = [range(0, 12), range(0, 6), range(6, 12), range(12, 24), range(12, 18), range(18, 24)];
    assert_eq!(sets(&proposed(&four, &AdjacencySpec::default(), Way::Bisect { levels: 2 })), expected);
}

#[test]
fn a_ring_comes_apart_evenly() {
    for (count, parts) in [(12, 3), (12, 4), (200, 5)] {
        let groups = proposed(&ring(count, 9.0, 0.1), &AdjacencySpec::default(), Way::Parts { count: parts });
        assert!(groups.iter().all(|group| group.members.len() == count / parts as usize), "{count} in {parts}: {groups:?}");
    }
}

#[test]
fn a_square_grid_is_cut_along_its_columns() {
    let groups = proposed(&grid(6, 6), &AdjacencySpec::default(), Way::Bisect { levels: 1 });
    let left: Vec<u32> = (0..36).filter(|agent| agent % 6 < 3).collect();
    assert_eq!(groups[0].members, left);
}

#[test]
fn only_firm_ties_connect() {
    let spec = AdjacencySpec { ties: vec![(0, 3, 5.0), (3, 4, 20.0), (7, 8, 4.0), (1, 2, 4.9)], ..AdjacencySpec::default() };
    let groups = proposed(&grid(3, 3), &spec, Way::Connected { factor: 5.0 });
    assert_eq!(groups, [Branch::leaf(vec![0, 3, 4])]);
    assert_eq!(proposed(&grid(3, 3), &spec, Way::Connected { factor: 1.0 }), [Branch::leaf((0..9).collect())]);
}

#[test]
fn a_cut_graph_falls_apart_along_its_pieces() {
    let spec = AdjacencySpec { base: Base::None, ties: vec![(0, 1, 1.0), (1, 2, 1.0), (4, 5, 1.0)], ..AdjacencySpec::default() };
    let groups = proposed(&grid(3, 2), &spec, Way::Parts { count: 3 });
    assert_eq!(groups, [vec![0, 1, 2], vec![3], vec![4, 5]].map(Branch::leaf));
}

#[test]
fn few_agents_are_a_group_each_and_nobody_is_none() {
    let spec = AdjacencySpec::default();
    assert_eq!(proposed(&[], &spec, Way::Parts { count: 3 }), []);
    assert_eq!(proposed(&[DVec2::ONE], &spec, Way::Parts { count: 3 }), [Branch::leaf(vec![0])]);
    assert_eq!(proposed(&[DVec2::ONE], &spec, Way::Bisect { levels: 3 }), []);
    assert_eq!(proposed(&[DVec2::X, DVec2::ZERO], &spec, Way::Bisect { levels: 3 }), [vec![0], vec![1]].map(Branch::leaf));
}

#[test]
fn a_proposal_for_some_leaves_the_others_alone() {
    let (formation, adjacency) = graph(&blocks(&THREE), &AdjacencySpec::default());
    let some: Vec<u32> = (6..18).rev().collect();
    let expected = [(6..12).collect(), (12..18).collect()].map(Branch::leaf);
    assert_eq!(propose(&formation, &adjacency, &some, Way::Parts { count: 2 }), expected);
}

/// Groups by affinity, everybody asked.
fn alike(source: &[DVec2], target: &[DVec2], metric: Metric, preference: Preference) -> Vec<Vec<u32>> {
    let [from, to] = [source, target].map(|points| Formation::new(points.to_vec()));
    let everyone: Vec<u32> = (0..source.len() as u32).rev().collect();
    let mut job = AffinityJob::new(&from, &to, &everyone, metric, preference);
    while job.step() < 1.0 {}
    job.groups().into_iter().map(|group| group.members).collect()
}

const MEDIAN: Preference = Preference::OfMedian(1.0);

/// The three blocks, each turned and shifted by itself, in which everybody strays by up to 0.3 m: of agents all alike it is chance who
/// leads, and when.
fn blocks_apart() -> (Vec<DVec2>, Vec<DVec2>) {
    let ways = [(0.4, [-20.0, 3.0]), (-1.3, [11.0, -7.0]), (2.5, [4.0, 30.0])];
    let moved = |(agent, place): (usize, DVec2)| {
        let (angle, shift) = ways[agent / 6];
        let turned = DVec2::from_angle(angle).rotate(place - DVec2::from_array(THREE[agent / 6])) + DVec2::from_array(shift);
        turned + strayed(agent)
    };
    (blocks(&THREE), blocks(&THREE).into_iter().enumerate().map(moved).collect())
}

fn strayed(agent: usize) -> DVec2 {
    0.2 * DVec2::new((3.7 * agent as f64).sin(), (5.3 * agent as f64).cos())
}

#[test]
fn those_who_keep_their_distances_are_a_group() {
    let (source, target) = blocks_apart();
    let expected: Vec<Vec<u32>> = (0..3).map(|block| (6 * block..6 * block + 6).collect()).collect();
    assert_eq!(alike(&source, &target, Metric::Euclidean, MEDIAN), expected);
    // Along the axes a turn changes distances, a shift does not.
    let shifts = [DVec2::new(-20.0, -20.0), DVec2::new(20.0, 0.0), DVec2::new(0.0, 20.0)];
    let shifted: Vec<DVec2> = source.iter().enumerate().map(|(agent, place)| *place + shifts[agent / 6] + strayed(agent)).collect();
    assert_eq!(alike(&source, &shifted, Metric::Manhattan, MEDIAN), expected);
}

/// Whoever is as far ahead in a block as the other's middle keeps the distance to it, too.
#[test]
fn blocks_that_change_places_are_the_groups() {
    let block = grid(5, 5);
    let beside: Vec<DVec2> = block.iter().map(|place| *place + DVec2::new(20.0, 0.0)).collect();
    let (source, target) = ([&block[..], &beside].concat(), [&beside[..], &block].concat());
    assert_eq!(alike(&source, &target, Metric::Euclidean, MEDIAN), [(0..25).collect::<Vec<u32>>(), (25..50).collect()]);
}

#[test]
fn who_moves_as_one_is_one_group_and_whoever_prefers_it_stands_alone() {
    let points = grid(5, 3);
    let turned: Vec<DVec2> = points.iter().map(|p| DVec2::from_angle(1.0).rotate(*p) + 700.0).collect();
    assert_eq!(alike(&points, &turned, Metric::Euclidean, MEDIAN), [(0..15).collect::<Vec<u32>>()]);
    let (source, target) = blocks_apart();
    assert_eq!(alike(&source, &target, Metric::Euclidean, Preference::Of(1.0)).len(), 18);
    assert_eq!(alike(&source, &target, Metric::Euclidean, Preference::Of(-1e6)).len(), 1);
}

#[test]
fn few_agents_have_an_affinity_too() {
    let none: [Vec<u32>; 0] = [];
    assert_eq!(alike(&[], &[], Metric::Euclidean, MEDIAN), none);
    assert_eq!(alike(&[DVec2::ONE], &[DVec2::X], Metric::Euclidean, MEDIAN), [[0]]);
    // The median of 0, 0, −1 and −1 is above −1.
    assert_eq!(alike(&[DVec2::ZERO, DVec2::X], &[DVec2::ZERO, DVec2::X * 2.0], Metric::Euclidean, MEDIAN), [[0], [1]]);
}

fn any_way() -> impl Strategy<Value = Way> {
    prop_oneof![
        (1_u32..5).prop_map(|levels| Way::Bisect { levels }),
        (1_u32..9).prop_map(|count| Way::Parts { count }),
        (0.5..3.0).prop_map(|factor| Way::Connected { factor }),
    ]
}

proptest! {
    #[test]
    fn nobody_is_in_two_groups_and_no_group_is_empty(positions in any_formation(), way in any_way()) {
        let groups = proposed(&positions, &AdjacencySpec::default(), way);
        let tops: Vec<Vec<u32>> = groups.iter().flat_map(|group| sets(std::slice::from_ref(group)).into_iter().take(1)).collect();
        let mut all = tops.concat();
        all.sort_unstable();
        prop_assert!(all.is_sorted_by(|a, b| a < b));
        prop_assert!(sets(&groups).iter().all(|set| !set.is_empty()));
        if let Way::Parts { count } = way {
            prop_assert_eq!(all.len(), positions.len());
            prop_assert!(groups.len() <= count as usize);
        }
        prop_assert_eq!(groups, proposed(&positions, &AdjacencySpec::default(), way), "the same again");
    }

    /// Blocks at places that nothing makes alike; who is who does not matter.
    #[test]
    fn new_labels_relabel_the_groups((positions, labels) in relabeled(Just(blocks(&THREE)))) {
        let mut moved = positions.clone();
        labels.iter().zip(&positions).for_each(|(label, p)| moved[*label as usize] = *p);
        for way in [Way::Bisect { levels: 2 }, Way::Parts { count: 5 }] {
            let renamed = |groups: &[Branch]| {
                let mut all: Vec<Vec<u32>> = sets(groups).iter().map(|set| set.iter().map(|agent| labels[*agent as usize]).collect()).collect();
                for set in &mut all {
                    set.sort_unstable();
                }
                all.sort();
                all
            };
            let mut found = sets(&proposed(&moved, &AdjacencySpec::default(), way));
            found.sort();
            prop_assert_eq!(renamed(&proposed(&positions, &AdjacencySpec::default(), way)), found);
        }
    }

    #[test]
    fn everybody_is_in_one_group_by_affinity_however_they_stand(source in any_formation(), target in any_formation()) {
        let count = source.len().min(target.len());
        let groups = alike(&source[..count], &target[..count], Metric::Euclidean, MEDIAN);
        let mut all = groups.concat();
        all.sort_unstable();
        prop_assert_eq!(all, (0..count as u32).collect::<Vec<_>>());
        prop_assert_eq!(groups, alike(&source[..count], &target[..count], Metric::Euclidean, MEDIAN), "the same again");
    }

    #[test]
    fn new_labels_relabel_the_groups_by_affinity((source, labels) in relabeled(Just(blocks_apart().0))) {
        let target = blocks_apart().1;
        let moved = |points: &[DVec2]| {
            let mut moved = points.to_vec();
            labels.iter().zip(points).for_each(|(label, p)| moved[*label as usize] = *p);
            moved
        };
        let renamed = |groups: Vec<Vec<u32>>| {
            let mut all: Vec<Vec<u32>> = groups.iter().map(|set| set.iter().map(|agent| labels[*agent as usize]).collect()).collect();
            for set in &mut all {
                set.sort_unstable();
            }
            all.sort();
            all
        };
        let found = alike(&moved(&source), &moved(&target), Metric::Euclidean, MEDIAN);
        prop_assert_eq!(renamed(alike(&source, &target, Metric::Euclidean, MEDIAN)), found);
    }
}
