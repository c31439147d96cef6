//! What a person may rely on when a scene is performed.

use std::sync::Arc;

use eigenform::choice::{Alignment, Choice, Join, MethodName, Order};
use eigenform::formation::Formation;
use eigenform::motion::clashes;
use eigenform::perform::{Performed, Performer, Salvage, SalvageStep, Step, perform};
use eigenform::scene::link::{self, Precision};
use eigenform::scene::{Keyframe, Scene, Segment, TransitionSpec, read_json, write_json};
use glam::DVec2;

/// Three keyframes of nine agents: a block, a wedge that is held, and the block turned.
fn show() -> Scene {
    let block: Vec<[f64; 2]> = (0..9).map(|i| [f64::from(i % 3) * 2.0, f64::from(i / 3) * 2.0]).collect();
    let wedge: Vec<[f64; 2]> = (0..9).map(|i| [f64::from(i) - 4.0, (f64::from(i) - 4.0).abs() * 1.5]).collect();
    let turned: Vec<[f64; 2]> = block.iter().map(|[x, y]| [-y * 0.9, x * 1.1]).collect();
    let text = serde_json::json!({
        "format": "eigenform", "version": 1, "frameRate": 10, "minimumDistance": 0.5,
        "keyframes": [
            { "time": 0.5, "positions": block },
            { "time": 3, "hold": 1, "positions": wedge },
            { "time": 6, "positions": turned },
        ],
    });
    read_json(&text.to_string()).expect("the show is valid")
}

fn finish(performer: &mut Performer, scene: &Scene, index: usize, held: Option<Choice>) -> Arc<Performed> {
    let held = vec![held; index + 1];
    let mut job = performer.begin(scene, index, &held);
    let mut last = -1.0;
    loop {
        match job.step(performer).expect("the show can be performed") {
            Step::Done(performed) => return performed,
            Step::Progress(progress) => {
                assert!(progress >= last && progress < 1.0, "progress runs from {last} to {progress}");
                last = progress;
            }
        }
    }
}

#[test]
fn keyframes_are_reached_exactly_and_held() {
    let scene = show();
    let performance = perform(&scene).expect("the show can be performed");
    for (time, keyframe) in [(0.0, 0), (0.5, 0), (3.0, 1), (3.7, 1), (4.0, 1), (6.0, 2), (99.0, 2)] {
        let expected = scene.main_track().keyframes[keyframe].positions.positions();
        let largest = performance.formation_at(time).positions().iter().zip(expected).map(|(a, b)| a.distance(*b)).fold(0.0, f64::max);
        assert!(largest <= 1e-9 * scene.main_track().keyframes[keyframe].positions.extent(), "{largest} at {time} s");
    }
}

#[test]
fn frames_are_what_the_methods_say_at_their_times() {
    let performance = perform(&show()).expect("the show can be performed");
    let mut count = 0;
    performance.for_each_frame(|frame, time, places| {
        assert_eq!(frame, count);
        count += 1;
        for (sampled, exact) in places.plan().iter().zip(performance.formation_at(time).positions()) {
            assert!(sampled.distance(*exact) <= 1e-12 * 20.0, "frame {frame}: {sampled} and {exact}");
        }
    });
    assert_eq!(count, 61, "six seconds at ten frames a second, and the first");
}

#[test]
fn auto_keeps_the_least_score_and_shows_what_it_compared() {
    let performance = perform(&show()).expect("the show can be performed");
    for performed in performance.segments() {
        let least = performed.candidates.iter().map(|candidate| candidate.score).fold(f64::INFINITY, f64::min);
        let chosen: Vec<_> = performed.candidates.iter().filter(|candidate| candidate.is_chosen).collect();
        assert_eq!(chosen.len(), 1);
        assert_eq!((chosen[0].score, chosen[0].choice), (least, performed.choice));
    }
}

#[test]
fn what_was_chosen_when_a_scene_was_saved_is_not_chosen_again() {
    let mut scene = show();
    let taken = Choice { method: MethodName::Polar, order: Order::Greedy, alignment: Alignment::Pca, sharing: 0.25 };
    let Segment::Transition(spec) = &mut scene.tracks[0].segments[0];
    spec.chosen = Some(taken);
    let performance = perform(&scene).expect("the show can be performed");
    assert_eq!(performance.segments()[0].choice, taken);
    assert!(performance.segments()[0].candidates.is_empty());
}

