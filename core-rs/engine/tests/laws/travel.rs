//! The laws of formations that travel along drawn paths.

use std::f64::consts::{FRAC_PI_2, PI, TAU};
use std::sync::Arc;

use eigenform::choice::{Alignment, Choice, Join, MethodName, Order, Timing};
use eigenform::formation::Formation;
use eigenform::perform::{Performance, perform};
use eigenform::scene::{Agent, Group, Keyframe, PathSpec, Scene, Segment, Track, TransitionSpec};
use glam::{DVec2, DVec3};
use proptest::collection::vec;
use proptest::prelude::*;

const METHODS: [MethodName; 6] =
    [MethodName::Linear, MethodName::Polar, MethodName::Shared, MethodName::Spectral, MethodName::Auto, MethodName::Crowd];

/// Seconds of every segment.
const DURATION: f64 = 4.0;

fn show(formations: &[Vec<DVec2>], method: MethodName) -> Scene {
    let keyframe = |(k, plan): (usize, &Vec<DVec2>)| Keyframe {
        time: DURATION * k as f64,
        positions: Arc::new(Formation::new(plan.clone())),
        ..Keyframe::default()
    };
    let transition = TransitionSpec { method, alignment: Alignment::Procrustes, ..TransitionSpec::default() };
    let track = Track {
        agents: Arc::new(vec![Agent::default(); formations[0].len()]),
        keyframes: formations.iter().enumerate().map(keyframe).collect(),
        segments: vec![Segment::Transition(transition); formations.len() - 1],
    };
    Scene { frame_rate: 10.0, tracks: vec![track], ..Scene::default() }
}

fn spec(scene: &mut Scene, segment: usize) -> &mut TransitionSpec {
    let Segment::Transition(spec) = &mut scene.tracks[0].segments[segment];
    spec
}

fn path(points: &[DVec2]) -> PathSpec {
    PathSpec { points: points.iter().map(|point| point.extend(0.0)).collect(), is_spatial: false }
}

fn performed(scene: &Scene) -> Performance {
    eigenform::scene::validate(scene).expect("the show is valid");
    perform(scene).expect("the show can be performed")
}

fn farthest(one: &[DVec2], other: &[DVec2]) -> f64 {
    one.iter().zip(other).map(|(a, b)| a.distance(*b)).fold(0.0, f64::max)
}

fn center(places: &[DVec2]) -> DVec2 {
    places.iter().sum::<DVec2>() / places.len() as f64
}

/// Nine agents in no order, one meter and more apart.
fn scattered(seed: f64, at: DVec2) -> Vec<DVec2> {
    let place = |i: f64| DVec2::new(1.5 * (i % 3.0) + 0.4 * (seed + 2.0 * i).sin(), 1.5 * (i / 3.0).floor() + 0.4 * (seed * i).cos());
    let places: Vec<DVec2> = (0..9).map(|i| place(f64::from(i))).collect();
    let middle = center(&places);
    places.into_iter().map(|place| at + place - middle).collect()
}

fn turned(places: &[DVec2], angle: f64, to: DVec2) -> Vec<DVec2> {
    let from = center(places);
    places.iter().map(|place| to + DVec2::from_angle(angle).rotate(*place - from)).collect()
}

/// A quarter of a circle of radius 10 to the left of east, from the origin.
fn bend(points: usize) -> Vec<DVec2> {
    (0..points).map(|k| quarter(k as f64 / (points - 1) as f64)).collect()
}

fn quarter(share: f64) -> DVec2 {
    let (sin, cos) = (FRAC_PI_2 * share).sin_cos();
    10.0 * DVec2::new(sin, 1.0 - cos)
}

const CORNER: DVec2 = DVec2::new(10.0, 10.0);

fn check_ends(scene: &Scene, performance: &Performance) {
    for keyframe in &scene.tracks[0].keyframes {
        let found = performance.positions_at(keyframe.time);
        let due = keyframe.positions.positions();
        let tolerance = 1e-9 * keyframe.positions.extent().max(1.0);
        assert!(farthest(&found, due) <= tolerance, "at {}: {:e}", keyframe.time, farthest(&found, due));
        let frame = (keyframe.time * scene.frame_rate).round() as usize;
        performance.for_each_frame(|number, _, places| {
            assert!(places.plan().iter().all(|place| place.is_finite()));
            assert!(number != frame || farthest(places.plan(), due) <= tolerance, "frame {frame}");
        });
    }
}

