//! Links are for ever: what a version has written, every later one reads, and writes again.

use eigenform::scene::link::{Precision, decode, encode};
use eigenform::scene::read_json;

const PLAIN: &str = r#"{ "format": "eigenform", "version": 1, "keyframes": [{ "positions": [[0, 0], [1.5, -2], [3, 4.25]] }] }"#;

/// Every field of the first format differs from its default.
const RICH: &str = r##"{
  "format": "eigenform", "version": 1, "title": "Opener", "seed": 7, "frameRate": 25, "minimumDistance": 0.5,
  "stage": { "width": 40, "depth": 20, "height": 3, "backdrop": "soccer", "units": "yd" },
  "tempo": { "beatsPerMinute": 96, "beatsPerBar": 3, "start": 0.25 },
  "agents": [{ "name": "T1", "color": "#ff8800" }, { "name": "T2", "radius": 0.4 }, { "name": "Ada" }, { "name": "Zoë", "color": "#00AA11" }],
  "groups": [
    { "name": "Band", "tieWeight": 10, "children": [{ "name": "Brass", "color": "#123456", "members": [1, 0] }] },
    { "members": [3] }
  ],
  "adjacency": { "weights": "unit", "ties": [[0, 3, 2], [1, 2, 0.5]], "cuts": [[0, 2]] },
  "keyframes": [
    { "name": "Block", "hold": 1.5, "positions": [[0, 0], [1.143, 0], [0, 1.143], [1.143, 1.143]] },
    { "time": 4, "positions": [[5, 5], [-5, 5], [-5, -5], [5, -5]], "adjacency": { "base": "none", "ties": [[0, 1, 100]] } },
    { "time": 9.75, "hold": 2, "positions": [[0.1234567, 1], [2, 3], [4, 5], [6, 7.7654321]] }
  ],
  "segments": [
    { "method": "spectral", "order": "hungarian", "alignment": "procrustes", "sharing": 0.25, "keepSize": true, "timing": "linear" },
    { "chosen": { "method": "polar", "sharing": 1 } }
  ]
}"##;

/// What was added behind the closing flag: joins, corners, even timing, avoidance, hierarchy, obstacles and heights.
const ADDED: &str = r#"{
  "format": "eigenform", "version": 1, "minimumDistance": 0.5, "join": "smooth", "tension": 0.25,
  "groups": [{ "name": "Wing", "members": [0], "children": [{ "members": [1] }] }],
  "keyframes": [
    { "positions": [[0, 0, 1], [2, 0, 3.5], [4, 1, -2]] },
    { "time": 4, "corner": true, "positions": [[5, 5, 1], [-5, 5, 3.5], [-5, -5, 0]] },
    { "time": 8, "positions": [[0, 1, 2], [2, 1, 2], [4, 2, 2]] }
  ],
  "segments": [
    { "method": "linear", "timing": "even", "avoidance": true },
    {
      "avoidance": true, "hierarchy": true,
      "nodes": [{ "method": "polar" }, { "group": [0, 0], "method": "linear", "blend": { "method": "spectral", "amount": 0.3 } }]
    }
  ],
  "obstacles": [
    { "name": "Tower", "kind": "circle", "center": [20, -3.5], "radius": 1.25 },
    { "kind": "polygon", "points": [[30, 0], [34, 0], [34, 2], [32, 2], [32, 6], [30, 6]] }
  ]
}"#;

/// What was added behind that: a crowd's forces, top speeds.
const CROWD: &str = r#"{
  "format": "eigenform", "version": 1, "minimumDistance": 0.5, "seed": 3,
  "agents": [{ "maxSpeed": 1.5 }, { "maxSpeed": 1.5, "radius": 0.4 }, {}],
  "groups": [{ "name": "Pair", "members": [0, 1] }],
  "keyframes": [
    { "positions": [[0, 0], [1, 0], [2, 0]] },
    { "time": 4, "positions": [[0, 5], [1.25, 5], [2.5, 5]] },
    { "time": 9, "positions": [[5, 0], [6, 0], [7, 0]] }
  ],
  "segments": [
    { "method": "crowd", "crowd": {
      "guide": "spectral", "directionFeedback": false, "speedFeedback": false, "reactionTime": 0.4, "lookAhead": 0.25, "strength": 3,
      "reach": 0.35, "groupStrength": 0.75, "groupReach": 1.5, "fluctuation": 0.125, "binSize": 5, "sectors": 12 } },
    { "method": "crowd", "avoidance": true }
  ]
}"#;

/// And behind that: how it was found who goes where.
const RECIPE: &str = r#"{
  "format": "eigenform", "version": 1,
  "keyframes": [
    { "positions": [[0, 0], [1, 0], [2, 0], [3, 0]] }, { "time": 4, "positions": [[0, 5], [1, 5], [2, 5], [3, 5]] },
    { "time": 8, "positions": [[0, 0], [0, 1], [0, 2], [0, 3]] }, { "time": 12, "positions": [[4, 0], [4, 1], [4, 2], [4, 3]] }
  ],
  "segments": [
    { "method": "linear", "assignment": { "cost": "least-effort", "lambda": 0.75, "keepGroups": true, "locks": [[0, 3], [2, 1]] } },
    {},
    { "method": "linear", "assignment": { "cost": "manhattan" } }
  ]
}"#;