#[test]
fn a_motion_is_there_before_its_numbers_and_stays_as_it_is() {
    let mut performer = Performer::default();
    let mut job = performer.begin(&show(), 1, &[]);
    let mut unmeasured = None;
    let performed = loop {
        match job.step(&mut performer).expect("the show can be performed") {
            Step::Done(performed) => break performed,
            Step::Progress(_) => unmeasured = job.motion().cloned(),
        }
    };
    assert_eq!(unmeasured.as_ref(), Some(&performed.motion));
}

#[test]
fn the_same_scene_has_the_same_motion_to_the_bit() {
    let bits = |scene: &Scene| -> Vec<u64> {
        let performance = perform(scene).expect("the show can be performed");
        performance.segments().iter().flat_map(|s| s.motion.positions().to_vec()).flat_map(|p| [p.x.to_bits(), p.y.to_bits()]).collect()
    };
    assert_eq!(bits(&show()), bits(&show()));
}

#[test]
fn moving_an_agent_performs_its_two_segments_and_no_other() {
    let mut performer = Performer::default();
    let mut scene = show();
    let track = &mut scene.tracks[0];
    let last = Keyframe { time: 9.0, ..track.keyframes[0].clone() };
    track.keyframes.push(last);
    track.segments.push(track.segments[0].clone());
    let scene = performer.adopt(scene);
    let before: Vec<_> = (0..3).map(|index| finish(&mut performer, &scene, index, None)).collect();
    let mut moved = scene.clone();
    let mut positions = moved.tracks[0].keyframes[0].positions.positions().to_vec();
    positions[4] += DVec2::new(0.3, 0.1);
    moved.tracks[0].keyframes[0].positions = Arc::new(Formation::new(positions));
    let moved = performer.adopt(moved);
    let after: Vec<_> = (0..3).map(|index| finish(&mut performer, &moved, index, None)).collect();
    let is_same: Vec<bool> = before.iter().zip(&after).map(|(a, b)| Arc::ptr_eq(a, b)).collect();
    assert_eq!(is_same, [false, true, true]);
}

/// Which of nine segments are performed anew when an agent is moved at the middle keyframe.
fn performed_anew(join: Join, sharing: f64) -> Vec<usize> {
    let mut performer = Performer::default();
    let mut scene = Scene { join, ..show() };
    let track = &mut scene.tracks[0];
    let choice = TransitionSpec { method: MethodName::Spectral, sharing, ..TransitionSpec::default() };
    track.segments = vec![Segment::Transition(choice); 9];
    let formations: Vec<_> = track.keyframes.iter().map(|keyframe| keyframe.positions.clone()).collect();
    track.keyframes =
        (0..10).map(|k| Keyframe { time: k as f64, positions: Arc::new((*formations[k % 3]).clone()), ..Keyframe::default() }).collect();
    let scene = performer.adopt(scene);
    let before: Vec<_> = (0..9).map(|index| finish(&mut performer, &scene, index, None)).collect();
    let mut moved = scene.clone();
    let mut positions = moved.tracks[0].keyframes[5].positions.positions().to_vec();
    positions[4] += DVec2::new(0.3, 0.1);
    moved.tracks[0].keyframes[5].positions = Arc::new(Formation::new(positions));
    let moved = performer.adopt(moved);
    let after: Vec<_> = (0..9).map(|index| finish(&mut performer, &moved, index, None)).collect();
    (0..9).filter(|index| !Arc::ptr_eq(&before[*index], &after[*index])).collect()
}

#[test]
fn a_moved_agent_performs_two_segments_anew_four_where_they_join_and_six_where_they_share() {
    assert_eq!(performed_anew(Join::Separate, 0.5), [4, 5]);
    assert_eq!(performed_anew(Join::Smooth, 0.0), [3, 4, 5, 6]);
    assert_eq!(performed_anew(Join::Product, 0.5), [3, 4, 5, 6]);
    assert_eq!(performed_anew(Join::Smooth, 0.5), [2, 3, 4, 5, 6, 7]);
}

