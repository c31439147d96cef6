//! Each verb does what its help says.

mod support;

use serde_json::{Value, json};
use support::{Desk, jpeg, png, webp};

fn parsed(text: &str) -> Value {
    serde_json::from_str(text).expect("JSON")
}

fn number(value: &Value) -> f64 {
    value.as_f64().expect("a number")
}

#[test]
fn motion_prints_a_row_a_frame_and_agent() {
    let desk = Desk::new();
    let text = desk.answer(&["motion", "keyframes.csv", "--method", "linear"]);
    let rows: Vec<&str> = text.lines().collect();
    // 30 frames a second for two seconds, both ends included, two agents a frame.
    assert_eq!(rows.len(), 1 + 61 * 2);
    assert_eq!(rows[0], "frame,time,agent,x,y,z");
    assert_eq!(rows[1], "0,0,Ada,0,0,0");
    assert_eq!(rows[122], "60,2,Ben,0,0,0");
}

#[test]
fn motion_writes_the_kind_of_file_that_the_name_says() {
    let desk = Desk::new();
    assert_eq!(desk.answer(&["motion", "show.json", "--out", "out.csv"]), "");
    assert_eq!(desk.read("out.csv"), desk.answer(&["motion", "show.json"]));
    assert_eq!(desk.answer(&["motion", "show.json", "--out", "out.json"]), "");
    assert_eq!(desk.read("out.json"), desk.answer(&["motion", "show.json", "--json"]));
    assert_eq!(desk.names(), ["keyframes.csv", "out.csv", "out.json", "show.json"]);
    let motion = parsed(&desk.read("out.json"));
    assert_eq!(motion["times"], json!([0.0, 0.5, 1.0, 1.5, 2.0]));
    assert_eq!(motion["positions"][4], json!([[2.0, 0.0], [2.0, 2.0], [0.0, 2.0], [0.0, 0.0]]));
}

#[test]
fn motion_at_instants_answers_in_the_order_asked() {
    let desk = Desk::new();
    let motion = parsed(&desk.answer(&["motion", "show.json", "--at", "1,-1,0.123,99", "--json"]));
    assert_eq!(motion["times"], json!([1.0, -1.0, 0.123, 99.0]));
    assert_eq!(motion["positions"][0], json!([[1.0, 0.0], [2.0, 1.0], [1.0, 2.0], [0.0, 1.0]]));
    assert_eq!(motion["positions"][1], json!([[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0]]));
    let t: f64 = 0.123 / 2.0;
    let x = 2.0 * t * t * (3.0 - 2.0 * t);
    assert!((number(&motion["positions"][2][0][0]) - x).abs() < 1e-15);
    assert_eq!(motion["positions"][3], json!([[2.0, 0.0], [2.0, 2.0], [0.0, 2.0], [0.0, 0.0]]));
}

#[test]
fn a_join_in_place_of_the_scenes_runs_through_its_keyframes() {
    let desk = Desk::new();
    desk.put(
        "line.json",
        r#"{ "format": "eigenform", "version": 1, "segments": [{ "method": "linear" }, { "method": "linear" }], "keyframes": [
            { "positions": [[0, 0]] }, { "time": 2, "positions": [[2, 0]] }, { "time": 4, "positions": [[6, 0]] }] }"#,
    );
    // (0.5 · (2 − 0) + 0.5 · (6 − 2)) m a segment of 2 s; a separate segment stands at its ends.
    for (join, speed) in [("smooth", 1.5), ("product", 1.5), ("separate", 0.0)] {
        let motion = parsed(&desk.answer(&["motion", "line.json", "--join", join, "--at", "1.999,2,2.001", "--json"]));
        let x: Vec<f64> = (0..3).map(|k| number(&motion["positions"][k][0][0])).collect();
        assert!((x[1] - 2.0).abs() < 1e-12);
        for way in [x[1] - x[0], x[2] - x[1]] {
            assert!((way / 0.001 - speed).abs() < 0.01, "{join}: {way} m in a millisecond");
        }
    }
}

#[test]
fn measure_has_its_keys_and_numbers() {
    let desk = Desk::new();
    let report = parsed(&desk.answer(&["measure", "show.json", "--minimum-distance", "1.5", "--json"]));
    let segment = report["segments"][0].as_object().expect("one segment");
    let keys: Vec<&str> = segment.keys().map(String::as_str).collect();
    let mut expected = [
        ["method", "options", "distortion", "turning", "clearance", "nearCollisions", "pathLength", "topSpeed"],
        [
            "rmsRadius",
            "candidates",
            "mutualInformation",
            "speedInformation",
            "structureDeviation",
            "effortDeviation",
            "targetDeviation",
            "roughness",
        ],
    ]
    .concat();
    expected.sort_unstable();
    assert_eq!(keys, expected);
    assert_eq!(segment["method"], "linear");
    assert_eq!(segment["options"], json!({ "timing": "smooth" }));
    assert_eq!(segment["candidates"], json!([]));
    // Halfway the corners of the square are the middles of its sides.
    assert!((number(&segment["clearance"]["distance"]) - 2.0_f64.sqrt()).abs() < 1e-12);
    assert_eq!(segment["clearance"]["time"], 1.0);
    assert_eq!(segment["nearCollisions"], 4);
    assert!((number(&segment["pathLength"]["mean"]) - 2.0).abs() < 1e-12);
}

