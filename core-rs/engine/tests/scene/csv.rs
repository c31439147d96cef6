//! Keyframe CSV as people and other programs write it.

use crate::scenes::arbitrary_scene;
use eigenform::error::Error;
use eigenform::scene::{self, Group, Keyframe, Scene, limits, read_csv, write_csv};
use glam::DVec2;
use proptest::prelude::*;

const TWO_BY_TWO: &str = "keyframe,time,agent,group,x,y\n0,0,a,Band,0,1\n0,0,b,,2,3\n1,2.5,a,Band,4,5\n1,2.5,b,,6,7\n";

fn read(text: &str) -> Scene {
    let scene = read_csv(text).unwrap().scene;
    assert_eq!(scene::validate(&scene), Ok(()));
    scene
}

/// The code and place of the refusal.
fn check(text: &str, code: &str, place: &str, what: &str) {
    let error = read_csv(text).expect_err(text);
    assert_eq!((error.code(), error.place().as_str(), error.to_string().as_str()), (code, place, what), "{text}");
}

#[test]
fn agents_and_keyframes_come_in_order_of_first_appearance() {
    let scene = read(TWO_BY_TWO);
    let track = scene.main_track();
    assert_eq!(track.agents.iter().map(|agent| agent.name.as_str()).collect::<Vec<_>>(), ["a", "b"]);
    assert_eq!(track.keyframes.iter().map(|keyframe| keyframe.time).collect::<Vec<_>>(), [0.0, 2.5]);
    assert_eq!(track.keyframes[1].positions.positions(), [DVec2::new(4.0, 5.0), DVec2::new(6.0, 7.0)]);
    assert_eq!((scene.groups.len(), &*scene.groups[0].name, &*scene.groups[0].members), (1, "Band", &[0][..]));
}

#[test]
fn spelling_does_not_matter() {
    let plain = read(TWO_BY_TWO);
    let cases = [
        ("a byte order mark", format!("\u{feff}{TWO_BY_TWO}")),
        ("carriage returns", TWO_BY_TWO.replace('\n', "\r\n")),
        ("carriage returns alone", TWO_BY_TWO.replace('\n', "\r")),
        ("no last line end", TWO_BY_TWO.trim_end().to_owned()),
        ("empty lines", TWO_BY_TWO.replace('\n', "\n\n")),
        ("empty rows of a spreadsheet", format!("{TWO_BY_TWO},,,,,\n \n")),
        ("quotes", TWO_BY_TWO.replace("Band", "\"Band\"").replace("2.5", "\"2.50\"")),
        ("white space", TWO_BY_TWO.replace(',', " , ")),
        ("capitals", TWO_BY_TWO.replace("keyframe,time,agent,group,x,y", "Keyframe,TIME,Agent,Group,X,Y")),
        (
            "another order of columns",
            "y,x,group,agent,time,keyframe\n1,0,Band,a,0,0\n3,2,,b,0,0\n5,4,Band,a,2.5,1\n7,6,,b,2.5,1\n".to_owned(),
        ),
        ("a height of zero", TWO_BY_TWO.replace('\n', ",0\n").replace(",y,0\n", ",y,z\n")),
    ];
    for (what, text) in cases {
        assert_eq!(read(&text), plain, "{what}");
    }
}

#[test]
fn ids_that_are_all_numbers_are_no_names() {
    let scene = read(&TWO_BY_TWO.replace(",a,", ",7,").replace(",b,", ",12,"));
    assert!(scene.main_track().agents.iter().all(|agent| agent.name.is_empty()));
    assert!(scene.main_track().keyframes.iter().all(|keyframe| keyframe.name.is_empty()));
}

#[test]
fn names_and_colors_have_columns_and_words_name_keyframes() {
    let scene = read("keyframe,time,agent,x,y,name,color\nline,0,1,0,0,Ada,#ff0000\nring,1,1,2,2,Ada,#ff0000\n");
    let track = scene.main_track();
    assert_eq!((track.agents[0].name.as_str(), track.agents[0].color.as_str()), ("Ada", "#ff0000"));
    assert_eq!(track.keyframes.iter().map(|keyframe| keyframe.name.as_str()).collect::<Vec<_>>(), ["line", "ring"]);
}

#[test]
fn an_agent_that_changes_its_group_keeps_the_first_and_it_is_said() {
    let changed = read_csv(&TWO_BY_TWO.replace("1,2.5,a,Band", "1,2.5,a,Drums")).unwrap();
    assert_eq!(changed.scene, read(TWO_BY_TWO));
    assert_eq!(changed.notes, ["1 of the agents change their group between keyframes; each keeps its first."]);
    assert!(read_csv(TWO_BY_TWO).unwrap().notes.is_empty());
}