#[test]
fn text_parsed_anew_serves_from_the_cache_when_nothing_changed() {
    let mut performer = Performer::default();
    let scene = performer.adopt(show());
    let first = finish(&mut performer, &scene, 0, None);
    let formations = scene.main_track().keyframes.iter().map(|keyframe| keyframe.positions.clone()).collect();
    let rest = rest_of(&scene);
    let again = eigenform::scene::document::read(&rest, formations).expect("the rest is valid");
    let again = performer.adopt(again);
    assert!(Arc::ptr_eq(&first, &finish(&mut performer, &again, 0, None)));
}

/// The scene as the page sends it: fields of the track beside the others, no positions.
fn rest_of(scene: &Scene) -> String {
    let mut value: serde_json::Value = serde_json::from_str(&eigenform::scene::document::write(scene)).expect("a scene is JSON");
    let top = value.as_object_mut().expect("a scene is an object");
    let mut tracks = top.remove("tracks").expect("a scene has tracks");
    top.append(tracks[0].as_object_mut().expect("a track is an object"));
    for keyframe in top["keyframes"].as_array_mut().expect("a track has keyframes") {
        keyframe.as_object_mut().expect("a keyframe is an object").remove("positions");
    }
    value.to_string()
}

/// Shows of every kind, with what they come to: the browser's engine is held to the same numbers (`web/src/engine/agreement.test.ts`).
#[test]
fn the_motions_on_record_are_performed_again() {
    let cases: serde_json::Value = serde_json::from_str(include_str!("../agreement.json")).expect("the record is JSON");
    for case in cases.as_array().expect("a list") {
        let performance = perform(&read_json(&case["scene"].to_string()).expect("a valid scene")).expect("a show that can be performed");
        let motion: serde_json::Value = serde_json::from_str(&performance.to_json()).expect("JSON");
        let [found, recorded] = [&motion["positions"], &case["positions"]].map(numbers);
        assert_eq!(found.len(), recorded.len(), "{}", case["name"]);
        let extent = 2.0 * recorded.iter().copied().map(f64::abs).fold(0.0, f64::max);
        let off = found.iter().zip(&recorded).map(|(found, recorded)| (found - recorded).abs()).fold(0.0, f64::max);
        // What the architecture promises between machines.
        assert!(off < 1e-8 * extent, "{}: {off:e} of {extent}", case["name"]);
    }
}

fn numbers(value: &serde_json::Value) -> Vec<f64> {
    match value {
        serde_json::Value::Array(values) => values.iter().flat_map(numbers).collect(),
        number => vec![number.as_f64().expect("a number")],
    }
}

/// Blocks of nine a meter apart.
fn block([x, y]: [f64; 2]) -> impl Iterator<Item = [f64; 2]> {
    (0..9).map(move |k| [x + f64::from(k % 3), y + f64::from(k / 3)])
}

/// Two blocks that pass through each other at right angles on straight ways, the first of which exchanges two ranks, so that it keeps no
/// files; they stand for `hold` seconds and go on.
fn crossing(minimum_distance: f64, hold: f64) -> Scene {
    let exchanged = |at| {
        let own: Vec<_> = block(at).collect();
        [&own[3..6], &own[..3], &own[6..]].concat()
    };
    let pair = |one: Vec<[f64; 2]>, other| one.into_iter().chain(block(other)).collect::<Vec<_>>();
    let segment = serde_json::json!({ "method": "linear", "avoidance": true });
    let text = serde_json::json!({
        "format": "eigenform", "version": 1, "minimumDistance": minimum_distance, "join": "smooth",
        "keyframes": [
            { "positions": pair(block([-6.0, 0.0]).collect(), [0.0, -6.0]) },
            { "time": 6, "hold": hold, "positions": pair(exchanged([6.0, 0.0]), [0.0, 6.0]) },
            { "time": 12, "positions": pair(exchanged([10.0, 3.0]), [-3.0, 10.0]) },
        ],
        "segments": [segment, segment],
    });
    read_json(&text.to_string()).expect("the show is valid")
}

