//! What avoidance promises, whatever the guide.

mod around;
mod rooms;
mod through;

use eigenform::edits::{Avoidance, AvoidanceJob, AvoidanceStep, Edited};
use eigenform::motion::{Motion, clashes, sample_times};
use glam::DVec2;
use proptest::prelude::*;

const DISTANCE: f64 = 0.5;

fn avoidance() -> Avoidance {
    Avoidance { minimum_distance: DISTANCE, is_clamped: [false; 2], seed: 7, obstacles: Vec::new(), holds: Vec::new(), groups: Vec::new() }
}

fn edited(avoidance: Avoidance, guide: &Motion) -> Edited {
    let mut job = AvoidanceJob::new(avoidance, guide.clone());
    let mut progress = 0.0;
    loop {
        match job.step() {
            AvoidanceStep::Progress(now) => {
                assert!((progress..=1.0).contains(&now), "progress never falls: {progress}, then {now}");
                progress = now;
            }
            AvoidanceStep::Done(edited) => return *edited,
        }
    }
}

fn last(motion: &Motion) -> usize {
    motion.times().len() - 1
}

/// Straight ways that ease at both ends, at 30 frames a second.
fn straight(source: &[DVec2], target: &[DVec2]) -> Motion {
    let times = sample_times(0.0, 6.0, 30.0);
    let eased = |time: f64| (time / 6.0) * (time / 6.0) * (3.0 - time / 3.0);
    let positions = times.iter().flat_map(|time| source.iter().zip(target).map(move |(from, to)| from.lerp(*to, eased(*time)))).collect();
    Motion::new(times, source.len(), positions)
}

/// Agents on a lattice of 1.2 m that change places at random.
fn guides() -> impl Strategy<Value = Motion> {
    (2_usize..16).prop_flat_map(|count| {
        let slots: Vec<usize> = (0..36).collect();
        (Just(count), Just(slots.clone()).prop_shuffle(), Just(slots).prop_shuffle()).prop_map(|(count, from, to)| {
            let at = |slot: usize| DVec2::new((slot % 6) as f64, (slot / 6) as f64) * 1.2;
            let places = |slots: &[usize]| slots[..count].iter().map(|slot| at(*slot)).collect::<Vec<_>>();
            straight(&places(&from), &places(&to))
        })
    })
}

#[test]
fn whom_keyframes_have_too_near_come_no_nearer_on_the_way() {
    let block: Vec<DVec2> = (0..16).map(|agent| DVec2::new(f64::from(agent / 4), f64::from(agent % 4))).collect();
    let moved: Vec<DVec2> = block.iter().map(|place| *place + DVec2::new(10.0, 0.0)).collect();
    let guide = straight(&block, &moved);
    for minimum_distance in [1.2, 2.0, 5.0, 20.0] {
        let Edited { motion, report, .. } = edited(Avoidance { minimum_distance, ..avoidance() }, &guide);
        let nearest = clashes(&motion, minimum_distance).iter().map(|clash| clash.distance).fold(f64::INFINITY, f64::min);
        assert!(nearest > 1.0 - 1e-6, "{nearest} m at a distance of {minimum_distance} m");
        assert!(motion.top_speed() < 2.0 * guide.top_speed(), "{} m/s at a distance of {minimum_distance} m", motion.top_speed());
        assert!(!report.is_solved() && !report.breaches.is_empty());
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]

    #[test]
    fn solved_is_proved_and_keyframes_stay(guide in guides()) {
        let result = edited(avoidance(), &guide);
        prop_assert_eq!(clashes(&result.motion, DISTANCE - 1e-6), result.report.unsolved.clone());
        for k in [0, last(&guide)] {
            prop_assert_eq!(result.motion.sample(k), guide.sample(k));
        }
        prop_assert_eq!(result.motion.times(), guide.times());
        prop_assert!(result.motion.positions().iter().all(|p| p.is_finite()));
    }

    #[test]
    fn the_same_guide_gives_the_same_motion(guide in guides()) {
        prop_assert_eq!(edited(avoidance(), &guide).motion, edited(avoidance(), &guide).motion);
    }

    #[test]
    fn a_guide_without_a_clash_is_returned_as_it_is(guide in guides()) {
        if clashes(&guide, DISTANCE - 1e-6).is_empty() {
            let result = edited(avoidance(), &guide);
            prop_assert_eq!(&result.motion, &guide);
            prop_assert!(result.deviation.is_none() && result.report.rung == 0);
        }
    }
}

/// Two who change places, and somebody far away who walks alone.
fn crossing() -> Motion {
    let [west, east, far] = [DVec2::new(-4.0, 0.0), DVec2::new(4.0, 0.0), DVec2::new(0.0, 60.0)];
    straight(&[west, east, far], &[east, west, far + DVec2::X * 5.0])
}

#[test]
fn only_those_who_clash_are_moved_and_only_near_the_clash() {
    let guide = crossing();
    let result = edited(avoidance(), &guide);
    assert!(result.report.is_solved());
    let shift = |k: usize, agent: usize| result.motion.sample(k)[agent].distance(guide.sample(k)[agent]);
    assert!((0..=last(&guide)).all(|k| shift(k, 2) == 0.0), "nobody comes near the third");
    // Each steps aside by half the distance and a margin.
    let widest = (0..=last(&guide)).map(|k| shift(k, 0)).fold(0.0, f64::max);
    assert!((0.25..0.3).contains(&widest), "{widest}");
}

