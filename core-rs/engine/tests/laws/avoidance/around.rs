//! What avoidance promises where something stands in the way.

use eigenform::edits::{Avoidance, NO_GROUP, Other, Outline};
use eigenform::motion::Motion;
use eigenform::perform::perform;
use eigenform::scene::read_json;
use glam::DVec2;

use super::{DISTANCE, avoidance, edited, last, straight};

/// Who goes 24 m or, in a file, 40 m to the right: alone, in a file of 20, in a block of 6 × 6.
fn marchers() -> [(&'static str, Motion); 3] {
    let walk = |source: Vec<DVec2>, way: f64| {
        let target: Vec<DVec2> = source.iter().map(|p| *p + DVec2::X * way).collect();
        straight(&source, &target)
    };
    let file = (0..20).map(|k| DVec2::new(-6.0 - 1.143 * f64::from(k), 0.1)).collect();
    let block = (0..36).map(|k| DVec2::new(-8.0 - 1.143 * f64::from(k % 6), 1.143 * (f64::from(k / 6) - 2.5))).collect();
    [("alone", walk(vec![DVec2::new(-12.0, 0.0)], 24.0)), ("a file", walk(file, 40.0)), ("a block", walk(block, 24.0))]
}

fn obstacles() -> [(&'static str, Outline); 2] {
    let corners = [[-2.0, -1.0], [2.0, -1.0], [2.0, 0.5], [0.0, 0.5], [0.0, 3.0], [-2.0, 3.0]];
    [("a circle", Outline { points: vec![[0.0, 0.3]], radius: 2.0 }), ("an L", Outline { points: corners.to_vec(), radius: 0.0 })]
}

/// The least clearance of anybody, at ten places on every straight piece: independent of the check inside.
pub(super) fn clearance(motion: &Motion, outline: &Outline) -> f64 {
    let mut least = f64::INFINITY;
    for k in 1..=last(motion) {
        for (from, to) in motion.sample(k - 1).iter().zip(motion.sample(k)) {
            let at = |tenth: u32| outline.clearance(from.lerp(*to, f64::from(tenth) / 10.0).to_array()).0;
            least = (0..=10).map(at).fold(least, f64::min);
        }
    }
    least
}

#[test]
fn marchers_pass_what_stands_in_their_way() {
    for (obstacle, outline) in obstacles() {
        for (who, guide) in marchers() {
            for is_clamped in [[false; 2], [true; 2]] {
                let result = edited(Avoidance { is_clamped, obstacles: vec![outline.clone()], ..avoidance() }, &guide);
                assert!(result.report.is_solved(), "{who} around {obstacle}: {:?}", result.report.blocked);
                let clearance = clearance(&result.motion, &outline);
                assert!(clearance >= DISTANCE - 1e-6, "{who} around {obstacle}: {clearance}");
            }
        }
    }
}

/// σ of the distances to the nearest neighbor, meters.
fn structure_deviation(places: &[DVec2]) -> f64 {
    let nearest = |p: &DVec2| places.iter().map(|q| p.distance(*q)).filter(|away| *away > 0.0).fold(f64::INFINITY, f64::min);
    let distances: Vec<f64> = places.iter().map(nearest).collect();
    let mean = distances.iter().sum::<f64>() / distances.len() as f64;
    (distances.iter().map(|d| (d - mean).powi(2)).sum::<f64>() / distances.len() as f64).sqrt()
}

#[test]
fn a_formation_wider_than_an_obstacle_opens_about_it_and_closes_again() {
    let block: Vec<DVec2> = (0..36).map(|k| DVec2::new(f64::from(k % 6) - 2.5, f64::from(k / 6) - 2.5) * 1.5).collect();
    let ring: Vec<DVec2> = (0..30).map(|k| DVec2::from_angle(f64::from(k) / 30.0 * std::f64::consts::TAU) * 6.0).collect();
    for (who, formation) in [("a block", block), ("a ring", ring)] {
        for (obstacle, outline) in obstacles() {
            let at = |x: f64| formation.iter().map(|p| *p + DVec2::X * x).collect::<Vec<_>>();
            let guide = straight(&at(-16.0), &at(16.0));
            let result = edited(Avoidance { obstacles: vec![outline.clone()], ..avoidance() }, &guide);
            assert!(result.report.is_solved(), "{who} around {obstacle}: {:?}", result.report.blocked);
            let middle = guide.times().len() / 2;
            let passed = |side: f64| (0..formation.len()).any(|agent| side * result.motion.sample(middle)[agent].y > 3.0);
            assert!(passed(1.0) && passed(-1.0), "{who} around {obstacle}: on both sides");
            // Each goes no farther aside than half the obstacle, its clearance and a little: on one side some would go twice that.
            assert!(result.report.deviation[1] < 3.0, "{who} around {obstacle}: {:?}", result.report.deviation);
            let [before, after] = [0, last(&guide)].map(|k| structure_deviation(result.motion.sample(k)));
            // The same places 32 m on: rounding of coordinates below 32.
            assert!((before - after).abs() < 1e-12, "{who} around {obstacle}: {before} {after}");
        }
    }
}

/// A block of 6 × 6 whose middle goes from so far before an obstacle to as far behind it.
fn marching_block(way: f64) -> Motion {
    let at = |x: f64| (0..36).map(move |k| DVec2::new(x + 1.143 * (f64::from(k % 6) - 2.5), 1.143 * (f64::from(k / 6) - 2.5)));
    straight(&at(-way).collect::<Vec<_>>(), &at(way).collect::<Vec<_>>())
}

/// By agent, whether it is to the left of a place when it comes past it.
fn passes_left(motion: &Motion, place: DVec2) -> Vec<bool> {
    let passes = |agent: usize| {
        let past = (0..=last(motion)).find(|k| motion.sample(*k)[agent].x > place.x).expect("everybody goes past");
        motion.sample(past)[agent].y > place.y
    };
    (0..motion.agent_count()).map(passes).collect()
}

#[test]
fn a_group_passes_an_obstacle_on_one_side() {
    let guide = marching_block(14.0);
    let by = |group: fn(u32) -> u32| (0..36).map(group).collect::<Vec<_>>();
    // All in one; side by side, so that either has its own way to go; one behind the other; and those amidst in none.
    let cases = [by(|_| 4), by(|k| u32::from(k >= 18)), by(|k| u32::from(k % 6 >= 3)), by(|k| if k % 6 == 2 { NO_GROUP } else { k / 18 })];
    for (obstacle, outline) in obstacles() {
        for groups in &cases {
            let result = edited(Avoidance { obstacles: vec![outline.clone()], groups: groups.clone(), ..avoidance() }, &guide);
            let case = format!("{obstacle}, groups {groups:?}");
            assert!(result.report.is_solved(), "{case}: {:?} {:?}", result.report.blocked, result.report.unsolved);
            assert!(clearance(&result.motion, &outline) >= DISTANCE - 1e-6, "{case}");
            let is_left = passes_left(&result.motion, DVec2::new(0.0, 0.3));
            for (agent, group) in groups.iter().enumerate().filter(|(_, group)| **group != NO_GROUP) {
                let first = groups.iter().position(|other| other == group).expect("it is among them");
                assert_eq!(is_left[agent], is_left[first], "{case}: {agent} and {first}");
            }
        }
    }
}

#[test]
fn who_is_in_no_group_goes_around_as_where_there_are_none() {
    for (_, outline) in obstacles() {
        for (_, guide) in marchers() {
            let around = |groups: Vec<u32>| edited(Avoidance { obstacles: vec![outline.clone()], groups, ..avoidance() }, &guide).motion;
            assert_eq!(around(vec![NO_GROUP; guide.agent_count()]), around(Vec::new()));
        }
    }
}

#[test]
fn a_group_parts_rather_than_go_far_astray() {
    // Two who are 20 m apart, and between them one in whose way the obstacle is: nobody else has to move.
    let [low, high] = [-10.0, 10.0].map(|y| DVec2::new(-14.0, y));
    let source = [low, high, DVec2::new(-14.0, 0.0)];
    let guide = straight(&source, &source.map(|p| p + DVec2::X * 28.0));
    let outline = Outline { points: vec![[0.0, 0.0]], radius: 1.0 };
    let result = edited(Avoidance { obstacles: vec![outline], groups: vec![0; 3], ..avoidance() }, &guide);
    assert!(result.report.is_solved());
    // The radius, the distance, and room for a smooth way.
    assert!(result.report.deviation[1] < 1.0 + DISTANCE + 0.5, "{:?}", result.report.deviation);
}

#[test]
fn an_obstacle_on_a_keyframe_is_reported_and_nobody_is_moved_there() {
    let (_, guide) = &marchers()[0];
    let outline = Outline { points: vec![[12.0, 0.2]], radius: 1.0 };
    let result = edited(Avoidance { obstacles: vec![outline], ..avoidance() }, guide);
    assert!(!result.report.is_solved());
    let breach = result.report.breaches[0];
    assert_eq!((breach.end, breach.agent, breach.other), (1, 0, Other::Obstacle(0)));
    assert!((breach.distance + 0.8).abs() < 1e-12, "{breach:?}");
    assert_eq!(result.motion.sample(last(guide)), guide.sample(last(guide)));
}

#[test]
fn who_stands_in_a_notch_is_led_out_of_it_first() {
    let (_, outline) = obstacles().into_iter().nth(1).expect("the L");
    // Inside its hull, with half a meter and more to either arm; beyond the L, and back.
    let [notch, west, south] = [[0.7, 1.2], [-6.0, 1.0], [0.5, -5.0]].map(DVec2::from_array);
    for (from, to) in [(notch, west), (west, notch), (notch, south), (south, notch)] {
        let result = edited(Avoidance { obstacles: vec![outline.clone()], ..avoidance() }, &straight(&[from], &[to]));
        assert!(result.report.is_solved(), "{from} to {to}: {:?}", result.report.blocked);
    }
}

#[test]
fn who_is_shut_off_keeps_the_guide_and_is_named_and_the_others_go_around() {
    let wall = |x: [f64; 2], y: [f64; 2]| Outline { points: vec![[x[0], y[0]], [x[1], y[0]], [x[1], y[1]], [x[0], y[1]]], radius: 0.0 };
    let [low, high] = [[-6.0, -5.0], [5.0, 6.0]];
    let whole = [-6.0, 6.0];
    let room = vec![wall(whole, low), wall(whole, high), wall(low, whole), wall(high, whole)];
    // One starts in the room, one has to pass it.
    let guide = straight(&[DVec2::ZERO, DVec2::new(-12.0, -5.5)], &[DVec2::new(0.5, 12.0), DVec2::new(12.0, -5.5)]);
    let closed = edited(Avoidance { obstacles: room.clone(), ..avoidance() }, &guide);
    let named: Vec<(u32, u32)> = closed.report.shut_off.iter().map(|shut| (shut.agent, shut.obstacle)).collect();
    assert_eq!(named, [(0, 1)]);
    for k in 0..guide.times().len() {
        // The guide, as exactly as avoidance checks.
        assert!(closed.motion.sample(k)[0].distance(guide.sample(k)[0]) < 1e-6, "at {k}");
    }
    assert!(closed.report.blocked.iter().all(|blocked| blocked.agent == 0), "{:?}", closed.report.blocked);
    let open = edited(Avoidance { obstacles: room[..1].to_vec(), ..avoidance() }, &guide);
    assert_eq!(open.report.shut_off, []);
}

#[test]
fn a_scenes_groups_stay_together_around_its_obstacles() {
    // A rank of six about a fountain that is in the way of the two in its middle.
    let places = |x: f64| (0..6).map(|k| format!("[{x}, {}]", 1.2 * (f64::from(k) - 2.5))).collect::<Vec<_>>().join(", ");
    let sides = |groups: &str| {
        let text = format!(
            r#"{{
                "format": "eigenform", "version": 1, "minimumDistance": 0.5, "agents": [{{}}, {{}}, {{}}, {{}}, {{}}, {{}}],
                "groups": {groups}, "obstacles": [{{ "kind": "circle", "center": [0, 0.1], "radius": 0.8 }}],
                "keyframes": [{{ "positions": [{}] }}, {{ "time": 8, "positions": [{}] }}],
                "segments": [{{ "method": "linear", "avoidance": true }}]
            }}"#,
            places(-12.0),
            places(12.0)
        );
        let performance = perform(&read_json(&text).expect("the scene is valid")).expect("it can be performed");
        let performed = &performance.segments()[0];
        assert!(performed.avoided.as_ref().is_some_and(|avoided| avoided.unsolved.is_empty() && avoided.blocked.is_empty()));
        passes_left(&performed.motion, DVec2::new(0.0, 0.1))
    };
    assert_eq!(sides("[]"), [false, false, false, true, true, true]);
    assert_eq!(sides(r#"[{ "members": [0, 1, 2, 3, 4, 5] }]"#), [false; 6]);
    assert_eq!(sides(r#"[{ "children": [{ "members": [0, 1] }, { "members": [2, 3, 4, 5] }] }]"#), [false, false, true, true, true, true]);
}
