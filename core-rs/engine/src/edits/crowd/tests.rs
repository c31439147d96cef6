use eigenform_force::{Constants, Feedback, NO_GROUP};
use glam::DVec2;

use super::{Aim, CrowdJob, CrowdRules, CrowdStep, Ending, Led};
use crate::edits::Outline;
use crate::motion::{Motion, closeness, sample_times};

const SECONDS: f64 = 6.0;

/// Straight ways that ease at both ends, at 30 frames a second.
fn straight(source: &[DVec2], target: &[DVec2]) -> Motion {
    let times = sample_times(1.0, 1.0 + SECONDS, 30.0);
    let eased = |time: f64| ((time - 1.0) / SECONDS).powi(2) * (3.0 - 2.0 * (time - 1.0) / SECONDS);
    let positions = times.iter().flat_map(|time| source.iter().zip(target).map(move |(from, to)| from.lerp(*to, eased(*time)))).collect();
    Motion::new(times, source.len(), positions)
}

/// Two rows of eight, a meter apart, that go straight through each other.
fn crossing() -> Motion {
    let row = |x: f64| (0..8).map(move |k| DVec2::new(x, f64::from(k))).collect::<Vec<_>>();
    straight(&[row(0.0), row(4.5)].concat(), &[row(4.5), row(0.0)].concat())
}

fn rules(agent_count: usize) -> CrowdRules {
    CrowdRules {
        constants: Constants::default(),
        feedback: Feedback { direction: true, speed: true },
        unit: 1.0,
        radius: vec![0.25; agent_count],
        top_speed: vec![f64::INFINITY; agent_count],
        group: (0..agent_count).map(|agent| u32::from(agent >= agent_count / 2)).collect(),
        obstacles: Vec::new(),
        clearance: 0.0,
        seed: 5,
        #[cfg(feature = "comparison")]
        is_reciprocal: false,
        aim: Aim::Guide,
        ending: Ending::Exact,
        waits: false,
        pace: None,
    }
}

fn led(rules: CrowdRules, guide: &Motion) -> Led {
    let mut job = CrowdJob::new(rules, guide.clone());
    let mut last = 0.0;
    loop {
        match job.step() {
            CrowdStep::Progress(now) => {
                assert!((last..=1.0).contains(&now), "progress never falls: {last}, then {now}");
                last = now;
            }
            CrowdStep::Done(led) => return *led,
        }
    }
}

fn farthest(motion: &Motion, other: &Motion, k: usize) -> f64 {
    farthest_from(motion, k, other.sample(k))
}

fn farthest_from(motion: &Motion, k: usize, places: &[DVec2]) -> f64 {
    motion.sample(k).iter().zip(places).map(|(p, q)| p.distance(*q)).fold(0.0, f64::max)
}

#[test]
fn everybody_arrives_exactly_and_with_the_guides_velocity() {
    let guide = crossing();
    let last = guide.times().len() - 1;
    for ending in [Ending::Exact, Ending::Smoothed(0.5)] {
        let led = led(CrowdRules { ending, ..rules(16) }, &guide);
        assert_eq!((farthest(&led.motion, &guide, 0), farthest(&led.motion, &guide, last)), (0.0, 0.0), "{ending:?}");
        assert!(led.distance[1] > 0.05, "they meet, and forces part them");
        for (end, inward) in [(0.0, 1.0), (SECONDS, -1.0)] {
            let mut added = vec![DVec2::ZERO; 16];
            led.deviation.add_to(1.0 + end + 1e-4 * inward, &mut added, None);
            // Without velocity at the ends what is added grows with the square of the time: by less than 20 m/s² here.
            assert!(added.iter().all(|added| added.length() < 10.0 * 1e-8), "{ending:?} at {end}");
        }
    }
}

#[test]
fn forces_keep_agents_farther_apart_than_their_guide_does() {
    let nearest = |motion: &Motion| closeness(motion, 0.0).nearest().expect("there are many").distance;
    let guide = crossing();
    let raw = led(rules(16), &guide);
    assert!(nearest(&guide) < 0.1 && nearest(&raw.motion) > 0.2, "{} {}", nearest(&guide), nearest(&raw.motion));
    let smooth = led(CrowdRules { ending: Ending::Smoothed(0.5), ..rules(16) }, &guide);
    assert!(nearest(&smooth.motion) >= nearest(&raw.motion).min(0.5));
}

#[test]
fn the_same_crowd_gives_the_same_motion_and_another_seed_another() {
    let guide = crossing();
    let shaken = |seed: u32| {
        let constants = Constants { fluctuation: 0.5, ..Constants::default() };
        led(CrowdRules { constants, seed, ..rules(16) }, &guide).motion
    };
    assert_eq!(shaken(5), shaken(5));
    assert_ne!(shaken(5), shaken(6));
}

