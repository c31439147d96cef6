//! What avoidance promises in rooms with walls all around, which doors join or nothing does.

use eigenform::edits::{Avoidance, Edited, Outline};
use eigenform::motion::{Motion, clashes};
use eigenform::perform::perform;
use eigenform::scene::read_json;
use glam::DVec2;
use proptest::prelude::*;
use serde_json::json;

use super::around::clearance;
use super::{DISTANCE, avoidance, edited, last, straight};

/// Half of what the room measures inside, meters.
const ROOM: DVec2 = DVec2::new(10.0, 6.0);
const THICKNESS: f64 = 0.3;

fn wall(low: [f64; 2], high: [f64; 2]) -> Outline {
    Outline { points: vec![low, [high[0], low[1]], high, [low[0], high[1]]], radius: 0.0 }
}

/// Four walls about everything, sealed.
fn outer() -> Vec<Outline> {
    let (inner, out) = (ROOM, ROOM + THICKNESS);
    vec![
        wall([-out.x, -out.y], [out.x, -inner.y]),
        wall([-out.x, inner.y], [out.x, out.y]),
        wall([-out.x, -out.y], [-inner.x, out.y]),
        wall([inner.x, -out.y], [out.x, out.y]),
    ]
}

/// From one side of the room to the other, at `x`, save for doors from so far to so far up.
fn across(x: f64, doors: &[[f64; 2]]) -> Vec<Outline> {
    let ends = std::iter::once(-ROOM.y).chain(doors.iter().flatten().copied()).chain([ROOM.y]);
    let pieces: Vec<f64> = ends.collect();
    pieces.chunks_exact(2).map(|piece| wall([x - 0.5 * THICKNESS, piece[0]], [x + 0.5 * THICKNESS, piece[1]])).collect()
}

/// Likewise at the height `y`.
fn along(y: f64, doors: &[[f64; 2]]) -> Vec<Outline> {
    let ends = std::iter::once(-ROOM.x).chain(doors.iter().flatten().copied()).chain([ROOM.x]);
    let pieces: Vec<f64> = ends.collect();
    pieces.chunks_exact(2).map(|piece| wall([piece[0], y - 0.5 * THICKNESS], [piece[1], y + 0.5 * THICKNESS])).collect()
}

fn block(x: f64, y: f64, columns: u32, rows: u32) -> Vec<DVec2> {
    let from_middle = |k: u32, count: u32| f64::from(k) - 0.5 * f64::from(count - 1);
    let at = |k: u32| DVec2::new(x + from_middle(k % columns, columns), y + from_middle(k / columns, rows));
    (0..columns * rows).map(at).collect()
}

/// Checks what holds whatever comes of it.
fn kept_apart(guide: &Motion, obstacles: &[Outline]) -> Result<Edited, TestCaseError> {
    let result = edited(Avoidance { obstacles: obstacles.to_vec(), ..avoidance() }, guide);
    for k in [0, last(guide)] {
        prop_assert_eq!(result.motion.sample(k), guide.sample(k), "keyframes stay");
    }
    let least = obstacles.iter().map(|outline| clearance(&result.motion, outline)).fold(f64::INFINITY, f64::min);
    let keeps = clashes(&result.motion, DISTANCE - 1e-6).is_empty() && least >= DISTANCE - 1e-6;
    prop_assert_eq!(keeps, result.report.is_solved(), "solved is proved: {}", least);
    // Not solved, nobody runs three times as fast as the guide for as much farther as there is to go: twice across the room at most.
    let longest = guide.sample(0).iter().zip(guide.sample(last(guide))).map(|(from, to)| from.distance(*to)).fold(0.0, f64::max);
    let stretch = (4.0 * (ROOM.x + ROOM.y) / longest).max(1.0);
    prop_assert!(keeps || result.motion.top_speed() <= (3.0 * stretch * guide.top_speed()).max(2.0), "{} m/s", result.motion.top_speed());
    Ok(result)
}

#[test]
fn formations_go_through_doors_that_do_not_lie_on_their_way() {
    let two_doors = [outer(), across(-3.0, &[[2.0, 4.0]]), across(3.0, &[[-4.0, -2.0]])].concat();
    let four_rooms = [outer(), across(0.0, &[[-4.0, -2.0], [2.0, 4.0]]), along(0.0, &[[-6.0, -4.0], [4.0, 6.0]])].concat();
    let exchange = |a: Vec<DVec2>, b: Vec<DVec2>| straight(&[&a[..], &b].concat(), &[&b[..], &a].concat());
    for (what, obstacles, guide) in [
        ("a block, one door after the other", two_doors, straight(&block(-8.0, 0.0, 2, 4), &block(8.0, 0.0, 2, 4))),
        ("two that change places, each through doors of its own", four_rooms, exchange(block(-5.0, -3.0, 3, 2), block(5.0, 3.0, 3, 2))),
    ] {
        let result = kept_apart(&guide, &obstacles).expect(what);
        assert!(result.report.is_solved(), "{what}: {:?} {:?}", result.report.blocked, result.report.unsolved);
    }
}

#[test]
fn who_does_not_get_through_in_time_goes_through_no_wall_and_is_not_flung_about() {
    // Far more than the doors have room for.
    let beside = [outer(), across(0.0, &[[4.0, 5.4]])].concat();
    let both_ways = [outer(), across(0.0, &[[-1.0, 1.0]])].concat();
    let exchange = [block(-5.0, 0.0, 4, 4), block(5.0, 0.0, 4, 4)];
    let [a, b] = &exchange;
    for (what, obstacles, guide) in [
        ("a block past a corner", beside, straight(a, b)),
        ("two blocks through one door", both_ways, straight(&[&a[..], b].concat(), &[&b[..], a].concat())),
    ] {
        let result = kept_apart(&guide, &obstacles).expect(what);
        assert!(!result.report.is_solved() && result.report.shut_off.is_empty(), "{what}");
        let through = result.report.blocked.iter().filter(|at| at.distance < 0.0).count();
        assert_eq!(through, 0, "{what}: {:?}", result.report.blocked);
        let inside = |place: &DVec2| place.abs().cmple(ROOM).all();
        assert!(result.motion.positions().iter().all(inside), "{what}: nobody leaves the room");
    }
}

