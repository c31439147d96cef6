//! Pairs of formations that break careless code, every choice there is, and how far apart two motions are.

use std::sync::Arc;

use eigenform::adjacency::{AdjacencySpec, build};
use eigenform::choice::{Alignment, Choice, MethodName, Order};
use eigenform::formation::Formation;
use eigenform::transition::{Chain, End, Planner, Way, Ways};
use glam::DVec2;

pub use crate::formations::{grid, ring};

use crate::formations::chance;

pub const ORDERS: [Order; 4] = [Order::Eigenvalue, Order::Greedy, Order::Maxmin, Order::Hungarian];
pub const ALIGNMENTS: [Alignment; 3] = [Alignment::None, Alignment::Pca, Alignment::Procrustes];
pub const SHARINGS: [f64; 3] = [0.0, 0.5, 1.0];

/// Two formations of the same agents and what makes them hard.
#[derive(Clone, Debug)]
pub struct Case {
    pub name: String,
    pub source: Vec<DVec2>,
    pub target: Vec<DVec2>,
    pub spec: AdjacencySpec,
    pub is_symmetric: bool,
    pub is_in_step: bool,
}

impl Case {
    pub fn new(name: impl Into<String>, source: Vec<DVec2>, target: Vec<DVec2>) -> Self {
        Self { name: name.into(), source, target, spec: AdjacencySpec::default(), is_symmetric: false, is_in_step: false }
    }

    pub fn extent(&self) -> f64 {
        Formation::new(self.source.clone()).extent().max(Formation::new(self.target.clone()).extent())
    }

    pub fn planned(&self) -> Planned {
        let end = |positions: &[DVec2]| {
            let formation = Formation::new(positions.to_vec());
            let adjacency = build(&formation, &self.spec, &[]).expect("few ties");
            End { formation: Arc::new(formation), adjacency: Arc::new(adjacency) }
        };
        Planned { chain: Chain::between(end(&self.source), end(&self.target)), planner: Planner::default() }
    }
}

/// A case, and what was found out about it.
pub struct Planned {
    chain: Chain,
    planner: Planner,
}

/// Every method with every option that it knows.
pub fn choices() -> Vec<Choice> {
    choices_sharing(&SHARINGS)
}

/// Those of some sharings.
pub fn choices_sharing(sharings: &[f64]) -> Vec<Choice> {
    let plain = |method, alignment| Choice { method, order: Order::Greedy, alignment, sharing: 0.0 };
    let mut all = vec![plain(MethodName::Linear, Alignment::None)];
    for alignment in ALIGNMENTS {
        all.extend([plain(MethodName::Polar, alignment), plain(MethodName::Shared, alignment)]);
        for order in ORDERS {
            all.extend(sharings.iter().map(|&sharing| Choice { method: MethodName::Spectral, order, alignment, sharing }));
        }
    }
    all
}

/// Positions at each t, one row a t.
pub fn motion(planned: &mut Planned, choice: &Choice, keep_size: bool, ts: &[f64]) -> Vec<Vec<DVec2>> {
    let transition = planned.planner.plan(&planned.chain, &Ways::all(Way::of(*choice, keep_size)));
    let agent_count = transition.agent_count();
    let mut out = vec![DVec2::NAN; agent_count * ts.len()];
    transition.evaluate_into(ts, &mut out, None);
    (0..ts.len()).map(|k| out[k * agent_count..][..agent_count].to_vec()).collect()
}

pub fn farthest(p: &[DVec2], q: &[DVec2]) -> f64 {
    assert_eq!(p.len(), q.len());
    p.iter().zip(q).map(|(p, q)| if p.is_finite() && q.is_finite() { p.distance(*q) } else { f64::INFINITY }).fold(0.0, f64::max)
}

pub fn line(count: usize, step: DVec2) -> Vec<DVec2> {
    (0..count).map(|i| step * i as f64).collect()
}

/// Agents at random in a square of 20 m, the same for the same seed.
pub fn scattered(count: usize, seed: u64) -> Vec<DVec2> {
    let mut next = chance(seed);
    (0..count).map(|_| DVec2::new(next(), next())).collect()
}

pub fn turned(points: &[DVec2], angle: f64) -> Vec<DVec2> {
    points.iter().map(|p| DVec2::from_angle(angle).rotate(*p)).collect()
}

/// No symmetry at either end: every law holds without exception.
pub fn generic() -> Vec<Case> {
    let mut all: Vec<Case> = [3, 4, 5, 9, 16, 25, 40]
        .into_iter()
        .map(|count| Case::new(format!("scattered {count}"), scattered(count, 1), scattered(count, 2)))
        .collect();
    let from = scattered(20, 3);
    let noise = scattered(20, 4);
    let to = turned(&from, 0.8).into_iter().zip(noise).map(|(p, q)| p + 0.05 * q).collect();
    all.push(Case::new("a turned copy, shaken", from, to));
    let blocks = |centers: [DVec2; 3]| {
        centers.iter().zip(5..).flat_map(|(c, seed)| scattered(6, seed).into_iter().map(move |p| *c + 0.2 * p)).collect()
    };
    let [a, b, c] = [DVec2::new(0.0, 0.0), DVec2::new(15.0, 2.0), DVec2::new(6.0, 14.0)];
    all.push(Case::new("three blocks change places", blocks([a, b, c]), blocks([b, c, a])));
    all
}

