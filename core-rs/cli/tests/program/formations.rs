//! Where agents stand: assign, shape, groups.

use serde_json::json;

use crate::desk::{Desk, jpeg, png, webp};
use crate::{number, parsed};

#[test]
fn assign_finds_who_stays() {
    let desk = Desk::new();
    let text = desk.answer(&["assign", "show.json", "--from", "0", "--to", "1", "--cost", "squared", "--json"]);
    assert_eq!(parsed(&text), json!({ "assignment": [3, 0, 1, 2], "cost": 0.0 }));
}

#[test]
fn assign_says_who_has_no_place_and_what_becomes_of_them() {
    let desk = Desk::new();
    let scene = json!({
        "format": "eigenform", "version": 1,
        "keyframes": [
            { "positions": [[0, 0], [5, 0], [6, 0]] },
            { "time": 4, "positions": [[0, 1], [4, 0], [6, 1]], "absent": [0] },
        ],
    });
    desk.put("few.json", &scene.to_string());
    let asked = |rest: &str| parsed(&desk.answer(&["assign", "few.json", "--from", "0", "--to", "1", "--json", "--rest", rest]));
    // Two places, at 4 and 6: agents 1 and 2 are a meter away each. Agent 0 walks a meter to the exit, or nowhere.
    assert_eq!(asked("leave"), json!({ "assignment": [0, 1, 2], "cost": 3.0, "rest": [0] }));
    assert_eq!(asked("bench"), json!({ "assignment": [0, 1, 2], "cost": 3.0, "rest": [0] }));
    assert_eq!(asked("stay"), json!({ "assignment": [0, 1, 2], "cost": 2.0, "rest": [0] }));
    let refused = desk.run(&["assign", "few.json", "--from", "0", "--to", "1", "--rest", "hide"]);
    assert_eq!(refused.code, 2);
    assert!(refused.stderr.starts_with("error: unknown-value: "), "{}", refused.stderr);
}

/// Two on either side of a wall, 2 m from the slot across it and 3 m from the one beside them.
fn beside_a_wall([low, high]: [f64; 2], distance: f64) -> String {
    json!({
        "format": "eigenform", "version": 1, "minimumDistance": distance,
        "obstacles": [
            { "kind": "polygon", "points": [[-40, -0.2], [low, -0.2], [low, 0.2], [-40, 0.2]] },
            { "kind": "polygon", "points": [[high, -0.2], [40, -0.2], [40, 0.2], [high, 0.2]] },
        ],
        "keyframes": [{ "positions": [[0, -1], [3, 1]] }, { "time": 4, "positions": [[0, 1], [3, -1]] }],
    })
    .to_string()
}

#[test]
fn assign_goes_around_obstacles_and_says_where_ways_bend() {
    let desk = Desk::new();
    let asked = &["assign", "wall.json", "--from", "0", "--to", "1", "--json"];
    desk.put("wall.json", &beside_a_wall([-1.0, 4.0], 0.5));
    // Straight through the gap.
    assert_eq!(parsed(&desk.answer(asked)), json!({ "assignment": [0, 1], "cost": 8.0 }));
    desk.put("wall.json", &beside_a_wall([1.0, 1.5], 0.5));
    assert_eq!(parsed(&desk.answer(asked)), json!({ "assignment": [1, 0], "cost": 18.0 }));
    let locked = parsed(&desk.answer(&[&asked[..], &["--cost", "euclidean", "--lock", "0:0"]].concat()));
    let bends = locked["bends"][0].as_array().expect("a way around");
    assert!(bends.len() > 4 && number(&locked["cost"]) > 80.0, "{locked}");
}

