//! How big a formation is and how close its agents stand.

use super::{Formation, PairSearch};
use crate::order;

impl Formation {
    /// The root of the mean squared distance from the barycenter, meters; 0 for no agents.
    pub fn rms_radius(&self) -> f64 {
        let middle = self.places().barycenter();
        let sum: f64 = self.places().iter().map(|place| place.distance_squared(middle)).sum();
        if self.agent_count() == 0 { 0.0 } else { (sum / self.agent_count() as f64).sqrt() }
    }

    /// By agent the distance to the nearest other, meters; infinite for one alone.
    pub fn nearest_distances(&self) -> Vec<f64> {
        self.nearest_squared(self.agent_count()).into_iter().map(f64::sqrt).collect()
    }

    /// The median over the agents of the distance to the nearest other, meters (the mean of the middle two of an even number);
    /// none below two agents.
    pub fn median_spacing(&self) -> Option<f64> {
        let agent_count = self.agent_count();
        if agent_count < 2 {
            return None;
        }
        let mut nearest = self.nearest_squared(agent_count / 2 + 1);
        order::sort_by_key(&mut nearest, |distance| u128::from(order::of_real(*distance)));
        let (lower, upper) = (nearest[(agent_count - 1) / 2].sqrt(), nearest[agent_count / 2].sqrt());
        Some(f64::midpoint(lower, upper))
    }

    /// By agent the squared distance to the nearest other, where it is among the `wanted` least; others may be infinite.
    fn nearest_squared(&self, wanted: usize) -> Vec<f64> {
        let agent_count = self.agent_count();
        // A hair wider than the formation is: two agents are as far apart as it is wide, in another rounding.
        let (places, extent) = (self.places(), self.extent() * (1.0 + 1e-9));
        let mut search = PairSearch::default();
        let mut nearest = vec![f64::INFINITY; agent_count];
        // What is found within the radius is final, so the radius grows only until it has found the middle.
        let mut radius = extent / agent_count.max(1) as f64;
        loop {
            search.for_each_within(self.positions(), radius, |a, b, _| {
                let distance_squared = places.at(a as usize).distance_squared(places.at(b as usize));
                for agent in [a, b].into_iter().filter(|_| distance_squared <= radius * radius) {
                    let nearest = &mut nearest[agent as usize];
                    *nearest = nearest.min(distance_squared);
                }
            });
            let found = nearest.iter().filter(|nearest| nearest.is_finite()).count();
            if found >= wanted || radius >= extent {
                return nearest;
            }
            radius *= 2.0;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn check(points: &[[f64; 2]], spacing: Option<f64>) {
        assert_eq!(Formation::from(points.to_vec()).median_spacing(), spacing);
    }

    #[test]
    fn spacing_is_the_median_to_the_nearest() {
        check(&[], None);
        check(&[[1.0, 1.0]], None);
        check(&[[1.0, 1.0]; 3], Some(0.0));
        check(&[[0.0, 0.0], [3.0, 4.0]], Some(5.0));
        // Nearest distances 1, 1, 2, 3.
        check(&[[0.0, 0.0], [1.0, 0.0], [3.0, 0.0], [6.0, 0.0]], Some(1.5));
        // One agent far away, and the others nearer to one another than the extent suggests.
        check(&[[0.0, 0.0], [0.5, 0.0], [0.0, 0.5], [9e4, 0.0]], Some(0.5));
    }

    #[test]
    fn an_rms_radius_is_taken_from_the_barycenter() {
        let square = Formation::from(vec![[1.0, 1.0], [3.0, 1.0], [3.0, 3.0], [1.0, 3.0]]);
        assert!((square.rms_radius() - 2f64.sqrt()).abs() < 1e-15);
        assert!(Formation::default().rms_radius().abs() < f64::MIN_POSITIVE);
    }

    #[test]
    fn everybody_has_a_nearest_but_one_alone() {
        let row = Formation::from(vec![[0.0, 0.0], [1.0, 0.0], [3.0, 0.0], [9e4, 0.0]]);
        assert_eq!(row.nearest_distances(), [1.0, 1.0, 2.0, 9e4 - 3.0]);
        // Two may be a rounding farther apart than the formation is wide.
        for (x, y) in (1..100).map(|k| (f64::from(k) * 0.093, f64::from(k) * 0.037)) {
            let pair = Formation::from(vec![[-4.9, 1.0], [x, y]]);
            assert!(pair.nearest_distances().iter().all(|nearest| (nearest - pair.extent()).abs() < 1e-12), "{x}, {y}");
        }
        assert_eq!(Formation::from(vec![[2.0, 2.0]]).nearest_distances(), [f64::INFINITY]);
        assert!(Formation::default().nearest_distances().is_empty());
    }
}
