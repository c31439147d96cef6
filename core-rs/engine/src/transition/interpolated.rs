//! A path known at a few instants, and between them by the polynomial through these.
//!
//! In modes every instant costs products of matrices of agents × agents, and a segment has hundreds of instants. But powers of
//! rotations and coefficients that turn are entire functions of t: the polynomials through their values at Chebyshev's points meet
//! them to round-off from a few dozen points on (Trefethen, "Approximation Theory and Approximation Practice", 2013, chapters 5 and 8).

use std::f64::consts::PI;

use eigenform_dense::product;
use faer::{Mat, MatRef};
use glam::{DVec2, DVec3};

use super::Transition;
use super::bent::places_at;

/// The degrees that are tried. Half a turn in every plane while the coefficients turn a whole one is round-off from the first on.
const DEGREES: [usize; 2] = [24, 48];

/// Who is asked for fewer instants than this gains little.
const LEAST_INSTANTS: usize = 4 * DEGREES[0];

/// Where the polynomials are compared with the path: between points of both degrees, near the ends and within.
const COMPARED: [f64; 4] = [0.003, 0.27, 0.54, 0.91];

/// A path is met where nobody is farther from it than this, of the farthest coordinate.
const ROUND_OFF: f64 = 1e-12;

/// Places at Chebyshev's points, beside an origin that goes straight.
struct Interpolated {
    agent_count: usize,
    origin: [DVec3; 2],
    points: Vec<f64>,
    /// Coordinates × points: x, y and z of every agent in turn.
    places: Mat<f64>,
}

/// The same path to round-off, cheaper where many agents move through many instants; itself where no such polynomials meet it.
pub(crate) fn interpolated(path: Box<dyn Transition>, instant_count: usize) -> Box<dyn Transition> {
    if path.agent_count() <= DEGREES[0] || instant_count < LEAST_INSTANTS {
        return path;
    }
    match DEGREES.iter().map(|degree| Interpolated::of(&*path, *degree)).find(|found| found.meets(&*path)) {
        Some(found) => Box::new(found),
        None => path,
    }
}

impl Interpolated {
    fn of(path: &dyn Transition, degree: usize) -> Self {
        let agent_count = path.agent_count();
        let points: Vec<f64> = (0..=degree).map(|k| libm::sin(0.5 * PI * k as f64 / degree as f64).powi(2)).collect();
        let found = places_at(path, &points);
        let origin = [found[0], found[degree * agent_count]];
        let places = Mat::from_fn(3 * agent_count, points.len(), |row, k| {
            (found[k * agent_count + row / 3] - origin_at(origin, points[k]))[row % 3]
        });
        Self { agent_count, origin, points, places }
    }

    fn meets(&self, path: &dyn Transition) -> bool {
        let farthest = eigenform_dense::largest(self.places.as_ref());
        let pairs = places_at(path, &COMPARED).into_iter().zip(places_at(self, &COMPARED));
        pairs.into_iter().all(|(place, own)| place.distance(own) <= ROUND_OFF * farthest)
    }

    /// What every point counts at `t`: barycentric weights, which sum to 1.
    fn weigh(&self, t: f64, weights: &mut [f64]) {
        if let Some(at) = self.points.iter().position(|point| *point == t) {
            weights[at] = 1.0;
            return;
        }
        let mut sign = 1.0;
        for (weight, point) in weights.iter_mut().zip(&self.points) {
            *weight = if *point == 0.0 || *point == 1.0 { 0.5 } else { 1.0 } * sign / (t - point);
            sign = -sign;
        }
        let sum: f64 = weights.iter().sum();
        for weight in weights {
            *weight /= sum;
        }
    }
}

/// What is level stays so to the bit.
fn origin_at([from, to]: [DVec3; 2], t: f64) -> DVec3 {
    from + (to - from) * t
}

impl Transition for Interpolated {
    fn agent_count(&self) -> usize {
        self.agent_count
    }