#[test]
fn the_stage_fits_what_stands_on_it() {
    let cases = [("0", "0", 10.0, 10.0), ("-30", "11", 70.0, 25.0), ("100000", "-100000", 2e5, 2e5)];
    for (x, y, width, depth) in cases {
        let scene = read(&format!("keyframe,time,agent,x,y\n0,0,0,{x},{y}\n"));
        assert_eq!((scene.stage.width, scene.stage.depth), (width, depth));
    }
}

#[test]
fn a_show_too_long_for_its_frames_gets_fewer_frames() {
    let rows = |keyframe: usize, time: usize| (0..5_000).map(move |agent| format!("{keyframe},{time},{agent},{agent},0\n"));
    let text: String = std::iter::once("keyframe,time,agent,x,y\n".to_owned()).chain(rows(0, 0)).chain(rows(1, 3_600)).collect();
    let read = read_csv(&text).unwrap();
    assert_eq!(read.scene.frame_rate.to_bits(), 1.0_f64.to_bits());
    assert_eq!(read.notes.len(), 1);
}

#[test]
fn every_refusal_names_its_row() {
    let row = |row: &str| format!("{TWO_BY_TWO}{row}\n");
    check("", "empty", "", "there is nothing to read; give a scene file, a keyframe CSV, a recording or a link");
    check("keyframe,time,agent,group,x,y\n", "no-keyframes", "keyframes", "there is no keyframe; a scene has at least one");
    let missing = "there is no column \"y\"; the first row names the columns, such as keyframe,time,agent,group,x,y";
    check("keyframe,time,agent,group,x\n", "missing-column", "row 1", missing);
    let unknown = "\"speed\" is no column here; the columns are \
                   \"keyframe\", \"time\", \"agent\", \"group\", \"x\", \"y\", \"z\", \"name\", \"color\"";
    check("keyframe,time,agent,group,x,y,speed\n", "unknown-column", "row 1", unknown);
    check("x,time,agent,group,x,y\n", "repeated-column", "row 1", "there are two columns \"x\"; each occurs once");
    check(&row("\n\n1,2.5,a"), "cut-row", "row 8", "row 8 has 3 fields; like the first row it must have 6");
    check(&row("1,2.5,a").replace('\n', "\r\n"), "cut-row", "row 6", "row 6 has 3 fields; like the first row it must have 6");
    check(&row("1,2.5,a"), "cut-row", "row 6", "row 6 has 3 fields; like the first row it must have 6");
    let twice = "row 6 gives agent a twice in keyframe 1; each agent has one row a keyframe";
    check(&row("1,2.5,a,,0,0"), "repeated-row", "row 6", twice);
    check(&row("2,3,a,,0,0"), "missing-row", "keyframe 2", "keyframe 2 has no row of agent b; every agent stands in every keyframe");
    check(&row("0,0,c,,0,0"), "missing-row", "keyframe 1", "keyframe 1 has no row of agent c; every agent stands in every keyframe");
    let number = "row 6 gives \"here\" for x; it must be a number, such as 2.5";
    check(&row("2,3,a,,here,0"), "not-a-number", "row 6, column x", number);
    check(&row("2,3,a,,0,"), "not-a-number", "row 6, column y", "row 6 gives \"\" for y; it must be a number, such as 2.5");
    check(&row("2,3,a,,inf,0"), "not-finite", "row 6, column x", "this is not a finite number");
    check(&row("2,3,a,,0,NaN"), "not-finite", "row 6, column y", "this is not a finite number");
    let range = "100001 is out of range; it must be from -100000 to 100000";
    check(&row("2,3,a,,100001,0"), "out-of-range", "row 6, column x", range);
    let rise = "2.5 s is not after 2.5 s, when the keyframe before ends (its time and hold); times must rise";
    check(&row("2,2.5,a,,0,0"), "times-do-not-rise", "row 6, column time", rise);
    check(&row("1,3,c,,0,0"), "times-differ", "row 6", "row 6 puts keyframe 1 at 3 s; the rows before put it at 2.5 s");
    check(&row("2,-1,a,,0,0"), "out-of-range", "row 6, column time", "-1 is out of range; it must be from 0 to 3600");
    check(&row(&format!("2,3,{},,0,0", "n".repeat(65))), "too-long", "row 6, column agent", "65 characters; at most 64");
    let color = "red is no color; it must be #rrggbb or empty";
    check("keyframe,time,agent,x,y,color\n0,0,0,0,0,red\n", "invalid-color", "row 2, column color", color);
    let heights = "100001 is out of range; it must be from -100000 to 100000";
    check("keyframe,time,agent,x,y,z\n0,0,0,0,0,100001\n", "out-of-range", "row 2, column z", heights);
    let mixed = "this position has 2 numbers where others have 3; all positions of a scene have two, or all have three";
    check("keyframe,time,agent,x,y,z\n0,0,a,0,0,2\n0,0,b,0,0,\n", "mixed-dimensions", "row 3, column z", mixed);
    check("keyframe,time,agent,x,y,z\n0,0,a,0,0,\n0,0,b,0,0,2\n", "mixed-dimensions", "row 2, column z", mixed);
    let deep = "groups are nested more than 8 deep";
    check("keyframe,time,agent,x,y,group\n0,0,0,0,0,a/b/c/d/e/f/g/h/i\n", "groups-too-deep", "group a/b/c/d/e/f/g/h/i", deep);
}