fn point() -> impl Strategy<Value = DVec2> {
    (-20..20, -20..20).prop_map(|(x, y)| DVec2::new(f64::from(x), f64::from(y)))
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]

    // Points on a coarse grid: paths cross themselves, double back, stand and end anywhere.
    #[test]
    fn keyframes_are_reached_whatever_is_drawn(
        points in vec(point(), 2..9), to in point(), index in 0..METHODS.len(), join in prop::sample::select(vec![Join::Separate, Join::Smooth, Join::Product]),
    ) {
        prop_assume!(points.iter().any(|point| *point != points[0]));
        let formations = [scattered(0.3, DVec2::ZERO), scattered(1.1, to), scattered(2.0, DVec2::ONE)];
        let mut scene = show(&formations, METHODS[index]);
        scene.join = join;
        spec(&mut scene, 0).path = Some(path(&points));
        spec(&mut scene, 1).timing = Timing::Even;
        check_ends(&scene, &performed(&scene));
    }

    #[test]
    fn a_straight_path_is_no_path(
        from in point(), to in point(), shares in vec(0.01..1.0_f64, 1..6), index in 0..METHODS.len(), is_smooth: bool,
    ) {
        let formations = [scattered(0.3, DVec2::ZERO), scattered(1.1, DVec2::new(12.0, 5.0)), scattered(2.0, CORNER)];
        prop_assume!(from != to);
        let mut scene = show(&formations, METHODS[index]);
        scene.join = if is_smooth { Join::Smooth } else { Join::Separate };
        let plain = performed(&scene);
        let mut share = 0.0;
        let total: f64 = shares.iter().sum();
        let drawn: Vec<DVec2> = std::iter::once(from).chain(shares.iter().map(|step| { share += step / total; from.lerp(to, share) })).collect();
        spec(&mut scene, 0).path = Some(path(&drawn));
        let along = performed(&scene);
        for k in 0..=40 {
            let time = 0.2 * f64::from(k);
            // Forces repeat a step hundreds of times on what round-off of 1e-14 left.
            let tolerance = if METHODS[index] == MethodName::Crowd { 1e-6 } else { 1e-9 };
            prop_assert!(farthest(&plain.positions_at(time), &along.positions_at(time)) < tolerance, "{:?} at {time}: {:e}", METHODS[index], farthest(&plain.positions_at(time), &along.positions_at(time)));
        }
    }
}

#[test]
fn the_barycenter_follows_the_path_at_the_pace_of_the_timing() {
    // The mean of polar ways is not on the straight way either.
    for method in [MethodName::Linear, MethodName::Shared, MethodName::Spectral] {
        let formations = [scattered(0.3, DVec2::ZERO), scattered(1.1, CORNER)];
        let mut scene = show(&formations, method);
        spec(&mut scene, 0).path = Some(path(&bend(33)));
        let performance = performed(&scene);
        for k in 0..=16 {
            let fraction = f64::from(k) / 16.0;
            let t = fraction * fraction * (3.0 - 2.0 * fraction);
            // A spline through 33 points of an arc is off by less than the sagitta of a chord, 10 · (π/64)²/8.
            let off = center(&performance.positions_at(DURATION * fraction)).distance(quarter(t));
            assert!(off < 3e-3, "{method:?} at {fraction}: {off}");
        }
    }
}

#[test]
fn a_formation_drawn_as_the_path_turns_it_goes_as_one_body() {
    for method in METHODS.into_iter().filter(|method| *method != MethodName::Crowd) {
        let start = scattered(0.3, DVec2::ZERO);
        let mut scene = show(&[start.clone(), turned(&start, FRAC_PI_2, CORNER)], method);
        spec(&mut scene, 0).path = Some(path(&bend(33)));
        spec(&mut scene, 0).timing = Timing::Linear;
        let performance = performed(&scene);
        for k in 0..=16 {
            let t = f64::from(k) / 16.0;
            let found = performance.positions_at(DURATION * t);
            let due = turned(&start, FRAC_PI_2 * t, quarter(t));
            // The spline's headings are off by less than half a chord's turn, π/128, for an agent 3 m away; the method does what is
            // left of the whole turn.
            assert!(farthest(&found, &due) < 0.03, "{method:?} at {t}: {}", farthest(&found, &due));
            for (a, b) in [(0, 8), (2, 5), (1, 7)] {
                let (apart, due) = (found[a].distance(found[b]), start[a].distance(start[b]));
                assert!((apart - due).abs() < 1e-3 * due, "{method:?} at {t}: {apart} for {due}");
            }
        }
    }
}

