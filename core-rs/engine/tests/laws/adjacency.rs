//! Laws of the graph that positions suggest (spectral.md, sections 2 and 10).

use crate::formations::{any_formation, apart, grid, mapped, relabeled, rigid_motion, ring};
use eigenform::adjacency::{AdjacencySpec, GroupTie, Weights, build, propose};
use eigenform::formation::Formation;
use glam::DVec2;
use proptest::prelude::*;

fn connects(agent_count: usize, edges: &[(u32, u32)]) -> bool {
    let mut reached = vec![false; agent_count];
    let mut frontier = vec![0u32];
    while let Some(agent) = frontier.pop() {
        if !std::mem::replace(&mut reached[agent as usize], true) {
            frontier.extend(edges.iter().filter(|edge| edge.0 == agent).map(|edge| edge.1));
            frontier.extend(edges.iter().filter(|edge| edge.1 == agent).map(|edge| edge.0));
        }
    }
    reached.into_iter().all(|reached| reached)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]

    #[test]
    fn relabeling_relabels_the_edges((points, labels) in relabeled(apart())) {
        let mut moved = vec![DVec2::ZERO; points.len()];
        for (&label, &point) in labels.iter().zip(&points) {
            moved[label as usize] = point;
        }
        let mut expected: Vec<(u32, u32)> = propose(&Formation::new(points)).into_iter().map(|(a, b)| {
            let (a, b) = (labels[a as usize], labels[b as usize]);
            (a.min(b), a.max(b))
        }).collect();
        expected.sort_unstable();
        prop_assert_eq!(propose(&Formation::new(moved)), expected);
    }

    #[test]
    fn a_rigid_motion_keeps_the_edges(points in apart(), motion in rigid_motion()) {
        prop_assert_eq!(propose(&mapped(&points, |p| motion.apply(p))), propose(&Formation::new(points)));
    }

    #[test]
    fn a_mirror_keeps_the_edges(points in apart()) {
        prop_assert_eq!(propose(&mapped(&points, |p| DVec2::new(-p.x, p.y))), propose(&Formation::new(points)));
    }

    #[test]
    fn scaling_keeps_the_edges(points in apart(), exponent in -6.0..4.0f64) {
        prop_assert_eq!(propose(&mapped(&points, |p| p * 10f64.powf(exponent))), propose(&Formation::new(points)));
    }

    #[test]
    fn scaling_divides_inverse_weights(points in apart(), exponent in -6.0..4.0f64) {
        let scale = 10f64.powf(exponent);
        let [one, scaled] = [1.0, scale].map(|scale| build(&mapped(&points, |p| p * scale), &AdjacencySpec::default(), &[]).unwrap());
        for (tie, scaled) in one.ties().iter().zip(scaled.ties()) {
            // A distance is a root of a few rounded operations on coordinates that 20 m / 1 cm bounds.
            prop_assert!((scaled.weight * scale / tie.weight - 1.0).abs() < 1e-12);
        }
    }

    #[test]
    fn the_proposal_connects_everyone(points in any_formation(), motion in rigid_motion()) {
        let formation = mapped(&points, |p| motion.apply(p));
        let edges = propose(&formation);
        prop_assert!(edges.is_sorted_by(|p, q| p < q), "ascending, each once");
        prop_assert!(edges.iter().all(|&(a, b)| a < b && (b as usize) < points.len()));
        prop_assert!(points.is_empty() || connects(points.len(), &edges));
    }

    #[test]
    fn weights_are_positive_and_finite(points in any_formation(), unit in any::<bool>(), factor in 1e-6..1e6f64) {
        let weights = if unit { Weights::Unit } else { Weights::Inverse };
        let everyone = GroupTie { members: (0..points.len() as u32).collect(), factor };
        let spec = AdjacencySpec { weights, ..AdjacencySpec::default() };
        let adjacency = build(&Formation::new(points), &spec, &[everyone]).unwrap();
        prop_assert!(adjacency.ties().iter().all(|tie| tie.weight > 0.0 && tie.weight.is_finite()));
    }

    #[test]
    fn rows_of_the_laplacian_sum_to_zero(points in any_formation()) {
        let count = points.len();
        let laplacian = build(&Formation::new(points), &AdjacencySpec::default(), &[]).unwrap().laplacian();
        for row in 0..count {
            let sum: f64 = (0..count).map(|column| laplacian[(row, column)]).sum();
            // n + 1 roundings of at most half an ulp of twice the diagonal each.
            prop_assert!(sum.abs() <= 1e-15 * (count as f64 + 1.0) * laplacian[(row, row)]);
            prop_assert!((0..count).all(|column| laplacian[(row, column)].to_bits() == laplacian[(column, row)].to_bits()));
        }
    }

    #[test]
    fn a_ring_keeps_its_cycle(count in 4usize..300, start in 0.0..6.3f64, motion in rigid_motion()) {
        let points = ring(count, 30.0, start);
        let mut cycle: Vec<(u32, u32)> = (0..count as u32 - 1).map(|i| (i, i + 1)).collect();
        cycle.push((0, count as u32 - 1));
        cycle.sort_unstable();
        prop_assert_eq!(propose(&mapped(&points, |p| motion.apply(p))), cycle);
    }

    #[test]
    fn a_square_grid_keeps_its_cells(columns in 2usize..12, rows in 2usize..12, motion in rigid_motion()) {
        let mut cells = Vec::new();
        for i in 0..columns * rows {
            if i % columns + 1 < columns {
                cells.push((i as u32, i as u32 + 1));
            }
            if i + columns < columns * rows {
                cells.push((i as u32, (i + columns) as u32));
            }
        }
        prop_assert_eq!(propose(&mapped(&grid(columns, rows), |p| motion.apply(p))), cells);
    }
}
