//! Guides whose agents meet: the symmetric cases that avoidance is judged by.

use eigenform::motion::{Motion, sample_times};
use glam::DVec2;

/// Straight ways that start and end gently, at 30 frames a second.
pub fn straight(source: &[DVec2], target: &[DVec2], seconds: f64) -> Motion {
    let times = sample_times(0.0, seconds, 30.0);
    let eased = |time: f64| {
        let t = time / seconds;
        t * t * (3.0 - 2.0 * t)
    };
    let at = |time: f64| source.iter().zip(target).map(move |(from, to)| from.lerp(*to, eased(time)));
    let positions = times.iter().flat_map(|time| at(*time)).collect();
    Motion::new(times, source.len(), positions)
}

/// Two blocks of `columns` × `rows`, `spacing` meters, that exchange places through each other: where they start and where they go.
pub fn blocks(columns: usize, rows: usize, spacing: f64) -> [Vec<DVec2>; 2] {
    let block = |x: f64| (0..columns * rows).map(move |k| DVec2::new(x + (k % columns) as f64 * spacing, (k / columns) as f64 * spacing));
    let gap = columns as f64 * spacing + 4.0;
    [block(0.0).chain(block(gap)).collect(), block(gap).chain(block(0.0)).collect()]
}

/// The suite by name; the drill field's spacing, 1.143 m.
pub fn suite() -> Vec<(&'static str, Motion)> {
    const SPACING: f64 = 1.143;
    let line = |count: usize, at: DVec2, step: DVec2| (0..count).map(move |k| at + step * k as f64);
    let across = DVec2::new(0.0, SPACING);
    let along = DVec2::new(SPACING, 0.0);
    let exchange = |one: Vec<DVec2>, other: Vec<DVec2>| {
        let (source, target) = ([one.clone(), other.clone()].concat(), [other, one].concat());
        straight(&source, &target, 8.0)
    };
    let facing = exchange(line(20, DVec2::ZERO, across).collect(), line(20, DVec2::new(10.0, 0.0), across).collect());
    // The columns march through one another, nobody to the other's place but one after the other.
    let columns = exchange(line(20, DVec2::ZERO, along).collect(), line(20, DVec2::new(30.0, 0.0), along).collect());
    let ring: Vec<DVec2> = (0..40).map(|k| DVec2::from_angle(f64::from(k) / 40.0 * std::f64::consts::TAU) * 10.0).collect();
    let opposite: Vec<DVec2> = ring.iter().map(|p| -*p).collect();
    let square = |at: DVec2| (0..100).map(move |k| at + DVec2::new(f64::from(k % 10), f64::from(k / 10)) * SPACING);
    let (west, south): (Vec<DVec2>, Vec<DVec2>) = (square(DVec2::new(-16.0, 0.0)).collect(), square(DVec2::new(0.0, -16.0)).collect());
    let (east, north): (Vec<DVec2>, Vec<DVec2>) = (square(DVec2::new(16.0, 0.0)).collect(), square(DVec2::new(0.0, 16.0)).collect());
    let wide = |at: DVec2| (0..64).map(move |k| at + DVec2::new(f64::from(k % 8) - 3.5, f64::from(k / 8) - 3.5) * 2.0);
    let crossing = |from: DVec2, to: DVec2| {
        straight(&wide(-from).chain(wide(-to)).collect::<Vec<_>>(), &wide(from).chain(wide(to)).collect::<Vec<_>>(), 12.0)
    };
    let grid: Vec<DVec2> = square(DVec2::ZERO).collect();
    let shuffled: Vec<DVec2> = (0..100).map(|k| grid[(k * 37 + 11) % 100]).collect();
    let [block_source, block_target] = blocks(10, 10, SPACING);
    let slanted = line(20, DVec2::new(10.0, 0.0), DVec2::new(0.6, 0.9)).collect();
    vec![
        ("two lines of 20 face to face", facing),
        ("columns of 20 end-on", columns),
        ("circle of 40", straight(&ring, &opposite, 8.0)),
        ("two 10 x 10 blocks", straight(&block_source, &block_target, 8.0)),
        ("blocks at right angles", straight(&[west, south].concat(), &[east, north].concat(), 8.0)),
        ("8 x 8 blocks, 2 m, end-on", crossing(DVec2::new(16.0, 0.0), DVec2::new(-16.0, 0.0))),
        ("8 x 8 blocks, 2 m, at right angles", crossing(DVec2::new(16.0, 0.0), DVec2::new(0.0, 16.0))),
        ("a grid of 100 shuffled", straight(&grid, &shuffled, 8.0)),
        ("lines that cross", exchange(line(20, DVec2::ZERO, across).collect(), slanted)),
    ]
}
