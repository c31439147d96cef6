//! Equal speed along the path.

use eigenform::choice::{Join, Timing};
use glam::DVec2;

use super::show::{blocks, choices, performed, positions, show, with_timing};

fn rms_step(pair: &[Vec<DVec2>]) -> f64 {
    (pair[0].iter().zip(&pair[1]).map(|(p, q)| p.distance_squared(*q)).sum::<f64>() / pair[0].len() as f64).sqrt()
}

#[test]
fn an_even_timing_covers_equal_ways_in_equal_times() {
    // Chords of a fortieth are not the way where it turns back, so each is taken in 25.
    let fractions: Vec<f64> = (0..=1000).map(|k| f64::from(k) / 1000.0).collect();
    for join in [Join::Separate, Join::Smooth] {
        for choice in choices() {
            let performance = performed(&with_timing(show(&blocks(), join, choice), Timing::Even));
            for segment in 0..4 {
                let chords: Vec<f64> = positions(&performance, segment, &fractions).windows(2).map(rms_step).collect();
                let steps: Vec<f64> = chords.chunks(25).map(|chords| chords.iter().sum()).collect();
                let mean = steps.iter().sum::<f64>() / steps.len() as f64;
                // The clock knows the path by 128 chords; one across a turning point is short by up to its length, a third of a step.
                let uneven: Vec<f64> = steps.iter().map(|step| (step / mean - 1.0).abs()).collect();
                let typical = uneven.iter().sum::<f64>() / uneven.len() as f64;
                assert!(typical < 0.02, "{join:?}, {choice:?}, segment {segment}: steps differ by {uneven:.3?}");
            }
        }
    }
}