#[test]
fn measure_shows_what_auto_chose_from() {
    let desk = Desk::new();
    let report = parsed(&desk.answer(&["measure", "show.json", "--method", "auto", "--json"]));
    let segment = &report["segments"][0];
    let candidates = segment["candidates"].as_array().expect("a list");
    assert!(candidates.len() > 5);
    let chosen: Vec<&Value> = candidates.iter().filter(|candidate| candidate["chosen"] == true).collect();
    assert_eq!(chosen.len(), 1);
    assert_eq!(chosen[0]["method"], segment["method"]);
    assert_eq!(chosen[0]["options"], segment["options"]);
    let least = candidates.iter().map(|candidate| number(&candidate["score"])).fold(f64::INFINITY, f64::min);
    assert!((number(&chosen[0]["score"]) - least).abs() < 1e-12);
}

#[test]
fn modes_of_a_square_are_those_of_the_cycle_of_four() {
    let desk = Desk::new();
    let text = desk.answer(&["modes", "show.json", "--keyframe", "0", "--json", "--vectors"]);
    let modes = parsed(&text);
    // Weights are 1/2: half of 0, 2, 2, 4.
    for (value, expected) in modes["eigenvalues"].as_array().expect("a list").iter().zip([0.0, 1.0, 1.0, 2.0]) {
        assert!((number(value) - expected).abs() < 1e-12);
    }
    assert_eq!(modes["ties"], json!([[0, 1, 0.5], [0, 3, 0.5], [1, 2, 0.5], [2, 3, 0.5]]));
    for (agent, position) in [[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0]].into_iter().enumerate() {
        for axis in 0..2 {
            let sum: f64 = (0..4).map(|k| number(&modes["vectors"][k][agent]) * number(&modes["coefficients"][k][axis])).sum();
            assert!((sum - position[axis]).abs() < 1e-12, "the modes add up to the formation");
        }
    }
    let without = parsed(&desk.answer(&["modes", "show.json", "--keyframe", "0", "--json"]));
    assert_eq!(without.as_object().expect("an object").len(), 2);
}

