//! What is wrong in a scene file is said with a stable code, and where.

use eigenform::scene::{open, open_bytes, read_json};

fn check(text: &str, code: &str, place: &str) {
    let error = read_json(text).expect_err(text);
    assert_eq!((error.code(), error.place().as_str()), (code, place), "{text}: {error}");
}

/// A scene of three agents with these fields beside the required ones.
fn with(fields: &str) -> String {
    format!(r#"{{ "format": "eigenform", "version": 1, {fields} "keyframes": [{{ "positions": [[0, 0], [1, 0], [0, 1]] }}] }}"#)
}

/// A scene of three agents and two keyframes, the second of which has these fields.
fn with_second(fields: &str) -> String {
    let positions = r#""positions": [[0, 0], [1, 0], [0, 1]]"#;
    format!(r#"{{ "format": "eigenform", "version": 1, "keyframes": [{{ {positions}, "hold": 1 }}, {{ {fields} {positions} }}] }}"#)
}

/// A scene of three agents with this segment.
fn with_segment(fields: &str) -> String {
    with_second(r#""time": 2,"#).replace(r#""keyframes""#, &format!(r#""segments": [{{ {fields} }}], "keyframes""#))
}

/// A scene of three agents, a field `name` of which is `value`.
fn with_field(name: &str, value: &str) -> String {
    with(&format!(r#""{name}": {value},"#))
}

#[test]
fn the_scene_that_the_cases_change_is_right() {
    for text in [with(""), with_second(r#""time": 2,"#), with_segment("")] {
        assert!(read_json(&text).is_ok(), "{text}");
    }
}

#[test]
fn a_text_that_is_no_scene_says_what_it_is() {
    check("", "empty", "");
    check(" \n\t", "empty", "");
    check("{", "invalid-json", "line 1 column 1");
    check("{\n  \"format\": \"eigenform\",\n  \"version\": 1,}", "invalid-json", "line 3 column 16");
    check(&with("").replace(']', ""), "invalid-json", "line 1 column 91");
    check(&(with("") + "x"), "invalid-json", "line 1 column 99");
    check("[1]", "wrong-type", "");
    check("{}", "missing-field", "");
    check(r#"{ "name": "a-package", "version": "1.0.0" }"#, "missing-field", "");
    check(r#"{ "format": "excalidraw", "version": 2 }"#, "not-a-scene", "format");
    check(r#"{ "format": "eigenform" }"#, "missing-field", "");
    check(r#"{ "format": "eigenform", "version": "1" }"#, "wrong-type", "version");
    check(r#"{ "format": "eigenform", "version": 0 }"#, "wrong-type", "version");
    check(r#"{ "format": "eigenform", "version": 1.5, "keyframes": [] }"#, "newer-version", "version");
    check(r#"{ "format": "eigenform", "version": 2, "anything": [] }"#, "newer-version", "version");
    check(r#"{ "format": "eigenform", "version": 1 }"#, "missing-field", "");
    check(r#"{ "format": "eigenform", "version": 1, "keyframes": [] }"#, "no-keyframes", "keyframes");
    check(r#"{ "format": "eigenform", "version": 1, "keyframes": [{}] }"#, "missing-field", "keyframes[0]");
    assert_eq!(open_bytes(b"{ \"title\": \"\xff\" }").unwrap_err().code(), "not-text");
}

#[test]
fn a_file_of_something_else_is_told_what_opens() {
    let minified = format!("<!doctype html><title>Time</title>{}", "<p>".repeat(5_000));
    for text in ["one,two\n1,2\n", "Dear Ada,\nwe meet at nine.\n", "<html>\n<meta name=\"x\">\n", &minified, "# Notes\n", "0,0,a,,1,2\n"] {
        let error = open(text).expect_err(text);
        assert_eq!((error.code(), error.place().as_str()), ("not-a-scene", ""), "{text}");
        let told = error.to_string();
        assert!(["scene file", "keyframe CSV", "recording", "link"].iter().all(|kind| told.contains(kind)), "{told}");
    }
    for bytes in [&b"OggS\0\x02\0\0"[..], b"\x89PNG\r\n\x1a\n", b"\xff\xfek\0e\0y\0"] {
        assert_eq!(open_bytes(bytes).unwrap_err().code(), "not-text");
    }
    // What is nearly a keyframe CSV is told what it lacks.
    assert_eq!(open("keyframe,time,agent,height\n").unwrap_err().code(), "unknown-column");
    assert_eq!(open("time,agent,x,y\n").unwrap_err().code(), "missing-column");
    for separator in [";", "\t"] {
        assert_eq!(open(&"keyframe,time,agent,x,y\n0,0,a,1,2\n".replace(',', separator)).unwrap_err().code(), "not-commas");
    }
}

#[test]
fn a_newer_version_says_so() {
    let error = read_json(r#"{ "format": "eigenform", "version": 7 }"#).unwrap_err();
    assert_eq!(error.to_string(), "this was made by a newer version of Eigenform (format version 7); this one reads version 1");
}

#[test]
fn unknown_fields_are_named_with_the_fields_there_are() {
    check(&with(r#""colour": 1,"#), "unknown-field", "");
    check(&with(r#""stage": { "height": 0, "heigth": 3 },"#), "unknown-field", "stage");
    check(&with(r#""tempo": { "bpm": 3 },"#), "unknown-field", "tempo");
    check(&with(r#""agents": [{}, { "nick": "" }, {}],"#), "unknown-field", "agents[1]");
    check(&with(r#""groups": [{ "children": [{ "kids": [] }] }],"#), "unknown-field", "groups[0].children[0]");
    check(&with(r#""adjacency": { "tie": [] },"#), "unknown-field", "adjacency");
    check(&with_second(r#""time": 2, "adjacency": { "x": 1 },"#), "unknown-field", "keyframes[1].adjacency");
    check(&with_second(r#""at": 2,"#), "unknown-field", "keyframes[1]");
    check(&with_segment(r#""ease": 2"#), "unknown-field", "segments[0]");
    check(&with_segment(r#""chosen": { "method": "linear", "x": 2 }"#), "unknown-field", "segments[0].chosen");
    check(&with(r#""title": "a", "title": "a","#), "repeated-field", "");
    check(&with(r#""title": "a", "\u0074itle": "a","#), "repeated-field", "");
    let error = read_json(&with(r#""tempo": { "bpm": 3 },"#)).unwrap_err();
    assert_eq!(error.to_string(), r#""bpm" is no field here; the fields are "beatsPerMinute", "beatsPerBar", "start""#);
}

#[test]
fn values_of_another_type_or_word_are_refused() {
    check(&with_field("title", "null"), "wrong-type", "title");
    check(&with_field("title", "3"), "wrong-type", "title");
    check(&with_field("title", r#""\ud800""#), "invalid-json", "title");
    check(&with_field("seed", "1.5"), "wrong-type", "seed");
    check(&with_field("seed", "-1"), "out-of-range", "seed");
    check(&with_field("seed", "4294967296"), "out-of-range", "seed");
    check(&with_field("frameRate", "\"30\""), "wrong-type", "frameRate");
    check(&with_field("frameRate", "NaN"), "invalid-json", "line 1 column 53");
    check(&with_field("frameRate", "1e999"), "not-finite", "frameRate");
    check(&with_field("stage", "[]"), "wrong-type", "stage");
    check(&with_field("stage", r#"{ "units": "km" }"#), "unknown-value", "stage.units");
    check(&with_field("stage", r#"{ "backdrop": "Grid" }"#), "unknown-value", "stage.backdrop");
    check(&with_field("tempo", r#"{ "beatsPerBar": 2.5 }"#), "wrong-type", "tempo.beatsPerBar");
    check(&with_field("groups", "{}"), "wrong-type", "groups");
    check(&with_field("groups", r#"[{ "members": [0, 0.5] }]"#), "wrong-type", "groups[0].members[1]");
    check(&with_field("groups", r#"[{ "tieWeight": "2" }]"#), "wrong-type", "groups[0].tieWeight");
    check(&with_field("adjacency", r#"{ "base": "knn" }"#), "unknown-value", "adjacency.base");
    check(&with_field("adjacency", r#"{ "weights": 1 }"#), "wrong-type", "adjacency.weights");
    check(&with_field("adjacency", r#"{ "ties": [[0, 1]] }"#), "wrong-type", "adjacency.ties[0]");
    check(&with_field("adjacency", r#"{ "ties": [[0, 1, 1], [0, "2", 1]] }"#), "wrong-type", "adjacency.ties[1]");
    check(&with_field("adjacency", r#"{ "ties": [[0, 1, 1e999]] }"#), "not-finite", "adjacency.ties[0]");
    check(&with_field("adjacency", r#"{ "cuts": [[0, 1, 2]] }"#), "wrong-type", "adjacency.cuts[0]");
    check(&with_field("join", "\"bumpy\""), "unknown-value", "join");
    check(&with_field("tension", "\"0.5\""), "wrong-type", "tension");
    check(&with_second(r#""time": "2","#), "wrong-type", "keyframes[1].time");
    check(&with_second(r#""corner": 0,"#), "wrong-type", "keyframes[1].corner");
    check(&with_second(r#""between": true,"#), "wrong-type", "keyframes[1].between");
    check(&with_second(r#""between": 201,"#), "out-of-range", "keyframes[1].between");
    check(&with("").replace("[1, 0]", "[1]"), "wrong-type", "keyframes[0].positions[1]");
    check(&with("").replace("[1, 0]", "[1, 0, 0, 0]"), "wrong-type", "keyframes[0].positions[1]");
    check(&with("").replace("[1, 0]", "[1, 0, \"high\"]"), "wrong-type", "keyframes[0].positions[1]");
    check(&with("").replace("[1, 0]", "[1, 0, 1e400]"), "not-finite", "keyframes[0].positions[1]");
    check(&with_field("obstacles", "{}"), "wrong-type", "obstacles");
    check(&with_field("obstacles", r#"[{ "center": [0, 0], "radius": 1 }]"#), "missing-field", "obstacles[0]");
    check(&with_field("obstacles", r#"[{ "kind": "square" }]"#), "unknown-value", "obstacles[0].kind");
    check(&with_field("obstacles", r#"[{ "kind": "circle", "center": [0, 0] }]"#), "missing-field", "obstacles[0]");
    check(&with_field("obstacles", r#"[{ "kind": "circle", "center": [0], "radius": 1 }]"#), "wrong-type", "obstacles[0].center");
    check(&with_field("obstacles", r#"[{ "kind": "circle", "points": [] }]"#), "unknown-field", "obstacles[0]");
    check(&with_field("obstacles", r#"[{ "kind": "polygon", "points": [[0, 0, 0]] }]"#), "wrong-type", "obstacles[0].points[0]");
    check(&with_field("obstacles", r#"[{ "kind": "polygon" }]"#), "missing-field", "obstacles[0]");
    check(&with_field("adjacency", r#"{ "obstacleTies": [[0, 0]] }"#), "wrong-type", "adjacency.obstacleTies[0]");
    check(&with_segment(r#""nodes": [{ "group": [] }]"#), "missing-field", "segments[0].nodes[0]");
    check(&with_segment(r#""nodes": [{ "group": [-1], "method": "linear" }]"#), "out-of-range", "segments[0].nodes[0].group[0]");
    check(&with_segment(r#""nodes": [{ "method": "auto" }]"#), "unknown-value", "segments[0].nodes[0].method");
    check(&with_segment(r#""nodes": [{ "method": "linear", "mix": 1 }]"#), "unknown-field", "segments[0].nodes[0]");
    let blended = |blend: &str| with_segment(&format!(r#""nodes": [{{ "method": "linear", "blend": {blend} }}]"#));
    check(&blended(r#"{ "method": "polar" }"#), "missing-field", "segments[0].nodes[0].blend");
    check(&blended(r#"{ "amount": 0.5 }"#), "missing-field", "segments[0].nodes[0].blend");
    check(&blended(r#"{ "method": "auto", "amount": 0.5 }"#), "unknown-value", "segments[0].nodes[0].blend.method");
    check(&with("").replace("[1, 0]", "[1, null]"), "wrong-type", "keyframes[0].positions[1]");
    check(&with("").replace("[1, 0]", "[1, 1e400]"), "not-finite", "keyframes[0].positions[1]");
    check(&with_segment(r#""kind": "jump""#), "unknown-value", "segments[0].kind");
    check(&with_segment(r#""method": "fastest""#), "unknown-value", "segments[0].method");
    check(&with_segment(r#""timing": "slow""#), "unknown-value", "segments[0].timing");
    check(&with_segment(r#""order": "greedy ""#), "unknown-value", "segments[0].order");
    check(&with_segment(r#""alignment": 0"#), "wrong-type", "segments[0].alignment");
    check(&with_segment(r#""keepSize": 1"#), "wrong-type", "segments[0].keepSize");
    check(&with_segment(r#""chosen": {}"#), "missing-field", "segments[0].chosen");
    check(&with_segment(r#""chosen": { "method": "auto" }"#), "unknown-value", "segments[0].chosen.method");
    check(&with_segment(r#""chosen": { "method": "crowd" }"#), "unknown-value", "segments[0].chosen.method");
    check(&with_segment(r#""crowd": { "guide": "crowd" }"#), "unknown-value", "segments[0].crowd.guide");
    check(&with_segment(r#""crowd": { "mass": 80 }"#), "unknown-field", "segments[0].crowd");
    check(&with_segment(r#""crowd": { "sectors": 7.5 }"#), "wrong-type", "segments[0].crowd.sectors");
    let error = read_json(&with_field("stage", r#"{ "units": "km" }"#)).unwrap_err();
    assert_eq!(error.to_string(), r#""km" is not known here; it must be one of "m", "ft", "yd", "steps""#);
}

#[test]
fn locks_that_contradict_each_other_say_which() {
    let with_locks = |locks: &str| with_segment(&format!(r#""assignment": {{ "locks": [{locks}] }}"#));
    check(&with_locks("[0, 1], [1, 0], [0, 2]"), "contradictory-locks", "segments[0].assignment.locks[2]");
    check(&with_locks("[0, 1], [2, 1]"), "contradictory-locks", "segments[0].assignment.locks[1]");
    check(&with_locks("[0, 3]"), "unknown-slot", "segments[0].assignment.locks[0]");
    check(&with_locks("[3, 0]"), "unknown-agent", "segments[0].assignment.locks[0]");
    check(&with_locks("[0]"), "wrong-type", "segments[0].assignment.locks[0]");
    check(&with_segment(r#""assignment": { "cost": "nearest" }"#), "unknown-value", "segments[0].assignment.cost");
    check(&with_segment(r#""assignment": { "lambda": 1.5 }"#), "out-of-range", "segments[0].assignment.lambda");
    let error = read_json(&with_locks("[0, 1], [0, 2]")).unwrap_err();
    assert_eq!(error.to_string(), "agent 0 is locked to slots 1 and 2; an agent has one");
}

#[test]
fn what_is_not_built_yet_is_refused_by_name_and_its_default_is_not() {
    let cases = [
        (with_field("recordings", "[@]"), "recordings", " ", "{}"),
        // The paper prints its product of powers for the plane.
        (
            with(r#""join": "product","#).replace("[0, 1]", "[0, 1, @]").replace("[0, 0]", "[0, 0, 0]").replace("[1, 0]", "[1, 0, 0]"),
            "join",
            "0",
            "1",
        ),
    ];
    for (text, place, default, other) in cases {
        let right = text.replace('@', default);
        assert_eq!(read_json(&right).map(|_| ()), Ok(()), "{right}");
        check(&text.replace('@', other), "unsupported", place);
    }
    let error = read_json(&with_field("recordings", "[{}]")).unwrap_err();
    assert!(error.to_string().starts_with("[{}] is not supported yet; give []"), "{error}");
}

#[test]
fn who_is_absent_is_an_agent_of_the_scene_and_named_once() {
    let with_absent = |agents: &str| with_second(&format!(r#""time": 2, "absent": [{agents}],"#));
    check(&with_absent("3"), "unknown-agent", "keyframes[1].absent[0]");
    check(&with_absent("-1"), "out-of-range", "keyframes[1].absent[0]");
    check(&with_absent("0.5"), "wrong-type", "keyframes[1].absent[0]");
    check(&with_absent("2, 0, 2"), "repeated-member", "keyframes[1].absent");
    let read = read_json(&with_absent("2, 0")).expect("an order is no matter");
    assert_eq!(read.main_track().keyframes[1].absent, [0, 2]);
    assert_eq!(read_json(&with_absent("0, 1, 2")).map(|_| ()), Ok(()), "a stage may be empty");
}

#[test]
fn a_path_that_cannot_be_followed_is_refused() {
    let check = |points: &str, code: &str, place: &str| check(&with_segment(&format!(r#""path": {points}"#)), code, place);
    for nowhere in ["[]", "[[0, 0]]", "[[3, 4], [3, 4], [3, 4]]"] {
        check(nowhere, "no-length", "segments[0].path");
    }
    check("[[0, 0], [1e999, 0]]", "not-finite", "segments[0].path[1]");
    check("[[0, 0], [1, 2e5]]", "out-of-range", "segments[0].path[1]");
    check("[[0, 0], [1, 2, 3]]", "mixed-dimensions", "segments[0].path[1]");
    check("[[0, 0, 0], [1, 2, 3]]", "mixed-dimensions", "segments[0].path[0]");
    check("[0, 1]", "wrong-type", "segments[0].path[0]");
    check("true", "wrong-type", "segments[0].path");
    check(&format!("[{}[0, 1]]", "[0, 0], ".repeat(200)), "too-many-points", "segments[0].path");
    let with_path = |points: &str| read_json(&with_segment(&format!(r#""path": {points}"#)));
    assert_eq!(
        with_path("[[0, 0]]").unwrap_err().to_string(),
        "this path has no length; give it two points apart or more, or null for the straight way"
    );
    assert_eq!(with_path(&format!("[{}[0, 1]]", "[0, 0], ".repeat(199))).map(|_| ()), Ok(()));
    let crossed = with_path("[[0, 0], [4, 4], [4, 0], [0, 4]]").expect("it can be followed");
    let told = eigenform::scene::cautions(&crossed);
    assert!(
        told.len() == 1 && told[0].contains("crosses itself after points 0 and 2") && told[0].ends_with("(segments[0].path)"),
        "{told:?}"
    );
    assert!(eigenform::scene::cautions(&with_path("[[0, 0], [4, 4], [4, 0], [0, -4]]").expect("it is plain")).is_empty());
}

#[test]
fn parts_that_do_not_fit_together_are_refused() {
    check(&with_field("agents", "[{}, {}]"), "wrong-count", "keyframes[0].positions");
    check(&with_second(r#""time": 2,"#).replacen(", [0, 1]", "", 1), "wrong-count", "keyframes[1].positions");
    check(&with_segment("}, {"), "wrong-count", "segments");
    check(&with_second(""), "times-do-not-rise", "keyframes[1].time");
    check(&with_second(r#""time": 1,"#), "times-do-not-rise", "keyframes[1].time");
    check(&with_field("groups", r#"[{ "members": [3] }]"#), "unknown-agent", "groups[0].members[0]");
    check(&with_field("groups", r#"[{ "members": [1, 1] }]"#), "repeated-member", "groups[0].members[1]");
    check(&with_field("groups", r#"[{ "members": [1] }, { "members": [0, 1] }]"#), "shared-member", "groups[1].members[1]");
    let cousins = r#"[{ "children": [{ "members": [2] }] }, { "children": [{ "members": [2] }] }]"#;
    check(&with_field("groups", cousins), "shared-member", "groups[1].children[0].members[0]");
    check(&with_field("adjacency", r#"{ "ties": [[0, 3, 1]] }"#), "unknown-agent", "adjacency.ties[0]");
    check(&with_field("adjacency", r#"{ "ties": [[2, 2, 1]] }"#), "self-tie", "adjacency.ties[0]");
    check(&with_field("adjacency", r#"{ "ties": [[0, 1, 1], [1, 2, 1], [1, 0, 2]] }"#), "repeated-pair", "adjacency.ties[2]");
    check(&with_field("adjacency", r#"{ "cuts": [[0, 1], [0, 1]] }"#), "repeated-pair", "adjacency.cuts[1]");
    check(&with_second(r#""time": 2, "adjacency": { "cuts": [[5, 1]] },"#), "unknown-agent", "keyframes[1].adjacency.cuts[0]");
    let two = r#"[{ "kind": "circle", "center": [5, 5], "radius": 1 }, { "kind": "circle", "center": [9, 5], "radius": 1 }]"#;
    let tied = |ties: &str| with(&format!(r#""obstacles": {two}, "adjacency": {{ "obstacleTies": {ties} }},"#));
    check(&tied("[[3, 0, 1]]"), "unknown-agent", "adjacency.obstacleTies[0]");
    check(&tied("[[0, 0, 1], [0, 2, 1]]"), "unknown-obstacle", "adjacency.obstacleTies[1]");
    check(&tied("[[0, 1, 1], [1, 0, 1], [0, 1, 2]]"), "repeated-pair", "adjacency.obstacleTies[2]");
    let line = r#"[{ "kind": "polygon", "points": [[0, 0], [1, 1], [3, 3]] }]"#;
    check(&with_field("obstacles", line), "no-area", "obstacles[0].points");
    check(&with_field("obstacles", &line.replace(", [3, 3]", "")), "no-area", "obstacles[0].points");
    check(&with_field("obstacles", r#"[{ "kind": "polygon", "points": [] }]"#), "no-area", "obstacles[0].points");
    let bow = r#"[{ "kind": "polygon", "points": [[0, 0], [4, 4], [4, 0], [0, 3]] }]"#;
    check(&with_field("obstacles", bow), "self-crossing", "obstacles[0].points");
    let grouped = |nodes: &str| with_segment(&format!(r#""nodes": {nodes} }}], "groups": [{{ "children": [{{}}]"#));
    check(&grouped(r#"[{ "group": [1], "method": "linear" }]"#), "unknown-group", "segments[0].nodes[0].group");
    check(&grouped(r#"[{ "group": [0, 1], "method": "linear" }]"#), "unknown-group", "segments[0].nodes[0].group");
    check(&grouped(r#"[{ "group": [0, 0, 0], "method": "linear" }]"#), "unknown-group", "segments[0].nodes[0].group");
    let twice = r#"[{ "group": [0, 0], "method": "linear" }, { "group": [], "method": "polar" }, { "group": [0, 0], "method": "polar" }]"#;
    check(&grouped(twice), "repeated-node", "segments[0].nodes[2]");
    check(&with("").replace("[1, 0]", "[1, 0, 0]"), "mixed-dimensions", "keyframes[0].positions[1]");
    check(&with_second(r#""time": 2,"#).replacen("[0, 0]", "[0, 0, 5]", 1), "mixed-dimensions", "keyframes[0].positions[1]");
    let second = with_second(r#""time": 2,"#);
    let (first, last) = second.rsplit_once("[0, 0], [1, 0], [0, 1]").expect("two keyframes");
    check(&format!("{first}[0, 0, 1], [1, 0, 1], [0, 1, 1]{last}"), "mixed-dimensions", "keyframes[1].positions[0]");
    check(&with_field("agents", r#"[{ "color": "red" }, {}, {}]"#), "invalid-color", "agents[0].color");
    check(&with_field("groups", r##"[{ "color": "#12345g" }]"##), "invalid-color", "groups[0].color");
}

#[test]
fn ties_name_the_lower_agent_first_and_keep_their_order() {
    let scene = read_json(&with_field("adjacency", r#"{ "ties": [[2, 1, 3], [1.0, 0, 2]], "cuts": [[2, 0]] }"#)).unwrap();
    assert_eq!((&*scene.adjacency.ties, &*scene.adjacency.cuts), (&[(1, 2, 3.0), (0, 1, 2.0)][..], &[(0, 2)][..]));
}

#[test]
fn a_group_may_repeat_what_its_children_have() {
    let scene = read_json(&with_field("groups", r#"[{ "members": [0, 1, 2], "children": [{ "members": [1] }] }]"#)).unwrap();
    assert_eq!((&*scene.groups[0].members, scene.groups[0].set()), (&[0, 2][..], vec![0, 1, 2]));
}

#[test]
fn a_message_is_one_short_line_whatever_was_typed() {
    let word = "w\\n".repeat(10_000);
    for text in [
        with_field("join", &format!("\"{word}\"")),
        with_field(&word, "0"),
        with_field("agents", &format!("[{{ \"color\": \"{word}\" }}]")),
    ] {
        let error = read_json(&text).unwrap_err();
        let message = format!("{error} ({})", error.place());
        assert!(message.chars().count() < 400 && !message.contains('\n'), "{message}");
    }
}

#[test]
fn nesting_costs_no_stack() {
    let deep = |open: &str, close: &str| open.repeat(1_000_000) + &close.repeat(1_000_000);
    check(&with_field("path", &deep("[", "]")), "unknown-field", "");
    check(&with_field("groups", &deep("[", "]")), "wrong-type", "groups[0]");
    check(
        &with_field("groups", &deep(r#"[{"children":"#, "}]").replace(":}", ":[]}")),
        "groups-too-deep",
        &format!("groups[0]{}", ".children[0]".repeat(8)),
    );
    check(&"[".repeat(5_000_000), "invalid-json", "line 1 column 5000000");
    check(&(deep("[", "]")), "wrong-type", "");
    check(&r#"{"a":"#.repeat(1_000_000), "invalid-json", "line 1 column 5000000");
}