fn salvage(scene: &Scene, index: usize) -> Option<Box<Salvage>> {
    let mut performer = Performer::default();
    let mut job = performer.salvage(scene, index);
    let mut last = 0.0;
    loop {
        match job.step(&mut performer).expect("the show can be performed") {
            SalvageStep::Done(found) => return found,
            SalvageStep::Progress(progress) => {
                assert!((last..=1.0).contains(&progress), "progress runs from {last} to {progress}");
                last = progress;
            }
        }
    }
}

/// The meetings in a scene that are too near, found anew.
fn too_near(scene: &Scene) -> usize {
    let performance = perform(scene).expect("the show can be performed");
    performance.segments().iter().map(|segment| clashes(&segment.motion, scene.minimum_distance - 1e-6).len()).sum()
}

#[test]
fn those_who_are_stuck_spread_out_by_way_of_keyframes_that_keep_everybody_apart() {
    let scene = crossing(0.8, 1.0);
    assert!(too_near(&scene) > 0, "they are stuck");
    let found = salvage(&scene, 0).expect("there is something to mend");
    let apart = found.apply(&scene, 0);
    assert_eq!(too_near(&apart), 0);
    // Nothing but the segment has changed.
    let (before, after) = (scene.main_track(), apart.main_track());
    let added = found.keyframes.len();
    assert_eq!(after.keyframes[1..=added], found.keyframes);
    assert_eq!([&after.keyframes[..1], &after.keyframes[1 + added..]].concat(), before.keyframes);
    assert_eq!(after.segments[1 + added..], before.segments[1..]);
    // A file and a link keep it.
    assert_eq!(read_json(&write_json(&apart)).as_ref(), Ok(&apart));
    let link = link::encode(&apart, Precision::Exact);
    assert_eq!((link.rounding, link.step), (0.0, 0.01), "new places lie on a person's grid");
    assert_eq!(too_near(&link::decode(&link.fragment).expect("a link reads back")), 0);
}

#[test]
fn the_numbers_of_a_salvage_are_those_of_the_motion_that_is_accepted() {
    let scene = crossing(0.8, 1.0);
    let found = salvage(&scene, 0).expect("there is something to mend");
    let performance = perform(&found.apply(&scene, 0)).expect("the show can be performed");
    let parts = &performance.segments()[..=found.keyframes.len()];
    let report = &found.report;
    let nearest = parts.iter().filter_map(|part| part.measures.clearance).map(|clearance| clearance.distance).fold(f64::INFINITY, f64::min);
    assert_eq!(report.clearance.map(|clearance| clearance.distance), Some(nearest));
    let mut plain = scene.clone();
    for Segment::Transition(transition) in &mut plain.tracks[0].segments {
        transition.avoidance = false;
    }
    let guide = perform(&plain).expect("the show can be performed");
    let mut widest = 0.0_f64;
    for part in parts {
        for (k, time) in part.motion.times().iter().enumerate() {
            let shifts = part.motion.sample(k).iter().zip(guide.positions_at(*time)).map(|(place, was)| place.distance(was));
            widest = shifts.fold(widest, f64::max);
        }
    }
    assert!((report.deviation.max - widest).abs() < 1e-9, "{} {widest}", report.deviation.max);
    let fastest = parts.iter().map(|part| part.measures.top_speed.speed).fold(0.0, f64::max);
    assert!((report.top_speed - fastest).abs() < 1e-9);
    assert!((report.guide_top_speed - guide.segments()[0].measures.top_speed.speed).abs() < 1e-9);
    // Two meters, or three minimum distances.
    assert_eq!(report.is_wild, widest > 2.4 || fastest > 1.5 * report.guide_top_speed);
}

#[test]
fn where_nobody_is_stuck_or_a_keyframe_is_to_blame_there_is_nothing_to_spread() {
    for minimum_distance in [0.3, 1.01] {
        assert!(salvage(&crossing(minimum_distance, 1.0), 0).is_none(), "{minimum_distance}");
    }
}

/// Who takes whose place on a lattice of 4 × 4: where auto's own guide fails at 0.7 m, and another one does not, or all do.
const MENDED: [usize; 16] = [13, 12, 2, 5, 8, 15, 1, 9, 7, 3, 10, 4, 6, 11, 0, 14];
const HOPELESS: [usize; 16] = [15, 14, 0, 13, 9, 3, 6, 11, 12, 7, 4, 2, 8, 5, 1, 10];

