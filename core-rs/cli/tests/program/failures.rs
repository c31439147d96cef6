//! Every failure is one line with a code, the right exit code, and nothing half-written.

use crate::desk::{Desk, SHOW, jpeg, png, webp};

fn check(desk: &Desk, arguments: &[&str], code: i32, start: &str) {
    let before = desk.names();
    let outcome = desk.run(arguments);
    assert_eq!(outcome.code, code, "{arguments:?}: {}", outcome.stderr);
    assert_eq!(outcome.stdout, "", "{arguments:?}");
    assert_eq!(outcome.stderr.matches('\n').count(), 1, "one line: {}", outcome.stderr);
    assert!(outcome.stderr.starts_with(&format!("error: {start}")), "{arguments:?}: {}", outcome.stderr);
    assert_eq!(desk.names(), before, "nothing is left behind");
}

#[test]
fn usage_is_two() {
    let desk = Desk::new();
    for arguments in [
        &[][..],
        &["dance"],
        &["motion"],
        &["motion", "show.json", "--out", "motion.txt"],
        &["motion", "show.json", "--out", "motion.csv", "--json"],
        &["motion", "show.json", "--at", "now"],
        &["motion", "show.json", "--loud"],
        &["modes", "show.json"],
        &["modes", "show.json", "--keyframe", "0", "--vectors"],
        &["link", "show.json", "--base", "https://example.org/#top"],
        &["link", "show.json", "--base", "javascript:1"],
        &["link", "show.json", "--base", "example.org"],
        &["link", "show.json", "--base", "https://"],
        &["convert", "show.json", "show.xml"],
    ] {
        check(&desk, arguments, 2, "usage: ");
    }
}

#[test]
fn bad_input_is_two_and_says_where() {
    let desk = Desk::new();
    desk.put("broken.json", "{\"format\": \"eigenform\",");
    desk.put("other.json", "{\"format\": \"else\", \"version\": 1, \"keyframes\": []}");
    desk.put("newer.json", &SHOW.replace("\"version\": 1", "\"version\": 2"));
    desk.put("unknown.json", &SHOW.replace("\"frameRate\"", "\"frameRatio\""));
    desk.put("drawn.json", &SHOW.replace("\"linear\"", "\"linear\", \"path\": [[0, 0], [0, 0]]"));
    desk.put("heavy.json", &SHOW.replace("\"linear\"", "\"crowd\", \"crowd\": { \"mass\": 80 }"));
    desk.put("empty.csv", "");
    desk.put("cut.csv", "keyframe,time,agent,group,x,y\n0,0,a,,1\n");
    desk.put("crowd.txt", "# framerate: 10\n1 0 0 0\n1 1 1 1\n");
    for (arguments, start) in [
        (&["check", "broken.json"][..], "invalid-json: "),
        (&["check", "other.json"], "not-a-scene: "),
        (&["check", "newer.json"], "newer-version: "),
        (&["check", "unknown.json"], "unknown-field: "),
        (&["motion", "drawn.json"], "no-length: "),
        (&["motion", "heavy.json"], "unknown-field: "),
        (&["check", "empty.csv"], "empty: "),
        (&["check", "cut.csv"], "cut-row: "),
        (&["motion", "crowd.txt"], "recording: "),
        (&["convert", "crowd.txt", "out.json"], "recording: "),
        (&["convert", "crowd.txt", "out.json", "--frames", "0,2"], "out-of-range: 2 is out of range; it must be from 0 to 1 (--frames)"),
        (&["convert", "show.json", "out.json", "--frames", "0,1"], "not-a-recording: "),
        (&["modes", "show.json", "--keyframe", "2"], "out-of-range: 2 is out of range; it must be from 0 to 1 (--keyframe)"),
        (&["modes", "show.json", "--keyframe", "-1"], "out-of-range: -1 is out of range; it must be from 0 to 1 (--keyframe)"),
        (&["assign", "show.json", "--from", "0", "--to", "7"], "out-of-range: "),
        (&["assign", "show.json", "--from", "-2", "--to", "1"], "out-of-range: -2 is out of range; it must be from 0 to 1 (--from)"),
        (&["spread", "show.json", "--segment", "-1"], "out-of-range: -1 is out of range; it must be from 0 to 0 (--segment)"),
        (&["groups", "show.json", "--keyframe", "2"], "out-of-range: "),
        (&["groups", "show.json", "--keyframe", "0", "--metric", "chess"], "unknown-value: "),
        (&["motion", "show.json", "--at", "NaN"], "not-finite: "),
        (&["check", "show.json", "--minimum-distance", "-1"], "out-of-range: "),
        (&["check", "show.json", "--method", "fast"], "unknown-value: "),
        (&["compare", "show.json", "--methods", "linear,best"], "unknown-value: \"best\" is not known here; it must be one of \"auto\""),
        (&["compare", "show.json", "--costs", "least"], "unknown-value: \"least\" is not known here; it must be one of \"squared\""),
        (&["compare", "show.json", "--free-arrival=0"], "out-of-range: 0 is out of range; it must be from 0.01 to 1000"),
        (&["check", "show.json", "--join", "sideways"], "unknown-value: \"sideways\" is not known here; it must be one of \"separate\""),
        (&["check", "show.json", "--avoidance=yes"], "unknown-value: "),
        (&["check", "show.json", "--avoidance", "maybe"], "unknown-value: \"maybe\" is not known here; it must be one of \"true\""),
        (&["check", "--avoidance", "maybe", "show.json"], "unknown-value: \"maybe\" is not known here; it must be one of \"true\""),
        (&["open", "https://example.org/"], "not-a-link: "),
        (&["open", "show.json"], "not-a-link: "),
        (&["open", "#s=1.AAAA"], "link-"),
        (&["check", "#s=9.AAAA"], "newer-version: "),
    ] {
        check(&desk, arguments, 2, start);
    }
}

