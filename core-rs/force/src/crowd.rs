//! The state of a crowd and its steps: semi-implicit Euler.

use eigenform_apart::Outline;

use crate::constants::Constants;
use crate::feedback::{Feedback, Sharing};
use crate::groups::Groups;
use crate::noise::noise;
use crate::obstacles::Obstacles;
use crate::repulsion::Repulsion;
use crate::wishes::Wishes;

/// Who is in a crowd; every list has an entry an agent.
#[derive(Clone, Debug, Default)]
pub struct Bodies {
    /// Where they start.
    pub x: Vec<f64>,
    /// The other coordinate.
    pub y: Vec<f64>,
    /// How they start, lengths a second.
    pub vx: Vec<f64>,
    /// The other coordinate.
    pub vy: Vec<f64>,
    /// Body radius.
    pub radius: Vec<f64>,
    /// Lengths a second; infinite for no limit.
    pub top_speed: Vec<f64>,
    /// The subgroup, from 0, or [`crate::NO_GROUP`].
    pub group: Vec<u32>,
}

/// Where a crowd is.
#[derive(Clone, Debug, Default)]
pub struct Setting {
    /// What stands in the way.
    pub obstacles: Vec<Outline>,
    /// By agent, whether it goes its way through all of that; empty: nobody does.
    pub goes_through: Vec<bool>,
    /// The body radius that the constants are made for.
    pub usual_radius: f64,
    /// Nobody wants to be faster than this, however late, lengths a second.
    pub hurry: f64,
    /// Of the fluctuation.
    pub seed: u32,
}

/// Agents on their way.
#[derive(Clone, Debug)]
pub struct Crowd {
    constants: Constants,
    feedback: Feedback,
    x: Vec<f64>,
    y: Vec<f64>,
    vx: Vec<f64>,
    vy: Vec<f64>,
    fx: Vec<f64>,
    fy: Vec<f64>,
    aim_x: Vec<f64>,
    aim_y: Vec<f64>,
    top_speed: Vec<f64>,
    wishes: Wishes,
    sharing: Sharing,
    groups: Groups,
    repulsion: Repulsion,
    obstacles: Obstacles,
    hurry: f64,
    seed: u32,
    step_count: u32,
}

impl Crowd {
    /// A crowd that aims where it stands.
    ///
    /// # Panics
    /// When the lists are not equally long: a bug.
    pub fn new(constants: Constants, feedback: Feedback, bodies: Bodies, setting: Setting) -> Self {
        let Setting { obstacles, goes_through, usual_radius, hurry, seed } = setting;
        let Bodies { x, y, vx, vy, radius, top_speed, group } = bodies;
        let count = x.len();
        let goes_through = |agent: usize| goes_through.get(agent).copied().unwrap_or(false);
        let pushed = radius.iter().enumerate().map(|(agent, radius)| (!goes_through(agent)).then_some(*radius)).collect();
        assert!([&y, &vx, &vy, &radius, &top_speed].iter().all(|list| list.len() == count) && group.len() == count, "every agent is told");
        Self {
            fx: vec![0.0; count],
            fy: vec![0.0; count],
            aim_x: x.clone(),
            aim_y: y.clone(),
            wishes: Wishes::new(count),
            sharing: Sharing::new(count, constants.sectors),
            groups: Groups::new(group),
            repulsion: Repulsion::new(radius.iter().map(|radius| radius - usual_radius).collect()),
            constants,
            feedback,
            x,
            y,
            vx,
            vy,
            top_speed,
            obstacles: Obstacles::new(obstacles, pushed),
            hurry,
            seed,
            step_count: 0,
        }
    }

    /// Where everybody is: x and y by agent.
    pub fn places(&self) -> [&[f64]; 2] {
        [&self.x, &self.y]
    }

    /// Where everybody wants to be next: x and y by agent.
    pub fn aims_mut(&mut self) -> [&mut [f64]; 2] {
        [&mut self.aim_x, &mut self.aim_y]
    }

    /// Lengths a second, by agent.
    pub fn top_speeds_mut(&mut self) -> &mut [f64] {
        &mut self.top_speed
    }

    /// Moves on by `seconds`; agents want to be where they aim `within` seconds from now.
    pub fn step(&mut self, seconds: f64, within: f64) {
        self.wish(within);
        if self.feedback.direction || self.feedback.speed {
            let state = [&self.x, &self.y, &self.vx, &self.vy].map(Vec::as_slice);
            self.sharing.feed_back(&self.constants, self.feedback, state, &mut self.wishes);
        }
        self.gather_forces();
        for agent in 0..self.x.len() {
            let (mut vx, mut vy) = (self.vx[agent] + seconds * self.fx[agent], self.vy[agent] + seconds * self.fy[agent]);
            let (speed, top) = ((vx * vx + vy * vy).sqrt(), self.top_speed[agent]);
            if speed > top {
                (vx, vy) = (vx * (top / speed), vy * (top / speed));
            }
            (self.vx[agent], self.vy[agent]) = (vx, vy);
            self.x[agent] += seconds * vx;
            self.y[agent] += seconds * vy;
        }
        self.step_count = self.step_count.wrapping_add(1);
    }