#[test]
fn assign_finds_who_stays() {
    let desk = Desk::new();
    let text = desk.answer(&["assign", "show.json", "--from", "0", "--to", "1", "--cost", "squared", "--json"]);
    assert_eq!(parsed(&text), json!({ "assignment": [3, 0, 1, 2], "cost": 0.0 }));
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

#[test]
fn a_link_opens_as_the_scene() {
    let desk = Desk::new();
    let link = desk.answer(&["link", "show.json", "--base", "https://example.org/"]);
    assert!(link.starts_with("https://example.org/#s=1."), "{link}");
    let scene = desk.answer(&["open", link.trim()]);
    assert_eq!(scene, desk.answer(&["convert", link.trim(), "-"]));
    desk.put("again.json", &scene);
    assert_eq!(desk.answer(&["link", "again.json", "--base", "https://example.org/"]), link);
    assert_eq!(desk.answer(&["motion", link.trim()]), desk.answer(&["motion", "show.json"]));
}

#[test]
fn a_short_link_says_what_it_rounds() {
    let desk = Desk::new();
    desk.put("odd.csv", "keyframe,time,agent,group,x,y\n0,0,0,,0.123456,0.1\n0,0,1,,31.7,0.3\n0,0,2,,9.9999,22.3333\n");
    let outcome = desk.run(&["link", "odd.csv", "--short"]);
    assert_eq!(outcome.code, 0);
    assert!(outcome.stderr.starts_with("note: positions are rounded by up to 0.00"), "{}", outcome.stderr);
    assert_eq!(desk.answer(&["link", "show.json", "--short"]), desk.answer(&["link", "show.json"]));
}

#[test]
fn convert_goes_both_ways() {
    let desk = Desk::new();
    assert_eq!(desk.answer(&["convert", "keyframes.csv", "scene.json"]), "");
    assert_eq!(desk.run(&["convert", "scene.json", "again.csv"]).code, 0);
    desk.answer(&["convert", "again.csv", "again.json"]);
    let [first, second] = ["scene.json", "again.json"].map(|name| parsed(&desk.read(name)));
    assert_eq!(first["keyframes"], second["keyframes"]);
    assert_eq!(desk.run(&["convert", "scene.json", "-"]).stdout, desk.read("again.csv"));
}

#[test]
fn check_counts() {
    let desk = Desk::new();
    assert_eq!(desk.answer(&["check", "show.json"]), "ok: 4 agents, 2 keyframes\n");
    assert_eq!(desk.answer(&["check", "keyframes.csv"]), "ok: 2 agents, 2 keyframes\n");
}

#[test]
fn what_a_scene_cannot_have_is_a_note_with_what_helps() {
    let desk = Desk::new();
    let stands = r#""stage": { "width": 4, "depth": 2 }, "obstacles": [{ "kind": "circle", "center": [0, 0], "radius": 1 }],"#;
    let positions = r#"{ "positions": [[0, 0], [1, 1], [-1, 1], [2, 0]] }"#;
    desk.put(
        "small.json",
        &format!(r#"{{ "format": "eigenform", "version": 1, "minimumDistance": 5, {stands} "keyframes": [{positions}] }}"#),
    );
    for verb in ["check", "measure"] {
        let outcome = desk.run(&[verb, "small.json"]);
        assert_eq!(outcome.code, 0);
        let notes: Vec<&str> = outcome.stderr.lines().collect();
        assert_eq!(notes.len(), 2, "{notes:?}");
        assert!(
            notes[0].starts_with("note: a stage of 4 × 2 m holds at most 2 agents 5 m apart, and the scene has 4; 2.00 m fits"),
            "{notes:?}"
        );
        assert!(notes[1].starts_with("note: agent 0 stands within obstacle 0; "), "{notes:?}");
    }
}

#[test]
fn a_dash_is_standard_input() {
    let desk = Desk::new();
    for input in ["show.json", "keyframes.csv"] {
        let by_name = desk.run(&["check", input]);
        assert_eq!(desk.run_with(&["check", "-"], &desk.read(input)), by_name);
    }
    let link = desk.answer(&["link", "show.json"]);
    assert_eq!(desk.run_with(&["open", "-"], &link).stdout, desk.answer(&["open", link.trim()]));
    assert_eq!(desk.run_with(&["check", "-"], &link).stdout, "ok: 4 agents, 2 keyframes\n");
}

#[test]
fn overrides_count_and_leave_the_rest() {
    let desk = Desk::new();
    let scene = desk.answer(&[
        "link",
        "show.json",
        "--method",
        "spectral",
        "--minimum-distance",
        "0.5",
        "--join",
        "separate",
        "--avoidance",
        "false",
    ]);
    let scene = parsed(&desk.answer(&["open", scene.trim()]));
    assert_eq!(scene["minimumDistance"], 0.5);
    assert_eq!(scene["segments"][0]["method"], "spectral");
    assert_eq!(scene["frameRate"], 2.0);
}

#[test]
fn two_who_change_places_are_kept_apart() {
    let desk = Desk::new();
    let straight = ["keyframes.csv", "--method", "linear", "--minimum-distance", "0.4"];
    let measured = |typed: &[&str]| parsed(&desk.answer(&[&["measure", "--json"], &straight[..], typed].concat()))["segments"][0].clone();
    let (free, apart) = (measured(&[]), measured(&["--avoidance"]));
    assert_eq!(free["clearance"]["distance"], 0.0);
    assert_eq!((&free["unsolved"], &free["deviation"]), (&Value::Null, &Value::Null));
    assert_eq!((&apart["unsolved"], &apart["guideClearance"]["distance"]), (&json!([]), &json!(0.0)));
    assert!(number(&apart["clearance"]["distance"]) >= 0.4 - 1e-6 && number(&apart["deviation"]["max"]) > 0.2, "{apart}");
    // At frames, as at the keyframes, an instant asked for is the frame itself.
    let at = |typed: &[&str]| desk.answer(&[&["motion", "--avoidance"], &straight[..], typed].concat());
    let [frames, instants] = [&["--json"][..], &["--at", "0,0.5,1,2"]].map(|typed| parsed(&at(typed)));
    for (instant, frame) in [0, 15, 30, 60].into_iter().enumerate() {
        assert_eq!(instants["positions"][instant], frames["positions"][frame]);
    }
}

#[test]
fn the_same_scene_gives_the_same_bytes() {
    let desk = Desk::new();
    for arguments in
        [&["motion", "show.json", "--method", "auto"][..], &["measure", "show.json", "--method", "auto", "--json"], &["link", "show.json"]]
    {
        assert_eq!(desk.run(arguments), desk.run(arguments));
    }
}

#[test]
fn every_verb_has_help_with_an_example() {
    let desk = Desk::new();
    for verb in ["motion", "measure", "modes", "assign", "groups", "link", "open", "convert", "check"] {
        let help = desk.answer(&[verb, "--help"]);
        assert!(help.contains(&format!("  eigenform {verb} ")), "{help}");
    }
    assert!(desk.answer(&["--help"]).contains("Exit codes"));
}

#[test]
fn convert_makes_a_scene_of_frames_of_a_recording() {
    let desk = Desk::new();
    desk.put("crowd.txt", "# framerate: 10.00 fps\n# id frame x/m y/m\n1 5 0 0\n2 5 4 0\n1 6 1 1\n2 6 4 1\n1 7 2 2\n");
    let outcome = desk.run(&["convert", "crowd.txt", "scene.json", "--frames", "5,7", "--method", "linear"]);
    assert_eq!((outcome.code, outcome.stderr.lines().count()), (0, 2), "{}", outcome.stderr);
    assert_eq!(desk.answer(&["check", "scene.json"]), "ok: 1 agents, 2 keyframes\n");
    let motion = parsed(&desk.answer(&["motion", "scene.json", "--at", "0,0.2", "--json"]));
    assert_eq!(motion["positions"], json!([[[0.0, 0.0]], [[2.0, 2.0]]]));
    desk.answer(&["motion", "show.json", "--out", "motion.csv"]);
    assert_eq!(desk.answer(&["convert", "motion.csv", "again.json", "--frames", "0,4"]), "");
    let motion = parsed(&desk.answer(&["motion", "again.json", "--at", "2", "--json"]));
    assert_eq!(motion["positions"], json!([[[2.0, 0.0], [2.0, 2.0], [0.0, 2.0], [0.0, 0.0]]]));
}

#[test]
fn ways_are_compared_by_their_names_and_those_that_no_scene_has_too() {
    let desk = Desk::new();
    let methods = ["linear", "crowd", "crowd-no-feedback", "social-force-guide", "social-force"];
    let told = parsed(&desk.answer(&["compare", "show.json", "--methods", &methods.join(","), "--minimum-distance", "0.5", "--json"]));
    let rows = told["segments"][0]["methods"].as_array().expect("a row a method");
    assert_eq!(rows.iter().map(|row| row["method"].as_str().expect("a name")).collect::<Vec<_>>(), methods);
    for row in rows {
        for key in ["mutualInformation", "speedInformation", "structureDeviation", "effortDeviation", "targetDeviation"] {
            assert!(row[key]["mean"].is_number() && row[key]["max"].is_number(), "{key} of {row}");
        }
        assert_eq!(row["curves"]["times"].as_array().map(Vec::len), Some(5));
    }
    assert_eq!((&rows[0]["time"], &rows[0]["arrivalError"]), (&json!(2.0), &Value::Null));
    assert!(rows[4]["arrivalError"]["max"].is_number() && rows[4]["unsolved"].is_array());
    let table = desk.answer(&["compare", "show.json", "--methods", "linear,social-force"]);
    assert_eq!(
        table.lines().map(|line| line.split_whitespace().next()).collect::<Vec<_>>(),
        ["keyframe", "method", "linear", "social-force"].map(Some)
    );
}

#[test]
fn spread_gives_those_who_are_stuck_room_and_leaves_all_else() {
    let desk = Desk::new();
    let outcome = desk.run(&["spread", "show.json"]);
    assert_eq!((outcome.code, outcome.stderr.as_str()), (0, ""));
    assert_eq!(parsed(&outcome.stdout)["keyframes"].as_array().map(Vec::len), Some(2));
    assert_eq!(desk.run(&["spread", "show.json", "--segment", "1"]).code, 2);
    let block = |x: f64, y: f64| (0..9).map(move |k| [x + f64::from(k % 3), y + f64::from(k / 3)]);
    let keyframes = json!([
        { "positions": block(-6.0, 0.0).chain(block(0.0, -6.0)).collect::<Vec<_>>() },
        { "time": 6, "positions": block(6.0, 0.0).chain(block(0.0, 6.0)).collect::<Vec<_>>() },
    ]);
    let scene = json!({
        "format": "eigenform", "version": 1, "minimumDistance": 0.8, "join": "smooth", "keyframes": keyframes,
        "segments": [{ "method": "linear", "avoidance": true }],
    });
    desk.put("stuck.json", &scene.to_string());
    let unsolved = |name: &str| {
        let report = parsed(&desk.answer(&["measure", name, "--json"]));
        report["segments"]
            .as_array()
            .expect("segments")
            .iter()
            .map(|segment| segment["unsolved"].as_array().map_or(0, Vec::len))
            .sum::<usize>()
    };
    assert!(unsolved("stuck.json") > 0);
    let outcome = desk.run(&["spread", "stuck.json"]);
    assert!(outcome.stderr.starts_with("note: transition 0: ") && outcome.stderr.contains("times as fast"), "{}", outcome.stderr);
    desk.put("apart.json", &outcome.stdout);
    assert_eq!(unsolved("apart.json"), 0);
}