#[test]
fn a_number_that_is_none_or_missing_is_named_with_its_option() {
    let desk = Desk::new();
    for (arguments, said) in [
        (&["motion", "show.json", "--at", "1,foo"][..], "\"foo\" is no number; give one such as 2.5 (--at)"),
        (&["motion", "show.json", "--at", "0,,1"], "\"\" is no number; give one such as 2.5 (--at)"),
        (&["check", "show.json", "--minimum-distance", "wide"], "\"wide\" is no number; give one such as 2.5 (--minimum-distance)"),
        (&["modes", "show.json", "--keyframe", "first"], "\"first\" is no whole number; give one such as 2 (--keyframe)"),
        (&["shape", "GO", "--agents", "1000000000000000000000"], "\"1000000000000000000000\" is far out of range (--agents)"),
        (&["shape", "GO"], "--agents <N> is missing (the verb's --help has an example)"),
        (&["assign", "show.json"], "--from <K> and --to <K> are missing (the verb's --help has an example)"),
        (&["shape", "GO", "--agents", "2.5"], "\"2.5\" is no whole number; give one such as 2 (--agents)"),
        (&["convert", "show.json", "out.json", "--frames", "0,x"], "\"x\" is no whole number; give one such as 2 (--frames)"),
    ] {
        check(&desk, arguments, 2, &format!("usage: {said}\n"));
    }
}

#[test]
fn a_recording_in_place_of_a_scene_is_told_the_command_that_makes_one_of_it() {
    let desk = Desk::new();
    let rows = (0..=120).map(|frame| format!("1 {frame} {frame} 0\n")).collect::<Vec<_>>().concat();
    desk.put("crowd.txt", &format!("# framerate: 10\n{rows}"));
    let said = desk.run(&["check", "crowd.txt"]).stderr;
    let typed = "convert RECORDING show.eigenform.json --frames 0,120";
    assert!(said.contains(&format!("eigenform {typed} ")), "{said}");
    let outcome = desk.run(&typed.replace("RECORDING", "crowd.txt").split(' ').collect::<Vec<_>>());
    assert_eq!(outcome.code, 0, "what was told works: {}", outcome.stderr);
}

