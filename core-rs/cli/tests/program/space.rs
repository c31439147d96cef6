//! Every verb takes scenes with heights.

use crate::desk::Desk;
use crate::parsed;
use serde_json::{Value, json};

const FLIGHT: &str = r#"{
    "format": "eigenform", "version": 1, "frameRate": 2,
    "keyframes": [
        { "positions": [[0, 0, 0], [3, 0, 0], [0, 4, 0], [0, 0, 5]] },
        { "time": 2, "positions": [[0, 0, 5], [3, 0, 5], [0, 4, 5], [0, 0, 0]] }
    ],
    "segments": [{ "method": "linear" }]
}"#;

fn desk() -> Desk {
    let desk = Desk::new();
    desk.put("flight.json", FLIGHT);
    desk
}

#[test]
fn check_says_that_a_scene_has_heights() {
    assert_eq!(desk().answer(&["check", "flight.json"]), "ok: 4 agents, 2 keyframes, 3D\n");
}

#[test]
fn motion_has_three_numbers_a_place_and_a_column_of_heights() {
    let desk = desk();
    let motion = parsed(&desk.answer(&["motion", "flight.json", "--at", "1", "--json"]));
    assert_eq!(motion["positions"][0], json!([[0.0, 0.0, 2.5], [3.0, 0.0, 2.5], [0.0, 4.0, 2.5], [0.0, 0.0, 2.5]]));
    let csv = desk.answer(&["motion", "flight.json"]);
    assert_eq!(csv.lines().nth(4), Some("0,0,3,0,0,5"));
}

#[test]
fn measure_counts_what_is_climbed() {
    let report = parsed(&desk().answer(&["measure", "flight.json", "--json"]));
    let segment = &report["segments"][0];
    assert_eq!(segment["pathLength"], json!({ "mean": 5.0, "max": 5.0 }));
    // Who goes down and who comes up pass through one place.
    assert_eq!(segment["clearance"], json!({ "distance": 0.0, "time": 1.0, "agents": [0, 3] }));
}

#[test]
fn modes_of_a_formation_with_heights_have_three_coefficients() {
    let modes = parsed(&desk().answer(&["modes", "flight.json", "--keyframe", "0", "--json", "--vectors"]));
    // A tetrahedron ties everybody.
    assert_eq!(modes["ties"].as_array().expect("a list").len(), 6);
    let places = [[0.0, 0.0, 0.0], [3.0, 0.0, 0.0], [0.0, 4.0, 0.0], [0.0, 0.0, 5.0]];
    for (agent, place) in places.iter().enumerate() {
        for (axis, due) in place.iter().enumerate() {
            let number = |value: &Value| value.as_f64().expect("a number");
            let sum: f64 = (0..4).map(|k| number(&modes["vectors"][k][agent]) * number(&modes["coefficients"][k][axis])).sum();
            assert!((sum - due).abs() < 1e-12, "the modes add up to the formation");
        }
    }
}

#[test]
fn assign_counts_heights_in_the_cost() {
    let answer = parsed(&desk().answer(&["assign", "flight.json", "--from", "0", "--to", "1", "--json"]));
    // 0 and 3 stay where they are by exchanging slots; 1 and 2 must climb.
    assert_eq!(answer, json!({ "assignment": [3, 1, 2, 0], "cost": 50.0 }));
}

#[test]
fn heights_survive_a_link_and_a_table() {
    let desk = desk();
    let link = desk.answer(&["link", "flight.json"]);
    let opened = parsed(&desk.answer(&["open", link.trim()]));
    assert_eq!(opened["keyframes"][1]["positions"][1], json!([3, 0, 5]));
    let converted = desk.run(&["convert", "flight.json", "flight.csv"]);
    assert_eq!(converted.code, 0, "what a table cannot hold is noted: {}", converted.stderr);
    // A table has no frame rate, so only the places at the end are the same.
    let last_place = |scene| {
        let motion = desk.answer(&["motion", scene, "--method", "linear"]);
        motion.lines().last().and_then(|row| Some(row.splitn(4, ',').nth(3)?.to_owned()))
    };
    assert_eq!(last_place("flight.csv"), last_place("flight.json"));
}
