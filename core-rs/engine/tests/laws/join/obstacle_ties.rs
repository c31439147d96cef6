//! Agents tied to an obstacle hold their clearance to it.

use std::f64::consts::{PI, TAU};
use std::sync::Arc;

use eigenform::choice::{Alignment, Choice, Join, MethodName, Order};
use eigenform::edits::{Outline, nearest_to};
use eigenform::obstacle::ObstacleShape;
use eigenform::scene::{Group, Obstacle, Scene};
use glam::DVec2;

use super::meeting::{check_velocities, velocities};
use super::show::{choice, extent, performed, positions, show, spec};

fn circle() -> ObstacleShape {
    ObstacleShape::Circle { center: DVec2::new(1.0, -2.0), radius: 2.5 }
}

/// A house, longer than it is wide.
fn house() -> ObstacleShape {
    ObstacleShape::Polygon { points: [[-3.0, -3.0], [5.0, -3.0], [5.0, -1.0], [-3.0, -1.0]].map(DVec2::from_array).to_vec() }
}

fn clearance(shape: &ObstacleShape, place: DVec2) -> f64 {
    let outline = match shape {
        ObstacleShape::Circle { center, radius } => Outline { points: vec![center.to_array()], radius: *radius },
        ObstacleShape::Polygon { points } => Outline { points: points.iter().map(DVec2::to_array).collect(), radius: 0.0 },
    };
    outline.clearance(place.to_array()).0
}

/// Five formations about the obstacle; ways from one to the next run straight through it.
fn around() -> Vec<Vec<DVec2>> {
    let place = |k: usize, agent: usize| {
        let angle = 0.2 + 2.3 * k as f64 + 0.9 * agent as f64;
        DVec2::new(1.0, -2.0) + DVec2::from_angle(angle) * (5.5 + 0.3 * agent as f64 + [0.0, 1.5, -0.2, 2.0, 0.4][k])
    };
    (0..5).map(|k| (0..6).map(|agent| place(k, agent)).collect()).collect()
}

fn tied(shape: ObstacleShape, join: Join, choice: Choice, ties: &[(u32, u32, f64)]) -> Scene {
    let mut scene = show(&around(), join, choice);
    scene.obstacles = Arc::new(vec![Obstacle { name: String::new(), shape }]);
    Arc::make_mut(&mut scene.adjacency).obstacle_ties = ties.to_vec();
    scene
}

fn some_choices() -> [Choice; 3] {
    use MethodName::{Linear, Polar, Spectral};
    [Linear, Polar, Spectral].map(|method| choice(method, Order::Greedy, Alignment::Procrustes, 0.5))
}

fn fractions() -> Vec<f64> {
    (0..=60).map(|k| f64::from(k) / 60.0).collect()
}

#[test]
fn a_tied_agent_is_never_nearer_than_at_the_nearer_of_two_keyframes() {
    for shape in [circle(), house()] {
        for join in [Join::Separate, Join::Smooth, Join::Product] {
            for choice in some_choices() {
                let scene = tied(shape.clone(), join, choice, &[(0, 0, 1.0), (3, 0, 1e6)]);
                let performance = performed(&scene);
                for segment in 0..4 {
                    for agent in [0, 3] {
                        let [from, to] = [segment, segment + 1].map(|k| clearance(&shape, around()[k][agent]));
                        for places in positions(&performance, segment, &fractions()) {
                            let here = clearance(&shape, places[agent]);
                            // Round-off of a few steps of geometry within ten meters.
                            let (least, most) = (from.min(to) - 1e-12, from.max(to) + 1e-12);
                            assert!((least..=most).contains(&here), "{choice:?}, {join:?}: {here} of {from}–{to}");
                        }
                    }
                }
            }
        }
    }
}

#[test]
fn tied_agents_reach_keyframes_exactly_and_pass_them_with_one_velocity() {
    for shape in [circle(), house()] {
        for choice in some_choices() {
            let mut scene = tied(shape.clone(), Join::Smooth, choice, &[(0, 0, 1.0), (2, 0, 0.3), (3, 0, 100.0)]);
            check_velocities(&format!("{choice:?}"), &scene);
            // Tied at two keyframes only: the tie takes hold and ends on the way.
            let own = scene.adjacency.clone();
            scene.adjacency = Arc::default();
            for k in [1, 2] {
                scene.tracks[0].keyframes[k].adjacency = Some(own.clone());
            }
            check_velocities(&format!("{choice:?}, for a while"), &scene);
            // And by groups.
            scene.adjacency = own;
            scene.groups = Arc::new(vec![Group { members: vec![0, 1, 2], ..Group::default() }]);
            (0..4).for_each(|segment| spec(&mut scene, segment).hierarchy = true);
            check_velocities(&format!("{choice:?}, by groups"), &scene);
        }
    }
}

#[test]
fn a_tie_leaves_straight_ways_along_a_wall_straight() {
    let mut scene = show(
        &[vec![DVec2::new(-20.0, 3.0), DVec2::new(-20.0, -3.0)], vec![DVec2::new(16.0, 3.0), DVec2::new(16.0, -3.0)]],
        Join::Separate,
        choice(MethodName::Linear, Order::Greedy, Alignment::None, 0.0),
    );
    let by_method = positions(&performed(&scene), 0, &fractions());
    let points = [[-30.0, -1.0], [30.0, -1.0], [30.0, 1.0], [-30.0, 1.0]].map(DVec2::from_array).to_vec();
    scene.obstacles = Arc::new(vec![Obstacle { name: String::new(), shape: ObstacleShape::Polygon { points } }]);
    Arc::make_mut(&mut scene.adjacency).obstacle_ties = vec![(0, 0, 1.0), (1, 0, 1.0)];
    let held = positions(&performed(&scene), 0, &fractions());
    for (by_method, held) in by_method.iter().zip(&held) {
        assert!(by_method.iter().zip(held).all(|(p, q)| p.distance(*q) < 1e-12), "{by_method:?} {held:?}");
    }
}

