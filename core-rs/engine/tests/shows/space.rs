//! Whole shows with heights: planes that write letters, and what is level.

use eigenform::formation::Formation;
use eigenform::perform::{Performance, perform};
use eigenform::scene::read_json;
use serde_json::{Value, json};

/// Ten planes upright in the sky, as letters: x and z, meters.
const LETTERS: [[[f64; 2]; 10]; 3] = [
    // T
    [[-8.0, 40.0], [-4.0, 40.0], [0.0, 40.0], [4.0, 40.0], [8.0, 40.0], [0.0, 36.0], [0.0, 32.0], [0.0, 28.0], [0.0, 24.0], [0.0, 20.0]],
    // H
    [[-6.0, 40.0], [-6.0, 35.0], [-6.0, 30.0], [-6.0, 25.0], [6.0, 40.0], [6.0, 35.0], [6.0, 30.0], [6.0, 25.0], [-2.0, 32.0], [2.0, 32.0]],
    // E
    [[-5.0, 40.0], [-5.0, 35.0], [-5.0, 30.0], [-5.0, 25.0], [0.0, 40.0], [5.0, 40.0], [0.0, 32.0], [0.0, 25.0], [5.0, 25.0], [-5.0, 20.0]],
];

fn show(positions: &[Value], join: &str, method: &str) -> Performance {
    let keyframes: Vec<Value> = (0..).zip(positions).map(|(k, places)| json!({ "time": 4 * k, "positions": places })).collect();
    let segments = vec![json!({ "kind": "transition", "method": method }); keyframes.len() - 1];
    let scene = json!({
        "format": "eigenform", "version": 1, "frameRate": 10, "minimumDistance": 1, "join": join,
        "keyframes": keyframes, "segments": segments,
    });
    perform(&read_json(&scene.to_string()).expect("a valid scene")).expect("a show that can be performed")
}

fn letters() -> Vec<Value> {
    // The formation flies away from the audience, tilted a little.
    let place = |k: usize, [x, z]: [f64; 2]| json!([x, 12.0 * k as f64 + 0.05 * x, z]);
    (0..3).map(|k| Value::from(LETTERS[k].iter().map(|&at| place(k, at)).collect::<Vec<_>>())).collect()
}

fn farthest(one: &Formation, other: &Formation) -> f64 {
    one.places().iter().zip(other.places().iter()).map(|(p, q)| p.distance(q)).fold(0.0, f64::max)
}

#[test]
fn ten_planes_write_the_and_every_number_of_it_is_one() {
    for join in ["separate", "smooth"] {
        for method in ["auto", "spectral", "shared", "polar", "linear"] {
            let performance = show(&letters(), join, method);
            for (k, keyframe) in performance.scene().main_track().keyframes.iter().enumerate() {
                let at = performance.formation_at(4.0 * k as f64);
                assert!(farthest(&at, &keyframe.positions) < 1e-9 * 60.0, "{join} {method} at letter {k}");
            }
            for performed in performance.segments() {
                let motion = &performed.motion;
                assert!(motion.heights().is_some_and(|heights| heights.iter().all(|height| height.is_finite())));
                let clearance = performed.measures.clearance.expect("ten planes have a distance");
                let (a, b) = clearance.agents;
                let sampled = (0..motion.times().len()).map(|k| motion.places(k).distance(a as usize, b as usize));
                assert!(clearance.distance <= sampled.fold(f64::INFINITY, f64::min) + 1e-9);
                let numbers = [performed.measures.distortion.mean, performed.measures.turning.max, performed.measures.top_speed.speed];
                assert!(numbers.iter().all(|number| number.is_finite()), "{join} {method}: {numbers:?}");
            }
        }
    }
}

