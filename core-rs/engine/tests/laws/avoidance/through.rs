//! What avoidance promises where a formation goes through a gap.

use eigenform::edits::{Avoidance, Edited, Outline};
use eigenform::motion::clashes;
use glam::DVec2;

use super::around::clearance;
use super::{DISTANCE, avoidance, edited, last, straight};

/// Two walls half a meter thick, with a gap between.
fn walls(gap: f64) -> Vec<Outline> {
    let wall = |low: f64, high: f64| Outline { points: vec![[-0.25, low], [0.25, low], [0.25, high], [-0.25, high]], radius: 0.0 };
    vec![wall(0.5 * gap, 14.0), wall(-14.0, -0.5 * gap)]
}

/// A block of 6 × 6 that goes 24 m, with its middle so far aside of that of the gap.
fn through(gap: f64, aside: f64, angle: f64) -> Edited {
    let turned = |p: DVec2| DVec2::from_angle(angle).rotate(p);
    let block = |x: f64| (0..36).map(move |k| DVec2::new(x + 1.143 * (f64::from(k % 6) - 2.5), aside + 1.143 * (f64::from(k / 6) - 2.5)));
    let guide = straight(&block(-12.0).map(turned).collect::<Vec<_>>(), &block(12.0).map(turned).collect::<Vec<_>>());
    let mut obstacles = walls(gap);
    obstacles.iter_mut().flat_map(|wall| &mut wall.points).for_each(|point| *point = turned(DVec2::from_array(*point)).to_array());
    let result = edited(Avoidance { obstacles: obstacles.clone(), ..avoidance() }, &guide);
    for k in [0, last(&guide)] {
        assert_eq!(result.motion.sample(k), guide.sample(k), "keyframes stay");
    }
    let least = obstacles.iter().map(|wall| clearance(&result.motion, wall)).fold(f64::INFINITY, f64::min);
    let keeps = clashes(&result.motion, DISTANCE - 1e-6).is_empty() && least >= DISTANCE - 1e-6;
    assert_eq!(keeps, result.report.is_solved(), "solved is proved: {least}");
    result
}

#[test]
fn a_block_closes_up_and_goes_through_a_gap_that_is_narrower() {
    // Five files have room at the distance where the gap is 3 m wide, three where it is 2 m; straight on, from the side, and askew.
    for (gap, aside, angle) in [(3.0, 0.0, 0.0), (2.0, 0.0, 0.0), (3.0, 2.0, 0.0), (3.0, 4.5, 0.0), (3.0, 0.5, 0.4)] {
        let result = through(gap, aside, angle);
        assert!(result.report.is_solved(), "{gap} m, {aside} m aside: {:?} {:?}", result.report.blocked, result.report.unsolved);
    }
}

#[test]
fn where_there_is_no_time_to_go_through_it_is_said_who_is_in_the_way() {
    // A gap for one file: 36 agents half a meter apart are 18 m long, and have 24 m to fall in and to form again.
    let result = through(1.2, 0.0, 0.0);
    assert!(!result.report.is_solved() && result.report.shut_off.is_empty());
    assert!(result.report.blocked.len() + result.report.unsolved.len() > 0);
}
