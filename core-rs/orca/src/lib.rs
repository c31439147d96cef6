//! A crowd by optimal reciprocal collision avoidance (van den Berg, Guy, Lin and Manocha 2011): what others would do, to compare with.
//!
//! The crate `dodgy_2d`, a port of RVO2, finds the velocity of each agent among those it is told of. Who is near whom is found here: its
//! own simulator looks at every pair and leaves out some that are near. It counts in single precision, so it is told of places as an
//! agent sees them, not of places on the stage. Aims, bodies and steps are those of `eigenform-force`.

#![forbid(unsafe_code)]

mod near;
mod walls;

use std::borrow::Cow;

use dodgy_2d::{Agent, AvoidanceOptions, Obstacle, Vec2};
use eigenform_force::Bodies;

pub use eigenform_apart::Outline;

use near::Near;

/// What pedestrians are given in the examples of Menge (Curtis, Best and Manocha 2016): how far they look, how many they heed, and for
/// how many seconds ahead they keep clear of each other.
const SIGHT: f64 = 5.0;
const HEEDED: usize = 10;
const FORESIGHT: f32 = 3.0;

/// The same of what stands still.
const WALL_FORESIGHT: f32 = 1.0;

/// What is added to a wish where all is symmetric, as RVO2's own examples do: so little, as a share of the greatest speed.
const NUDGE: f64 = 1e-4;

/// The golden angle: no two of those who stand together are nudged alike.
const TURN: f64 = 2.399_963_229_728_653;

/// Where a crowd is; lengths in units.
#[derive(Clone, Debug)]
pub struct Setting {
    /// What stands in the way.
    pub obstacles: Vec<Outline>,
    /// One unit, meters: people see as far at any scale.
    pub unit: f64,
    /// Nobody wants to be faster than this, a second.
    pub wished: f64,
    /// Nobody is faster than this, a second.
    pub greatest: f64,
}

/// Agents on their way.
pub struct Walkers {
    x: Vec<f64>,
    y: Vec<f64>,
    vx: Vec<f64>,
    vy: Vec<f64>,
    aim_x: Vec<f64>,
    aim_y: Vec<f64>,
    radius: Vec<f64>,
    top_speed: Vec<f64>,
    near: Near,
    walls: Vec<walls::Wall>,
    setting: Setting,
}

