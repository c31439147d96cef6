//! What goes in and out: link, open, convert, check, help.

use serde_json::json;

use crate::desk::Desk;
use crate::parsed;

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
        let notes: Vec<&str> = outcome.stderr.lines().filter(|note| !note.contains("so nothing moves")).collect();
        assert_eq!(notes.len(), 3, "{notes:?}");
        assert!(
            notes[0].starts_with("note: a stage of 4 × 2 m holds at most 2 agents 5 m apart, and the scene has 4; 2.00 m fits"),
            "{notes:?}"
        );
        assert!(notes[1].starts_with("note: agents 0 and 1 stand 1.414 m apart, the nearest of 6 pairs, "), "{notes:?}");
        assert!(notes[2].starts_with("note: agent 0 stands within obstacle 0; "), "{notes:?}");
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
    let unordered = desk.run(&["convert", "crowd.txt", "-", "--frames", "7,5,7"]);
    assert!(unordered.stderr.contains("Frames are taken as they follow each other, each once: 5, 7."), "{}", unordered.stderr);
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