#[test]
fn agents_are_as_far_apart_as_the_method_has_them_without_a_turn() {
    // An S: the heading at its end is that at its start, so that the method's own task stays, and distances on the way are its own.
    let wave: Vec<DVec2> = (0..=60).map(|k| f64::from(k) / 60.0).map(|s| DVec2::new(20.0 * s, 3.0 * (1.0 - (TAU * s).cos()))).collect();
    for method in [MethodName::Linear, MethodName::Polar, MethodName::Shared, MethodName::Spectral] {
        let formations = [scattered(0.3, DVec2::ZERO), scattered(1.1, DVec2::new(20.0, 0.0))];
        let mut scene = show(&formations, method);
        let plain = performed(&scene);
        spec(&mut scene, 0).path = Some(path(&wave));
        let along = performed(&scene);
        for k in 0..=8 {
            let time = 0.125 * f64::from(k) * DURATION;
            let (one, other) = (plain.positions_at(time), along.positions_at(time));
            for (a, b) in [(0, 8), (2, 5), (1, 7), (3, 4)] {
                let (before, after) = (one[a].distance(one[b]), other[a].distance(other[b]));
                // Both ends of the wave are straight by symmetry, to the spline's fourth order.
                assert!((before - after).abs() < 1e-3, "{method:?} at {time}: {before} {after}");
            }
        }
    }
}

#[test]
fn a_whole_circle_turns_a_formation_once_around() {
    let start = scattered(0.3, DVec2::ZERO);
    let mut scene = show(&[start.clone(), start.clone()], MethodName::Linear);
    let circle: Vec<DVec2> = (0..=64).map(|k| DVec2::from_angle(TAU * f64::from(k) / 64.0 - FRAC_PI_2) * 8.0).collect();
    spec(&mut scene, 0).path = Some(path(&circle));
    let halfway = performed(&scene).positions_at(0.5 * DURATION);
    // Half a chord's turn, π/64, for an agent 3 m away.
    assert!(farthest(&halfway, &turned(&start, PI, DVec2::new(0.0, 16.0))) < 0.2);
}

#[test]
fn groups_travel_with_the_formation_and_a_crowd_ends_where_it_should() {
    let formations = [scattered(0.3, DVec2::ZERO), scattered(1.1, CORNER)];
    let mut scene = show(&formations, MethodName::Spectral);
    scene.groups = Arc::new(vec![Group { members: vec![0, 1, 2, 3], ..Group::default() }]);
    spec(&mut scene, 0).path = Some(path(&bend(9)));
    spec(&mut scene, 0).hierarchy = true;
    check_ends(&scene, &performed(&scene));
    (scene.minimum_distance, spec(&mut scene, 0).avoidance, spec(&mut scene, 0).method) = (0.4, true, MethodName::Crowd);
    let performance = performed(&scene);
    check_ends(&scene, &performance);
    assert!(performance.segments()[0].avoided.as_ref().is_some_and(|avoided| avoided.unsolved.is_empty()));
}

#[test]
fn segments_with_and_without_paths_meet_with_one_velocity() {
    let formations: Vec<_> = [DVec2::ZERO, CORNER, DVec2::new(10.0, 30.0), DVec2::new(-5.0, 30.0)]
        .iter()
        .enumerate()
        .map(|(k, at)| scattered(0.3 + k as f64, *at))
        .collect();
    let hook = [CORNER, DVec2::new(14.0, 16.0), DVec2::new(6.0, 24.0), DVec2::new(10.0, 30.0)];
    for method in METHODS {
        for (join, tension) in [(Join::Smooth, 0.5), (Join::Smooth, 0.2)] {
            let mut scene = show(&formations, method);
            (scene.join, scene.tension) = (join, tension);
            spec(&mut scene, 0).path = Some(path(&bend(7)));
            spec(&mut scene, 1).path = Some(path(&hook));
            spec(&mut scene, 2).method = MethodName::Linear;
            let performance = performed(&scene);
            check_ends(&scene, &performance);
            for keyframe in [1, 2] {
                let time = DURATION * f64::from(keyframe);
                // Differences of second order over 1e-4 s: accelerations change by less than 100 m/s³, and forces fade in as a square.
                let velocity = |way: f64| -> Vec<DVec2> {
                    let [here, near, far] = [0.0, 1e-4, 2e-4].map(|step| performance.positions_at(time + way * step));
                    (0..9).map(|i| (4.0 * near[i] - 3.0 * here[i] - far[i]) / (way * 2e-4)).collect()
                };
                let off = farthest(&velocity(-1.0), &velocity(1.0));
                assert!(off < 1e-4, "{method:?} at keyframe {keyframe}, tension {tension}: {off:e}");
            }
        }
    }
}