impl Walkers {
    /// Agents that aim where they stand; subgroups mean nothing to them.
    ///
    /// # Panics
    /// When the lists are not equally long: a bug.
    pub fn new(bodies: Bodies, setting: Setting) -> Self {
        let Bodies { x, y, vx, vy, radius, top_speed, group: _ } = bodies;
        assert!([&y, &vx, &vy, &radius, &top_speed].iter().all(|list| list.len() == x.len()), "every agent is told");
        Self {
            aim_x: x.clone(),
            aim_y: y.clone(),
            near: Near::new(SIGHT / setting.unit),
            walls: setting.obstacles.iter().map(walls::Wall::new).collect(),
            x,
            y,
            vx,
            vy,
            radius,
            top_speed,
            setting,
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

    /// Moves on by `seconds`; agents want to be where they aim `within` seconds from now.
    pub fn step(&mut self, seconds: f64, within: f64) {
        self.near.sort(&self.x, &self.y);
        let next: Vec<[f64; 2]> = (0..self.x.len()).map(|agent| self.velocity(agent, seconds, within)).collect();
        for (agent, [vx, vy]) in next.into_iter().enumerate() {
            (self.vx[agent], self.vy[agent]) = (vx, vy);
            self.x[agent] += seconds * vx;
            self.y[agent] += seconds * vy;
        }
    }

    fn velocity(&self, agent: usize, seconds: f64, within: f64) -> [f64; 2] {
        let at = [self.x[agent], self.y[agent]];
        let neighbors: Vec<Cow<Agent>> = self.near.nearest(agent, HEEDED).iter().map(|other| Cow::Owned(self.seen(*other, at))).collect();
        let sight = SIGHT / self.setting.unit;
        let walls: Vec<Cow<Obstacle>> =
            self.walls.iter().filter(|wall| wall.is_within(sight, at)).map(|wall| Cow::Owned(wall.seen(at))).collect();
        let greatest = self.setting.greatest.min(self.top_speed[agent]);
        let options =
            AvoidanceOptions { obstacle_margin: self.radius[agent] as f32, time_horizon: FORESIGHT, obstacle_time_horizon: WALL_FORESIGHT };
        let found = self.seen(agent, at).compute_avoiding_velocity(
            &neighbors,
            &walls,
            self.wish(agent, within),
            greatest as f32,
            seconds as f32,
            &options,
        );
        [f64::from(found.x), f64::from(found.y)]
    }

    /// Toward the aim, as fast as to be there in time, and never faster than one can and any would; a trace aside.
    fn wish(&self, agent: usize, within: f64) -> Vec2 {
        let way = [self.aim_x[agent] - self.x[agent], self.aim_y[agent] - self.y[agent]];
        let length = (way[0] * way[0] + way[1] * way[1]).sqrt();
        let speed = (length / within).min(self.top_speed[agent]).min(self.setting.wished);
        let per_length = if length > 0.0 { speed / length } else { 0.0 };
        let (sin, cos) = (TURN * agent as f64).sin_cos();
        // Whoever is there stays there.
        let nudge = NUDGE * speed;
        Vec2::new((way[0] * per_length + nudge * cos) as f32, (way[1] * per_length + nudge * sin) as f32)
    }

    /// An agent as seen from a place. Where two stand in one place, each is seen a trace beside: else the crate would draw lots.
    fn seen(&self, agent: usize, from: [f64; 2]) -> Agent {
        let (sin, cos) = (TURN * agent as f64).sin_cos();
        let trace = NUDGE * self.radius[agent];
        Agent {
            position: Vec2::new((self.x[agent] - from[0] + trace * cos) as f32, (self.y[agent] - from[1] + trace * sin) as f32),
            velocity: Vec2::new(self.vx[agent] as f32, self.vy[agent] as f32),
            radius: self.radius[agent] as f32,
            avoidance_responsibility: 1.0,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const STEP: f64 = 1.0 / 30.0;

    fn walkers(places: &[(f64, f64)], obstacles: Vec<Outline>) -> Walkers {
        let still = vec![0.0; places.len()];
        let bodies = Bodies {
            x: places.iter().map(|place| place.0).collect(),
            y: places.iter().map(|place| place.1).collect(),
            vx: still.clone(),
            vy: still,
            radius: vec![0.25; places.len()],
            top_speed: vec![f64::INFINITY; places.len()],
            group: Vec::new(),
        };
        Walkers::new(bodies, Setting { obstacles, unit: 1.0, wished: 1.4, greatest: 2.0 })
    }

    /// Steps while everybody aims at a place that stays; the nearest that any two come.
    fn walk(walkers: &mut Walkers, aims: &[(f64, f64)], steps: usize) -> f64 {
        let [x, y] = walkers.aims_mut();
        for (agent, aim) in aims.iter().enumerate() {
            (x[agent], y[agent]) = *aim;
        }
        let mut nearest = f64::INFINITY;
        for _ in 0..steps {
            walkers.step(STEP, 0.5);
            let [x, y] = walkers.places();
            for a in 0..x.len() {
                for b in 0..a {
                    nearest = nearest.min((x[a] - x[b]).hypot(y[a] - y[b]));
                }
            }
        }
        nearest
    }

    fn farthest(walkers: &Walkers, aims: &[(f64, f64)]) -> f64 {
        let [x, y] = walkers.places();
        aims.iter().enumerate().map(|(agent, aim)| (x[agent] - aim.0).hypot(y[agent] - aim.1)).fold(0.0, f64::max)
    }

    #[test]
    fn who_is_alone_goes_straight_as_fast_as_wished() {
        let mut alone = walkers(&[(0.0, 0.0)], Vec::new());
        walk(&mut alone, &[(30.0, 40.0)], 300);
        let [x, y] = alone.places();
        // 10 s at 1.4; a trace of 1e-4 aside, and single precision.
        assert!((x[0] - 8.4).abs() < 0.01 && (y[0] - 11.2).abs() < 0.01, "{} {}", x[0], y[0]);
    }

    #[test]
    fn a_circle_changes_sides_and_nobody_touches() {
        let around = |k: i32, radius: f64| (radius * f64::from(k).cos(), radius * f64::from(k).sin());
        let start: Vec<(f64, f64)> = (0..6).map(|k| around(k, 6.0)).collect();
        let end: Vec<(f64, f64)> = (0..6).map(|k| around(k, -6.0)).collect();
        let mut circle = walkers(&start, Vec::new());
        let nearest = walk(&mut circle, &end, 900);
        // Two bodies, and what a step of 1/30 s at 2 may err.
        assert!(nearest > 0.5 - 0.02, "{nearest}");
        assert!(farthest(&circle, &end) < 0.05, "{}", farthest(&circle, &end));
    }

    #[test]
    fn two_in_one_place_come_apart_the_same_way_every_time() {
        let apart = || {
            let mut pair = walkers(&[(1e4, 0.0), (1e4, 0.0)], Vec::new());
            walk(&mut pair, &[(1e4, 0.0), (1e4, 0.0)], 60);
            let [x, y] = pair.places();
            [x[0], y[0], x[1], y[1]]
        };
        let [x0, y0, x1, y1] = apart();
        assert!((x1 - x0).hypot(y1 - y0) > 0.3);
        assert_eq!(apart(), [x0, y0, x1, y1]);
    }

    #[test]
    fn what_stands_in_the_way_is_walked_around() {
        for points in [
            vec![[5.0, 0.1]],
            vec![[4.0, -1.0], [6.0, -1.0], [6.0, 1.2], [4.0, 1.2]],
            vec![[4.0, 1.2], [6.0, 1.2], [6.0, -1.0], [4.0, -1.0]],
        ] {
            let outline = Outline { radius: if points.len() == 1 { 1.0 } else { 0.0 }, points };
            let mut alone = walkers(&[(0.0, 0.0)], vec![outline.clone()]);
            let [x, _] = alone.aims_mut();
            x[0] = 10.0;
            for _ in 0..600 {
                alone.step(STEP, 0.5);
                let [x, y] = alone.places();
                assert!(outline.clearance([x[0], y[0]]).0 > 0.2, "{} {}", x[0], y[0]);
            }
        }
    }
}