    /// e and v⁰: toward the aim, as fast as to be there in time, and never faster than one can and any would.
    fn wish(&mut self, within: f64) {
        for agent in 0..self.x.len() {
            let way = [self.aim_x[agent] - self.x[agent], self.aim_y[agent] - self.y[agent]];
            let length = (way[0] * way[0] + way[1] * way[1]).sqrt();
            let per_length = if length > 0.0 { 1.0 / length } else { 0.0 };
            self.wishes.ex[agent] = way[0] * per_length;
            self.wishes.ey[agent] = way[1] * per_length;
            self.wishes.speed[agent] = (length / within).min(self.top_speed[agent]).min(self.hurry);
        }
    }

    /// All forces of equation 23.
    fn gather_forces(&mut self) {
        let constants = &self.constants;
        let rate = 1.0 / constants.reaction_time;
        for agent in 0..self.x.len() {
            let speed = self.wishes.speed[agent];
            self.fx[agent] = rate * (speed * self.wishes.ex[agent] - self.vx[agent]);
            self.fy[agent] = rate * (speed * self.wishes.ey[agent] - self.vy[agent]);
        }
        let places = [self.x.as_slice(), self.y.as_slice()];
        self.repulsion.push_apart(constants, &self.groups, places, [&mut self.fx, &mut self.fy]);
        self.obstacles.push_off(constants, places, [&mut self.fx, &mut self.fy]);
        self.groups.attract(constants, places, [&mut self.fx, &mut self.fy]);
        if constants.fluctuation > 0.0 {
            for agent in 0..self.x.len() {
                let [x, y] = noise(self.seed, self.step_count, agent as u32);
                self.fx[agent] += constants.fluctuation * x;
                self.fy[agent] += constants.fluctuation * y;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::groups::NO_GROUP;

    const STEP: f64 = 1.0 / 30.0;

    const OFF: Feedback = Feedback { direction: false, speed: false };

    fn bodies(places: &[(f64, f64)]) -> Bodies {
        let still = vec![0.0; places.len()];
        Bodies {
            x: places.iter().map(|place| place.0).collect(),
            y: places.iter().map(|place| place.1).collect(),
            vx: still.clone(),
            vy: still,
            radius: vec![0.25; places.len()],
            top_speed: vec![f64::INFINITY; places.len()],
            group: vec![NO_GROUP; places.len()],
        }
    }

    fn crowd(constants: Constants, bodies: Bodies, obstacles: Vec<Outline>) -> Crowd {
        Crowd::new(constants, OFF, bodies, Setting { obstacles, usual_radius: 0.25, hurry: 50.0, seed: 1, ..Setting::default() })
    }

    /// Steps while everybody aims at a place that stays.
    fn walk(crowd: &mut Crowd, aims: &[(f64, f64)], steps: usize) {
        let [x, y] = crowd.aims_mut();
        for (agent, aim) in aims.iter().enumerate() {
            (x[agent], y[agent]) = *aim;
        }
        for _ in 0..steps {
            crowd.step(STEP, 1.0);
        }
    }

    fn at(crowd: &Crowd, agent: usize) -> (f64, f64) {
        let [x, y] = crowd.places();
        (x[agent], y[agent])
    }

    #[test]
    fn who_is_alone_goes_straight_and_arrives() {
        let mut alone = crowd(Constants::default(), bodies(&[(0.0, 0.0)]), Vec::new());
        walk(&mut alone, &[(3.0, 4.0)], 600);
        let (x, y) = at(&alone, 0);
        // 20 s of approach at a rate of one in 1 s leave e⁻¹⁵ of the way, whatever the reaction adds.
        assert!((x - 3.0).abs() < 1e-5 && (y - 4.0).abs() < 1e-5, "{x} {y}");
        assert!((x * 4.0 - y * 3.0).abs() < 1e-12, "straight");
    }

    #[test]
    fn nobody_is_faster_than_they_can() {
        let slow = Bodies { top_speed: vec![0.5], ..bodies(&[(0.0, 0.0)]) };
        let mut slow = crowd(Constants::default(), slow, Vec::new());
        for step in 1..=30 {
            let before = at(&slow, 0).0;
            walk(&mut slow, &[(100.0, 0.0)], 1);
            assert!(at(&slow, 0).0 - before <= 0.5 * STEP * (1.0 + 1e-12), "step {step}");
        }
    }

    #[test]
    fn two_push_each_other_equally_and_larger_bodies_more() {
        let rest = |radius: f64| {
            let pair = Bodies { radius: vec![0.25, radius], ..bodies(&[(0.0, 0.0), (0.5, 0.0)]) };
            let mut pair = crowd(Constants::default(), pair, Vec::new());
            walk(&mut pair, &[(0.0, 0.0), (0.5, 0.0)], 300);
            let (left, right) = (at(&pair, 0).0, at(&pair, 1).0);
            assert!((left + right - 0.5).abs() < 1e-12, "the barycenter stays");
            right - left
        };
        assert!(rest(0.25) > 0.55, "{}", rest(0.25));
        assert!(rest(0.5) > rest(0.25) + 0.05);
    }

    #[test]
    fn even_two_in_one_place_come_apart() {
        let mut pair = crowd(Constants::default(), bodies(&[(0.0, 0.0), (0.0, 0.0)]), Vec::new());
        walk(&mut pair, &[(0.0, 0.0), (0.0, 0.0)], 60);
        assert!(at(&pair, 1).0 - at(&pair, 0).0 > 0.2);
    }

    #[test]
    fn two_who_meet_head_on_pass_each_other() {
        let mut pair = crowd(Constants::default(), bodies(&[(0.0, 0.0), (6.0, 0.0)]), Vec::new());
        let mut nearest = f64::INFINITY;
        for _ in 0..900 {
            let ([x, y], within) = (pair.aims_mut(), 4.0);
            (x[0], x[1], y[0], y[1]) = (6.0, 0.0, 0.0, 0.0);
            pair.step(STEP, within);
            nearest = nearest.min((at(&pair, 0).0 - at(&pair, 1).0).hypot(at(&pair, 0).1 - at(&pair, 1).1));
        }
        assert!(nearest > 0.2, "{nearest}");
        assert!(at(&pair, 0).0 > 5.9 && at(&pair, 1).0 < 0.1);
    }

    #[test]
    fn a_subgroup_draws_its_members_and_keeps_strangers_off() {
        let row = [(0.0, 0.0), (3.0, 0.0), (6.0, 0.0), (9.0, 0.0)];
        let width = |group: [u32; 4], pair: [usize; 2]| {
            let mut all = crowd(Constants::default(), Bodies { group: group.to_vec(), ..bodies(&row) }, Vec::new());
            walk(&mut all, &row, 300);
            at(&all, pair[1]).0 - at(&all, pair[0]).0
        };
        assert!(width([0, 0, 1, 1], [0, 1]) < 3.0 - 0.1);
        assert!(width([0, 0, 1, 1], [1, 2]) > 3.0 + 0.1);
        // What nobody asks for is not there: farther than any push reaches.
        assert_eq!(width([NO_GROUP; 4], [0, 3]), 9.0);
    }

    #[test]
    fn an_obstacle_is_not_walked_through() {
        let circle = Outline { points: vec![[5.0, 0.1]], radius: 1.0 };
        let mut alone = crowd(Constants::default(), bodies(&[(0.0, 0.0)]), vec![circle.clone()]);
        alone.aims_mut()[0][0] = 10.0;
        for _ in 0..600 {
            // Two lengths a second at first.
            alone.step(STEP, 5.0);
            let (x, y) = at(&alone, 0);
            assert!(circle.clearance([x, y]).0 > 0.0, "at {x} {y}");
        }
    }

    #[test]
    fn who_goes_through_an_obstacle_walks_as_if_it_were_not_there() {
        let walked = |obstacles: Vec<Outline>| {
            let setting = Setting { obstacles, goes_through: vec![true], usual_radius: 0.25, hurry: 50.0, ..Setting::default() };
            let mut alone = Crowd::new(Constants::default(), OFF, bodies(&[(0.0, 0.0)]), setting);
            walk(&mut alone, &[(10.0, 0.0)], 100);
            at(&alone, 0)
        };
        assert_eq!(walked(vec![Outline { points: vec![[5.0, 0.1]], radius: 1.0 }]), walked(Vec::new()));
    }

    #[test]
    fn fluctuation_repeats_by_seed_and_is_as_large_as_told() {
        let constants = Constants { fluctuation: 1.0, ..Constants::default() };
        let places = [(0.0, 0.0), (50.0, 0.0)];
        let run = |seed: u32| {
            let setting = Setting { usual_radius: 0.25, hurry: 50.0, seed, ..Setting::default() };
            let mut shaken = Crowd::new(constants, OFF, bodies(&places), setting);
            walk(&mut shaken, &places, 40);
            (at(&shaken, 0), at(&shaken, 1))
        };
        assert_eq!(run(3), run(3));
        assert_ne!(run(3), run(4));
        let (x, y) = run(3).0;
        // No farther than the same acceleration would lead against the driving force: τ per second.
        assert!(x.hypot(y) > 1e-4 && x.hypot(y) < 1.0, "{x} {y}");
    }
}
