//! What places in a shape promise, over shapes, numbers and seeds.

use glam::DVec2;

use super::*;
use crate::error::{Blank, Error};
use crate::formation::{Formation, PairSearch};

/// Whether a place is inside, in shares of the picture's width, y down.
type Inside = fn(f64, f64) -> bool;

const SHAPES: [(&str, Inside); 6] = [
    ("disc", |x, y| (x - 0.5).hypot(y - 0.5) <= 0.5),
    ("ring", |x, y| (0.3..=0.5).contains(&(x - 0.5).hypot(y - 0.5))),
    ("L", |x, y| x < 0.4 || y > 0.65),
    ("A", |x, y| {
        let sides = [[0.1, 0.95, 0.5, 0.06], [0.9, 0.95, 0.5, 0.06], [0.25, 0.62, 0.75, 0.62]];
        sides.iter().any(|&side| stroke(x, y, side) <= 0.05)
    }),
    ("E", |x, y| x < 0.2 || !(0.15..=0.85).contains(&y) || (x < 0.8 && (y - 0.5).abs() < 0.08)),
    // A disc with a tail that is thinner than the distances.
    ("kite", |x, y| (x - 0.3).hypot(y - 0.5) <= 0.26 || stroke(x, y, [0.3, 0.5, 0.98, 0.5]) <= 0.008),
];

const ROOM: Room = Room { width: 40.0, depth: 40.0 };

/// Black on white, each pixel as gray as it is covered.
fn drawn(side: usize, inside: Inside) -> Vec<u8> {
    let share = |at: usize, part: usize| (at as f64 + (part as f64 + 0.5) / 4.0) / side as f64;
    let covered = |at: usize| (0..16).filter(|part| inside(share(at % side, part % 4), share(at / side, part / 4))).count();
    (0..side * side).flat_map(|at| [255 - (covered(at) * 255 / 16) as u8; 3].into_iter().chain([255])).collect()
}

fn region(side: usize, inside: Inside) -> Region {
    read(side, side, &drawn(side, inside)).expect("a shape")
}

fn read(width: usize, height: usize, rgba: &[u8]) -> Result<Region, Error> {
    Region::from_picture(Picture { width, height, rgba }, Reading::default(), ROOM)
}

fn places(region: &Region, request: Request) -> Result<Formation, Error> {
    SlotJob::new(region.clone(), request)?.finish()
}

fn filled(count: usize, seed: u32) -> Request {
    Request { count, least_distance: 0.0, style: Style::Filled, seed }
}

/// The distance from a place to a straight line.
fn stroke(x: f64, y: f64, [x0, y0, x1, y1]: [f64; 4]) -> f64 {
    let (at, from, way) = (DVec2::new(x, y), DVec2::new(x0, y0), DVec2::new(x1 - x0, y1 - y0));
    at.distance(from + way * ((at - from).dot(way) / way.length_squared()).clamp(0.0, 1.0))
}

/// From each place to its nearest: the mean, the deviation as a share of it, and the least.
fn distances(places: &Formation) -> (f64, f64, f64) {
    let mut nearest = vec![f64::INFINITY; places.agent_count()];
    PairSearch::default().for_each_within(places.positions(), places.extent(), |a, b, squared| {
        for agent in [a, b] {
            nearest[agent as usize] = nearest[agent as usize].min(squared.sqrt());
        }
    });
    let mean = nearest.iter().sum::<f64>() / nearest.len() as f64;
    let variance = nearest.iter().map(|distance| (distance - mean).powi(2)).sum::<f64>() / nearest.len() as f64;
    (mean, variance.sqrt() / mean, nearest.into_iter().fold(f64::INFINITY, f64::min))
}

#[test]
fn filled_shapes_are_even_whatever_the_seed() {
    for (name, inside) in SHAPES {
        let region = region(160, inside);
        for (count, seed) in [(25, 0), (90, 1), (90, 2), (400, 3)] {
            let places = places(&region, filled(count, seed)).expect("room enough");
            assert_eq!(places.agent_count(), count);
            assert!(places.positions().iter().all(|&place| region.contains(place)), "{name}: all are inside");
            // What counts as even; by chance alone it would be 0.52.
            let (_, deviation, _) = distances(&places);
            assert!(deviation <= 0.15, "{count} in {name}, seed {seed}: {deviation}");
        }
    }
}

#[test]
fn a_seed_gives_the_same_places_and_another_one_others() {
    let region = region(100, SHAPES[0].1);
    let bits = |seed: u32| {
        places(&region, filled(60, seed))
            .map(|places| places.positions().iter().map(|p| [p.x.to_bits(), p.y.to_bits()]).collect::<Vec<_>>())
    };
    assert_eq!(bits(7), bits(7));
    assert_ne!(bits(7), bits(8));
}

