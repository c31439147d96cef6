//! The laws of agents that are not there.

use std::sync::Arc;

use eigenform::assignment::{AssignmentSpec, Cost, Question, assign};
use eigenform::choice::{Alignment, MethodName};
use eigenform::formation::Formation;
use eigenform::perform::{ComparedWay, Comparison, ComparisonJob, ComparisonStep, Performance, Performer, Seats, perform};
use eigenform::scene::{Scene, Segment, read_json, validate};
use glam::DVec2;

/// Three formations of eight in two groups, with ties and a minimum distance; 4 s from each to the next.
const SHOW: &str = r#"{
  "format": "eigenform", "version": 1, "frameRate": 10, "minimumDistance": 0.5, "join": "smooth",
  "groups": [{ "members": [0, 1, 6, 7], "tieWeight": 3 }, { "members": [2, 3] }],
  "adjacency": { "ties": [[0, 5, 4], [6, 7, 2]], "cuts": [[1, 2]] },
  "keyframes": [
    { "positions": [[0, 0], [2, 0], [4, 0.5], [0, 2], [2.2, 2], [4, 2], [1, 1], [9, 9]] },
    { "time": 4, "positions": [[5, 5], [3, 6], [7, 5], [5, 8], [3, 8.5], [7, 8], [5, 6], [9, 9]] },
    { "time": 8, "positions": [[0, 9], [2, 9], [4, 9.5], [0, 7], [2.2, 7], [4, 7], [1, 8], [9, 9]] }
  ]
}"#;

const METHODS: [MethodName; 6] =
    [MethodName::Linear, MethodName::Polar, MethodName::Shared, MethodName::Spectral, MethodName::Auto, MethodName::Crowd];

fn show(method: MethodName, absent: [&[u32]; 3]) -> Scene {
    let mut scene = read_json(SHOW).expect("the show is valid");
    for Segment::Transition(transition) in &mut scene.tracks[0].segments {
        (transition.method, transition.alignment, transition.avoidance) = (method, Alignment::Procrustes, true);
    }
    for (keyframe, absent) in scene.tracks[0].keyframes.iter_mut().zip(absent) {
        keyframe.absent = absent.to_vec();
    }
    validate(&scene).expect("the show stays valid");
    scene
}

/// The same show without agents 6 and 7.
fn without(method: MethodName) -> Scene {
    let mut scene = show(method, [&[]; 3]);
    let track = &mut scene.tracks[0];
    track.agents = Arc::new(track.agents[..6].to_vec());
    for keyframe in &mut track.keyframes {
        keyframe.positions = Arc::new(Formation::new(keyframe.positions.positions()[..6].to_vec()));
    }
    Arc::make_mut(&mut scene.groups)[0].members = vec![0, 1];
    Arc::make_mut(&mut scene.adjacency).ties.truncate(1);
    scene
}

fn performed(scene: &Scene) -> Performance {
    perform(scene).expect("the show can be performed")
}

#[test]
fn who_is_never_there_leaves_no_trace() {
    for method in METHODS {
        for by_groups in [false, true] {
            let [mut with, mut without] = [show(method, [&[6, 7]; 3]), without(method)];
            for scene in [&mut with, &mut without] {
                let Segment::Transition(transition) = &mut scene.tracks[0].segments[1];
                transition.hierarchy = by_groups;
            }
            let [with, without] = [performed(&with), performed(&without)];
            for (one, other) in with.segments().iter().zip(without.segments()) {
                assert_eq!(one.choice, other.choice, "{method:?}");
                assert_eq!(one.measures, other.measures, "{method:?}");
                assert_eq!(one.candidates, other.candidates, "{method:?}");
                assert_eq!(one.avoided, other.avoided, "{method:?}");
                assert_eq!(one.movement().0, other.movement().0, "{method:?}");
                for k in 0..one.motion.times().len() {
                    assert_eq!(one.motion.sample(k)[..6], *other.motion.sample(k), "{method:?}");
                }
            }
            for k in 0..=80 {
                let time = 0.1 * f64::from(k);
                assert_eq!(with.positions_at(time)[..6], without.positions_at(time), "{method:?} at {time}");
            }
        }
    }
}

