//! Recordings as other programs write them.

use std::time::{Duration, Instant};

use eigenform::choice::MethodName;
use eigenform::error::{Error, RecordingError};
use eigenform::perform::perform;
use eigenform::scene::recording::{Recording, is_recording, read_recording};
use eigenform::scene::{Segment, limits, open, read_json, validate};
use glam::DVec2;
use proptest::prelude::*;
use proptest::strategy::ValueTree;
use proptest::test_runner::{Config, RngAlgorithm, TestRng, TestRunner};

/// Agent 7 is there all the time, 3 enters at frame 1, 12 leaves after it.
const CROWD: &str = "\
# description: a corridor
# framerate: 25.00 fps
# id\tframe\tx/m\ty/m\tz/m
7\t0\t0.5\t1.0\t0
12\t0\t2.0\t1.0\t0
7\t1\t0.75\t1.0\t0
12\t1\t2.25\t1.0\t0
3\t1\t-1.0\t0.5\t0
7\t2\t1.0\t1.0\t0
3\t2\t-0.5\t0.5\t0
";

const TRIO: &str = "frame,time,agent,x,y,z\n0,0,a,0,1,0\n0,0,b,2,3,0\n1,0.5,a,4,5,0\n1,0.5,b,6,7,0\n";

fn read(text: &str) -> Recording {
    read_recording(text).unwrap_or_else(|error| panic!("{error} ({}): {text}", error.place()))
}

fn check(text: &str, code: &str, place: &str) {
    let error = read_recording(text).expect_err(text);
    assert_eq!((error.code(), error.place().as_str()), (code, place), "{text}: {error}");
    assert!(!error.to_string().contains('\n'));
}

#[test]
fn a_crowd_is_read_with_those_who_enter_and_leave() {
    let crowd = read(CROWD);
    assert_eq!((crowd.frame_rate, crowd.frame_count), (25.0, 3));
    assert_eq!(crowd.agents, ["7", "12", "3"]);
    let places: Vec<Option<DVec2>> =
        (0..3).flat_map(|frame| (0..3).map(move |agent| (frame, agent))).map(|(f, a)| crowd.position(f, a)).collect();
    let at = |x, y| Some(DVec2::new(x, y));
    let expected = [at(0.5, 1.0), at(2.0, 1.0), None, at(0.75, 1.0), at(2.25, 1.0), at(-1.0, 0.5), at(1.0, 1.0), None, at(-0.5, 0.5)];
    assert_eq!(places, expected);
    assert_eq!(crowd.notes, ["Not everybody is there all the time."]);
    assert_eq!((crowd.agents_at(&[0, 1]), crowd.agents_at(&[0, 2])), (vec![0, 1], vec![0]));
}

#[test]
fn spelling_does_not_matter() {
    let crowd = read(CROWD);
    let centimeters = "\
# framerate: 25.00 fps
# id frame x/cm y/cm z/cm
7 0 50 100 0
12 0 200 100 0
7 1 75 100 0
12 1 225 100 0
3 1 -100 50 0
7 2 100 100 0
3 2 -50 50 0
";
    for (what, text) in [
        ("a byte order mark", format!("\u{feff}{CROWD}")),
        ("carriage returns", CROWD.replace('\n', "\r\n")),
        ("spaces", CROWD.replace('\t', "   ")),
        ("empty lines", CROWD.replace('\n', "\n\n")),
        ("no space after the mark", CROWD.replace("# ", "#")),
        ("no mark before the columns", CROWD.replace("# id", "id")),
        ("no columns", CROWD.replace("# id\tframe\tx/m\ty/m\tz/m\n", "")),
        ("no unit of the frame rate", CROWD.replace("25.00 fps", "25")),
        ("an older head", CROWD.replace("id\tframe\tx/m\ty/m\tz/m", "ID\tFR\tX\tY\tZ")),
        ("no heights", CROWD.replace("\tz/m", "").replace("\t0\n", "\n")),
        ("centimeters", centimeters.to_owned()),
        ("every tenth frame", CROWD.replace("25.00", "250").replace("\t1\t", "\t10\t").replace("\t2\t", "\t20\t")),
    ] {
        let other = read(&text);
        assert_eq!((other.frame_rate, &other.agents, &other.notes), (crowd.frame_rate, &crowd.agents, &crowd.notes), "{what}");
        for (frame, agent) in (0..3).flat_map(|frame| (0..3).map(move |agent| (frame, agent))) {
            assert_eq!(other.position(frame, agent), crowd.position(frame, agent), "{what}");
        }
    }
}

#[test]
fn frames_go_by_their_numbers() {
    let later = read(&CROWD.replace("\t0\t", "\t100\t").replace("\t1\t", "\t104\t").replace("\t2\t", "\t108\t"));
    assert_eq!(later.numbers(), (100, 108));
    let frames: Vec<_> = [96, 100, 102, 104, 108, 112, i64::MIN].into_iter().map(|number| later.frame_numbered(number)).collect();
    assert_eq!(frames, [None, Some(0), None, Some(1), Some(2), None, None]);
}