#[test]
fn who_is_alone_stays_on_the_guide() {
    let guide = straight(&[DVec2::ZERO], &[DVec2::new(10.0, 3.0)]);
    let alone = led(CrowdRules { group: vec![NO_GROUP], ..rules(1) }, &guide);
    // Looking half a second ahead cuts the corners of its speed: half of 1.75 m/s² times 0.5 s × 0.5 s, at the most.
    assert!(alone.distance[1] < 0.5 * 1.75 * 0.25, "{:?}", alone.distance);
}

#[test]
fn who_cannot_arrive_at_its_top_speed_goes_as_fast_as_need_be_and_who_can_keeps_to_it() {
    let guide = straight(&[DVec2::ZERO], &[DVec2::new(20.0, 0.0)]);
    let fastest = |top_speed: f64| {
        let alone = led(CrowdRules { group: vec![NO_GROUP], top_speed: vec![top_speed], ..rules(1) }, &guide);
        assert_eq!(farthest(&alone.motion, &guide, guide.times().len() - 1), 0.0, "it arrives");
        alone.motion.top_speed()
    };
    // The guide eases and so is faster in its middle than an even pace; nobody has to outrun it who goes its way evenly.
    for top_speed in [0.5, 2.0, 3.0] {
        assert!(fastest(top_speed) < guide.top_speed(), "{top_speed}: {} and {}", fastest(top_speed), guide.top_speed());
    }
    // An even pace is 3.33 m/s: who may go at 4.5 m/s has time to spare.
    assert!(fastest(4.5) < 1.01 * 4.5, "{}", fastest(4.5));
}

#[test]
fn who_hurries_is_never_faster_than_the_way_left_asks_for_whoever_is_in_the_way() {
    let guide = crossing();
    let limits: Vec<f64> = (0..16).map(|agent| if agent % 3 == 0 { 0.4 } else { f64::INFINITY }).collect();
    let motion = led(CrowdRules { top_speed: limits.clone(), ..rules(16) }, &guide).motion;
    let (times, last) = (motion.times(), motion.times().len() - 1);
    // Until the last second leads back onto the guide; two fifths of that are what they have to be there in.
    for k in (1..=last).take_while(|k| times[last] - times[k - 1] > 1.0 + 1e-9) {
        for agent in (0..16).filter(|agent| limits[*agent].is_finite()) {
            let speed = motion.sample(k)[agent].distance(motion.sample(k - 1)[agent]) / (times[k] - times[k - 1]);
            let left = motion.sample(k - 1)[agent].distance(guide.sample(last)[agent]) / (times[last] - times[k - 1] - 0.6);
            // Edits see guides in grains of 2⁻²⁰ m: at most half of one along each axis, here and at the sample before, in a thirtieth of
            // a second.
            let grain = 30.0 * 2.0_f64.sqrt() * 2.0_f64.powi(-20);
            assert!(speed <= limits[agent].max(left) + 2.0 * grain, "{agent} at {k}: {speed} m/s, {left} m/s");
        }
    }
}

/// Four walls about the middle, without a gap.
fn room() -> Vec<Outline> {
    let wall = |x: [f64; 2], y: [f64; 2]| Outline { points: vec![[x[0], y[0]], [x[1], y[0]], [x[1], y[1]], [x[0], y[1]]], radius: 0.0 };
    let [low, high, whole] = [[-4.0, -3.5], [3.5, 4.0], [-4.0, 4.0]];
    vec![wall(whole, low), wall(whole, high), wall(low, whole), wall(high, whole)]
}

#[test]
fn whom_walls_shut_off_is_led_as_if_they_were_not_there() {
    let source: Vec<DVec2> = (0..12).map(|k| DVec2::new(f64::from(k % 4) - 1.5, f64::from(k / 4) - 1.0)).collect();
    let guide = straight(&source, &source.iter().map(|p| *p + DVec2::X * 12.0).collect::<Vec<_>>());
    let walked = |obstacles: Vec<Outline>| led(CrowdRules { obstacles, clearance: 0.5, ..rules(12) }, &guide).motion;
    assert_eq!(walked(room()), walked(Vec::new()));
}

#[test]
fn walls_rush_nobody_whom_they_shut_off() {
    // One to go out of the room, one to come into it, and one with a limit.
    let guide =
        straight(&[DVec2::ZERO, DVec2::new(12.0, 2.0), DVec2::new(0.0, -2.0)], &[DVec2::X * 12.0, DVec2::Y * 2.0, DVec2::new(-12.0, -2.0)]);
    let top_speed = vec![f64::INFINITY, f64::INFINITY, 1.0];
    let rules = CrowdRules { group: vec![NO_GROUP; 3], obstacles: room(), clearance: 0.5, top_speed, ..rules(3) };
    let led = led(rules, &guide);
    // Nobody wants to be faster than half as fast again as the fastest on the guide, and who is pushed by nobody is no faster than that.
    // The last second takes back what they are off the guide there: a cubic step falls by one and a half of that a second.
    let stretch = led.motion.times().len() - 31;
    let left = (stretch..led.motion.times().len()).map(|k| farthest(&led.motion, &guide, k)).fold(0.0, f64::max);
    assert!(led.motion.top_speed() < 1.5 * guide.top_speed() + 1.5 * left, "{} {}", led.motion.top_speed(), guide.top_speed());
    assert!(left < 0.5 * guide.top_speed(), "{left}: less than what a look ahead of half a second is");
}

