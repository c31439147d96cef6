//! A keyframe that lies in a transition bends it, and leaves the rest where it was.

use std::sync::Arc;

use eigenform::choice::{Alignment, Join, MethodName, Order, Timing};
use eigenform::formation::Formation;
use eigenform::perform::{Performance, Performer, Step, perform};
use eigenform::scene::{Keyframe, PathSpec, Scene, read_json, validate};
use glam::{DVec2, DVec3};

use super::meeting::{check_velocities, velocities};
use super::show::{blocks, choice, choices, degenerate, extent, generic, performed, show, spec, symmetric};
use crate::transition::cases::{farthest, grid, shuffled};

/// The scene with keyframes between, at `times` and where they are seen then.
fn inserted(scene: &Scene, performance: &Performance, times: &[f64]) -> Scene {
    let mut scene = scene.clone();
    let track = &mut scene.tracks[0];
    for time in times {
        let at = track.keyframes.partition_point(|keyframe| keyframe.time <= *time);
        // One more than what lies beside it.
        let depths = track.depths();
        let between = 1 + depths[at - 1].max(depths[at]);
        let positions = Arc::new(performance.formation_at(*time));
        let absent = performance.absent_at(*time);
        track.keyframes.insert(at, Keyframe { time: *time, between, positions, absent, ..Keyframe::default() });
        track.segments.insert(at, track.segments[at - 1].clone());
    }
    validate(&scene).expect("it stays valid");
    scene
}

/// Of two performances of as long a show, over every hundredth of it and everybody who is there.
fn difference(one: &Performance, other: &Performance) -> f64 {
    let seconds = one.scene().duration();
    let apart = |k: i32| {
        let time = seconds * f64::from(k) / 100.0;
        let [a, b] = [one, other].map(|performance| performance.formation_at(time));
        let absent = one.absent_at(time);
        assert_eq!(absent, other.absent_at(time));
        let there = (0..a.agent_count()).filter(|agent| absent.binary_search(&(*agent as u32)).is_err());
        there.map(|agent| a.places().at(agent).distance(b.places().at(agent))).fold(0.0, f64::max)
    };
    (0..=100).map(apart).fold(0.0, f64::max)
}

fn check_unchanged(name: &str, scene: &Scene, times: &[f64]) {
    let before = performed(scene);
    let after = performed(&inserted(scene, &before, times));
    // Both are the same motion at the same times, but for the round-off of fractions of them.
    let tolerance = 1e-9 * extent(scene).max(1.0);
    let off = difference(&before, &after);
    assert!(off <= tolerance, "{name}: {off:e}");
}

#[test]
fn where_it_asks_for_what_is_seen_nothing_moves() {
    for formations in [generic(9), blocks(), symmetric()].into_iter().chain(degenerate().into_iter().skip(1)) {
        for join in [Join::Separate, Join::Smooth, Join::Product] {
            for choice in choices() {
                let mut scene = show(&formations, join, choice);
                spec(&mut scene, 1).timing = Timing::Even;
                scene.tracks[0].keyframes[2].hold = 0.25;
                check_unchanged(&format!("{join:?}, {choice:?}"), &scene, &[0.9, 2.6, 3.1, 5.0]);
            }
        }
    }
}

#[test]
fn so_it_is_with_groups_paths_forces_and_heights() {
    let chosen = |method| choice(method, Order::Greedy, Alignment::Procrustes, 0.5);
    for method in [MethodName::Auto, MethodName::Spectral, MethodName::Crowd] {
        let mut scene = show(&blocks(), Join::Smooth, chosen(method));
        scene.minimum_distance = 0.5;
        spec(&mut scene, 1).avoidance = true;
        let points = vec![DVec3::ZERO, DVec3::new(5.0, 9.0, 0.0), DVec3::new(12.0, 4.0, 0.0)];
        spec(&mut scene, 2).path = Some(PathSpec { points, is_spatial: false });
        spec(&mut scene, 3).hierarchy = true;
        check_unchanged(&format!("{method:?}"), &scene, &[0.9, 1.5, 2.75, 3.3, 4.8, 7.75]);
        for keyframe in &mut scene.tracks[0].keyframes {
            let plan = keyframe.positions.positions().to_vec();
            let heights = (0..plan.len()).map(|agent| (agent % 4) as f64 * (keyframe.time - 2.0)).collect();
            keyframe.positions = Arc::new(Formation::spatial(plan, heights));
        }
        check_unchanged(&format!("{method:?} in space"), &scene, &[0.9, 1.5, 2.75, 3.3, 4.8, 7.75]);
    }
}

