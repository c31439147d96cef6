//! Segments in space that meet at keyframes.

use eigenform::choice::{Alignment, Choice, Join, MethodName, Order};
use eigenform::formation::Formation;
use eigenform::transition::{Chain, Planner, Way, Ways};
use glam::DVec3;

use super::cases::{block, end, farthest, formation, motion_of, scattered};

const DURATIONS: [f64; 3] = [2.0, 0.7, 3.0];

fn way(method: MethodName, alignment: Alignment) -> Way {
    Way::of(Choice { method, order: Order::Greedy, alignment, sharing: 0.5 }, false)
}

/// Four keyframes, passed in uneven times.
fn show() -> [Formation; 4] {
    [scattered(12, 41), scattered(12, 42), block(3, 2, 2), scattered(12, 44)].map(|points| formation(&points))
}

/// The chain that segment `at` of a show depends on.
fn chain(show: &[Formation; 4], at: usize) -> Chain {
    let (first, last) = (at.saturating_sub(1), (at + 2).min(3));
    let ends = show[first..=last].iter().map(end).collect();
    Chain::new(ends, DURATIONS[first..last].to_vec(), at - first, Join::Smooth, 0.5)
}

fn ways(ways: [Way; 3], at: usize) -> Ways {
    Ways { before: at.checked_sub(1).map(|before| ways[before]), own: ways[at], after: ways.get(at + 1).copied() }
}

/// Meters a second at an end of a segment, from inside.
fn velocity(planner: &mut Planner, show: &[Formation; 4], all: [Way; 3], at: usize, end: f64) -> Vec<DVec3> {
    let step = 1e-5 * (1.0 - 2.0 * end);
    let frames = motion_of(planner, &chain(show, at), &ways(all, at), &[end, end + step, end + 2.0 * step]);
    let seconds = step * DURATIONS[at];
    (0..12).map(|agent| (4.0 * frames[1][agent] - 3.0 * frames[0][agent] - frames[2][agent]) / (2.0 * seconds)).collect()
}

#[test]
fn agents_pass_keyframes_exactly_and_with_one_velocity_whatever_the_methods_beside() {
    let show = show();
    let mut planner = Planner::default();
    let (polar, spectral) = (way(MethodName::Polar, Alignment::Pca), way(MethodName::Spectral, Alignment::Procrustes));
    let (shared, linear) = (way(MethodName::Shared, Alignment::None), way(MethodName::Linear, Alignment::None));
    for all in [[spectral; 3], [polar; 3], [shared; 3], [linear; 3], [linear, spectral, polar]] {
        for keyframe in 1..3 {
            let arriving = velocity(&mut planner, &show, all, keyframe - 1, 1.0);
            let leaving = velocity(&mut planner, &show, all, keyframe, 0.0);
            // Second differences of step 1e-5 are good to 1e-10 · 1e3 m/s³, and round-off costs 1e-15 · 20 m / 1e-5 s.
            assert!(farthest(&arriving, &leaving) < 1e-6, "{all:?} at {keyframe}: {}", farthest(&arriving, &leaving));
        }
        for at in 0..3 {
            let frames = motion_of(&mut planner, &chain(&show, at), &ways(all, at), &[0.0, 1.0]);
            for (frame, due) in frames.iter().zip([&show[at], &show[at + 1]]) {
                let due: Vec<DVec3> = due.places().iter().collect();
                assert!(farthest(frame, &due) < 1e-9 * 35.0, "{all:?}: segment {at}");
            }
        }
    }
}

/// Straight ways have a velocity of their own on the plane: the same in space.
#[test]
fn straight_ways_are_the_cubics_of_the_plane() {
    let (flat, deep) = (scattered(12, 41), [scattered(12, 42), scattered(12, 43), scattered(12, 44)]);
    let level: Vec<Formation> =
        std::iter::once(&flat).chain(&deep).map(|points| formation(&points.iter().map(|p| p.with_z(2.0)).collect::<Vec<_>>())).collect();
    let of = |is_in_space: bool| {
        let chain = Chain::new(level.iter().map(end).collect(), DURATIONS.to_vec(), 1, Join::Smooth, 0.5);
        if is_in_space { chain.in_space() } else { chain }
    };
    let ways = Ways::all(way(MethodName::Linear, Alignment::None));
    let mut planner = Planner::default();
    let [on_the_plane, in_space] = [false, true].map(|is_in_space| motion_of(&mut planner, &of(is_in_space), &ways, &[0.2, 0.5, 0.9]));
    for (one, other) in on_the_plane.iter().zip(&in_space) {
        // A velocity from differences is good to eps over the step of 1e-3.
        assert!(farthest(one, other) < 1e-10 * 35.0, "{}", farthest(one, other));
    }
}