#[test]
fn who_comes_or_goes_walks_and_everybody_stops_there() {
    for method in METHODS {
        let mut scene = show(method, [&[6], &[7], &[7]]);
        // What keeps apart may leave with a velocity of its own.
        for Segment::Transition(transition) in &mut scene.tracks[0].segments {
            transition.avoidance = false;
        }
        let performance = performed(&scene);
        for keyframe in &scene.tracks[0].keyframes {
            let found = performance.positions_at(keyframe.time);
            let due = keyframe.positions.positions();
            assert!(found.iter().zip(due).all(|(found, due)| found.distance(*due) < 1e-9), "{method:?} at {}", keyframe.time);
        }
        // The first transition is of all, the second without agent 7: they stop between.
        let [here, near] = [4.0, 4.001].map(|time| performance.positions_at(time));
        // Smooth timing eases: 3 · (0.001/4)² of ways below 10 m, and forces fade in no faster.
        assert!(here.iter().zip(&near).all(|(here, near)| here.distance(*near) < 1e-5), "{method:?}");
        assert_eq!(performance.absent_at(0.0), [6]);
        assert_eq!(performance.absent_at(2.0), [] as [u32; 0]);
        assert_eq!(performance.absent_at(4.0), [7]);
        assert_eq!(performance.absent_at(6.0), [7]);
    }
}

#[test]
fn numbers_name_agents_as_the_scene_does() {
    // Agents 6 and 7 change places through one another; 0 to 5 are not there.
    let mut scene = show(MethodName::Linear, [&[0, 1, 2, 3, 4, 5], &[0, 1, 2, 3, 4, 5], &[]]);
    let track = &mut scene.tracks[0];
    let places = |keyframe: usize, a: DVec2, b: DVec2| {
        let mut plan = track.keyframes[keyframe].positions.positions().to_vec();
        (plan[6], plan[7]) = (a, b);
        Arc::new(Formation::new(plan))
    };
    let [start, end] = [places(0, DVec2::ZERO, DVec2::X), places(1, DVec2::X, DVec2::ZERO)];
    (track.keyframes[0].positions, track.keyframes[1].positions) = (start, end);
    let Segment::Transition(transition) = &mut track.segments[0];
    transition.avoidance = false;
    let performance = performed(&scene);
    let first = &performance.segments()[0];
    assert_eq!(first.measures.clearance.map(|clearance| clearance.agents), Some((6, 7)));
    assert!([6, 7].contains(&first.measures.top_speed.agent));
    // Beside others who stand where they meet, nobody else counts.
    assert!(first.measures.clearance.is_some_and(|clearance| clearance.distance < 1e-9));
    let Segment::Transition(transition) = &mut scene.tracks[0].segments[0];
    transition.avoidance = true;
    let kept = performed(&scene);
    assert!(kept.segments()[0].avoided.as_ref().is_some_and(|avoided| avoided.unsolved.is_empty()));
    assert!(kept.segments()[0].measures.clearance.is_some_and(|clearance| clearance.agents == (6, 7) && clearance.distance > 0.5 - 1e-6));
}

#[test]
fn files_of_motion_hold_only_who_is_there() {
    let scene = show(MethodName::Linear, [&[6], &[7], &[7]]);
    let performance = performed(&scene);
    let csv = performance.to_csv();
    let rows = |frame: &str| csv.lines().filter(|line| line.starts_with(&format!("{frame},"))).count();
    assert_eq!([rows("0"), rows("1"), rows("40"), rows("41")], [7, 8, 7, 7]);
    assert!(performance.to_json_at(&[0.0]).ends_with("[1.0,1.0]],[null]]}") || performance.to_json_at(&[0.0]).contains("null,[9.0,9.0]"));
    assert_eq!(performance.to_json_at(&[2.0]).matches("null").count(), 0);
    assert_eq!(performance.to_json_at(&[6.0]).matches("null").count(), 1);
}

#[test]
fn nobody_is_tied_to_who_is_absent() {
    let scene = show(MethodName::Linear, [&[6], &[], &[]]);
    let graph = |keyframe: usize| Performer::default().graph(&scene, keyframe).expect("few ties");
    assert_eq!(graph(0).agent_count(), 8);
    assert!(graph(0).ties().iter().all(|tie| tie.a != 6 && tie.b != 6));
    assert!(graph(1).ties().iter().any(|tie| tie.a == 6 || tie.b == 6));
}