#[test]
fn whom_walls_shut_off_are_all_named_and_whoever_stays_in_their_part_keeps_apart() {
    let obstacles = [outer(), across(0.0, &[])].concat();
    // Eight are to go to the other part; eight change places in theirs.
    let (crossing, staying) = (block(-7.0, 0.0, 2, 4), block(-4.0, 0.0, 2, 4));
    let turned: Vec<DVec2> = staying.iter().rev().copied().collect();
    let guide = straight(&[&crossing[..], &staying].concat(), &[&block(5.0, 0.0, 2, 4)[..], &turned].concat());
    let result = kept_apart(&guide, &obstacles).expect("it is checked");
    let named: Vec<u32> = result.report.shut_off.iter().map(|shut| shut.agent).collect();
    assert_eq!(named, (0..8).collect::<Vec<_>>());
    assert!(result.report.shut_off.iter().all(|shut| shut.obstacle == 4), "the wall between: {:?}", result.report.shut_off);
    assert_eq!(result.report.blocked_on_the_way().count(), 0);
    let among_those_who_stay = |clash: &eigenform::motion::Approach| clash.agents.0 >= 8;
    assert!(!result.report.unsolved.iter().any(among_those_who_stay), "{:?}", result.report.unsolved);
}

#[test]
fn a_crowd_goes_through_a_door_at_the_pace_of_a_crowd() {
    let outlines = [outer(), across(0.0, &[[-1.0, 1.0]])].concat();
    let obstacles: Vec<_> = outlines.iter().map(|outline| json!({ "kind": "polygon", "points": outline.points })).collect();
    let places = |x: f64| block(x, 0.0, 4, 4).iter().map(DVec2::to_array).collect::<Vec<_>>();
    let scene = json!({
        "format": "eigenform", "version": 1, "minimumDistance": DISTANCE, "obstacles": obstacles,
        "keyframes": [{ "positions": places(-5.0) }, { "time": 8, "positions": places(5.0) }],
        "segments": [{ "method": "crowd", "avoidance": true }]
    });
    let performance = perform(&read_json(&scene.to_string()).expect("the scene is valid")).expect("it can be performed");
    let performed = &performance.segments()[0];
    let avoided = performed.avoided.as_ref().expect("it is kept apart");
    assert!(avoided.unsolved.is_empty() && avoided.blocked.is_empty(), "{:?} {:?}", avoided.unsolved, avoided.blocked);
    // 10 m in 8 s, eased, are 1.9 m/s at the most; those in the corners have 12 % farther to go.
    assert!(performed.motion.top_speed() < 3.0, "{}", performed.motion.top_speed());
}

#[test]
fn who_stands_too_near_to_a_wall_and_who_only_returns_are_led_nowhere() {
    let outlines = [outer(), across(2.0, &[[-4.0, -2.0]]), vec![wall([-1.0, -1.0], [1.0, 1.0])]].concat();
    let obstacles: Vec<_> = outlines.iter().map(|outline| json!({ "kind": "polygon", "points": outline.points })).collect();
    // One stands 0.2 m from the block in the middle; one goes around it, along a path, to where it began; two change places.
    for path in [json!(null), json!([[-6.0, 0.0], [6.0, 0.0], [6.0, -5.0], [-6.0, 0.01]])] {
        for method in ["linear", "spectral", "crowd"] {
            let scene = json!({
                "format": "eigenform", "version": 1, "minimumDistance": DISTANCE, "obstacles": obstacles,
                "keyframes": [
                    { "positions": [[0, 1.2], [-5, -3], [5, -3], [-4, 0]] },
                    { "time": 8, "positions": [[0, 1.2], [5, -3], [-5, -3], [-4, 0]] }
                ],
                "segments": [{ "method": method, "path": path, "avoidance": true }]
            });
            let performance = perform(&read_json(&scene.to_string()).expect("the scene is valid")).expect("it can be performed");
            let motion = &performance.segments()[0].motion;
            assert!(motion.positions().iter().all(|place| place.is_finite()), "{method}, {path}");
        }
    }
}

/// A place in the room, clear of the wall across and of others by what is kept.
fn places(count: usize) -> impl Strategy<Value = Vec<DVec2>> {
    let slots: Vec<DVec2> = [block(-5.0, 0.0, 8, 10), block(5.0, 0.0, 8, 10)].concat();
    Just(slots).prop_shuffle().prop_map(move |slots| slots[..count].to_vec())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(8))]

    #[test]
    fn whoever_goes_wherever_in_a_room_of_two_parts(from in places(9), to in places(9), door in -5.0..4.0, width in 0.0..2.0) {
        let doors: &[[f64; 2]] = if width < 0.5 { &[] } else { &[[door, door + width]] };
        let result = kept_apart(&straight(&from, &to), &[outer(), across(0.0, doors)].concat())?;
        prop_assert!(result.motion.positions().iter().all(|place| place.is_finite()));
        // Everybody is shut off who changes sides, or nobody.
        let crossing = from.iter().zip(&to).filter(|(from, to)| from.x * to.x < 0.0).count();
        let shut = result.report.shut_off.len();
        prop_assert!(shut == 0 || shut == crossing, "{} of {}", shut, crossing);
        prop_assert!(shut == 0 || width < 2.0 * DISTANCE + 0.01);
    }
}