#[test]
fn heights_of_heads_are_left_out_and_said() {
    let walking = read(&CROWD.replace("\t0\n", "\t1.75\n"));
    assert!(!walking.is_spatial());
    assert!(walking.notes[0].starts_with("Heights are left out"), "{:?}", walking.notes);
}

#[test]
fn a_motion_csv_of_this_program_comes_back_as_its_motion() {
    let show = r#"{ "format": "eigenform", "version": 1, "frameRate": 24, "agents": [{ "name": "Ada, B." }, { "name": "Ben" }, { "name": "Cy" }],
        "keyframes": [{ "positions": [[0, 0], [1, 0], [0, 1]], "hold": 0.3 }, { "time": 2.5, "positions": [[3, 3], [7, 1], [5, 2]] }] }"#;
    let mut scene = read_json(show).unwrap();
    let Segment::Transition(transition) = &mut scene.tracks[0].segments[0];
    transition.method = MethodName::Linear;
    let performance = perform(&scene).unwrap();
    let recording = read(&performance.to_csv());
    assert_eq!((recording.frame_rate, recording.frame_count), (24.0, scene.frame_count()));
    assert_eq!((&*recording.agents, recording.notes.len()), (&["Ada, B.", "Ben", "Cy"].map(str::to_owned)[..], 0));
    for (frame, time) in performance.frame_times().enumerate() {
        let places = (0..3).map(|agent| recording.position(frame, agent).unwrap());
        // The file's shortest digits read back as the same doubles.
        assert_eq!(places.collect::<Vec<_>>(), performance.positions_at(time)[..3].to_vec(), "frame {frame}");
    }
}

#[test]
fn frames_become_keyframes_of_those_who_are_there() {
    let made = read(CROWD).scene(&[1, 0]).unwrap();
    let track = made.scene.main_track();
    assert_eq!(track.keyframes.iter().map(|keyframe| keyframe.time).collect::<Vec<_>>(), [0.0, 0.04]);
    assert_eq!(track.keyframes[1].positions.positions(), [DVec2::new(0.75, 1.0), DVec2::new(2.25, 1.0)]);
    assert!(track.agents.iter().all(|agent| agent.name.is_empty()));
    assert_eq!((track.agents.len(), track.segments.len(), made.scene.frame_rate), (2, 1, 25.0));
    assert_eq!(made.notes[1], "1 of 3 agents are not there at all of these frames and are left out.");
    let named = read(TRIO).scene(&[0, 1]).unwrap().scene;
    assert_eq!(named.main_track().agents.iter().map(|agent| agent.name.as_str()).collect::<Vec<_>>(), ["a", "b"]);
    let apart = "# framerate: 10\n1 0 0 0\n1 1 0 0\n2 2 5 5\n";
    assert_eq!(read(apart).scene(&[0, 2]), Err(RecordingError::NobodyThere.into()));
}

#[test]
fn every_refusal_names_its_row() {
    let row = |row: &str| format!("{CROWD}{row}\n");
    check("", "empty", "");
    for text in ["Dear Ada,\n", "{ \"format\": \"eigenform\" }", "keyframe,time,agent,x,y\n0,0,a,1,2\n"] {
        check(text, "not-a-recording", "");
    }
    check(&CROWD.replace("framerate", "speed"), "no-frame-rate", "");
    check(&CROWD.replace("25.00 fps", "fast"), "not-a-number", "row 2, column framerate");
    check(&CROWD.replace("25.00 fps", "0 fps"), "out-of-range", "row 2, framerate");
    check("# framerate: 25\n", "one-frame", "");
    check("# framerate: 25\n1 0 0 0\n2 0 1 1\n", "one-frame", "");
    check(&row("7\t3\t1.2"), "cut-row", "row 11");
    check("# framerate: 25\n1 0 0\n", "cut-row", "row 2");
    check(&row("7\t3\there\t1.0\t0"), "not-a-number", "row 11, column x");
    check(&row("7\t3.5\t1.0\t1.0\t0"), "not-a-number", "row 11, column frame");
    check(&row("7\t3\t1.0\tNaN\t0"), "not-finite", "row 11, column y");
    check(&row("7\t3\t1e300\t0\t0"), "out-of-range", "row 11, column x");
    check(&row("7\t1e300\t0\t0\t0"), "out-of-range", "row 11, column frame");
    check(&row("7\t2\t1.0\t1.0\t0"), "repeated-sample", "row 11");
    check(&row("12\t3\t1.0\t1.0\t0"), "gap", "row 11");
    check(&row(&format!("{}\t3\t1.0\t1.0\t0", "n".repeat(65))), "too-long", "row 11, the agent");
    check(&row(&" ".repeat(10_001)), "too-long", "row 11");
    let gap = read_recording(&row("12\t3\t1.0\t1.0\t0")).unwrap_err().to_string();
    assert_eq!(gap, "agent 12 is there until frame 1 and again from frame 3; an agent enters once and leaves once");
    let csv = |row: &str| format!("{TRIO}{row}\n");
    check("frame,time,agent,x,y\n", "one-frame", "");
    check(&TRIO.replace("time", "when"), "unknown-column", "row 1");
    check(&TRIO.replace(",time", ""), "missing-column", "row 1");
    check(&csv("2,1,a,0"), "cut-row", "row 6");
    check(&csv("2,1,a,0,inf,0"), "not-finite", "row 6, column y");
    check(&csv("2,1,a,0,200000,0"), "out-of-range", "row 6, column y");
    check(&csv("2,1,a,0,0,0\n3,9,a,0,0,0"), "uneven-frames", "row 4");
    check(&csv("1,0.5,a,0,0,0"), "repeated-sample", "row 6");
    check(&TRIO.replace("0.5", "0"), "not-finite", "column time, from row 2 to row 4");
    check(&csv("3,1.5,a,0,0,0"), "gap", "row 6");
}

