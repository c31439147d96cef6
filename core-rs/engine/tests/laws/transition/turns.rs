//! A copy that is only turned is turned, and nothing else.

use std::f64::consts::PI;

use eigenform::choice::{Alignment, Choice, MethodName, Order};
use glam::DVec2;

use super::cases::{Case, choices, farthest, grid, line, motion, ring, scattered, turned};

const TS: [f64; 5] = [0.0, 0.25, 0.5, 0.75, 1.0];

fn shapes() -> Vec<(&'static str, Vec<DVec2>)> {
    vec![
        ("two agents", vec![DVec2::new(1.0, 0.0), DVec2::new(4.0, 2.0)]),
        ("scattered 10", scattered(10, 31)),
        ("scattered 30", scattered(30, 32)),
        ("ring of 12", ring(12, 5.0, 0.2)),
        ("square block", grid(5, 5)),
        ("line", line(7, DVec2::new(1.0, 0.5))),
    ]
}

#[test]
fn a_turned_copy_is_a_rigid_turn_under_every_option() {
    for (name, shape) in shapes() {
        for angle in [1e-7, 0.3, -1.2, 2.0, -3.0, PI] {
            let shift = DVec2::new(4.0, -9.0);
            let target = turned(&shape, angle).into_iter().map(|p| p + shift).collect();
            let case = Case::new(name, shape.clone(), target);
            let mut planner = case.planned();
            // Symmetric shapes: the tie-break decides, and round-off of the turned copy grows by 1/1e-6.
            let tolerance = 1e-7 * case.extent();
            let center = shape.iter().sum::<DVec2>() / shape.len() as f64;
            for choice in choices().into_iter().filter(|choice| choice.method != MethodName::Linear) {
                for keep_size in [false, true] {
                    for (frame, t) in motion(&mut planner, &choice, keep_size, &TS).iter().zip(TS) {
                        let travel = (DVec2::from_angle(angle).rotate(center) + shift - center) * t + center;
                        let expected: Vec<DVec2> =
                            shape.iter().map(|p| DVec2::from_angle(t * angle).rotate(*p - center) + travel).collect();
                        let off = farthest(frame, &expected);
                        assert!(off <= tolerance, "{name} by {angle}: {choice:?} is off by {off:e} at t = {t}");
                    }
                }
            }
        }
    }
}

/// Figure 3 of paper A: between a formation and its half turn straight lines meet in one point, polar ones keep the formation.
#[test]
fn straight_lines_collapse_a_half_turn_and_polar_ones_turn_it() {
    let shape = scattered(20, 33);
    let center = shape.iter().sum::<DVec2>() / 20.0;
    let about: Vec<DVec2> = shape.iter().map(|p| *p - center).collect();
    let mut planner = Case::new("half turn", about.clone(), turned(&about, PI)).planned();
    let mut middle = |method| {
        let choice = Choice { method, order: Order::Greedy, alignment: Alignment::Pca, sharing: 0.0 };
        motion(&mut planner, &choice, false, &[0.5]).remove(0)
    };
    assert!(farthest(&middle(MethodName::Linear), &[DVec2::ZERO; 20]) < 1e-12);
    assert!(farthest(&middle(MethodName::Polar), &turned(&about, PI / 2.0)) < 1e-12);
}
