//! Every limit admits what reaches it and refuses what passes it, as a file and as a value.

use std::fmt::Write as _;
use std::sync::Arc;

use eigenform::adjacency::{AdjacencySpec, COMPLETE_GROUP_LIMIT};
use eigenform::choice::{Alignment, Blend, Choice, MethodName, Order};
use eigenform::edits::Constants;
use eigenform::error::Error;
use eigenform::formation::Formation;
use eigenform::obstacle::ObstacleShape;
use eigenform::scene::{Agent, CrowdSpec, Group, Keyframe, NodeSpec, Obstacle, PathSpec, Scene, Segment, Track, TransitionSpec};
use eigenform::scene::{document, limits, open_bytes, read_json, validate, write_json};
use glam::{DVec2, DVec3};

/// Agents in a row at keyframes a second apart.
fn scene(agent_count: usize, keyframe_count: usize) -> Scene {
    let row = Arc::new(Formation::new((0..agent_count).map(|agent| DVec2::new(agent as f64, 0.0)).collect()));
    let keyframe = |index| Keyframe { time: index as f64, positions: Arc::clone(&row), ..Keyframe::default() };
    let track = Track {
        agents: Arc::new(vec![Agent::default(); agent_count]),
        keyframes: (0..keyframe_count).map(keyframe).collect(),
        segments: vec![Segment::default(); keyframe_count.saturating_sub(1)],
    };
    Scene { tracks: vec![track], ..Scene::default() }
}

fn changed(change: impl FnOnce(&mut Scene)) -> Scene {
    let mut scene = scene(3, 2);
    change(&mut scene);
    scene
}

fn keyframe(change: impl FnOnce(&mut Keyframe)) -> Scene {
    changed(|scene| change(&mut scene.tracks[0].keyframes[1]))
}

fn ties(change: impl FnOnce(&mut AdjacencySpec)) -> Scene {
    changed(|scene| change(Arc::make_mut(&mut scene.adjacency)))
}

/// The scene is valid, as a value and as a file; at most it asks for what is not built yet, which is said last.
fn admits(scene: &Scene) {
    if validate(scene).is_err_and(|error| error.code() == "unsupported") {
        return;
    }
    assert_eq!(validate(scene), Ok(()));
    assert_eq!(read_json(&write_json(scene)).as_ref(), Ok(scene));
}

/// The scene is refused, as a value and as a file.
fn refuses(scene: &Scene, code: &str, place: &str) {
    let error = validate(scene).expect_err(place);
    assert_eq!((error.code(), error.place().as_str()), (code, place), "{error}");
    assert_eq!(read_json(&write_json(scene)).expect_err(place).code(), code);
}

/// Counts one and two below the least that is refused are fine.
fn check_count(least_refused: usize, code: &str, place: &str, scene: impl Fn(usize) -> Scene) {
    admits(&scene(least_refused - 2));
    admits(&scene(least_refused - 1));
    refuses(&scene(least_refused), code, place);
}

/// Both ends of a range are fine, the doubles next to them are not.
fn check_range(range: &std::ops::RangeInclusive<f64>, place: &str, scene: impl Fn(f64) -> Scene) {
    let (low, high) = (*range.start(), *range.end());
    for value in [low, low.next_up(), high.next_down(), high] {
        admits(&scene(value));
    }
    for value in [low.next_down(), high.next_up()] {
        refuses(&scene(value), "out-of-range", place);
    }
    for value in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let error = validate(&scene(value)).expect_err(place);
        assert_eq!((error.code(), error.place().as_str()), ("not-finite", place));
    }
}

#[test]
fn agents_keyframes_and_positions_have_limits() {
    check_count(limits::AGENTS + 1, "too-many-agents", "agents", |count| scene(count, 1));
    check_count(limits::KEYFRAMES + 1, "too-many-keyframes", "keyframes", |count| scene(2, count));
    check_count(1_001, "too-many-positions", "keyframes", |count| scene(count, 200));
    refuses(&scene(0, 0), "no-keyframes", "keyframes");
    admits(&scene(0, 1));
}