/// Symmetric at one end or both, so that eigenvalues repeat, but no symmetry takes both ends to themselves.
pub fn symmetric() -> Vec<Case> {
    let cases = vec![
        Case::new("ring of 12 to a block", ring(12, 6.0, 0.1), shuffled(&grid(4, 3))),
        Case::new("block to ring of 12", grid(4, 3), shuffled(&ring(12, 6.0, 0.1))),
        Case::new("ring of 12 to a line", ring(12, 6.0, 0.3), shuffled(&line(12, DVec2::new(1.0, 0.2)))),
        Case::new("ring of 12 to a ring", ring(12, 6.0, 0.3), shuffled(&ring(12, 4.0, 1.0))),
        Case::new("ring of 15 to a scatter", ring(15, 6.0, 0.0), scattered(15, 8)),
        Case::new("square block to a scatter", grid(5, 5), scattered(25, 9)),
        Case::new("square block to a turned square block", grid(5, 5), turned(&shuffled(&grid(5, 5)), 0.3)),
    ];
    cases.into_iter().map(|case| Case { is_symmetric: true, ..case }).collect()
}

/// A symmetry takes both ends to themselves. Modes turn by half turns then, which have no mirror image and no way back, and the
/// eigenvalue order pairs modes that the symmetry reverses with modes that it keeps: nothing in the formations tells their signs.
pub fn symmetric_in_step() -> Vec<Case> {
    let cases = vec![
        Case::new("ring of 12 to a block, in step", ring(12, 6.0, 0.1), grid(4, 3)),
        Case::new("block to ring of 12, in step", grid(4, 3), ring(12, 6.0, 0.1)),
        Case::new("ring of 12 to a line, in step", ring(12, 6.0, 0.3), line(12, DVec2::new(1.0, 0.2))),
        Case::new("ring of 12 to a smaller one", ring(12, 6.0, 0.3), ring(12, 4.0, 1.0)),
        Case::new("square block, sheared", grid(4, 4), grid(4, 4).iter().map(|p| DVec2::new(p.x + 0.5 * p.y, p.y)).collect()),
    ];
    cases.into_iter().map(|case| Case { is_symmetric: true, is_in_step: true, ..case }).collect()
}

/// The same places with other agents in them, in an order of no symmetry.
pub fn shuffled(points: &[DVec2]) -> Vec<DVec2> {
    let mut order: Vec<(DVec2, DVec2)> = scattered(points.len(), 77).into_iter().zip(points.iter().copied()).collect();
    order.sort_by(|(p, _), (q, _)| p.x.total_cmp(&q.x));
    order.into_iter().map(|(_, point)| point).collect()
}

/// What people do by accident.
pub fn degenerate() -> Vec<Case> {
    let here = DVec2::new(3.0, -2.0);
    let mut twins = scattered(9, 11);
    twins[4] = twins[2];
    let mut cut = Case::new("no ties at all", scattered(8, 12), scattered(8, 13));
    cut.spec.base = eigenform::adjacency::Base::None;
    let mut pieces = Case::new("three pieces", scattered(9, 14), scattered(9, 15));
    pieces.spec.base = eigenform::adjacency::Base::None;
    pieces.spec.ties = vec![(0, 1, 1.0), (1, 2, 2.0), (3, 4, 1.0), (4, 5, 1.0), (6, 7, 1.0), (7, 8, 3.0)];
    vec![
        Case::new("nobody", vec![], vec![]),
        Case::new("one agent", vec![here], vec![-here]),
        Case::new("two agents", vec![here, DVec2::ZERO], vec![DVec2::new(1.0, 1.0), DVec2::new(5.0, 1.5)]),
        Case::new("two agents change places", vec![here, -here], vec![-here, here]),
        Case::new("all in one place", vec![here; 7], vec![-here; 7]),
        Case::new("from one place", vec![here; 7], scattered(7, 16)),
        Case::new("into one place", scattered(7, 17), vec![here; 7]),
        Case::new("twins", twins.clone(), scattered(9, 18)),
        Case::new("to twins", scattered(9, 18), twins),
        Case::new("line to line", line(9, DVec2::new(1.0, 0.0)), line(9, DVec2::new(0.3, 1.1))),
        Case::new("line to its reverse", line(9, DVec2::X), line(9, DVec2::X).into_iter().rev().collect()),
        Case::new("identical", grid(3, 3), grid(3, 3)),
        Case::new("a half turn", scattered(12, 19), turned(&scattered(12, 19), std::f64::consts::PI)),
        Case::new("a half turn of a ring", ring(12, 6.0, 0.0), ring(12, 6.0, std::f64::consts::PI)),
        Case::new("a mirror image", scattered(12, 20), scattered(12, 20).iter().map(|p| DVec2::new(-p.x, p.y)).collect()),
        Case::new("very large", scattered(10, 21).iter().map(|p| *p * 1e4).collect(), scattered(10, 22).iter().map(|p| *p * 1e4).collect()),
        Case::new(
            "very small",
            scattered(10, 21).iter().map(|p| *p * 1e-6).collect(),
            scattered(10, 22).iter().map(|p| *p * 1e-6).collect(),
        ),
        Case::new(
            "small among large",
            scattered(10, 21).iter().map(|p| *p * 1e-3).collect(),
            scattered(10, 22).iter().map(|p| *p * 1e3).collect(),
        ),
        cut,
        pieces,
    ]
}

pub fn all_cases() -> Vec<Case> {
    [generic(), symmetric(), symmetric_in_step(), degenerate()].concat()
}
