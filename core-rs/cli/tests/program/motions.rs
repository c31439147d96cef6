//! How agents move: motion, measure, modes, compare, spread.

use serde_json::{Value, json};

use crate::desk::{Desk, SHOW};
use crate::{number, parsed};

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
fn measure_says_who_is_too_fast_who_is_shut_off_and_who_stands_inside() {
    let desk = Desk::new();
    let scene = |extra: Value, from: [f64; 2], to: [f64; 2], segment: Value| {
        let keyframes = json!([{ "positions": [from, [9.5, -9.5]] }, { "time": 2, "positions": [to, [9.5, -6.5]] }]);
        let mut scene =
            json!({ "format": "eigenform", "version": 1, "minimumDistance": 0.5, "keyframes": keyframes, "segments": [segment] });
        scene.as_object_mut().expect("an object").extend(extra.as_object().expect("fields").clone());
        scene.to_string()
    };
    let avoiding = json!({ "method": "linear", "avoidance": true });
    // Ten meters in two seconds, at a meter a second.
    let limited = json!({ "agents": [{ "maxSpeed": 1 }, {}] });
    desk.put("hurried.json", &scene(limited, [0.0, 0.0], [0.0, 10.0], json!({ "method": "crowd" })));
    let wall = |[left, bottom, right, top]: [i32; 4]| json!({ "kind": "polygon", "points": [[left, bottom], [right, bottom], [right, top], [left, top]] });
    let walls = [[-4, -4, 4, -3], [-4, 3, 4, 4], [-4, -4, -3, 4], [3, -4, 4, 4]].map(wall);
    let room = json!({ "obstacles": walls });
    desk.put("shut.json", &scene(room, [0.0, 0.0], [0.0, 8.0], avoiding.clone()));
    let pillar = json!({ "obstacles": [{ "kind": "circle", "center": [0, 0], "radius": 1 }] });
    desk.put("inside.json", &scene(pillar, [0.75, 0.0], [6.0, 0.0], avoiding));
    let said = |name: &str| {
        let outcome = desk.run(&["measure", name]);
        assert_eq!(outcome.code, 0, "{}", outcome.stderr);
        outcome.stdout.lines().filter(|line| line.starts_with("segment 0: ")).map(str::to_owned).collect::<Vec<_>>()
    };
    let hurried = said("hurried.json").concat();
    let number = |before: &str, after: &str| -> f64 {
        let rest = hurried.split_once(before).unwrap_or_else(|| panic!("{hurried}")).1;
        rest.split_once(after).and_then(|(number, _)| number.parse().ok()).unwrap_or_else(|| panic!("{hurried}"))
    };
    let fastest = number("segment 0: agent 0 moves at up to ", " m/s to arrive in time, and its top speed is 1 m/s; ");
    // As much longer as it is too fast; both are written rounded.
    let longer = number("its top speed is 1 m/s; ", " s would do");
    assert!(fastest >= 5.0 && (longer - 2.0 * fastest).abs() < 0.12, "{hurried}");
    let shut = "segment 0: no way leads agent 0 to its place, so it goes through: obstacle 1 shuts it off; move the obstacle, or leave a gap of 1 m";
    assert_eq!(said("shut.json")[0], shut);
    assert_eq!(said("inside.json"), ["segment 0: agent 0 is 0.250 m inside obstacle 0 at 0.00 s"]);
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
fn modes_are_of_those_who_are_there() {
    let desk = Desk::new();
    let with_a_fifth = SHOW.replace("[0, 2]]", "[0, 2], [9, 9]], \"absent\": [4]").replace("[0, 0]] }", "[0, 0], [9, 9]] }");
    desk.put("five.json", &with_a_fifth);
    let asked = |name: &str| parsed(&desk.answer(&["modes", name, "--keyframe", "0", "--json", "--vectors"]));
    let (four, mut five) = (asked("show.json"), asked("five.json"));
    for vector in five["vectors"].as_array_mut().expect("a list") {
        assert_eq!(vector.as_array_mut().expect("a list").pop(), Some(json!(0.0)), "no part in any mode");
    }
    assert_eq!(five, four);
}

#[test]
fn modes_tell_how_they_become_those_of_the_next_keyframe() {
    let desk = Desk::new();
    let text = desk.answer(&["modes", "show.json", "--keyframe", "0", "--json", "--vectors", "--next"]);
    let modes = parsed(&text);
    // Two orthonormal bases of one space: every row and every column of squares adds up to one.
    let likeness = |k: usize, l: usize| number(&modes["likeness"][k][l]).powi(2);
    for k in 0..3 {
        assert!(((0..3).map(|l| likeness(k, l)).sum::<f64>() - 1.0).abs() < 1e-12);
        assert!(((0..3).map(|l| likeness(l, k)).sum::<f64>() - 1.0).abs() < 1e-12);
    }
    for order in ["eigenvalue", "greedy", "maxmin", "hungarian"] {
        let mut paired: Vec<f64> = modes["pairs"][order].as_array().expect("a list").iter().map(number).collect();
        paired.sort_by(f64::total_cmp);
        assert_eq!(paired, [1.0, 2.0, 3.0], "{order}");
    }
    let between = &modes["between"];
    assert_eq!((&between["t"][0], &between["t"][32]), (&json!(0.0), &json!(1.0)));
    for (value, start) in between["eigenvalues"][0].as_array().expect("a list").iter().zip(modes["eigenvalues"].as_array().expect("a list"))
    {
        assert!((number(value) - number(start)).abs() < 1e-12);
    }
    let refused = desk.run(&["modes", "show.json", "--keyframe", "1", "--json", "--next"]);
    assert_eq!((refused.code, refused.stderr.as_str()), (2, "error: usage: keyframe 1 is the last one; none comes after it (--next)\n"));
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
fn ways_are_compared_under_every_cost_and_where_everybody_arrives_when_they_do() {
    let desk = Desk::new();
    // Two who stand in each other's place: any cost but keeping sends nobody anywhere.
    let keyframes = json!([{ "positions": [[0, 0], [3, 0]] }, { "time": 2, "positions": [[3, 0], [0, 0]] }]);
    desk.put("swap.json", &json!({ "format": "eigenform", "version": 1, "keyframes": keyframes }).to_string());
    let asked = ["compare", "swap.json", "--methods", "linear,crowd", "--costs", "keep,least-effort,manhattan"];
    let rows = |typed: &[&str]| parsed(&desk.answer(&[&asked[..], typed, &["--json"]].concat()))["segments"][0]["methods"].clone();
    let timed = rows(&[]);
    let of = |rows: &Value, key: &str| rows.as_array().expect("rows").iter().map(|row| row[key].clone()).collect::<Vec<_>>();
    assert_eq!(of(&timed, "cost"), ["keep", "keep", "least-effort", "least-effort", "manhattan", "manhattan"]);
    assert_eq!(of(&timed, "method"), ["linear", "crowd", "linear", "crowd", "linear", "crowd"]);
    let walked: Vec<f64> = of(&timed, "pathLength").iter().map(|length| number(&length["max"])).collect();
    assert!((walked[0] - 3.0).abs() < 1e-9 && walked[2] < 1e-9 && walked[4] < 1e-9, "{walked:?}");
    // 3 m at 1.34 m/s and at 0.5 m/s.
    assert!((number(&rows(&["--free-arrival"])[0]["time"]) - 3.0 / 1.34).abs() < 1e-9);
    assert!((number(&rows(&["--free-arrival=0.5"])[0]["time"]) - 6.0).abs() < 1e-9);
    let table = desk.answer(&asked);
    assert_eq!(table.lines().nth(1).and_then(|line| line.split_whitespace().next()), Some("cost"));
    assert_eq!(table.lines().count(), 2 + 6);
}

#[test]
fn spread_gives_those_who_are_stuck_room_and_leaves_all_else() {
    let desk = Desk::new();
    let outcome = desk.run(&["spread", "show.json"]);
    assert_eq!((outcome.code, outcome.stderr.as_str()), (0, ""));
    assert_eq!(parsed(&outcome.stdout)["keyframes"].as_array().map(Vec::len), Some(2));
    assert_eq!(desk.run(&["spread", "show.json", "--segment", "1"]).code, 2);
    let block = |x: f64, y: f64| (0..9).map(move |k| [x + f64::from(k % 3), y + f64::from(k / 3)]);
    // Two ranks change places.
    let exchanged = [3, 4, 5, 0, 1, 2, 6, 7, 8].into_iter().map(|k| [6.0 + f64::from(k % 3), f64::from(k / 3)]);
    let keyframes = json!([
        { "positions": block(-6.0, 0.0).chain(block(0.0, -6.0)).collect::<Vec<_>>() },
        { "time": 6, "positions": exchanged.chain(block(0.0, 6.0)).collect::<Vec<_>>() },
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

#[test]
fn of_one_keyframe_it_is_said_that_nothing_moves() {
    let desk = Desk::new();
    desk.put("one.json", r#"{ "format": "eigenform", "version": 1, "keyframes": [{ "positions": [[0, 0], [2, 0]] }] }"#);
    for verb in ["measure", "compare"] {
        let outcome = desk.run(&[verb, "one.json"]);
        assert_eq!(
            (outcome.code, outcome.stderr.as_str()),
            (0, "note: the scene has one keyframe, so nothing moves: add another\n"),
            "{verb}"
        );
    }
}