#[test]
fn a_file_names_the_list_that_is_too_long() {
    let place = |scene: &Scene| read_json(&write_json(scene)).unwrap_err().place();
    assert_eq!(place(&scene(5_001, 2)), "keyframes[0].positions");
    assert_eq!(place(&scene(1, 201)), "keyframes");
    assert_eq!(place(&scene(4_000, 51)), "keyframes[50]");
}

#[test]
fn numbers_have_ranges() {
    check_range(&limits::FRAME_RATE, "frameRate", |value| changed(|scene| scene.frame_rate = value));
    check_range(&limits::LENGTH, "minimumDistance", |value| changed(|scene| scene.minimum_distance = value));
    check_range(&limits::STAGE_SIDE, "stage.width", |value| changed(|scene| scene.stage.width = value));
    check_range(&limits::STAGE_SIDE, "stage.depth", |value| changed(|scene| scene.stage.depth = value));
    check_range(&limits::LENGTH, "stage.height", |value| changed(|scene| scene.stage.height = value));
    check_range(&limits::BEATS_PER_MINUTE, "tempo.beatsPerMinute", |value| changed(|scene| scene.tempo.beats_per_minute = value));
    check_range(&limits::TEMPO_START, "tempo.start", |value| changed(|scene| scene.tempo.start = value));
    check_range(&limits::MAX_SPEED, "agents[1].maxSpeed", |value| {
        changed(|scene| Arc::make_mut(&mut scene.tracks[0].agents)[1].max_speed = Some(value))
    });
    check_range(&limits::LENGTH, "agents[1].radius", |value| changed(|scene| Arc::make_mut(&mut scene.tracks[0].agents)[1].radius = value));
    for coordinate in 0..2 {
        check_range(&limits::COORDINATE, "keyframes[1].positions[2]", |value| {
            let mut positions = vec![DVec2::ZERO; 3];
            positions[2][coordinate] = value;
            keyframe(|keyframe| keyframe.positions = Arc::new(Formation::new(positions)))
        });
    }
    check_range(&limits::COORDINATE, "keyframes[0].positions[2]", |value| {
        let spatial = Arc::new(Formation::spatial(vec![DVec2::ZERO; 3], vec![0.0, 1.0, value]));
        changed(|scene| scene.tracks[0].keyframes.iter_mut().for_each(|keyframe| keyframe.positions = Arc::clone(&spatial)))
    });
    check_range(&limits::TENSION, "tension", |value| changed(|scene| scene.tension = value));
    check_range(&limits::FACTOR, "adjacency.ties[0]", |factor| ties(|spec| spec.ties = vec![(0, 1, factor)]));
    check_range(&limits::FACTOR, "groups[0].tieWeight", |factor| {
        changed(|scene| scene.groups = Arc::new(vec![Group { members: vec![0, 1], tie_weight: Some(factor), ..Group::default() }]))
    });
    let with_transition = |transition| changed(|scene| scene.tracks[0].segments = vec![Segment::Transition(transition)]);
    let with_crowd = |constants: Constants| {
        let crowd = CrowdSpec { constants, ..CrowdSpec::default() };
        with_transition(TransitionSpec { crowd, ..TransitionSpec::default() })
    };
    let usual = Constants::default();
    check_range(&limits::CROWD[0].1, "segments[0].crowd.reactionTime", |reaction_time| with_crowd(Constants { reaction_time, ..usual }));
    check_range(&limits::CROWD[3].1, "segments[0].crowd.reach", |reach| with_crowd(Constants { reach, ..usual }));
    check_range(&limits::CROWD[7].1, "segments[0].crowd.binSize", |bin_size| with_crowd(Constants { bin_size, ..usual }));
    for sectors in [1, 64] {
        admits(&with_crowd(Constants { sectors, ..usual }));
    }
    for sectors in [0, 65] {
        refuses(&with_crowd(Constants { sectors, ..usual }), "out-of-range", "segments[0].crowd.sectors");
    }
    check_range(&limits::SHARING, "segments[0].sharing", |sharing| {
        with_transition(TransitionSpec { sharing, ..TransitionSpec::default() })
    });
    check_range(&limits::BLEND, "segments[0].nodes[0].blend.amount", |amount| {
        let blend = Some(Blend { method: MethodName::Polar, amount });
        let nodes = vec![NodeSpec { group: Vec::new(), method: MethodName::Linear, blend }];
        with_transition(TransitionSpec { nodes, ..TransitionSpec::default() })
    });
    for coordinate in 0..2 {
        check_range(&limits::COORDINATE, "segments[0].path[1]", |value| {
            let mut points = vec![DVec3::ZERO, DVec3::ZERO, DVec3::new(1.0, 1.0, 0.0)];
            points[1][coordinate] = value;
            with_transition(TransitionSpec { path: Some(PathSpec { points, is_spatial: false }), ..TransitionSpec::default() })
        });
    }
    check_range(&limits::SHARING, "segments[0].chosen.sharing", |sharing| {
        let choice = Choice { method: MethodName::Polar, order: Order::Greedy, alignment: Alignment::Pca, sharing };
        with_transition(TransitionSpec { chosen: Some(choice), ..TransitionSpec::default() })
    });
    for (beats, is_right) in [(0, false), (1, true), (64, true), (65, false)] {
        assert_eq!(validate(&changed(|scene| scene.tempo.beats_per_bar = beats)).is_ok(), is_right);
    }
}