#[test]
fn plain_forces_leave_agents_where_they_are_and_say_how_far_that_is() {
    let guide = crossing();
    let plain = CrowdRules { aim: Aim::Target, ending: Ending::AsItComes, waits: true, ..rules(16) };
    let led = led(plain, &guide);
    let last = guide.times().len() - 1;
    assert!((farthest(&led.motion, &guide, last) - led.arrival_error[1]).abs() < 1e-12);
    assert!(led.arrived_after.is_none_or(|seconds| seconds > 0.5 * SECONDS));
}

#[test]
#[cfg(feature = "comparison")]
fn with_free_arrival_it_is_over_once_everybody_is_there() {
    let guide = crossing();
    // The guide stands at its end for twice its time.
    let times = sample_times(1.0, 1.0 + 3.0 * SECONDS, 30.0);
    let last = guide.times().len() - 1;
    let positions = (0..times.len()).flat_map(|k| guide.sample(k.min(last)).to_vec()).collect();
    let standing = Motion::new(times, 16, positions);
    for (aim, is_reciprocal) in [(Aim::Guide, false), (Aim::Target, false), (Aim::Target, true)] {
        let free = CrowdRules { aim, is_reciprocal, ending: Ending::AsItComes, waits: true, pace: Some(1.5), ..rules(16) };
        let led = led(free, &standing);
        let over = led.motion.times().len() - 1;
        let seconds = led.motion.times()[over] - 1.0;
        // 4.5 m at 1.5 m/s take 3 s.
        assert!((3.0 - 0.5..3.0 * SECONDS).contains(&seconds) && led.arrived_after == Some(seconds), "{aim:?} {seconds}");
        let error = farthest_from(&led.motion, over, guide.sample(last));
        // Edits see guides in grains of 2⁻²⁰ m, here at both the end and the sample before.
        assert!(error <= 0.5 && (error - led.arrival_error[1]).abs() < 2.0_f64.powi(-19), "{aim:?} {error}");
        assert!(farthest_from(&led.motion, over - 1, guide.sample(last)) > 0.5, "it is over as soon as they are");
    }
}

#[test]
fn a_crowd_goes_around_what_stands_in_its_way() {
    let guide = straight(&[DVec2::new(0.0, 0.1)], &[DVec2::new(6.0, 0.1)]);
    let circle = Outline { points: vec![[3.0, 0.0]], radius: 0.8 };
    let led = led(CrowdRules { group: vec![NO_GROUP], obstacles: vec![circle.clone()], ..rules(1) }, &guide);
    let clearance = led.motion.positions().iter().map(|p| circle.clearance(p.to_array()).0).fold(f64::INFINITY, f64::min);
    assert!(clearance > 0.0, "{clearance}");
}

#[test]
fn a_crowd_whose_guide_knows_a_wall_arrives_where_one_is_caught_by_it() {
    let group = |x: f64| (0..12).map(|k| DVec2::new(x + f64::from(k / 4), f64::from(k % 4) - 1.5)).collect::<Vec<_>>();
    let guide = straight(&group(-6.0), &group(6.0));
    let corners = [[-0.3, -4.0], [0.3, -4.0], [0.3, 4.0], [-0.3, 4.0]];
    let wall = Outline { points: corners.to_vec(), radius: 0.0 };
    let walked = |clearance: f64| led(CrowdRules { obstacles: vec![wall.clone()], clearance, ..rules(12) }, &guide);
    let [caught, knowing] = [walked(0.0), walked(0.5)];
    // Half the way is left to whoever stands before the wall; who knows the way is late by their look ahead.
    assert!(caught.arrival_error[1] > 4.0 && knowing.arrival_error[1] < 1.0, "{:?} {:?}", caught.arrival_error, knowing.arrival_error);
    let clearance = knowing.motion.positions().iter().map(|p| wall.clearance(p.to_array()).0).fold(f64::INFINITY, f64::min);
    // Whoever is behind may press somebody to the wall by less than their body; keeping apart comes after.
    assert!(clearance > -0.25, "{clearance}");
    for k in [0, guide.times().len() - 1] {
        assert!(farthest(&knowing.motion, &guide, k) < 1e-12);
    }
}

#[test]
fn one_frame_between_two_keyframes_is_enough() {
    let times = vec![0.0, 0.2];
    let guide = Motion::new(times, 2, vec![DVec2::ZERO, DVec2::X, DVec2::Y, DVec2::ONE]);
    let led = led(rules(2), &guide);
    assert_eq!(led.motion, guide);
}