/// Sixteen agents a meter apart who change places, and go on to the right.
fn shuffled(minimum_distance: f64, join: &str, slots: [usize; 16]) -> Scene {
    let start: Vec<[f64; 2]> = (0..16).map(|k| [f64::from(k % 4), f64::from(k / 4)]).collect();
    let target = slots.map(|slot| start[slot]);
    let last = target.map(|[x, y]| [x + 6.0, y]);
    let segment = serde_json::json!({ "avoidance": true });
    let text = serde_json::json!({
        "format": "eigenform", "version": 1, "minimumDistance": minimum_distance, "join": join,
        "keyframes": [{ "positions": start }, { "time": 6, "positions": target }, { "time": 12, "positions": last }],
        "segments": [segment, segment],
    });
    read_json(&text.to_string()).expect("the show is valid")
}

fn first_segment(scene: &Scene, choice: Option<Choice>) -> Arc<Performed> {
    let mut scene = scene.clone();
    let Segment::Transition(transition) = &mut scene.tracks[0].segments[0];
    transition.chosen = choice;
    finish(&mut Performer::default(), &scene, 0, None)
}

fn left(performed: &Performed) -> usize {
    performed.avoided.as_ref().expect("agents are kept apart").unsolved.len()
}

/// What auto finds best before anybody is kept apart.
fn own_choice(performed: &Performed) -> Choice {
    let tried = performed
        .candidates
        .iter()
        .filter(|candidate| !(candidate.choice.method == MethodName::Spectral && candidate.choice.sharing == 1.0));
    tried.min_by(|a, b| a.score.total_cmp(&b.score)).expect("auto tries some").choice
}

#[test]
fn auto_resorts_to_the_first_guide_that_can_be_kept_apart_or_to_the_one_that_leaves_fewest() {
    let halfway = |order, alignment| Choice { method: MethodName::Spectral, order, alignment, sharing: 1.0 };
    let straight = Choice { method: MethodName::Linear, ..halfway(Order::Greedy, Alignment::Procrustes) };
    let resorts = [
        straight,
        halfway(Order::Hungarian, Alignment::Procrustes),
        halfway(Order::Hungarian, Alignment::None),
        halfway(Order::Greedy, Alignment::Pca),
    ];
    for (slots, is_kept_apart) in [(MENDED, true), (HOPELESS, false)] {
        let scene = shuffled(0.7, "separate", slots);
        let taken = first_segment(&scene, None);
        let own = own_choice(&taken);
        let tried = std::iter::once(own)
            .chain(resorts.into_iter().filter(|choice| choice.method != own.method || own.method != MethodName::Linear));
        let counts: Vec<(Choice, usize)> = tried.map(|choice| (choice, left(&first_segment(&scene, Some(choice))))).collect();
        assert!(counts[0].1 > 0, "auto's own guide fails");
        let least = counts.iter().map(|(_, count)| *count).min();
        let expected = counts.iter().find(|(_, count)| Some(*count) == least).expect("one is the least");
        assert_eq!((taken.choice, left(&taken)), *expected, "{counts:?}");
        assert_eq!(least == Some(0), is_kept_apart);
        // The table marks it, with its own score, and nothing else.
        let marked: Vec<Choice> =
            taken.candidates.iter().filter(|candidate| candidate.is_chosen).map(|candidate| candidate.choice).collect();
        assert_eq!(marked, [taken.choice]);
    }
}

#[test]
fn auto_keeps_its_guide_where_it_holds_where_agents_pass_and_where_it_is_told() {
    let own = own_choice(&first_segment(&shuffled(0.7, "separate", MENDED), None));
    for (what, scene) in [("it holds", shuffled(0.2, "separate", MENDED)), ("agents pass on", shuffled(0.7, "smooth", MENDED))] {
        let performed = first_segment(&scene, None);
        assert_eq!(performed.choice, own_choice(&performed), "{what}");
    }
    let told = first_segment(&shuffled(0.7, "separate", MENDED), Some(own));
    assert_eq!(told.choice, own);
    assert!(left(&told) > 0);
}