#[test]
fn a_shape_fills_its_room_about_the_origin() {
    let wide: Inside = |x, y| (0.1..0.9).contains(&x) && (0.2..0.6).contains(&y);
    let rgba = drawn(200, wide);
    let picture = Picture { width: 200, height: 200, rgba: &rgba };
    for (room, size) in [(Room { width: 40.0, depth: f64::INFINITY }, [40.0, 20.0]), (Room { width: 40.0, depth: 10.0 }, [20.0, 10.0])] {
        let region = Region::from_picture(picture, Reading::default(), room).expect("a shape");
        let (low, high) = places(&region, filled(200, 0)).expect("room enough").bounds();
        // A place that is pushed outward stands at the edge, which lies within half a pixel.
        let pixel = room.width.min(room.depth * 2.0) / 160.0;
        assert!((high - low - DVec2::from_array(size)).abs().max_element() <= pixel, "{low} to {high}");
        assert!((high + low).abs().max_element() <= pixel, "{low} to {high}");
    }
}

#[test]
fn as_many_as_fit_keep_their_distance_and_more_are_refused() {
    for (name, inside) in SHAPES {
        let region = region(160, inside);
        let request = |count: usize, style| Request { count, least_distance: 2.0, style, seed: 5 };
        for style in [Style::Filled, Style::Outline] {
            let refused = places(&region, request(5_000, style)).expect_err("too many");
            let Error::TooCrowded { count: 5_000, largest, .. } = refused else { panic!("{name}: {refused}") };
            let full = places(&region, request(largest, style)).expect("as many as fit");
            // Distances are found to the last bits.
            assert!(distances(&full).2 >= 2.0 * (1.0 - 1e-12), "{name}, {style:?}");
            let one_more = places(&region, request(largest + 1, style)).expect_err("too many");
            assert_eq!(one_more, Error::TooCrowded { count: largest + 1, distance: 2.0, largest }, "{name}, {style:?}");
        }
        // Hexagons about the places: none can hold more of them than its area and half its edge allow (Groemer); rows come near it.
        let refused = places(&region, request(5_000, Style::Filled)).expect_err("too many");
        let Error::TooCrowded { largest, .. } = refused else { unreachable!("just seen") };
        assert!(largest as f64 >= 0.85 * region.area() / (0.75_f64.sqrt() * 4.0), "{name} holds {largest}");
    }
}

#[test]
fn an_outline_is_walked_in_even_steps() {
    let disc = region(200, SHAPES[0].1);
    let around = places(&disc, Request { style: Style::Outline, ..filled(60, 1) }).expect("room enough");
    let (mean, deviation, _) = distances(&around);
    // A circle of 40 m; its edge is known to a part of a pixel, 0.2 m, and so is a step.
    assert!((mean - 40.0 * (std::f64::consts::PI / 60.0).sin()).abs() < 0.05, "{mean}");
    assert!(deviation < 0.03, "{deviation}");
    assert!(around.positions().iter().all(|place| (place.length() - 20.0).abs() < 0.2));
    // Both edges of a ring, each with its share: 50 of 80 outside.
    let ring = region(200, SHAPES[1].1);
    let both = places(&ring, Request { style: Style::Outline, ..filled(80, 1) }).expect("room enough");
    assert_eq!(both.positions().iter().filter(|place| place.length() > 16.0).count(), 50);
}

#[test]
fn the_few_stand_sensibly() {
    for (name, inside) in SHAPES {
        let region = region(100, inside);
        for (count, style) in [(1, Style::Filled), (2, Style::Filled), (3, Style::Filled), (1, Style::Outline), (2, Style::Outline)] {
            let places = places(&region, Request { style, ..filled(count, 0) }).expect("room enough");
            assert_eq!(places.agent_count(), count, "{name}");
            assert!(count < 2 || distances(&places).2 > 5.0, "{name}: {places:?}");
        }
    }
    // One stands in the middle of what has one.
    let middle = places(&region(100, SHAPES[0].1), filled(1, 0)).expect("room enough");
    assert!(middle.positions()[0].length() < 0.5);
}

#[test]
fn a_job_is_steps_that_come_nearer_to_the_end() {
    let mut job = SlotJob::new(region(100, SHAPES[4].1), filled(300, 0)).expect("a number of agents");
    let mut before = 0.0;
    loop {
        match job.step().expect("room enough") {
            Step::Progress(progress) => {
                assert!((before..1.0).contains(&progress), "{progress} after {before}");
                before = progress;
            }
            Step::Done(places) => break assert_eq!(places.agent_count(), 300),
        }
    }
}