fn obstacle(shape: ObstacleShape) -> Scene {
    changed(|scene| scene.obstacles = Arc::new(vec![Obstacle { name: String::new(), shape }]))
}

/// Corners around the origin.
fn polygon(corner_count: usize) -> ObstacleShape {
    let turn = std::f64::consts::TAU / corner_count as f64;
    ObstacleShape::Polygon { points: (0..corner_count).map(|corner| DVec2::from_angle(turn * corner as f64)).collect() }
}

#[test]
fn obstacles_have_limits() {
    check_count(201, "too-many-obstacles", "obstacles", |count| {
        changed(|scene| scene.obstacles = Arc::new(vec![Obstacle { name: String::new(), shape: polygon(3) }; count]))
    });
    check_count(201, "too-many-corners", "obstacles[0].points", |count| obstacle(polygon(count)));
    check_count(65, "too-long", "obstacles[0].name", |length| {
        changed(|scene| scene.obstacles = Arc::new(vec![Obstacle { name: "é".repeat(length), shape: polygon(3) }]))
    });
    check_range(&limits::OBSTACLE_RADIUS, "obstacles[0].radius", |radius| obstacle(ObstacleShape::Circle { center: DVec2::ONE, radius }));
    for coordinate in 0..2 {
        check_range(&limits::COORDINATE, "obstacles[0].center", |value| {
            let mut center = DVec2::ZERO;
            center[coordinate] = value;
            obstacle(ObstacleShape::Circle { center, radius: 1.0 })
        });
        check_range(&limits::COORDINATE, "obstacles[0].points[2]", |value| {
            let mut points = vec![DVec2::ZERO, DVec2::ONE, DVec2::splat(-7.0)];
            points[2][coordinate] = value;
            obstacle(ObstacleShape::Polygon { points })
        });
    }
    check_range(&limits::FACTOR, "adjacency.obstacleTies[0]", |factor| {
        let mut scene = obstacle(polygon(3));
        Arc::make_mut(&mut scene.adjacency).obstacle_ties = vec![(2, 0, factor)];
        scene
    });
}

#[test]
fn ties_to_obstacles_count_with_the_others() {
    let with = |count: usize| {
        let mut scene = scene(400, 1);
        scene.obstacles = Arc::new(vec![Obstacle { name: String::new(), shape: polygon(3) }; 2]);
        let obstacle_ties = (0..400).flat_map(|agent| [(agent, 0, 1.0), (agent, 1, 1.0)]).collect();
        scene.adjacency = Arc::new(AdjacencySpec { ties: pairs(count - 800), obstacle_ties, ..AdjacencySpec::default() });
        scene
    };
    check_count(50_001, "too-many-ties", "keyframes[0]", with);
}

