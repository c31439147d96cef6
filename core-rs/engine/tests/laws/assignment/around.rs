//! Laws of who goes where when obstacles stand between.

use crate::formations::{grid, scattered};
use eigenform::assignment::{Assignment, AssignmentSpec, Cost, Job, Question, assign, assign_around, cost_of};
use eigenform::error::Error;
use eigenform::formation::Formation;
use eigenform::obstacle::{Detours, Norm, ObstacleShape};
use glam::DVec2;
use proptest::prelude::*;

const COSTS: [Cost; 4] = [Cost::Squared, Cost::LeastEffort, Cost::Euclidean, Cost::Manhattan];

const DISTANCE: f64 = 0.5;

fn question<'a>(source: &'a Formation, target: &'a Formation, spec: &'a AssignmentSpec) -> Question<'a> {
    Question { source, target, spec, sections: &[], is_flipped: false, is_predicted: false }
}

fn block(low: [f64; 2], high: [f64; 2]) -> ObstacleShape {
    let corners = [low, [high[0], low[1]], high, [low[0], high[1]]];
    ObstacleShape::Polygon { points: corners.map(DVec2::from_array).to_vec() }
}

/// A wall along y = 0 from −40 to 40, open between −1 and 1 about `gap`.
fn wall_with_gap(gap: f64) -> Vec<ObstacleShape> {
    vec![block([-40.0, -0.2], [gap - 1.0, 0.2]), block([gap + 1.0, -0.2], [40.0, 0.2])]
}

/// Below the wall and above it.
fn sides(count: usize) -> impl Strategy<Value = (Formation, Formation)> {
    let side = move |sign: f64| {
        scattered(count..count + 1)
            .prop_map(move |places| Formation::new(places.into_iter().map(|p| DVec2::new(p.x, sign * (1.0 + p.y.abs()))).collect()))
    };
    (side(-1.0), side(1.0))
}

/// By agent and slot the length of the shortest way, found apart from any assignment.
fn lengths(source: &Formation, target: &Formation, shapes: &[ObstacleShape], norm: Norm) -> Vec<Vec<f64>> {
    let mut detours = Detours::new(shapes, DISTANCE);
    while !detours.find_row() {}
    let way = |from: DVec2, to: DVec2| {
        if detours.is_clear(from, to) {
            return norm.of(to - from);
        }
        let (known, _) = detours.from(from, &detours.seen_from(from), norm);
        let ends = detours.seen_from(to).into_iter().map(|bend| known[bend as usize] + norm.of(to - detours.bend(bend)));
        ends.fold(f64::INFINITY, f64::min)
    };
    source.positions().iter().map(|from| target.positions().iter().map(|to| way(*from, *to)).collect()).collect()
}

/// Every order of the numbers below `count`.
fn orders(count: u32) -> Vec<Vec<u32>> {
    if count == 0 {
        return vec![vec![]];
    }
    let with = |order: Vec<u32>| (0..=order.len()).map(move |at| [&order[..at], &[count - 1], &order[at..]].concat());
    orders(count - 1).into_iter().flat_map(with).collect()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    #[test]
    fn through_the_gap_no_assignment_is_shorter((source, target) in sides(5), gap in -8..8_i32) {
        let shapes = wall_with_gap(f64::from(gap));
        for cost in [Cost::Squared, Cost::Euclidean, Cost::Manhattan] {
            let norm = if cost == Cost::Manhattan { Norm::Manhattan } else { Norm::Euclidean };
            let known = lengths(&source, &target, &shapes, norm);
            let of = |agent: usize, slot: usize| if cost == Cost::Squared { known[agent][slot].powi(2) } else { known[agent][slot] };
            let least = orders(5).into_iter().map(|order| Assignment::new(order).unwrap().total(of)).fold(f64::INFINITY, f64::min);
            let spec = AssignmentSpec { cost, ..AssignmentSpec::default() };
            let asked = question(&source, &target, &spec);
            let (answer, bends) = assign_around(&asked, &shapes, DISTANCE).unwrap();
            // Five costs below 10⁴: 1e-8 is thousands of their roundings.
            prop_assert!(answer.total(of) <= least + 1e-8, "{cost:?}: {} {least}", answer.total(of));
            prop_assert!((cost_of(&asked, &answer, &bends) - answer.total(of)).abs() <= 1e-8);
        }
    }

    #[test]
    fn a_way_bends_only_where_it_keeps_the_distance((source, target) in sides(12), gap in -8..8_i32) {
        let shapes = wall_with_gap(f64::from(gap));
        let spec = AssignmentSpec::default();
        let (answer, bends) = assign_around(&question(&source, &target, &spec), &shapes, DISTANCE).unwrap();
        let detours = Detours::new(&shapes, DISTANCE);
        for (agent, way) in bends.iter().enumerate() {
            let (from, to) = (source.positions()[agent], target.positions()[answer.target(agent)]);
            let places = [&[from][..], way, &[to]].concat();
            prop_assert!(places.windows(2).all(|pair| detours.is_clear(pair[0], pair[1])), "{places:?}");
        }
    }

    #[test]
    fn obstacles_that_are_in_nobodys_way_change_nothing((source, target) in sides(40)) {
        let shapes = [block([-40.0, 30.0], [40.0, 31.0]), ObstacleShape::Circle { center: DVec2::new(60.0, 0.0), radius: 9.0 }];
        for cost in COSTS {
            let spec = AssignmentSpec { cost, ..AssignmentSpec::default() };
            let asked = question(&source, &target, &spec);
            let (answer, bends) = assign_around(&asked, &shapes, DISTANCE).unwrap();
            prop_assert_eq!(answer, assign(&asked).unwrap());
            prop_assert!(bends.iter().all(Vec::is_empty));
        }
    }
}