#[test]
fn a_shape_that_is_none_says_why() {
    let desk = Desk::new();
    let blank = png(9, 9, |_, _| [255; 4]);
    desk.put_bytes("blank.png", &blank);
    desk.put_bytes("pale.png", &png(9, 9, |x, _| if x < 4 { [204, 204, 204, 255] } else { [255; 4] }));
    desk.put_bytes("cut.png", &blank[..blank.len() / 2]);
    desk.put_bytes("cut.jpg", &jpeg()[..40]);
    desk.put_bytes("cut.webp", &webp()[..20]);
    desk.put_bytes("clear.png", &png(9, 9, |_, _| [0; 4]));
    desk.put_bytes("dot.png", &png(1, 1, |_, _| [0, 0, 0, 255]));
    // The header of a PNG of 60,000 × 60,000 pixels, whose checksum fits.
    let mut huge = blank.clone();
    huge[16..24].copy_from_slice(&[0, 0, 0xEA, 0x60, 0, 0, 0xEA, 0x60]);
    huge[29..33].copy_from_slice(&0x80D2_7542_u32.to_be_bytes());
    desk.put_bytes("huge.png", &huge);
    let svg = |inside: &str| format!("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 8 8\">{inside}</svg>");
    desk.put("script.svg", &svg("<script>alert(1)</script>"));
    desk.put("handler.svg", &svg("<path onload=\"alert(1)\" d=\"M 0 0 L 4 0 L 2 3 Z\"/>"));
    desk.put("link.svg", &svg("<use href=\"https://example.org/#a\"/>"));
    desk.put("style.svg", &svg("<style>path { fill: url(https://example.org/a) }</style>"));
    desk.put("cut.svg", &svg("<path")[..60]);
    let triangle = "M 0 0 L 4 0 L 2 3 Z";
    for (input, rest, start) in [
        ("blank.png", &[][..], "blank-picture: there is no shape in this picture: all of it is alike"),
        ("blank.png", &["--invert"], "blank-picture: there is no shape in this picture: all of it is alike"),
        (
            "pale.png",
            &[],
            "blank-picture: there is no shape in this picture: nothing of it is taken for the shape; raise the threshold, to 0.9 ",
        ),
        ("clear.png", &[], "blank-picture: there is no shape in this picture: all of it is transparent"),
        ("cut.png", &[], "broken-picture: the picture cannot be decoded; it may be cut short or damaged (cut.png)\n"),
        ("cut.jpg", &[], "broken-picture: the picture cannot be decoded; it may be cut short or damaged (cut.jpg)\n"),
        ("cut.webp", &[], "broken-picture: the picture cannot be decoded; it may be cut short or damaged (cut.webp)\n"),
        ("dot.png", &[], "picture-size: 1 × 1 pixels"),
        ("huge.png", &[], "picture-size: 60000 × 60000 pixels"),
        ("script.svg", &[], "active-svg: this SVG has a script in it"),
        ("handler.svg", &[], "active-svg: this SVG has a script in it"),
        ("link.svg", &[], "active-svg: this SVG links to something outside"),
        ("style.svg", &[], "active-svg: this SVG links to something outside"),
        ("cut.svg", &[], "broken-picture: the SVG cannot be read; it may be cut short"),
        ("show.json", &[], "broken-picture: this is no PNG, JPEG, WebP or SVG"),
        ("M 0 0 L 4 0", &[], "broken-picture: this path has no inside"),
        ("M 0 0", &[], "broken-picture: this path has no inside"),
        ("M 0 0 L 4 4", &[], "broken-picture: this path has no inside"),
        (" ", &[], "no-text: nothing of this text can be seen"),
        ("Go", &["--font", "No Such Font"], "no-font: "),
        (triangle, &["--threshold", "2"], "out-of-range: 2 is out of range; it must be from 0.01 to 0.99 (--threshold)"),
        (triangle, &["--width", "0"], "out-of-range: "),
        (triangle, &["--width", "5", "--minimum-distance", "2"], "too-crowded: 60 agents do not fit 2 m apart, "),
    ] {
        check(&desk, &[&["shape", input, "--agents", "60"], rest].concat(), 2, start);
    }
    for count in ["0", "5001", "-3"] {
        check(
            &desk,
            &["shape", triangle, "--agents", count],
            2,
            &format!("out-of-range: {count} is out of range; it must be from 1 to 5000"),
        );
    }
    check(&desk, &["shape", triangle, "--agents", "many"], 2, "usage: ");
    check(
        &desk,
        &["shape", triangle, "--agents", "9", "--seed", "-1"],
        2,
        "out-of-range: -1 is out of range; it must be from 0 to 4294967295",
    );
    check(&desk, &["shape", "absent.png", "--agents", "60"], 1, "cannot-read: ");
}