/// What was added behind further flags: paths, on the plane and climbing, and who is absent.
const TRAVELED: &str = r#"{
  "format": "eigenform", "version": 1,
  "keyframes": [
    { "positions": [[0, 0, 1], [2, 0, 3.5], [4, 1, -2]], "absent": [0, 2] },
    { "time": 4, "positions": [[5, 5, 1], [-5, 5, 3.5], [-5, -5, 0]], "absent": [0, 2] },
    { "time": 8, "positions": [[0, 1, 2], [2, 1, 2], [4, 2, 2]], "absent": [1] }
  ],
  "segments": [{ "path": [[0, 0], [10, 0.25], [0.1234567890123, 20]] }, { "path": [[0, 0, 0], [1, 2, 3]] }]
}"#;

/// And behind that: a keyframe that lies in a transition.
const BETWEEN: &str = r#"{
  "format": "eigenform", "version": 1, "join": "smooth",
  "keyframes": [
    { "positions": [[0, 0], [2, 0], [4, 1]] }, { "time": 2.5, "between": 2, "positions": [[1.5, 3], [3, 2], [4.25, 4]] },
    { "time": 4, "positions": [[5, 5], [-5, 5], [-5, -5]] }
  ],
  "segments": [{ "method": "spectral" }, { "method": "spectral" }]
}"#;

/// The scene has this link, and the link is that of the scene it opens.
fn check(scene: &str, precision: Precision, link: &str) {
    let scene = read_json(scene).expect("a scene");
    assert_eq!(encode(&scene, precision).fragment, link);
    let opened = decode(link).expect("a link of an earlier version opens");
    assert_eq!(encode(&opened, precision).fragment, link);
}

#[test]
fn the_links_of_the_first_format_stay_what_they_were() {
    let plain = "#s=1.C0-PVARJPkjbP8PUW6rGEQ";
    check(PLAIN, Precision::Exact, plain);
    check(PLAIN, Precision::Short, plain);
    assert_eq!(decode(plain), read_json(PLAIN));
    check(
        RICH,
        Precision::Exact,
        "#s=1.tgEY-zxnAT3hEADO63nN6SCj2ARIwB4esawMHwAPDb2owRqM4NP4NahXQJRof-etBiar37CQAAq4ppUACGuF8Gb-h9ORECelTXgWeo4F3AVwUzqQbvHMrONr\
         jcLEnaYxubktUXdmEVSBlR_FS3Me8rowDLHCLdY5meRjlj1CTzEVklulEogYzemkWYKIQQ-vIen5d2d2BS80FfSYRECg0kDPQNk4ifxtluT1ltNuPocYGA59_0w8wL\
         yX50E",
    );
    check(
        RICH,
        Precision::Short,
        "#s=1.pgE-FTFpAT3hEADO63nN6SCj2ARIwB4esawMHwAPDb2owRqM4NhVVBQ1qFdAlGh_560GJq2rjkABowdDNwxukSefOpl2iO8vyAlOt9MyX5hfq3ZhOIvlL14B\
         5sVvCuALLjTY-YpSCth35PI6QR7yKBirILVSAUq2VOAWGgUKcXYhaxXRTjv2PYx0mPGbhKZBtAQFvGHSeqiox3ufG73xCtJEPExD6tt_atXMZA",
    );
}

#[test]
fn so_do_those_of_what_was_added() {
    let link = "#s=1.WyrPRlMp6mLCyH6KkW4fVv4xL0Pc8EUsJLc0KjA9o-ArjWn5PI88m5lZP4DF4--eI_W5_DuAYZ9-DA3L-RitGTu4BNCYiJ5oQL8wQj5_rmJWf-LT0SwTRQzaa\
                nvONn0W";
    check(ADDED, Precision::Exact, link);
    check(ADDED, Precision::Short, link);
    assert_eq!(decode(link), read_json(ADDED));
}

#[test]
fn so_do_those_of_crowds() {
    let link = "#s=1.RhwyzEQIAjWBLnCEYGaYyddBnuXMJuZ3uVQxbDouuErrVG65JRFzZDb3FJ8kOdaRTUcsgCtyFZssBdat15V5hEsYLArI4EDYFgwY";
    check(CROWD, Precision::Exact, link);
    check(CROWD, Precision::Short, link);
    assert_eq!(decode(link), read_json(CROWD));
}

#[test]
fn so_do_those_of_who_goes_where() {
    let link = "#s=1.Kf4OJGNDx1PsD8O6rEqejIs6nD_rMsSUlPEGXXVTOm8isN1uTJWRiX7lHICoTA";
    check(RECIPE, Precision::Exact, link);
    check(RECIPE, Precision::Short, link);
    assert_eq!(decode(link), read_json(RECIPE));
}

#[test]
fn so_do_those_with_paths_and_absences() {
    let link = "#s=1.QHnXyYtGgsjxH8PRaAuYk2w_RdzhKI1iOcOkN2xrRcvV1cJ2I9jX60wmVxZXzNyREWQpA4NskxB1ctLH-2nUOJ-ggqYK";
    check(TRAVELED, Precision::Exact, link);
    check(TRAVELED, Precision::Short, link);
    assert_eq!(decode(link), read_json(TRAVELED));
}

#[test]
fn so_do_those_with_keyframes_between() {
    let link = "#s=1.J3JqzzlJPkjxH8Pc0Aen_rep4Dx69SkXQqYapCNksEHe2heD57pRM32jdUc";
    check(BETWEEN, Precision::Exact, link);
    check(BETWEEN, Precision::Short, link);
    assert_eq!(decode(link), read_json(BETWEEN));
}