#[test]
fn assign_refuses_a_room_without_a_way_out() {
    let desk = Desk::new();
    let ring =
        [[-5.0, -5.0], [5.0, -5.0], [5.0, -0.2], [4.0, -0.2], [4.0, -4.0], [-4.0, -4.0], [-4.0, 4.0], [4.0, 4.0], [4.0, 0.2], [5.0, 0.2]];
    let outline = [&ring[..], &[[5.0, 5.0], [-5.0, 5.0]]].concat();
    let scene = json!({
        "format": "eigenform", "version": 1, "minimumDistance": 0.5,
        "obstacles": [{ "kind": "polygon", "points": outline }],
        "keyframes": [{ "positions": [[0, 0], [9, 9]] }, { "time": 4, "positions": [[9, 0], [9, 5]] }],
    });
    desk.put("room.json", &scene.to_string());
    let outcome = desk.run(&["assign", "room.json", "--from", "0", "--to", "1"]);
    assert_eq!(outcome.code, 2);
    assert!(outcome.stderr.starts_with("error: no-way: no way leads agent 0 "), "{}", outcome.stderr);
    assert!(outcome.stderr.trim_end().ends_with("(obstacles[0])"), "{}", outcome.stderr);
}

/// The positions of the first keyframe, and the sizes of their bounding box.
fn formation(scene: &str) -> (Vec<[f64; 2]>, [f64; 2]) {
    let scene = parsed(scene);
    let list = scene["keyframes"][0]["positions"].as_array().expect("positions");
    let positions: Vec<[f64; 2]> = list.iter().map(|at| [number(&at[0]), number(&at[1])]).collect();
    let size = |axis: usize| {
        let along = positions.iter().map(|at| at[axis]);
        along.clone().fold(f64::NEG_INFINITY, f64::max) - along.fold(f64::INFINITY, f64::min)
    };
    let sizes = [size(0), size(1)];
    (positions, sizes)
}

#[test]
fn shape_makes_a_scene_of_exactly_so_many() {
    let desk = Desk::new();
    let triangle = "M 0 0 L 4 0 L 2 3 Z";
    let asked = &["shape", triangle, "--agents", "66", "--width", "20", "--seed", "4", "--minimum-distance", "0.5"];
    let text = desk.answer(asked);
    let (positions, [width, depth]) = formation(&text);
    // The width is that of the drawing to a pixel in a thousand; the deepest agent stands at a corner, about.
    assert_eq!(positions.len(), 66);
    assert!((19.5..=20.05).contains(&width) && (14.0..=15.05).contains(&depth), "{width} × {depth}");
    assert_eq!(
        (&parsed(&text)["title"], &parsed(&text)["seed"], &parsed(&text)["minimumDistance"]),
        (&json!(triangle), &json!(4), &json!(0.5))
    );
    desk.put("triangle.json", &text);
    assert_eq!(desk.answer(&["check", "triangle.json"]), "ok: 66 agents, 1 keyframes\n");
    // The same again; along the edge others.
    assert_eq!(desk.answer(asked), text);
    let edge = desk.answer(&["shape", triangle, "--agents", "66", "--width", "20", "--outline"]);
    assert_ne!(formation(&edge).0, positions);
}

#[test]
fn shape_reads_every_kind_of_picture() {
    let desk = Desk::new();
    desk.put_bytes("left.jpg", &jpeg());
    desk.put_bytes("left.webp", &webp());
    desk.put_bytes("left.png", &png(8, 8, |x, _| if x < 4 { [0, 0, 0, 255] } else { [255; 4] }));
    desk.put_bytes("seen.png", &png(8, 8, |x, _| if x < 4 { [255; 4] } else { [0; 4] }));
    let svg = |inside: &str| format!("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 8 8\">{inside}</svg>");
    desk.put("left.svg", &svg("<g transform=\"scale(2)\"><rect width=\"2\" height=\"4\" style=\"fill: gold\"/></g>"));
    for name in ["left.jpg", "left.webp", "left.png", "seen.png", "left.svg"] {
        let (positions, [width, depth]) = formation(&desk.answer(&["shape", name, "--agents", "40"]));
        // Half of the square: as deep as the room for it, and half as wide. Agents stand at the edge to half a pixel of eight.
        assert_eq!(positions.len(), 40, "{name}");
        assert!((42.0..=48.0).contains(&depth) && (18.0..=24.0).contains(&width), "{name}: {width} × {depth}");
    }
}