/// Two blocks that cross in the middle, the second's way turned by `angle` degrees from the first's.
fn blocks(columns: usize, spacing: f64, distance_apart: f64, angle: f64) -> Motion {
    let half = 0.5 * (columns - 1) as f64 * spacing;
    let block = (0..columns * columns).map(|k| DVec2::new((k % columns) as f64, (k / columns) as f64) * spacing - DVec2::splat(half));
    let block: Vec<DVec2> = block.collect();
    let at = |middle: DVec2| block.iter().map(move |p| *p + middle);
    let [west, other] = [DVec2::X, DVec2::from_angle(angle.to_radians())].map(|way| -distance_apart * way);
    straight(&at(west).chain(at(other)).collect::<Vec<_>>(), &at(-west).chain(at(-other)).collect::<Vec<_>>())
}

#[test]
fn blocks_pass_through_one_another_and_are_whole_again() {
    // By half their spacing of 2 m and by less, end-on, at right angles and between; and the spacing of a drill field.
    let cases = [
        (8, 2.0, 16.0, 180.0, 0.5),
        (8, 2.0, 16.0, 180.0, 1.0),
        (8, 2.0, 16.0, 90.0, 0.5),
        (8, 2.0, 16.0, 90.0, 1.0),
        (8, 2.0, 24.0, 90.0, 1.0),
        (10, 1.143, 16.0, 90.0, 0.5),
        (6, 2.0, 14.0, 135.0, 0.5),
    ];
    for (columns, spacing, apart, angle, minimum_distance) in cases {
        let guide = blocks(columns, spacing, apart, angle);
        let result = edited(Avoidance { minimum_distance, ..avoidance() }, &guide);
        let case = format!("{columns} × {columns} at {spacing} m, {angle}°, {minimum_distance} m: {:?}", result.report.deviation);
        assert!(result.report.is_solved() && clashes(&result.motion, minimum_distance - 1e-6).is_empty(), "{case}");
        assert_eq!(result.motion.sample(last(&guide)), guide.sample(last(&guide)), "{case}");
        assert!(result.motion.top_speed() <= 1.5 * guide.top_speed(), "{case}");
    }
}

#[test]
fn a_ring_changes_sides_as_a_roundabout() {
    let ring: Vec<DVec2> = (0..40).map(|k| DVec2::from_angle(f64::from(k) / 40.0 * std::f64::consts::TAU) * 10.0).collect();
    let result = edited(avoidance(), &straight(&ring, &ring.iter().map(|p| -*p).collect::<Vec<_>>()));
    assert!(result.report.is_solved() && result.report.deviation[1] < 0.25 * 20.0, "{:?}", result.report.deviation);
}

#[test]
fn other_labels_are_solved_as_well() {
    let circle: Vec<DVec2> = (0..9).map(|k| DVec2::from_angle(f64::from(k) * 0.7) * (2.0 + f64::from(k % 3))).collect();
    let across: Vec<DVec2> = circle.iter().map(|p| -*p * 1.1).collect();
    for shift in 0..9 {
        let relabeled = |points: &[DVec2]| (0..9).map(|k| points[(k * 4 + shift) % 9]).collect::<Vec<_>>();
        let result = edited(avoidance(), &straight(&relabeled(&circle), &relabeled(&across)));
        assert!(result.report.is_solved(), "labels {shift}: {:?}", result.report.unsolved);
    }
}

#[test]
fn a_clamped_end_keeps_its_velocity() {
    // They meet right after the start, so that a free end would set out aside at once.
    let [west, east] = [DVec2::new(-0.6, 0.0), DVec2::new(0.6, 0.0)];
    let guide = straight(&[west, east], &[east * 5.0, west * 5.0]);
    let start_speed = |is_clamped| {
        let result = edited(Avoidance { is_clamped, ..avoidance() }, &guide);
        assert!(result.report.is_solved());
        let deviation = result.deviation.expect("they were moved");
        let instant = 1e-6;
        let mut at = [DVec2::ZERO; 2];
        deviation.add_to(guide.times()[0] + instant, &mut at, None);
        at[0].length() / instant
    };
    // A clamped cubic starts with u''/2 t²: a millionth of a second at any sane acceleration.
    assert!(start_speed([true, false]) < 1e-4);
    assert!(start_speed([false, false]) > 1e-2);
}

#[test]
fn between_frames_the_motion_is_as_smooth_and_at_frames_the_same() {
    let guide = crossing();
    let result = edited(avoidance(), &guide);
    let deviation = result.deviation.expect("they were moved");
    for (k, time) in guide.times().iter().enumerate() {
        let mut at = guide.sample(k).to_vec();
        deviation.add_to(*time, &mut at, None);
        assert_eq!(at, result.motion.sample(k));
    }
}

#[test]
fn a_keyframe_that_is_too_near_is_reported_and_stays() {
    let [a, b, far] = [DVec2::ZERO, DVec2::new(0.3, 0.0), DVec2::new(8.0, 0.0)];
    let guide = straight(&[a, b, far], &[DVec2::new(8.0, 2.0), DVec2::new(8.0, -2.0), a]);
    let result = edited(avoidance(), &guide);
    assert!(!result.report.is_solved());
    let breach = result.report.breaches[0];
    assert_eq!((breach.end, breach.agent, breach.distance), (0, 0, 0.3));
    assert_eq!(result.motion.sample(0), guide.sample(0));
    // The others are kept apart all the same.
    assert!(result.report.unsolved.iter().all(|clash| clash.agents == (0, 1)), "{:?}", result.report.unsolved);
}

#[test]
fn nobody_one_agent_and_an_instant_have_an_answer() {
    for (count, times) in [(0, vec![0.0, 1.0]), (1, vec![0.0, 1.0]), (2, vec![0.0, 1.0]), (2, vec![0.0, 0.5, 1.0])] {
        let positions = (0..count * times.len()).map(|k| DVec2::new(k as f64, 0.0)).collect();
        let guide = Motion::new(times, count, positions);
        assert_eq!(edited(avoidance(), &guide).motion, guide);
    }
}
