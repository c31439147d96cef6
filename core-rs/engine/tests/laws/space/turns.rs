//! A copy that is only turned is turned, and nothing else.

use std::f64::consts::PI;

use eigenform::choice::{Alignment, MethodName};
use eigenform::transition::Planner;
use glam::{DQuat, DVec3};

use super::cases::{Rigid, block, center, chain, choices, farthest, formation, helix, motion, scattered};

const TS: [f64; 5] = [0.0, 0.25, 0.5, 0.75, 1.0];

#[test]
fn a_turned_copy_is_a_rigid_turn_under_every_alignment() {
    // A block's axes are its own only up to its symmetry: least squares know, so it stays out of the principal axes' trouble.
    let shapes =
        [("scattered 10", scattered(10, 31)), ("scattered 25", scattered(25, 32)), ("block", block(4, 3, 2)), ("helix", helix(15))];
    for (name, shape) in shapes {
        for (axis, angle) in
            [([0.0, 0.0, 1.0], 0.3), ([1.0, 0.0, 0.0], -1.2), ([1.0, 2.0, -0.5], 2.0), ([0.3, -1.0, 1.0], 3.1), ([0.2, 0.1, 1.0], PI)]
        {
            let rigid = Rigid::new(axis, angle, [4.0, -9.0, 2.0]);
            let target = rigid.apply(&shape);
            let [from, to] = [&shape, &target].map(|points| formation(points));
            let (mut planner, chain) = (Planner::default(), chain(&from, &to));
            let axis = DVec3::from_array(axis).normalize();
            let is_aligned = |alignment| alignment != Alignment::None;
            for choice in choices().into_iter().filter(|choice| choice.method != MethodName::Linear && is_aligned(choice.alignment)) {
                for keep_size in [false, true] {
                    for (frame, t) in motion(&mut planner, &chain, &choice, keep_size, &TS).iter().zip(TS) {
                        let turn = DQuat::from_axis_angle(axis, t * angle);
                        let middle = center(&shape).lerp(center(&target), t);
                        let expected: Vec<DVec3> = shape.iter().map(|p| turn * (*p - center(&shape)) + middle).collect();
                        let off = farthest(frame, &expected);
                        // As on the plane: where eigenvalues repeat the tie-break decides, and round-off of the copy grows by 1e6.
                        assert!(off <= 1e-7 * from.extent(), "{name} by {angle}: {choice:?} is off by {off:e} at t = {t}");
                    }
                }
            }
        }
    }
}