/// A file of `agents` agents at `keyframes` keyframes.
fn file(agents: usize, keyframes: usize) -> String {
    let rows = (0..keyframes).flat_map(|keyframe| (0..agents).map(move |agent| format!("{keyframe},{keyframe},{agent},0,0\n")));
    std::iter::once("keyframe,time,agent,x,y\n".to_owned()).chain(rows).collect()
}

#[test]
fn limits_hold_at_the_row_that_breaks_them() {
    for (agents, keyframes) in [(4_999, 1), (5_000, 1), (1, 199), (1, 200), (1_000, 200)] {
        assert_eq!(read_csv(&file(agents, keyframes)).map(|_| ()), Ok(()), "{agents} × {keyframes}");
    }
    let cases = [(5_001, 1, "too-many-agents"), (1, 201, "too-many-keyframes"), (1_001, 200, "too-many-positions")];
    for (agents, keyframes, code) in cases {
        let error = read_csv(&file(agents, keyframes)).unwrap_err();
        assert_eq!(error.code(), code);
        assert!(error.place().starts_with("row "), "{}", error.place());
    }
    let padded = |length: usize| TWO_BY_TWO.replace("0,0,a,", &format!("0,0,a{},", " ".repeat(length - "0,0,a,Band,0,1".len())));
    for length in [limits::ROW_CHARACTERS - 1, limits::ROW_CHARACTERS] {
        assert_eq!(read(&padded(length)), read(TWO_BY_TWO));
    }
    check(&padded(limits::ROW_CHARACTERS + 1), "too-long", "row 2", "10001 characters; at most 10000");
    let large = " ".repeat(limits::FILE_BYTES + 1);
    assert!(matches!(read_csv(&large), Err(Error::FileTooLarge { .. })));
}

proptest! {
    #[test]
    fn a_keyframe_csv_keeps_times_positions_names_and_groups(scene in arbitrary_scene()) {
        let written = write_csv(&scene);
        let (before, agent_count) = (scene.main_track(), scene.main_track().agents.len());
        if agent_count == 0 {
            prop_assert_eq!(read_csv(&written.text), Err(Error::NoKeyframes));
            return Ok(());
        }
        let read = read_csv(&written.text).map_err(|error| TestCaseError::fail(format!("{error} ({}): {}", error.place(), written.text)))?;
        let after = read.scene.main_track();
        prop_assert_eq!(after.keyframes.len(), before.keyframes.len());
        for (after, before) in after.keyframes.iter().zip(&before.keyframes) {
            prop_assert_eq!(after.time.to_bits(), before.time.to_bits());
            // Debug text tells −0 from 0, which equality does not.
            prop_assert_eq!(format!("{:?}", after.positions.positions()), format!("{:?}", before.positions.positions()));
            let heights = |keyframe: &Keyframe| (0..agent_count).map(|agent| keyframe.positions.height(agent)).collect::<Vec<_>>();
            // A height of −0 is 0 where all are, and the scene is plane.
            prop_assert_eq!(heights(after), heights(before));
        }
        for (after, before) in after.agents.iter().zip(&**before.agents) {
            prop_assert_eq!((after.name.trim(), &after.color), (before.name.trim(), &before.color));
        }
        prop_assert_eq!(read.scene.groups.iter().flat_map(Group::set).count(), scene.groups.iter().flat_map(Group::set).count());
        // What a CSV holds, it holds for good.
        prop_assert_eq!(read_csv(&write_csv(&read.scene).text), Ok(read));
    }
}

#[test]
fn what_a_csv_cannot_hold_is_said() {
    let plain = read(TWO_BY_TWO);
    assert!(write_csv(&plain).notes.is_empty());
    let mut rich = plain.clone();
    rich.title = "Opener".to_owned();
    rich.minimum_distance = 0.5;
    rich.tracks[0].keyframes[1].hold = 2.0;
    let expected = "A keyframe CSV does not hold these, so they are left out: the title, the minimum distance, holds.";
    assert_eq!(write_csv(&rich).notes, [expected]);
    assert_eq!(write_csv(&rich).text, write_csv(&plain).text);
}