#[test]
fn a_weak_tie_gives_way_and_no_tie_changes_nothing() {
    let choice = choice(MethodName::Linear, Order::Greedy, Alignment::None, 0.0);
    let with = |factor: f64| performed(&tied(circle(), Join::Smooth, choice, &[(0, 0, factor)]));
    let without = performed(&tied(circle(), Join::Smooth, choice, &[]));
    let at = |performance: &eigenform::perform::Performance| positions(performance, 1, &[0.4])[0][0];
    let (free, half, firm) = (at(&without), at(&with(0.5)), at(&with(1.0)));
    assert!(free.distance(firm) > 1.0 && half.distance(0.5 * (free + firm)) < 1e-12);
    assert_eq!(without.segments()[1].held_clearance, None);
    let mut scene = tied(circle(), Join::Smooth, choice, &[]);
    scene.obstacles = Arc::default();
    assert_eq!(performed(&scene).segments()[1].motion, without.segments()[1].motion);
}

#[test]
fn the_least_clearance_of_those_who_are_tied_is_reported() {
    let choice = choice(MethodName::Spectral, Order::Greedy, Alignment::Pca, 0.5);
    let performance = performed(&tied(house(), Join::Smooth, choice, &[(1, 0, 1.0), (4, 0, 1.0)]));
    for performed in performance.segments() {
        let reported = performed.held_clearance.expect("two are tied");
        let samples = (0..performed.motion.times().len()).flat_map(|k| [1, 4].map(|agent| performed.motion.sample(k)[agent]));
        let least = samples.map(|place| clearance(&house(), place)).fold(f64::INFINITY, f64::min);
        // Straight pieces cut corners of arcs, of at most a third of a circle in ten samples.
        assert!(reported.distance <= least && reported.distance > least - 0.05, "{} {least}", reported.distance);
    }
}

#[test]
fn who_stands_in_the_obstacle_or_at_its_corner_has_a_finite_motion() {
    let places = [[1.0, -2.0], [5.0, -1.0], [5.0, -1.0 + 1e-9], [1.0, -1.0], [9.0, 3.0], [-3.0, 4.0]].map(DVec2::from_array);
    for shape in [circle(), house()] {
        for k in 0..6 {
            let formations: Vec<Vec<DVec2>> = (0..5).map(|f| (0..6).map(|agent| places[(agent + f * k) % 6]).collect()).collect();
            let choice = choice(MethodName::Spectral, Order::Greedy, Alignment::Pca, 0.5);
            let mut scene = show(&formations, Join::Smooth, choice);
            scene.obstacles = Arc::new(vec![Obstacle { name: String::new(), shape: shape.clone() }; 2]);
            Arc::make_mut(&mut scene.adjacency).obstacle_ties = (0..6).flat_map(|agent| [(agent, 0, 1.0), (agent, 1, 0.7)]).collect();
            let performance = performed(&scene);
            for (segment, performed) in performance.segments().iter().enumerate() {
                let reach = 30.0 * extent(&scene);
                assert!(performed.motion.positions().iter().all(|place| place.length() < reach), "{shape:?} {k} {segment}");
                for (end, at) in [(0, 0), (1, performed.motion.times().len() - 1)] {
                    let off = crate::transition::cases::farthest(performed.motion.sample(at), &formations[segment + end]);
                    assert!(off < 1e-9 * extent(&scene), "{shape:?} {k} {segment}: {off}");
                }
            }
        }
    }
}

#[test]
fn keeping_apart_takes_nobody_nearer_to_an_obstacle_that_they_are_tied_to() {
    let center = DVec2::new(1.0, -2.0);
    let at = |angle: f64, clearance: f64| center + DVec2::from_angle(angle) * (2.5 + clearance);
    // Two on one ring about the circle that meet head on, and one who crosses their way.
    let formations = [vec![at(0.0, 1.5), at(2.5, 1.5), at(PI, 0.8)], vec![at(2.5, 1.5), at(0.0, 1.5), at(TAU - 1.0, 4.0)]];
    let mut scene = show(&formations, Join::Separate, choice(MethodName::Linear, Order::Greedy, Alignment::None, 0.0));
    scene.obstacles = Arc::new(vec![Obstacle { name: String::new(), shape: circle() }]);
    Arc::make_mut(&mut scene.adjacency).obstacle_ties = vec![(0, 0, 1.0), (1, 0, 1.0)];
    scene.minimum_distance = 0.5;
    scene.frame_rate = 30.0;
    let guide = performed(&scene);
    spec(&mut scene, 0).avoidance = true;
    let apart = performed(&scene);
    let avoided = apart.segments()[0].avoided.as_ref().expect("avoidance was asked for");
    assert!(avoided.unsolved.is_empty() && avoided.blocked.is_empty() && avoided.rung > 0, "{avoided:?}");
    let outline = Outline { points: vec![center.to_array()], radius: 2.5 };
    for agent in [0, 1] {
        let [before, after] =
            [&guide, &apart].map(|performance| nearest_to(&performance.segments()[0].motion, agent, 0, &outline).distance);
        // Straight pieces of a sixteenth of a radian cut 2 mm from a ring of 4 m; and the slack of the exact check.
        assert!(before > 1.5 - 3e-3 && after >= before - 1e-6, "agent {agent}: {after} of {before}");
    }
    assert!(velocities(&scene, &apart, 0).iter().flatten().all(|velocity| velocity.is_finite()));
}