#[test]
fn an_assignment_that_cannot_be_says_why() {
    let desk = Desk::new();
    let between = ["assign", "show.json", "--from", "0", "--to", "1"];
    for (more, start) in [
        (&["--cost", "neighbors"][..], "unknown-value: "),
        (&["--lambda", "1.5"], "out-of-range: "),
        (&["--lock", "0-1"], "usage: "),
        (&["--lock", "-1:0"], "usage: \"-1:0\" is no lock; "),
        (&["--lock", "0:4"], "unknown-slot: there is no slot 4; slots are 0 to 3 (--lock 0:4)"),
        (&["--lock", "4:0"], "unknown-agent: there is no agent 4; agents are 0 to 3 (--lock 4:0)"),
        (&["--lock", "0:1", "--lock", "0:2"], "contradictory-locks: agent 0 is locked to slots 1 and 2"),
        (&["--lock", "0:1", "--lock", "0:1"], "contradictory-locks: agent 0 is locked to slot 1 twice; once is enough (--lock 0:1)"),
        (&["--lock", "0:1", "--lock", "3:1"], "contradictory-locks: slot 1 is locked for agents 0 and 3"),
        (&["--predict"], "nothing-to-predict-from: "),
    ] {
        check(&desk, &[&between[..], more].concat(), 2, start);
    }
}

#[test]
fn a_link_cut_anywhere_says_so() {
    let desk = Desk::new();
    let link = desk.answer(&["link", "keyframes.csv"]);
    let link = link.trim();
    for length in [1, 3, 4, 5, 6, 12, link.len() - 1] {
        check(&desk, &["open", &link[..length]], 2, "link-cut: ");
    }
}

#[test]
fn files_that_cannot_be_read_or_written_are_one() {
    let desk = Desk::new();
    std::fs::create_dir(desk.path("folder.csv")).expect("a folder");
    std::fs::create_dir(desk.path("folder.json")).expect("a folder");
    for (arguments, said) in [
        (&["check", "absent.json"][..], "there is no such file (absent.json)"),
        (&["motion", "folder.json"], "this is a folder, not a file (folder.json)"),
        (&["convert", "absent.csv", "scene.json"], "there is no such file (absent.csv)"),
    ] {
        check(&desk, arguments, 1, &format!("cannot-read: {said}\n"));
    }
    for arguments in [
        &["motion", "show.json", "--out", "absent/motion.csv"][..],
        &["motion", "show.json", "--out", "folder.csv"],
        &["convert", "show.json", "folder.csv"],
    ] {
        check(&desk, arguments, 1, "cannot-write: ");
    }
    check(
        &desk,
        &["motion", "show.json", "--out", "absent/motion.csv"],
        1,
        "cannot-write: there is no folder absent (absent/motion.csv)\n",
    );
    let through_a_file = "cannot-write: there is no folder show.json (show.json/motion.csv)\n";
    check(&desk, &["motion", "show.json", "--out", "show.json/motion.csv"], 1, through_a_file);
}

#[test]
fn a_failure_leaves_the_file_that_was_there() {
    let desk = Desk::new();
    desk.put("motion.csv", "precious");
    check(&desk, &["motion", "show.json", "--method", "fast", "--out", "motion.csv"], 2, "unknown-value: ");
    assert_eq!(desk.read("motion.csv"), "precious");
}

#[test]
fn a_file_of_something_else_is_told_what_opens() {
    let desk = Desk::new();
    desk.put("letter.txt", "Dear Ada,\nwe meet at nine.\n");
    desk.put("page.html", "<!doctype html>\n<title>Time</title>\n");
    for name in ["letter.txt", "page.html"] {
        check(&desk, &["check", name], 2, "not-a-scene: this is no scene; what opens is a scene file (JSON), a keyframe CSV (");
    }
}

#[test]
fn text_that_is_none_is_refused() {
    let desk = Desk::new();
    std::fs::write(desk.path("picture.png"), [0x89, b'P', b'N', b'G', 0xFF, 0x00]).expect("a file on the desk");
    check(&desk, &["check", "picture.png"], 2, "not-text: ");
}

#[cfg(unix)]
#[test]
fn a_written_file_is_as_readable_as_any_other() {
    use std::os::unix::fs::PermissionsExt as _;
    let desk = Desk::new();
    desk.answer(&["motion", "show.json", "--out", "motion.csv"]);
    let mode = |name: &str| std::fs::metadata(desk.path(name)).expect("a file").permissions().mode();
    assert_eq!(mode("motion.csv"), mode("show.json"));
}
