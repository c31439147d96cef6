//! Places of all agents at one instant, in plan or in space, wherever they are stored.

use glam::{DVec2, DVec3};

use super::Formation;

impl Formation {
    /// Where everybody stands.
    pub fn places(&self) -> Places<'_> {
        Places::new(self.positions(), self.heights())
    }

    /// The formation of some of its agents, in the order given.
    #[must_use]
    pub fn only(&self, agents: &[u32]) -> Self {
        let plan = agents.iter().map(|&agent| self.positions()[agent as usize]).collect();
        match self.heights() {
            Some(heights) => Self::spatial(plan, agents.iter().map(|&agent| heights[agent as usize]).collect()),
            None => Self::new(plan),
        }
    }
}

/// Where everybody is: in plan, and how high where the formation leaves the ground. Meters, by agent index.
#[derive(Clone, Copy, Debug, Default)]
pub struct Places<'a> {
    plan: &'a [DVec2],
    heights: Option<&'a [f64]>,
}

impl<'a> Places<'a> {
    /// Without heights everybody stands on the ground.
    ///
    /// # Panics
    /// When there are not as many heights as places in plan: a bug, not input.
    pub fn new(plan: &'a [DVec2], heights: Option<&'a [f64]>) -> Self {
        assert!(heights.is_none_or(|heights| heights.len() == plan.len()), "every agent has a height, or none has");
        Self { plan, heights }
    }

    /// Seen from above.
    pub fn plan(self) -> &'a [DVec2] {
        self.plan
    }

    /// Heights; none when everybody stands on the ground.
    pub fn heights(self) -> Option<&'a [f64]> {
        self.heights
    }

    /// How many agents.
    pub fn agent_count(self) -> usize {
        self.plan.len()
    }

    /// Whether everybody is equally high: what the plan alone decides.
    pub fn is_level(self) -> bool {
        self.heights.is_none_or(|heights| heights.iter().all(|height| *height == heights[0]))
    }

    /// Where an agent is.
    pub fn at(self, agent: usize) -> DVec3 {
        self.plan[agent].extend(self.heights.map_or(0.0, |heights| heights[agent]))
    }

    /// How far apart two agents are.
    pub fn distance(self, a: usize, b: usize) -> f64 {
        self.at(a).distance(self.at(b))
    }

    /// All of them, in order.
    pub fn iter(self) -> impl Iterator<Item = DVec3> + use<'a> {
        (0..self.plan.len()).map(move |agent| self.at(agent))
    }

    /// The mean place; the origin for nobody. Of equal heights it is that height, without round-off.
    pub fn barycenter(self) -> DVec3 {
        if self.plan.is_empty() {
            return DVec3::ZERO;
        }
        let mean = self.iter().sum::<DVec3>() / self.plan.len() as f64;
        if self.is_level() { mean.with_z(self.at(0).z) } else { mean }
    }

    /// Opposite corners of the bounding box; both the origin for nobody.
    pub fn bounds(self) -> (DVec3, DVec3) {
        let first = self.iter().next().unwrap_or_default();
        self.iter().fold((first, first), |(low, high), place| (low.min(place), high.max(place)))
    }

    /// From the barycenter to everybody.
    pub fn about_barycenter(self) -> Vec<DVec3> {
        let center = self.barycenter();
        self.iter().map(|place| place - center).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const PLAN: [DVec2; 3] = [DVec2::new(1.0, 2.0), DVec2::new(4.0, 2.0), DVec2::new(4.0, 6.0)];

    #[test]
    fn without_heights_everybody_stands_on_the_ground() {
        let places = Places::new(&PLAN, None);
        assert!(places.is_level());
        assert_eq!(places.at(2), DVec3::new(4.0, 6.0, 0.0));
        assert_eq!(places.distance(0, 2), 5.0);
    }

    #[test]
    fn equal_heights_are_level_and_leave_no_rest_about_the_barycenter() {
        let level = Places::new(&PLAN, Some(&[0.1; 3]));
        assert!(level.is_level() && level.about_barycenter().iter().all(|away| away.z == 0.0));
        let lifted = Places::new(&PLAN, Some(&[0.0, 12.0, 0.0]));
        assert!(!lifted.is_level());
        assert_eq!(lifted.bounds(), (DVec3::new(1.0, 2.0, 0.0), DVec3::new(4.0, 6.0, 12.0)));
        assert_eq!(lifted.barycenter().z, 4.0);
    }
}