#[test]
fn modes_are_of_who_is_there() {
    let [mut with, without] = [show(MethodName::Linear, [&[6, 7]; 3]), without(MethodName::Linear)];
    for keyframe in 0..3 {
        let basis = |scene: &Scene| Performer::default().eigenbasis(scene, keyframe).expect("few ties");
        let [(one, there), (other, everybody)] = [basis(&with), basis(&without)];
        assert_eq!((one.eigenvalues(), one.modes()), (other.eigenvalues(), other.modes()));
        assert_eq!((&**there, &**everybody), (&[0, 1, 2, 3, 4, 5][..], &[0, 1, 2, 3, 4, 5][..]));
    }
    with.tracks[0].keyframes[1].absent = vec![0, 2];
    let (basis, there) = Performer::default().eigenbasis(&with, 1).expect("few ties");
    assert_eq!((basis.agent_count(), &**there), (6, &[1, 3, 4, 5, 6, 7][..]));
    // One piece, one mode of nothing: Delaunay ties reach everybody.
    assert!(basis.eigenvalues()[1] > 1e-6, "{:?}", basis.eigenvalues());
    with.tracks[0].keyframes[1].absent = (0..8).collect();
    let (basis, there) = Performer::default().eigenbasis(&with, 1).expect("few ties");
    assert_eq!((basis.agent_count(), there.len()), (0, 0));
}

#[test]
fn an_empty_stage_is_none_the_worse() {
    let all: &[u32] = &[0, 1, 2, 3, 4, 5, 6, 7];
    for method in METHODS {
        for absent in [[all, all, &[]], [&[], all, &[]], [all, all, all], [&all[1..], &all[1..], &[]]] {
            let performance = performed(&show(method, absent));
            performance.for_each_frame(|_, _, places| assert!(places.plan().iter().all(|place| place.is_finite())));
        }
    }
}

/// One transition compared, as text.
fn compared(scene: &Scene, segment: usize, asked: Comparison) -> String {
    let (mut performer, mut seats) = (Performer::default(), Seats::default());
    let mut job = ComparisonJob::new(scene, segment, asked, &mut seats).expect("nothing is locked");
    loop {
        if let ComparisonStep::Done(mut compared) = job.step(&mut performer, &mut seats).expect("it can be performed") {
            compared.cost = Cost::Keep;
            return serde_json::to_string(&compared).expect("numbers are JSON");
        }
    }
}

#[test]
fn compared_under_a_cost_who_takes_the_place_of_an_absent_agent_is_absent() {
    let spec = AssignmentSpec { cost: Cost::Euclidean, ..Default::default() };
    let mut others_are_gone = false;
    for absent in [[&[][..], &[2], &[2, 5]], [&[6], &[7], &[7]], [&[1, 6], &[0, 6], &[]]] {
        let scene = show(MethodName::Linear, absent);
        for segment in [0, 1] {
            let keyframes = &scene.main_track().keyframes;
            let (source, target) = (&*keyframes[segment].positions, &*keyframes[segment + 1].positions);
            let takes = assign(&Question { source, target, spec: &spec, sections: &[], is_flipped: false, is_predicted: false });
            let takes = takes.expect("nothing is locked");
            let mut taken = scene.clone();
            for keyframe in &mut taken.tracks[0].keyframes[segment + 1..] {
                keyframe.positions = Arc::new(keyframe.positions.only(takes.targets()));
                keyframe.absent = (0..8).filter(|agent| keyframe.absent.contains(&takes.targets()[*agent as usize])).collect();
            }
            let gone = |scene: &Scene| scene.main_track().keyframes[segment + 1].absent.clone();
            others_are_gone |= gone(&taken) != gone(&scene);
            for name in ["linear", "spectral", "crowd", "social-force", "orca"] {
                let asked = Comparison { way: ComparedWay::named(name).expect("a way"), cost: Cost::Euclidean, pace: None };
                let kept = Comparison { cost: Cost::Keep, ..asked };
                assert_eq!(compared(&scene, segment, asked), compared(&taken, segment, kept), "{name}, absent {absent:?}");
            }
        }
    }
    assert!(others_are_gone, "somebody takes the place of an absent agent");
}