#[test]
fn times_end_after_an_hour_and_rise() {
    let at = |time: f64, hold: f64| {
        keyframe(|keyframe| {
            keyframe.time = time;
            keyframe.hold = hold;
        })
    };
    admits(&at(3_600.0, 0.0));
    refuses(&at(3_600.0_f64.next_up(), 0.0), "out-of-range", "keyframes[1].time");
    admits(&at(3_000.0, 600.0));
    refuses(&at(3_000.0, 600.0_f64.next_up()), "out-of-range", "keyframes[1].hold");
    refuses(&at(1.0, -f64::MIN_POSITIVE), "out-of-range", "keyframes[1].hold");
    refuses(&changed(|scene| scene.tracks[0].keyframes[0].time = -1e-9), "out-of-range", "keyframes[0].time");
    let after_hold = |time| {
        changed(|scene| {
            scene.tracks[0].keyframes[0].hold = 2.5;
            scene.tracks[0].keyframes[1].time = time;
        })
    };
    admits(&after_hold(2.5_f64.next_up()));
    refuses(&after_hold(2.5), "times-do-not-rise", "keyframes[1].time");
    refuses(&after_hold(2.5_f64.next_down()), "times-do-not-rise", "keyframes[1].time");
}

#[test]
fn agents_times_frames_has_a_limit_that_names_the_rate_that_fits() {
    let show = |agent_count: usize, time: f64, frame_rate: f64| {
        let mut scene = scene(agent_count, 2);
        scene.frame_rate = frame_rate;
        scene.tracks[0].keyframes[1].time = time;
        scene
    };
    // 1,000 agents have room for 20,000 frames.
    admits(&show(1_000, 19_998.0 / 30.0, 30.0));
    admits(&show(1_000, 19_999.0 / 30.0, 30.0));
    refuses(&show(1_000, 20_000.0 / 30.0, 30.0), "too-many-frames", "");
    for (agent_count, time) in [(5_000, 3_600.0), (5_000, 100.0), (1_000, 200.0), (1_000, 166.7), (777, 1_234.5)] {
        let Err(Error::TooManyFrames { fitting_rate, .. }) = validate(&show(agent_count, time, 120.0)) else { panic!("{agent_count}") };
        admits(&show(agent_count, time, f64::from(fitting_rate)));
        refuses(&show(agent_count, time, f64::from(fitting_rate + 1)), "too-many-frames", "");
    }
    let message = validate(&show(5_000, 3_600.0, 30.0)).unwrap_err().to_string();
    assert_eq!(message, "5000 agents × 108001 frames; at most 20000000 in all, which fits at 1 frames per second");
}

#[test]
fn names_and_titles_count_characters_not_bytes() {
    let text = |length| "é".repeat(length);
    check_count(201, "too-long", "title", |length| changed(|scene| scene.title = text(length)));
    check_count(65, "too-long", "keyframes[1].name", |length| keyframe(|keyframe| keyframe.name = text(length)));
    check_count(65, "too-long", "agents[2].name", |length| {
        changed(|scene| Arc::make_mut(&mut scene.tracks[0].agents)[2].name = text(length))
    });
    check_count(65, "too-long", "groups[0].name", |length| {
        changed(|scene| scene.groups = Arc::new(vec![Group { name: text(length), ..Group::default() }]))
    });
}

#[test]
fn groups_have_limits() {
    check_count(1_001, "too-many-groups", "groups", |count| changed(|scene| scene.groups = Arc::new(vec![Group::default(); count])));
    check_count(1_001, "too-many-groups", "groups", |count| {
        let parent = Group { children: vec![Group::default(); count - 1], ..Group::default() };
        changed(|scene| scene.groups = Arc::new(vec![parent]))
    });
    let place = format!("groups[0]{}", ".children[0]".repeat(8));
    check_count(9, "groups-too-deep", &place, |depth| {
        let within = |child: Group| Group { children: vec![child], ..Group::default() };
        changed(|scene| scene.groups = Arc::new(vec![(1..depth).fold(Group::default(), |group, _| within(group))]))
    });
}

/// The first `count` pairs of many agents.
fn pairs(count: usize) -> Vec<(u32, u32, f64)> {
    (0..).flat_map(|b| (0..b).map(move |a| (a, b, 1.0))).take(count).collect()
}

fn with_ties(keyframe_count: usize, count: usize, groups: Vec<Group>) -> Scene {
    let mut scene = scene(400, keyframe_count);
    scene.adjacency = Arc::new(AdjacencySpec { ties: pairs(count), ..AdjacencySpec::default() });
    scene.groups = Arc::new(groups);
    scene
}