#[test]
fn shape_writes_text() {
    let desk = Desk::new();
    let outcome = desk.run(&["shape", "IT", "--agents", "120"]);
    // A machine without any font says so.
    if outcome.code != 0 {
        assert!(outcome.stderr.starts_with("error: no-glyph: no font of this machine"), "{}", outcome.stderr);
        return;
    }
    let (positions, _) = formation(&outcome.stdout);
    // I and T stand apart: nobody is in the gap between them.
    let mut xs: Vec<f64> = positions.iter().map(|at| at[0]).collect();
    xs.sort_by(f64::total_cmp);
    let gap = xs.windows(2).map(|pair| pair[1] - pair[0]).fold(0.0, f64::max);
    assert!(positions.len() == 120 && gap > 1.0, "{gap} m");
}

#[test]
fn assign_does_as_it_is_told() {
    let desk = Desk::new();
    // Five abreast in two groups go to five places to the right and one apart from them.
    desk.put(
        "line.json",
        r#"{ "format": "eigenform", "version": 1, "groups": [{ "members": [0, 2] }, { "members": [1, 3, 4] }], "keyframes": [
            { "positions": [[0, 0], [1, 0], [2, 0], [3, 0], [4, 0]] },
            { "time": 2, "positions": [[14, 0], [13, 0], [12, 0], [11, 0], [10, 0]] }] }"#,
    );
    let slots = |more: &[&str]| {
        let typed = [&["assign", "line.json", "--from", "0", "--to", "1", "--json"], more].concat();
        serde_json::from_value::<Vec<u32>>(parsed(&desk.answer(&typed))["assignment"].clone()).expect("slots")
    };
    for cost in ["squared", "least-effort"] {
        assert_eq!(slots(&["--cost", cost]), [4, 3, 2, 1, 0], "{cost}");
    }
    assert_eq!(slots(&["--cost", "keep"]), [0, 1, 2, 3, 4]);
    assert_eq!(slots(&["--cost", "keep", "--lock", "0:1"]), [1, 0, 2, 3, 4]);
    assert_eq!(slots(&["--lock", "0:1", "--lock", "4:2"]), [1, 4, 3, 0, 2]);
    assert_eq!(slots(&["--keep-groups"]), [4, 2, 3, 1, 0]);
    assert_eq!(slots(&["--flip"]), [0, 1, 2, 3, 4]);
    assert_eq!(slots(&["--predict", "--lock", "0:0", "--lock", "1:1"]), [0, 1, 2, 3, 4]);
}

#[test]
fn groups_are_those_who_move_as_one() {
    let desk = Desk::new();
    // Four go up and four to the right, mixed by number.
    let places = |t: f64| {
        let place = |agent: usize| {
            let (x, y) = ((agent / 2 % 2) as f64, (agent / 4) as f64);
            if agent.is_multiple_of(2) { json!([x, y + t]) } else { json!([x + 10.0 + t, y]) }
        };
        (0..8).map(place).collect::<Vec<_>>()
    };
    let scene = json!({ "format": "eigenform", "version": 1,
        "keyframes": [{ "positions": places(0.0) }, { "time": 2, "positions": places(9.0) }] });
    desk.put("apart.json", &scene.to_string());
    for keyframe in ["0", "1"] {
        let report = parsed(&desk.answer(&["groups", "apart.json", "--keyframe", keyframe, "--json"]));
        assert_eq!(report["groups"], json!([[0, 2, 4, 6], [1, 3, 5, 7]]));
        assert!(number(&report["preference"]) < 0.0);
    }
    let alone = desk.answer(&["groups", "apart.json", "--keyframe", "0", "--preference", "1"]);
    assert_eq!(alone, "0\n1\n2\n3\n4\n5\n6\n7\n");
    let one = desk.answer(&["groups", "apart.json", "--keyframe", "0", "--preference", "-1e9", "--metric", "manhattan"]);
    assert_eq!(one, "0 1 2 3 4 5 6 7\n");
}