#[test]
fn limits_hold_before_there_is_room_for_more() {
    let crowd = |count: usize| -> String {
        let rows = (0..count).map(|agent| format!("{agent} {} 0 0\n", usize::from(agent == 0)));
        std::iter::once("# framerate: 1\n".to_owned()).chain(rows).collect()
    };
    assert_eq!(read(&crowd(limits::AGENTS)).agents.len(), limits::AGENTS);
    check(&crowd(limits::AGENTS + 1), "too-many-agents", "row 5002");
    // Two agents for ten million frames are the most there is room for.
    let long = |last: usize| format!("# framerate: 1\n1 0 0 0\n1 1 0 0\n2 {last} 0 0\n");
    assert_eq!(read(&long(9_999_999)).frame_count, 10_000_000);
    check(&long(10_000_000), "too-many-samples", "");
    let large = " ".repeat(limits::FILE_BYTES + 1);
    assert!(matches!(read_recording(&large), Err(Error::FileTooLarge { .. })));
}

#[test]
fn where_a_scene_is_wanted_a_recording_says_what_it_is() {
    for text in [CROWD, TRIO, "1 0 0.5 0.5\n1 1 0.5 0.5\n"] {
        assert!(is_recording(text), "{text}");
        assert_eq!(open(text), Err(Error::IsRecording), "{text}");
    }
    for text in ["keyframe,time,agent,x,y\n0,0,0,0,0\n", "#s=1.AAAA", "{ \"format\": \"eigenform\" }", "", "a frame\nagent"] {
        assert!(!is_recording(text), "{text}");
    }
    let endless = "1".repeat(limits::FILE_BYTES);
    let start = Instant::now();
    assert!(!is_recording(&endless));
    assert!(start.elapsed() < Duration::from_secs(1));
}

/// Changes a file at up to four places.
fn mutated(file: &[u8], runner: &mut TestRunner) -> String {
    const SNIPPETS: [&str; 12] = ["", "-", "1e999", "NaN", "\n", "#", ",", "\t", "frame", "99999999999", "0.5", "\u{feff}"];
    let mut draw = |bound: usize| (0..bound.max(1)).new_tree(runner).expect("a range has values").current();
    let mut file = file.to_vec();
    for _ in 0..=draw(4) {
        let at = draw(file.len() + 1);
        let end = (at + draw(12)).min(file.len());
        match draw(4) {
            0 => drop(file.drain(at..end)),
            1 => {
                let again = file[at..end].to_vec();
                file.splice(at..at, again);
            }
            2 if draw(4) == 0 => file.truncate(at),
            _ => drop(file.splice(at..end, SNIPPETS[draw(SNIPPETS.len())].bytes())),
        }
    }
    String::from_utf8_lossy(&file).into_owned()
}

#[test]
fn a_damaged_recording_is_refused_or_sound() {
    let mut runner = TestRunner::new_with_rng(Config::default(), TestRng::from_seed(RngAlgorithm::ChaCha, &[7; 32]));
    let mut refused = 0;
    for file in [CROWD, TRIO].iter().cycle().take(10_000) {
        let text = mutated(file.as_bytes(), &mut runner);
        match read_recording(&text) {
            Ok(recording) => {
                assert!(recording.frame_count >= 2 && recording.frame_rate > 0.0, "{text}");
                match recording.scene(&[0, recording.frame_count - 1]) {
                    Ok(made) => assert_eq!(validate(&made.scene), Ok(()), "{text}"),
                    Err(error) => assert!(!error.code().is_empty(), "{text}"),
                }
            }
            Err(error) => {
                refused += 1;
                assert!(!error.code().is_empty() && !error.to_string().is_empty());
            }
        }
    }
    assert!(refused > 3_000, "{refused}");
}