#[test]
fn five_thousand_find_place_on_a_speck() {
    let speck: Inside = |x, y| (0.5..0.51).contains(&x) && (0.5..0.51).contains(&y);
    let places = places(&region(200, speck), filled(5_000, 0)).expect("room enough");
    assert!(distances(&places).2 > 0.0);
}

#[test]
fn numbers_of_agents_that_no_scene_has_are_refused() {
    let region = region(20, SHAPES[0].1);
    for count in [0, 5_001, usize::MAX] {
        let refused = places(&region, filled(count, 0)).expect_err("no number of agents");
        assert_eq!((refused.code(), refused.place()), ("out-of-range", "agents".to_owned()));
    }
}

#[test]
fn pictures_without_a_shape_are_refused() {
    let check = |width: usize, height: usize, pixel: [u8; 4], expected: &Error| {
        let rgba = pixel.repeat(width * height);
        assert_eq!(read(width, height, &rgba).err().as_ref(), Some(expected));
    };
    let blank = |why| Error::BlankPicture { why };
    check(9, 7, [255; 4], &blank(Blank::Alike));
    check(9, 7, [0, 0, 0, 255], &blank(Blank::Alike));
    check(9, 7, [90, 0, 0, 40], &blank(Blank::Alike));
    check(9, 7, [0; 4], &blank(Blank::Transparent));
    for (width, height) in [(1, 1), (0, 0), (9_000, 4)] {
        check(width, height, [0, 0, 0, 255], &Error::PictureSize { width, height, low: 4, high: 4_096 });
    }
}

#[test]
fn what_a_blank_picture_is_told_helps() {
    let tones = [0, 1, 3, 90, 128, 250, 253, 254, 255].map(|tone| [tone, tone, tone, 255]);
    let faint = [[0; 4], [255, 255, 255, 0], [0, 0, 0, 1], [200, 0, 0, 90], [0, 0, 0, 90], [0, 0, 0, 127], [0, 90, 0, 128], [9, 9, 9, 254]];
    let pixels = [&tones[..], &faint].concat();
    let hundredths = || (1..=99).map(|hundredth| f64::from(hundredth) / 100.0);
    for (one, other) in pixels.iter().flat_map(|one| pixels.iter().map(move |other| (one, other))) {
        let rgba = [one.repeat(32), other.repeat(32)].concat();
        let read = |threshold: f64, is_inverted: bool| {
            Picture { width: 8, height: 8, rgba: &rgba }.coverage(Reading { threshold, is_inverted }).err()
        };
        for (threshold, is_inverted) in [0.01, 0.5, 0.99].into_iter().flat_map(|threshold| [(threshold, false), (threshold, true)]) {
            let Some(refusal) = read(threshold, is_inverted) else { continue };
            assert!(read(threshold, !is_inverted).is_some(), "inverting does not help: {one:?} and {other:?}");
            let Error::BlankPicture { why } = refusal else { panic!("{refusal}") };
            match why {
                Blank::Transparent => assert_eq!([one[3], other[3]], [0, 0]),
                Blank::Alike => {
                    let all_are_blank = hundredths().all(|threshold| read(threshold, false).is_some());
                    assert!(all_are_blank, "{one:?} and {other:?} are told apart");
                }
                Blank::Undivided { is_everything, better, .. } => {
                    assert_eq!(read(better, is_inverted), None, "{one:?} and {other:?} at {threshold}: {why}");
                    assert_eq!(is_everything != is_inverted, better < threshold, "{why}");
                    assert!(why.to_string().contains(if better > threshold { "raise" } else { "lower" }));
                }
            }
        }
    }
}

#[test]
fn what_is_read_of_a_picture_is_the_persons_choice() {
    // Gray on the left, white in the middle, and nothing on the right.
    let columns = [[128, 128, 128, 255], [255; 4], [0; 4]];
    let rgba = |take: usize| -> Vec<u8> { (0..8).flat_map(|_| (0..4 * take).flat_map(|x| columns[x / 4])).collect() };
    let area = |take: usize, threshold: f64, is_inverted: bool| {
        let picture = Picture { width: 4 * take, height: 8, rgba: &rgba(take) };
        let region = Region::from_picture(picture, Reading { threshold, is_inverted }, ROOM).expect("a shape");
        (region.area() / region.pixel().powi(2)).round()
    };
    // Gray of brightness 0.502 is darker than 0.6; inverted, the white is the shape.
    assert_eq!((area(2, 0.6, false), area(2, 0.6, true)), (32.0, 32.0));
    // Where something is transparent, all that can be seen is the shape, white or not.
    assert_eq!((area(3, 0.5, false), area(3, 0.5, true)), (64.0, 32.0));
}
