//! A scene whose heights are all alike is a scene on the plane, to the bit.

use eigenform::formation::Formation;
use eigenform::transition::{Planner, Way, Ways};
use glam::DVec2;

use super::cases::{block, chain, choices, scattered};

const TS: [f64; 6] = [0.0, 0.1, 0.35, 0.5, 0.9, 1.0];

fn check(source: &[DVec2], target: &[DVec2]) {
    let (low, high) = (0.1, 7.3);
    let lifted = |plan: &[DVec2], height: f64| Formation::spatial(plan.to_vec(), vec![height; plan.len()]);
    let on_the_plane = chain(&Formation::new(source.to_vec()), &Formation::new(target.to_vec()));
    let level = chain(&lifted(source, low), &lifted(target, high));
    let mut planner = Planner::default();
    let count = source.len() * TS.len();
    for choice in choices() {
        for keep_size in [false, true] {
            let [mut expected, mut found] = [vec![DVec2::NAN; count], vec![DVec2::NAN; count]];
            let mut heights = vec![f64::NAN; count];
            let ways = Ways::all(Way::of(choice, keep_size));
            planner.plan(&on_the_plane, &ways).evaluate_into(&TS, &mut expected, None);
            planner.plan(&level, &ways).evaluate_into(&TS, &mut found, Some(&mut heights));
            assert_eq!(found, expected, "{choice:?}");
            for (k, t) in TS.iter().enumerate() {
                let due = (1.0 - t) * low + t * high;
                let own = &heights[k * source.len()..][..source.len()];
                // The mean of equal heights errs by an ulp or so.
                assert!(own.iter().all(|height| (height - due).abs() < 1e-14), "{choice:?}: {own:?} at {t}");
            }
        }
    }
}

#[test]
fn level_ends_move_as_on_the_plane_to_the_bit_and_rise_evenly() {
    let plan = |points: &[glam::DVec3]| points.iter().map(|point| point.truncate()).collect::<Vec<_>>();
    let blocks = plan(&block(5, 5, 1));
    check(&plan(&scattered(20, 1)), &plan(&scattered(20, 2)));
    check(&blocks, &plan(&scattered(25, 3)));
    check(&blocks, &blocks.iter().map(|p| DVec2::from_angle(0.4).rotate(*p)).collect::<Vec<_>>());
}