#[test]
fn level_formations_travel_as_on_the_plane_to_the_bit() {
    let formations = [scattered(0.3, DVec2::ZERO), scattered(1.1, CORNER), scattered(2.0, DVec2::ONE)];
    for method in METHODS {
        let mut plane = show(&formations, method);
        plane.join = Join::Smooth;
        spec(&mut plane, 0).path = Some(path(&bend(9)));
        let mut level = plane.clone();
        for keyframe in &mut level.tracks[0].keyframes {
            let plan = keyframe.positions.positions().to_vec();
            keyframe.positions = Arc::new(Formation::spatial(plan, vec![0.1; 9]));
        }
        let points = bend(9).iter().map(|point| point.extend(0.3)).collect();
        spec(&mut level, 0).path = Some(PathSpec { points, is_spatial: true });
        let (plane, level) = (performed(&plane), performed(&level));
        for k in 0..=40 {
            let (flat, raised) = (plane.formation_at(0.2 * f64::from(k)), level.formation_at(0.2 * f64::from(k)));
            assert_eq!(flat.positions(), raised.positions(), "{method:?}");
            assert!(raised.heights().is_some_and(|heights| heights.iter().all(|height| (height - 0.1).abs() < 1e-15)), "{method:?}");
        }
    }
}

#[test]
fn a_path_may_climb() {
    let mut scene = show(&[scattered(0.3, DVec2::ZERO), scattered(1.1, CORNER)], MethodName::Polar);
    for (keyframe, height) in scene.tracks[0].keyframes.iter_mut().zip([1.0, 1.0]) {
        let plan = keyframe.positions.positions().to_vec();
        keyframe.positions = Arc::new(Formation::spatial(plan, (0..9).map(|i| height + 0.1 * f64::from(i)).collect()));
    }
    let arch = (0..=32).map(|k| f64::from(k) / 32.0).map(|s| DVec3::new(10.0 * s, 10.0 * s, 4.0 * (PI * s).sin())).collect();
    spec(&mut scene, 0).path = Some(PathSpec { points: arch, is_spatial: true });
    let performance = performed(&scene);
    check_ends(&scene, &performance);
    // Halfway the arch is 4 m above its ends, which are 1.4 m up; a spline's error is below a chord's sagitta, 4 · (π/32)²/8.
    let top = performance.formation_at(0.5 * DURATION).places().barycenter();
    assert!((top.z - 5.4).abs() < 5e-3 && top.truncate().distance(0.5 * CORNER) < 1e-2, "{top}");
}

#[test]
fn nobody_and_one_alone_travel_too() {
    for count in [0, 1] {
        let places = |at: DVec2| vec![at; count];
        for method in METHODS {
            for join in [Join::Separate, Join::Smooth] {
                let mut scene = show(&[places(DVec2::ZERO), places(CORNER), places(DVec2::ZERO)], method);
                scene.join = join;
                spec(&mut scene, 0).path = Some(path(&bend(5)));
                check_ends(&scene, &performed(&scene));
            }
        }
    }
}

#[test]
fn auto_chooses_as_it_would_for_what_the_path_leaves_to_do() {
    let start = scattered(0.3, DVec2::ZERO);
    let mut scene = show(&[start.clone(), turned(&start, FRAC_PI_2, CORNER)], MethodName::Auto);
    spec(&mut scene, 0).path = Some(path(&bend(33)));
    let segment = performed(&scene).segments()[0].clone();
    // The path does the whole turn; any method keeps the shape then, and straight ways come first.
    assert_eq!(segment.choice, Choice { method: MethodName::Linear, order: Order::Greedy, alignment: Alignment::Procrustes, sharing: 0.5 });
}