#[test]
fn planes_pass_a_letter_with_one_velocity_where_the_show_is_smooth() {
    let performance = show(&letters(), "smooth", "spectral");
    let [before, at, after] = [4.0 - 1e-4, 4.0, 4.0 + 1e-4].map(|time| performance.formation_at(time));
    for agent in 0..10 {
        let [before, at, after] = [&before, &at, &after].map(|formation| formation.places().at(agent));
        // One-sided differences differ by the step times the acceleration, of which 1e3 m/s² is more than anybody's.
        assert!((at - before).distance(after - at) / 1e-4 < 1e-4 * 1e3, "plane {agent} turns its nose at once");
    }
}

#[test]
fn a_level_show_is_the_show_on_the_plane_to_the_bit_however_it_joins() {
    let plan = |k: usize, height: Option<f64>| {
        let place = move |[x, y]: [f64; 2]| height.map_or_else(|| json!([x, y]), |z| json!([x, y, z]));
        Value::from(LETTERS[k].iter().map(|&at| place(at)).collect::<Vec<_>>())
    };
    for join in ["separate", "smooth"] {
        for method in ["auto", "spectral", "shared", "polar", "linear"] {
            let on_the_plane = show(&[plan(0, None), plan(1, None), plan(2, None)], join, method);
            let level = show(&[plan(0, Some(1.0)), plan(1, Some(3.0)), plan(2, Some(2.0))], join, method);
            for (one, other) in on_the_plane.segments().iter().zip(level.segments()) {
                assert_eq!(one.choice, other.choice);
                assert_eq!(one.motion.positions(), other.motion.positions(), "{join} {method}");
                let heights = other.motion.heights().expect("a level show has heights");
                assert!(heights.chunks(10).all(|sample| sample.iter().all(|height| *height == sample[0])));
            }
        }
    }
}

#[test]
fn motion_text_has_three_numbers_where_the_scene_has() {
    let performance = show(&letters(), "separate", "linear");
    let json: Value = serde_json::from_str(&performance.to_json_at(&[0.0, 4.0])).expect("JSON");
    assert_eq!(json["positions"][1][0], json!([-6.0, 12.0 + 0.05 * -6.0, 40.0]));
    let csv = performance.to_csv();
    assert_eq!(csv.lines().nth(1), Some("0,0,0,-8,-0.4,40"));
}

/// Two planes exchange heights on one vertical, between two that stand by.
#[test]
fn planes_that_would_meet_in_the_air_keep_their_distance() {
    let low_to_high = [json!([0, 0, 10]), json!([0, 0, 30]), json!([6, 1, 20]), json!([-6, -1, 20])];
    let high_to_low = [json!([0, 0, 30]), json!([0, 0, 10]), json!([6, 1, 20]), json!([-6, -1, 20])];
    let scene = json!({
        "format": "eigenform", "version": 1, "frameRate": 25, "minimumDistance": 1,
        "keyframes": [{ "positions": low_to_high }, { "time": 6, "positions": high_to_low }],
        "segments": [{ "kind": "transition", "method": "linear", "avoidance": true }],
    });
    let performance = perform(&read_json(&scene.to_string()).expect("a valid scene")).expect("a show that can be performed");
    let clearance = performance.segments()[0].measures.clearance.expect("four planes have a distance");
    assert!(clearance.distance >= 1.0 - 1e-6, "{clearance:?}");
    for (time, keyframe) in [(0.0, 0), (6.0, 1)] {
        let due = &performance.scene().main_track().keyframes[keyframe].positions;
        assert!(farthest(&performance.formation_at(time), due) < 1e-9 * 30.0);
    }
}

/// Two groups within one and a third beside it, and somebody alone.
fn by_groups(positions: &[Vec<[f64; 3]>], join: &str, method: &str) -> Performance {
    let keyframes: Vec<Value> = (0..).zip(positions).map(|(k, places)| json!({ "time": 4 * k, "positions": places })).collect();
    let node = json!({ "group": [0], "method": "linear", "blend": { "method": "polar", "amount": 0.5 } });
    let segment = json!({ "method": method, "hierarchy": true, "nodes": [node] });
    let scene = json!({
        "format": "eigenform", "version": 1, "frameRate": 10, "join": join, "keyframes": keyframes,
        "groups": [{ "members": [], "children": [{ "members": [0, 1, 2] }, { "members": [3, 4, 5] }] }, { "members": [6, 7, 8] }],
        "segments": vec![segment; positions.len() - 1],
    });
    perform(&read_json(&scene.to_string()).expect("a valid scene")).expect("a show that can be performed")
}