    fn evaluate_into(&self, ts: &[f64], plan: &mut [DVec2], mut heights: Option<&mut [f64]>) {
        let point_count = self.points.len();
        let mut weights = vec![0.0; point_count * ts.len()];
        for (t, weights) in ts.iter().zip(weights.chunks_exact_mut(point_count)) {
            self.weigh(*t, weights);
        }
        let places = product(self.places.as_ref(), MatRef::from_column_major_slice(&weights, point_count, ts.len()));
        for (k, t) in ts.iter().enumerate() {
            let origin = origin_at(self.origin, *t);
            for agent in 0..self.agent_count {
                let [x, y, z] = [0, 1, 2].map(|axis| origin[axis] + places[(3 * agent + axis, k)]);
                plan[k * self.agent_count + agent] = DVec2::new(x, y);
                if let Some(heights) = &mut heights {
                    heights[k * self.agent_count + agent] = z;
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use super::*;
    use crate::adjacency::{AdjacencySpec, build};
    use crate::choice::{Alignment, Choice, Join, MethodName, Order};
    use crate::formation::Formation;
    use crate::transition::{Chain, End, Planner, Way, Ways};

    const AGENTS: usize = 40;

    /// Strewn over a disk of 10 m, anew for every seed.
    fn strewn(seed: usize, height: impl Fn(f64) -> f64) -> End {
        let angle = |agent: usize| (1.0 + agent as f64) * (2.4 + 0.37 * seed as f64);
        let place = |agent: usize| DVec2::from_angle(angle(agent)) * 10.0 * ((agent + 1) as f64 / AGENTS as f64).sqrt();
        let heights = (0..AGENTS).map(|agent| height(angle(agent))).collect();
        let formation = Formation::spatial((0..AGENTS).map(place).collect(), heights);
        let adjacency = build(&formation, &AdjacencySpec::default(), &[]).expect("few ties");
        End { formation: Arc::new(formation), adjacency: Arc::new(adjacency) }
    }

    fn ways(method: MethodName, sharing: f64, keeps_size: bool) -> Ways {
        Ways::all(Way::of(Choice { method, order: Order::Greedy, alignment: Alignment::Pca, sharing }, keeps_size))
    }

    /// How far a path and its polynomial are apart at instants beside the points; none where the path is kept.
    fn apart(plan: impl Fn() -> Box<dyn Transition>) -> Option<f64> {
        let ts: Vec<f64> = (0..=100).map(|k| f64::from(k) / 100.0).collect();
        let [expected, found] = [plan(), interpolated(plan(), LEAST_INSTANTS)].map(|path| places_at(&*path, &ts));
        // Round-off differs wherever something is computed another way.
        let farthest = expected.iter().zip(&found).map(|(p, q)| p.distance(*q)).fold(0.0, f64::max);
        (expected != found).then_some(farthest)
    }

    #[test]
    fn a_path_in_modes_is_met_to_round_off() {
        for heights in [|_: f64| 2.0, |angle: f64| 3.0 * angle.sin()] {
            let ends: Vec<End> = (0..4).map(|seed| strewn(seed, heights)).collect();
            let alone = Chain::between(ends[0].clone(), ends[1].clone());
            let passing = Chain::new(ends, vec![2.0, 4.0, 3.0], 1, Join::Smooth, 0.5);
            for chain in [alone, passing] {
                for method in [MethodName::Shared, MethodName::Spectral] {
                    for (sharing, keeps_size) in [(0.0, false), (0.5, true), (1.0, false)] {
                        let apart = apart(|| Planner::default().plan(&chain, &ways(method, sharing, keeps_size)));
                        // Nobody is farther than 20 m from anybody; between the compared instants the error has no other size.
                        assert!(apart.is_some_and(|apart| apart < 10.0 * ROUND_OFF * 20.0), "{method:?} {sharing}: {apart:?}");
                    }
                }
            }
        }
    }

    /// Everybody turns back at once, between two points.
    struct Bouncing;

    impl Transition for Bouncing {
        fn agent_count(&self) -> usize {
            AGENTS
        }

        fn evaluate_into(&self, ts: &[f64], plan: &mut [DVec2], _heights: Option<&mut [f64]>) {
            for (t, places) in ts.iter().zip(plan.chunks_exact_mut(AGENTS)) {
                places.fill(DVec2::splat((t - 0.3).abs()));
            }
        }
    }

    #[test]
    fn a_path_with_a_corner_is_kept() {
        assert_eq!(apart(|| Box::new(Bouncing)), None);
    }

    #[test]
    fn who_is_level_stays_so_to_the_bit() {
        let [source, target] = [0, 1].map(|seed| strewn(seed, |_| 0.1));
        let chain = Chain::between(source, target);
        let path = interpolated(Planner::default().plan(&chain, &ways(MethodName::Spectral, 0.5, false)), LEAST_INSTANTS);
        assert!(places_at(&*path, &[0.0, 0.3, 0.77, 1.0]).iter().all(|place| place.z == chain.formation(0).height(0)));
    }
}