#[test]
fn two_on_either_side_of_a_wall_stay_on_their_side() {
    // Across the wall it would be 2 m; the way around is 80.
    let source = Formation::from(vec![[0.0, -1.0], [3.0, 1.0]]);
    let target = Formation::from(vec![[0.0, 1.0], [3.0, -1.0]]);
    let wall = [block([-40.0, -0.2], [40.0, 0.2])];
    let spec = AssignmentSpec::default();
    let asked = question(&source, &target, &spec);
    assert_eq!(assign(&asked).unwrap().targets(), [0, 1]);
    let (answer, bends) = assign_around(&asked, &wall, DISTANCE).unwrap();
    assert_eq!((answer.targets(), bends), (&[1, 0][..], vec![vec![]; 2]));
}

#[test]
fn a_closed_room_keeps_who_is_in_it_and_says_who_cannot_leave() {
    let room = [
        block([-5.0, -5.0], [5.0, -4.0]),
        block([-5.0, 4.0], [5.0, 5.0]),
        block([-5.0, -5.0], [-4.0, 5.0]),
        block([4.0, -3.5], [5.0, 3.5]),
    ];
    let spec = AssignmentSpec::default();
    let inside = |slots: [[f64; 2]; 3]| {
        let (source, target) = (Formation::from(vec![[-1.0, 0.0], [9.0, 0.0], [1.0, 0.0]]), Formation::from(slots.to_vec()));
        assign_around(&question(&source, &target, &spec), &room, DISTANCE).map(|(answer, _)| answer.targets().to_vec())
    };
    assert_eq!(inside([[0.0, -2.0], [2.0, 2.0], [0.0, 30.0]]), Ok(vec![0, 2, 1]));
    let refusal = inside([[0.0, 2.0], [9.0, 9.0], [0.0, 30.0]]);
    let Err(Error::NoWay { agent, obstacle, .. }) = refusal else { panic!("{refusal:?}") };
    assert!([0, 2].contains(&agent) && obstacle < 4);
    // One obstacle alone opens the room when it goes: the one that is named, though another stands before it.
    let cell = [
        block([-0.2, -2.0], [0.2, 2.0]),
        ObstacleShape::Polygon {
            points: [
                [-5.0, -5.0],
                [5.0, -5.0],
                [5.0, -0.4],
                [4.0, -0.4],
                [4.0, -4.0],
                [-4.0, -4.0],
                [-4.0, 4.0],
                [4.0, 4.0],
                [4.0, 0.4],
                [5.0, 0.4],
                [5.0, 5.0],
                [-5.0, 5.0],
            ]
            .map(DVec2::from_array)
            .to_vec(),
        },
    ];
    let (source, target) = (Formation::from(vec![[-2.0, 0.0]]), Formation::from(vec![[9.0, 0.0]]));
    let refusal = assign_around(&question(&source, &target, &spec), &cell, DISTANCE);
    assert_eq!(refusal, Err(Error::NoWay { agent: 0, obstacle: 1, distance: DISTANCE }));
    // A gap of 0.8 m is wide enough for 0.4 m on either side.
    assert!(assign_around(&question(&source, &target, &spec), &cell, 0.4).is_ok());
}

#[test]
fn who_stands_too_near_to_an_obstacle_still_gets_a_slot() {
    let (source, target) = (Formation::from(vec![[0.0, -0.4], [2.0, -0.1]]), Formation::from(vec![[0.0, 3.0], [2.0, 3.0]]));
    let spec = AssignmentSpec::default();
    let (answer, bends) = assign_around(&question(&source, &target, &spec), &[block([-9.0, -0.2], [9.0, 0.2])], DISTANCE).unwrap();
    assert_eq!(answer.targets().len(), 2);
    // First straight out: 0.5 m from the wall's side.
    assert!(bends.iter().all(|way| (way[0].y + 0.7).abs() < 1e-6), "{bends:?}");
}

#[test]
fn groups_are_kept_together_on_the_side_that_is_theirs() {
    // Two groups of four on either side of a wall, slots on both sides: no group is sent across.
    let row = |y: f64, x: f64| (0..4).map(move |k| DVec2::new(x + f64::from(k), y));
    let source = Formation::new(row(-1.5, 0.0).chain(row(1.5, 0.0)).collect());
    let target = Formation::new(row(1.5, 6.0).chain(row(-1.5, 6.0)).collect());
    let sections = [(0..8).map(|agent| Some(agent / 4)).collect::<Vec<_>>()];
    let wall = [block([-40.0, -0.2], [40.0, 0.2])];
    for cost in COSTS {
        let spec = AssignmentSpec { keep_groups: true, cost, ..AssignmentSpec::default() };
        let asked = Question { sections: &sections, ..question(&source, &target, &spec) };
        let (answer, _) = assign_around(&asked, &wall, DISTANCE).unwrap();
        assert!((0..8).all(|agent| (answer.target(agent) >= 4) == (agent < 4)), "{cost:?}: {answer:?}");
    }
}

#[test]
fn progress_never_falls_on_the_way_around() {
    let (source, target) = (Formation::new(grid(12, 5)), Formation::new(grid(12, 5).into_iter().map(|p| p + DVec2::Y * 30.0).collect()));
    let spec = AssignmentSpec::default();
    let mut job = Job::around(&question(&source, &target, &spec), &wall_with_gap(3.0), DISTANCE).unwrap();
    let mut progress = 0.0;
    while progress < 1.0 {
        let now = job.step().unwrap();
        assert!((progress..=1.0).contains(&now), "{progress}, then {now}");
        progress = now;
    }
}