#[test]
fn so_it_is_where_some_are_not_there() {
    let mut scene = show(&blocks(), Join::Smooth, choice(MethodName::Spectral, Order::Greedy, Alignment::Procrustes, 0.5));
    for (keyframe, absent) in scene.tracks[0].keyframes.iter_mut().zip([vec![], vec![3], vec![3, 8], vec![8], vec![]]) {
        keyframe.absent = absent;
    }
    check_unchanged("absent", &scene, &[0.9, 2.75, 3.3, 4.8, 7.75]);
}

/// As deep as each other.
fn side_by_side(mut scene: Scene) -> Scene {
    scene.tracks[0].keyframes.iter_mut().for_each(|keyframe| keyframe.between = keyframe.between.min(1));
    scene
}

/// Three keyframes in the second transition of a show, the middle one with its first agent `by` meters aside.
fn bent(join: Join, by: DVec2) -> (Performance, Scene) {
    let scene = show(&generic(9), join, choice(MethodName::Spectral, Order::Greedy, Alignment::Procrustes, 0.5));
    let before = performed(&scene);
    let mut scene = side_by_side(inserted(&scene, &before, &[2.7, 3.0, 3.5]));
    let mut places = scene.tracks[0].keyframes[3].positions.positions().to_vec();
    places[0] += by;
    scene.tracks[0].keyframes[3].positions = Arc::new(Formation::new(places));
    (before, scene)
}

#[test]
fn it_is_reached_passed_with_one_velocity_and_bends_its_neighborhood_alone() {
    let by = DVec2::new(0.6, -0.8);
    for join in [Join::Separate, Join::Smooth] {
        let (before, scene) = bent(join, by);
        check_velocities(&format!("{join:?}"), &scene);
        let after = performed(&scene);
        let mut was_there = false;
        for k in 0..=1000 {
            let time = 0.01 * f64::from(k);
            let [was, is] = [&before, &after].map(|performance| performance.positions_at(time));
            let moved = farthest(&was, &is);
            assert!(moved <= by.length() + 1e-9 && farthest(&was[1..], &is[1..]) < 1e-9, "{join:?} at {time}: {moved}");
            assert!(moved < 1e-9 || (2.7..=3.5).contains(&time), "{join:?} at {time}: {moved}");
            was_there |= (moved - by.length()).abs() < 1e-9;
        }
        assert!(was_there, "{join:?}");
    }
}

#[test]
fn what_all_keyframes_between_ask_for_is_kept_up_without_swinging() {
    let scene = show(&generic(9), Join::Smooth, choice(MethodName::Linear, Order::Greedy, Alignment::None, 0.5));
    let before = performed(&scene);
    let mut bent = side_by_side(inserted(&scene, &before, &[2.7, 3.0, 3.5]));
    for (keyframe, by) in bent.tracks[0].keyframes[2..5].iter_mut().zip([1.0, 1.0, 2.0]) {
        keyframe.positions = Arc::new(Formation::new(keyframe.positions.positions().iter().map(|at| *at + DVec2::X * by).collect()));
    }
    let after = performed(&bent);
    let aside = |time: f64| (after.positions_at(time)[4] - before.positions_at(time)[4]).x;
    let course: Vec<f64> = (0..=1250).map(|k| aside(2.5 + 0.001 * f64::from(k))).collect();
    let rises = |from: usize, to: usize| course[from..=to].is_sorted_by(|a, b| *b >= a - 1e-9);
    assert!(rises(0, 1000) && course[1000..].is_sorted_by(|a, b| *b <= a + 1e-9), "up to the third, and back");
    assert!(course[200..=500].iter().all(|aside| (aside - 1.0).abs() < 1e-9), "even between two that ask for the same");
}

#[test]
fn whoever_is_brought_too_near_there_is_kept_apart_beside_it() {
    let text = r#"{ "format": "eigenform", "version": 1, "minimumDistance": 0.5, "join": "smooth", "keyframes": [
        { "positions": [[0, 0], [10, 1]] },
        { "time": 4, "between": 1, "positions": [[5, 0], [5, 0.6]] },
        { "time": 8, "positions": [[10, 0], [0, 1]] }
    ], "segments": [{ "method": "linear", "avoidance": true }, { "method": "linear" }] }"#;
    let scene = read_json(text).expect("the scene is valid");
    let performance = performed(&scene);
    for segment in performance.segments() {
        let avoided = segment.avoided.as_ref().expect("both parts keep apart as the transition does");
        assert!(avoided.unsolved.is_empty() && avoided.breaches.is_empty());
        assert!(segment.measures.clearance.expect("there are two").distance >= 0.5 - 1e-6);
    }
    check_velocities("kept apart", &scene);
    assert!(velocities(&scene, &performance, 0)[1][0].x > 1.0, "nobody stops there");
}