#[test]
fn ties_by_hand_have_a_limit() {
    check_count(50_001, "too-many-ties", "adjacency.ties", |count| with_ties(1, count, Vec::new()));
    check_count(50_001, "too-many-cuts", "adjacency.cuts", |count| {
        let mut scene = with_ties(1, 0, Vec::new());
        Arc::make_mut(&mut scene.adjacency).cuts = pairs(count).into_iter().map(|(a, b, _)| (a, b)).collect();
        scene
    });
}

#[test]
fn ties_of_groups_count_with_those_by_hand() {
    let group = |size: usize| Group { members: (0..size as u32).collect(), tie_weight: Some(2.0), ..Group::default() };
    let complete = COMPLETE_GROUP_LIMIT * (COMPLETE_GROUP_LIMIT - 1) / 2;
    check_count(50_001, "too-many-ties", "keyframes[0]", |count| with_ties(1, count - complete, vec![group(COMPLETE_GROUP_LIMIT)]));
    // In a row of agents every one but the first has a neighbor before it, every one but two has one at distance two.
    check_count(50_001, "too-many-ties", "keyframes[0]", |count| with_ties(1, count - (99 + 98), vec![group(100)]));
}

#[test]
fn ties_of_all_keyframes_have_a_limit() {
    // Ten keyframes share one adjacency; the ties beyond come at one more keyframe of its own.
    check_count(500_001, "too-many-ties", "keyframes", |count| {
        let mut scene = with_ties(11, 49_000, Vec::new());
        let own = AdjacencySpec { ties: pairs(count - 490_000), ..AdjacencySpec::default() };
        scene.tracks[0].keyframes[10].adjacency = Some(Arc::new(own));
        scene
    });
}

#[test]
fn a_keyframes_own_ties_replace_the_scenes() {
    let mut scene = with_ties(1, 50_000, Vec::new());
    scene.tracks[0].keyframes[0].adjacency = Some(Arc::new(AdjacencySpec { ties: pairs(50_000), ..AdjacencySpec::default() }));
    admits(&scene);
}

#[test]
fn a_file_has_a_largest_size() {
    let text = write_json(&scene(2, 1));
    let padded = |length: usize| text.clone() + &" ".repeat(length - text.len());
    for length in [limits::FILE_BYTES - 1, limits::FILE_BYTES] {
        assert!(read_json(&padded(length)).is_ok());
    }
    let large = padded(limits::FILE_BYTES + 1);
    let expected = Error::FileTooLarge { bytes: limits::FILE_BYTES + 1, limit: limits::FILE_BYTES };
    assert_eq!(read_json(&large), Err(expected.clone()));
    assert_eq!(open_bytes(large.as_bytes()), Err(expected.clone()));
    assert_eq!(document::read(&large, Vec::new()), Err(expected));
}

#[test]
fn a_list_of_millions_is_refused_by_its_kind() {
    let filled = |before: &str, entry: &str, after: &str| {
        let mut text = String::new();
        text.push_str(r#"{ "format": "eigenform", "version": 1, "#);
        let entries = vec![entry; 1_000_000].join(",");
        write!(text, "{before}{entries}{after}}}").unwrap();
        text
    };
    let cases = [
        (filled(r#""keyframes": [{"positions": ["#, "[0,0]", "]}]"), "too-many-agents"),
        (filled(r#""keyframes": ["#, "{}", "]"), "too-many-keyframes"),
        (filled(r#""keyframes": [], "groups": ["#, "{}", "]"), "too-many-groups"),
        (filled(r#""keyframes": [], "agents": ["#, "{}", "]"), "too-many-agents"),
        (filled(r#""keyframes": [], "segments": ["#, "{}", "]"), "too-many-segments"),
        (filled(r#""keyframes": [], "adjacency": {"ties": ["#, "[0,1,1]", "]}"), "too-many-ties"),
        (filled(r#""keyframes": [], "recordings": ["#, "0", "]"), "unsupported"),
        (filled(r#""keyframes": [], "#, r#""x":0"#, ""), "unknown-field"),
    ];
    for (text, code) in cases {
        assert_eq!(read_json(&text).unwrap_err().code(), code);
    }
}