/// Ten agents at four keyframes, nothing alike; `height` of an agent at a keyframe.
fn climbing(height: impl Fn(f64) -> f64) -> Vec<Vec<[f64; 3]>> {
    let place = |k: u32, agent: u32| {
        let angle = 2.4 * f64::from(agent) + 1.1 * f64::from(k * k);
        let away = 3.0 + 1.3 * f64::from((3 * agent + k) % 7);
        [away * angle.cos(), away * angle.sin(), height(f64::from(k) + 0.37 * f64::from(agent))]
    };
    (0..4).map(|k| (0..10).map(|agent| place(k, agent)).collect()).collect()
}

const BY_GROUPS: [(&str, &str); 6] = [
    ("separate", "spectral"),
    ("separate", "polar"),
    ("smooth", "spectral"),
    ("smooth", "shared"),
    ("smooth", "linear"),
    ("smooth", "auto"),
];

#[test]
fn groups_that_climb_reach_every_keyframe_in_all_three_numbers() {
    let positions = climbing(|seat| 4.0 + 3.0 * (2.3 * seat).sin());
    for (join, method) in BY_GROUPS {
        let performance = by_groups(&positions, join, method);
        for (k, keyframe) in performance.scene().main_track().keyframes.iter().enumerate() {
            let at = performance.formation_at(4.0 * k as f64);
            assert!(farthest(&at, &keyframe.positions) < 1e-9 * 30.0, "{join} {method} at keyframe {k}");
        }
        for (segment, performed) in performance.segments().iter().enumerate() {
            let motion = &performed.motion;
            let heights = motion.heights().expect("they climb");
            // No method takes anybody farther than a turned formation of that extent reaches, joins overshoot by a fraction.
            assert!(motion.positions().iter().all(|place| place.length() < 60.0), "{join} {method}");
            assert!(heights.iter().all(|height| height.abs() < 60.0), "{join} {method}");
            for (end, k) in [(0, 0), (1, motion.times().len() - 1)] {
                let found = Formation::spatial(motion.sample(k).to_vec(), heights[k * 10..(k + 1) * 10].to_vec());
                let due = &performance.scene().main_track().keyframes[segment + end].positions;
                assert!(farthest(&found, due) < 1e-9 * 30.0, "{join} {method}: end {end} of segment {segment}");
            }
        }
    }
}

#[test]
fn groups_that_are_level_move_as_on_the_plane() {
    let level = climbing(|_| 2.5);
    let keyframes: Vec<Value> = level.iter().map(|places| places.iter().map(|[x, y, _]| json!([x, y])).collect()).collect();
    for (join, method) in BY_GROUPS {
        let in_space = by_groups(&level, join, method);
        let mut scene = in_space.scene().clone();
        for (keyframe, places) in scene.tracks[0].keyframes.iter_mut().zip(&keyframes) {
            keyframe.positions =
                std::sync::Arc::new(Formation::from(serde_json::from_value::<Vec<[f64; 2]>>(places.clone()).expect("pairs")));
        }
        let on_the_plane = perform(&scene).expect("a show that can be performed");
        for (one, other) in in_space.segments().iter().zip(on_the_plane.segments()) {
            assert_eq!(one.motion.positions(), other.motion.positions(), "{join} {method}");
            let heights = one.motion.heights().expect("positions have three numbers");
            assert!(heights.iter().all(|height| (height - 2.5).abs() < 1e-9), "{join} {method}");
        }
    }
}
