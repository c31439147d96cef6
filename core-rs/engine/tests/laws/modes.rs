//! What a person may rely on when they look at the modes behind a motion.

use eigenform::perform::Performer;
use eigenform::scene::{Scene, read_json};
use eigenform::spectral::ModeMatch;

/// Nine agents without symmetry, the same ones moved a little, and the first again with its agents exchanged pairwise.
fn show() -> Scene {
    let spiral = |pitch: f64| (1..10).map(f64::from).map(move |i| [(1.0 + pitch * i) * i.cos(), (1.0 + pitch * i) * i.sin()]);
    let first: Vec<[f64; 2]> = spiral(0.7).collect();
    let second: Vec<[f64; 2]> = spiral(0.75).collect();
    let third: Vec<[f64; 2]> = (0..9).map(|i| first[if i == 8 { 8 } else { i ^ 1 }]).collect();
    let text = serde_json::json!({
        "format": "eigenform", "version": 1,
        "keyframes": [{ "time": 0, "positions": first }, { "time": 2, "positions": second }, { "time": 4, "positions": third }],
    });
    read_json(&text.to_string()).expect("the show is valid")
}

fn diagonal(matched: &ModeMatch, order: usize) -> Vec<f64> {
    let row = |(source, target): (usize, &usize)| matched.amounts[source * matched.mode_count + target];
    matched.targets[order].iter().enumerate().map(row).collect()
}

#[test]
fn a_formation_is_the_sum_of_its_modes() {
    let scene = show();
    let formation = &scene.main_track().keyframes[0].positions;
    let (basis, _) = Performer::default().eigenbasis(&scene, 0).expect("nine agents have modes");
    let center = formation.barycenter();
    for (agent, place) in formation.positions().iter().enumerate() {
        let parts = basis.coefficients(formation).into_iter().zip(basis.modes().row(agent).iter()).map(|(c, e)| c.truncate() * *e);
        let sum = parts.fold(center, |sum, part| sum + part);
        // Orthonormality of n modes to some n · eps, times the extent.
        assert!(sum.distance(*place) < 1e-13 * 9.0 * formation.extent(), "agent {agent}: {sum} for {place}");
    }
}

#[test]
fn every_order_pairs_each_mode_once_and_rows_have_unit_length() {
    let scene = show();
    for segment in [0, 1] {
        let matched = Performer::default().mode_match(&scene, segment).expect("both ends have modes");
        assert_eq!(matched.mode_count, 8);
        for targets in &matched.targets {
            let mut sorted = targets.clone();
            sorted.sort_unstable();
            assert_eq!(sorted, (0..8).collect::<Vec<_>>());
        }
        for row in matched.amounts.chunks_exact(8) {
            // Both bases span the same space, so a mode of one is a unit vector in the other.
            assert!((row.iter().map(|amount| amount * amount).sum::<f64>() - 1.0).abs() < 1e-12);
        }
    }
}

#[test]
fn each_order_is_best_at_what_it_is_for() {
    let matched = Performer::default().mode_match(&show(), 1).expect("both ends have modes");
    let [eigenvalue, greedy, maxmin, hungarian] = [0, 1, 2, 3].map(|order| diagonal(&matched, order));
    let least = |amounts: &[f64]| amounts.iter().copied().fold(f64::INFINITY, f64::min);
    let squares = |amounts: &[f64]| amounts.iter().map(|amount| amount * amount).sum::<f64>();
    assert!(greedy[0] >= eigenvalue[0]);
    assert!(least(&maxmin) >= least(&greedy));
    assert!(squares(&hungarian) >= squares(&greedy).max(squares(&eigenvalue)) - 1e-9);
}

#[test]
fn eigenvalues_on_the_way_start_and_end_as_those_of_the_keyframes() {
    let scene = show();
    let mut performer = Performer::default();
    let between = performer.eigenvalues_between(&scene, 1, 4).expect("both ends have ties");
    assert_eq!(between.len(), 5);
    for (at, keyframe) in [(0, 1), (4, 2)] {
        let (expected, _) = performer.eigenbasis(&scene, keyframe).expect("nine agents have modes");
        // Alone and beside their vectors they are found in two ways: each is good to a small multiple of eps times the greatest.
        for (found, expected) in between[at].iter().zip(expected.eigenvalues()) {
            assert!((found - expected).abs() <= 8.0 * 9.0 * f64::EPSILON * between[at][8], "{found} {expected}");
        }
    }
    for values in &between {
        assert!(values.is_sorted() && values[0] == 0.0);
    }
}