#[test]
fn one_more_beside_a_bend_moves_nothing() {
    for join in [Join::Separate, Join::Smooth] {
        let (_, scene) = bent(join, DVec2::new(3.0, -4.0));
        check_unchanged(&format!("{join:?}"), &scene, &[2.6, 2.85, 3.2, 3.4, 3.7]);
    }
}

#[test]
fn nor_does_one_beside_a_bend_that_keeps_agents_apart() {
    for method in [MethodName::Linear, MethodName::Crowd] {
        let blocks = [0.0, 6.0].map(|x| (0..16).map(|k| DVec2::new(x + f64::from(k % 4), f64::from(k / 4))).collect::<Vec<_>>());
        let formations = [blocks.concat(), [blocks[1].clone(), blocks[0].clone()].concat()];
        let mut scene = show(&formations, Join::Smooth, choice(method, Order::Greedy, Alignment::None, 0.5));
        scene.minimum_distance = 0.5;
        spec(&mut scene, 0).avoidance = true;
        let mut bent = inserted(&scene, &performed(&scene), &[1.2]);
        let places = bent.tracks[0].keyframes[1].positions.positions();
        let moved = places.iter().enumerate().map(|(agent, at)| if agent < 16 { *at + DVec2::new(0.0, 0.5) } else { *at }).collect();
        bent.tracks[0].keyframes[1].positions = Arc::new(Formation::new(moved));
        let parts = performed(&bent);
        assert!(parts.segments().iter().any(|part| part.avoided.as_ref().is_some_and(|avoided| avoided.deviation.max > 0.01)));
        check_unchanged(&format!("{method:?}"), &bent, &[0.9, 1.5, 1.8, 2.1]);
    }
}

/// A block whose agents change places at random.
fn crowded(distance: f64) -> Scene {
    let formations = [grid(5, 4), shuffled(&grid(5, 4))];
    let mut scene = show(&formations, Join::Smooth, choice(MethodName::Linear, Order::Greedy, Alignment::None, 0.5));
    scene.minimum_distance = distance;
    spec(&mut scene, 0).avoidance = true;
    scene
}

#[test]
fn what_keeping_apart_made_of_a_transition_stays_and_is_told_of_its_parts() {
    for distance in [0.3, 0.95] {
        let scene = crowded(distance);
        let before = performed(&scene);
        let whole = before.segments()[0].avoided.as_ref().expect("it is asked for");
        assert_eq!(whole.unsolved.is_empty(), distance < 0.5, "{distance}");
        check_unchanged(&format!("{distance}"), &scene, &[0.9, 1.4, 1.9]);
        let after = performed(&inserted(&scene, &before, &[0.9, 1.4, 1.9]));
        let parts: Vec<_> = after.segments().iter().map(|part| part.avoided.as_ref().expect("of each part")).collect();
        let least = parts.iter().filter_map(|part| part.guide_clearance).map(|met| met.distance).fold(f64::INFINITY, f64::min);
        let farthest = parts.iter().map(|part| part.deviation.max).fold(0.0, f64::max);
        // Between frames the parts have samples of their own, at their keyframes.
        assert!((least - whole.guide_clearance.expect("there are twenty").distance).abs() < 1e-2, "{least}");
        assert!((farthest - whole.deviation.max).abs() < 1e-2 && parts.iter().all(|part| part.rung == whole.rung), "{farthest}");
        assert_eq!(parts.iter().all(|part| part.unsolved.is_empty()), whole.unsolved.is_empty());
    }
}

#[test]
fn to_move_it_leaves_the_whole_as_it_was_performed() {
    let (_, scene) = bent(Join::Smooth, DVec2::X);
    let mut performer = Performer::default();
    let steps = |performer: &mut Performer, scene: &Scene| {
        let mut job = performer.begin(scene, 2, &[]);
        (1..1_000_000).find(|_| matches!(job.step(performer), Ok(Step::Done(_)))).expect("it can be performed")
    };
    let first = steps(&mut performer, &scene);
    let mut moved = scene.clone();
    moved.tracks[0].keyframes[3].positions =
        Arc::new(Formation::new(scene.tracks[0].keyframes[3].positions.positions().iter().map(|at| *at * 1.1).collect()));
    let again = steps(&mut performer, &moved);
    assert!(again < first, "{again} steps after {first}");
    let afresh = perform(&moved).expect("it can be performed");
    assert_eq!(difference(&performer.perform(&moved).expect("it can be performed"), &afresh), 0.0);
}
