//! Shortest ways that keep a distance from obstacles, on the plane.
//!
//! A shortest way is straight but where it bends along an obstacle, whatever norm measures it: pulling it taut makes it shorter in all
//! of them. So it leads from bend to bend of a visibility graph. Round corners are walked in chords, 32 a full turn.

use std::collections::BinaryHeap;

use glam::DVec2;

use super::ObstacleShape;
use super::wall::{Bend, Wall};
use crate::order;

/// Ways keep this far from an obstacle at least, meters: what runs along a wall is beside it.
const LEAST_DISTANCE: f64 = 0.01;

/// Obstacles so near to one another push a place to and fro; after so many rounds it is shut in.
const ROUNDS: usize = 16;

/// What measures a way.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Norm {
    /// Its length.
    Euclidean,
    /// Its length along the axes.
    Manhattan,
}

impl Norm {
    /// Of a straight way, meters.
    pub fn of(self, way: DVec2) -> f64 {
        match self {
            Self::Euclidean => way.length(),
            Self::Manhattan => way.x.abs() + way.y.abs(),
        }
    }
}

/// Obstacles, and where ways around them bend.
pub struct Detours {
    walls: Vec<Wall>,
    bends: Vec<Bend>,
    /// By bend: the others that a way from it may bend at next. Rows are found one by one.
    next: Vec<Vec<u32>>,
    found: usize,
}

impl Detours {
    /// Around shapes at a distance, meters; no row of the graph is known yet.
    pub fn new<'a>(shapes: impl IntoIterator<Item = &'a ObstacleShape>, distance: f64) -> Self {
        let walls: Vec<Wall> = shapes.into_iter().map(|shape| Wall::new(shape, distance.max(LEAST_DISTANCE))).collect();
        let is_free = |bend: &Bend| walls.iter().all(|wall| wall.is_clear_of(bend.at, bend.at));
        let bends: Vec<Bend> = walls.iter().flat_map(Wall::bends).filter(is_free).collect();
        Self { next: vec![Vec::new(); bends.len()], walls, bends, found: 0 }
    }

    /// How many bends there are.
    pub fn bend_count(&self) -> usize {
        self.bends.len()
    }

    /// How many obstacles.
    pub fn wall_count(&self) -> usize {
        self.walls.len()
    }

    /// Where a bend is.
    pub fn bend(&self, bend: u32) -> DVec2 {
        self.bends[bend as usize].at
    }

    /// Finds one more row of the graph; whether all are known.
    pub fn find_row(&mut self) -> bool {
        if let Some(own) = self.bends.get(self.found).copied() {
            for other in 0..self.found {
                let there = self.bends[other];
                if own.is_smooth(there.at) && there.is_smooth(own.at) && self.is_clear(own.at, there.at) {
                    self.next[self.found].push(other as u32);
                    self.next[other].push(self.found as u32);
                }
            }
            self.found += 1;
        }
        self.found >= self.bends.len()
    }

    /// Whether a straight way keeps the distance.
    pub fn is_clear(&self, from: DVec2, to: DVec2) -> bool {
        self.walls.iter().all(|wall| wall.is_clear_of(from, to))
    }

    /// The obstacles that a straight way comes too near to, by number.
    pub fn blocking(&self, from: DVec2, to: DVec2) -> impl Iterator<Item = usize> {
        (0..self.walls.len()).filter(move |wall| !self.walls[*wall].is_clear_of(from, to))
    }

    /// The place itself where it keeps the distance, else one near by that does; none where there is none.
    pub fn exit(&self, place: DVec2) -> Option<DVec2> {
        let mut at = place;
        for _ in 0..ROUNDS {
            if self.is_clear(at, at) {
                return Some(at);
            }
            let deepest = self.walls.iter().min_by(|a, b| a.beyond(at).0.total_cmp(&b.beyond(at).0))?;
            at = deepest.out(at);
        }
        None
    }

    /// The bends that a straight way from a place may lead to.
    pub fn seen_from(&self, place: DVec2) -> Vec<u32> {
        let is_seen = |bend: &Bend| bend.is_smooth(place) && self.is_clear(place, bend.at);
        (0..).zip(&self.bends).filter(|(_, bend)| is_seen(bend)).map(|(number, _)| number).collect()
    }

    /// The shortest way from one place to another, both included; where one is not clear, over a place near by. None where no way leads.
    /// All rows of the graph are known.
    pub fn way(&self, from: DVec2, to: DVec2) -> Option<Vec<DVec2>> {
        let (start, end) = (self.exit(from)?, self.exit(to)?);
        let mut way = vec![to, end];
        if !self.is_clear(start, end) {
            let (known, before) = self.from(start, &self.seen_from(start), Norm::Euclidean);
            let length = |bend: u32| known[bend as usize] + self.bend(bend).distance(end);
            let nearest = self.seen_from(end).into_iter().min_by(|a, b| length(*a).total_cmp(&length(*b)));
            let mut last = Some(nearest.filter(|bend| known[*bend as usize].is_finite())?);
            while let Some(bend) = last {
                way.push(self.bend(bend));
                last = before[bend as usize];
            }
        }
        way.extend([start, from]);
        way.reverse();
        way.dedup();
        Some(way)
    }

    /// What shuts two places off: the first of the obstacles between them without which a way would lead, else the first. `shapes` and
    /// `distance` are those it was made of.
    pub fn barrier(&self, shapes: &[ObstacleShape], distance: f64, ends: [DVec2; 2]) -> usize {
        let [from, to] = ends.map(|place| self.exit(place).unwrap_or(place));
        let blocking: Vec<usize> = self.blocking(from, to).collect();
        let opens = |obstacle: &usize| {
            let others = shapes.iter().enumerate().filter(|(number, _)| number != obstacle).map(|(_, shape)| shape);
            let mut detours = Self::new(others, distance);
            while !detours.find_row() {}
            detours.way(from, to).is_some()
        };
        blocking.iter().copied().find(opens).or(blocking.first().copied()).unwrap_or(0)
    }

    /// By bend, how far it is from a place that sees `first`, and the bend before it; infinite where no way leads, and no bend before
    /// the first. All rows of the graph are known.
    pub fn from(&self, place: DVec2, first: &[u32], norm: Norm) -> (Vec<f64>, Vec<Option<u32>>) {
        let mut distances = vec![f64::INFINITY; self.bends.len()];
        let mut before = vec![None; self.bends.len()];
        let mut heap = BinaryHeap::new();
        // The nearest on top; of equals the lowest.
        let entry = |distance: f64, bend: u32| (std::cmp::Reverse(order::of_real(distance)), std::cmp::Reverse(bend));
        for &bend in first {
            distances[bend as usize] = norm.of(self.bend(bend) - place);
            heap.push(entry(distances[bend as usize], bend));
        }
        while let Some((std::cmp::Reverse(key), std::cmp::Reverse(bend))) = heap.pop() {
            let so_far = distances[bend as usize];
            if key != order::of_real(so_far) {
                continue;
            }
            for &next in &self.next[bend as usize] {
                let distance = so_far + norm.of(self.bend(next) - self.bend(bend));
                if distance < distances[next as usize] {
                    distances[next as usize] = distance;
                    before[next as usize] = Some(bend);
                    heap.push(entry(distance, next));
                }
            }
        }
        (distances, before)
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use super::*;

    /// The shortest way between two places that do not see each other.
    fn length(shapes: &[ObstacleShape], from: [f64; 2], to: [f64; 2], norm: Norm) -> f64 {
        let mut detours = Detours::new(shapes, 0.5);
        while !detours.find_row() {}
        let (from, to) = (DVec2::from(from), DVec2::from(to));
        let (distances, _) = detours.from(from, &detours.seen_from(from), norm);
        let last = |bend: u32| distances[bend as usize] + norm.of(to - detours.bend(bend));
        detours.seen_from(to).into_iter().map(last).fold(f64::INFINITY, f64::min)
    }

    fn polygon(corners: &[[f64; 2]]) -> ObstacleShape {
        ObstacleShape::Polygon { points: corners.iter().copied().map(DVec2::from_array).collect() }
    }

    #[test]
    fn a_way_around_a_circle_is_two_tangents_and_an_arc() {
        let circle = ObstacleShape::Circle { center: DVec2::ZERO, radius: 1.5 };
        let found = length(&[circle], [-5.0, 0.0], [5.0, 0.0], Norm::Euclidean);
        // Radius 2: tangents of √(25 − 4), and what of the half turn their ends leave.
        let arc = 2.0 * (PI - 2.0 * (2.0_f64 / 5.0).acos());
        let exact = 2.0 * 21.0_f64.sqrt() + arc;
        // Chords are up to 0.2 % shorter than the arc; a tangent to a corner of theirs is longer by less than that.
        assert!((found - exact).abs() < 0.002 * arc, "{found} {exact}");
    }

    #[test]
    fn a_wall_is_passed_through_its_gap_and_around_its_end() {
        let wall = |low: f64, high: f64| polygon(&[[-0.1, low], [0.1, low], [0.1, high], [-0.1, high]]);
        let with_gap = [wall(-20.0, -1.0), wall(1.0, 20.0)];
        let through = length(&with_gap, [-3.0, 9.0], [3.0, 9.0], Norm::Euclidean);
        let around = length(&[wall(-20.0, 20.0)], [-3.0, 9.0], [3.0, 9.0], Norm::Euclidean);
        assert!((16.0..21.0).contains(&through) && around > 22.0, "{through} {around}");
        // Half a meter on either side needs a gap of one.
        let narrow = [wall(-20.0, -0.48), wall(0.48, 20.0)];
        assert!(length(&narrow, [-3.0, 9.0], [3.0, 9.0], Norm::Euclidean) > 22.0);
        let just = [wall(-20.0, -0.5), wall(0.5, 20.0)];
        assert!(length(&just, [-3.0, 9.0], [3.0, 9.0], Norm::Euclidean) < 21.0);
    }

    #[test]
    fn along_the_axes_a_way_around_a_block_is_as_long_as_its_sides() {
        let block = polygon(&[[-1.0, -4.0], [1.0, -4.0], [1.0, 2.0], [-1.0, 2.0]]);
        // Up past the corner at 2.5 and down again; chords lie on the rounded corner, so that none is cut.
        let found = length(&[block], [-3.0, 0.0], [3.0, 0.0], Norm::Manhattan);
        assert!((found - 11.0).abs() < 1e-9, "{found}");
    }

    #[test]
    fn a_closed_room_has_no_way_out() {
        let wall = |corners: [[f64; 2]; 4]| polygon(&corners);
        let room = [
            wall([[-5.0, -5.0], [5.0, -5.0], [5.0, -4.0], [-5.0, -4.0]]),
            wall([[-5.0, 4.0], [5.0, 4.0], [5.0, 5.0], [-5.0, 5.0]]),
            wall([[-5.0, -5.0], [-4.0, -5.0], [-4.0, 5.0], [-5.0, 5.0]]),
            wall([[4.0, -3.5], [5.0, -3.5], [5.0, 3.5], [4.0, 3.5]]),
        ];
        assert_eq!(length(&room, [0.0, 0.0], [9.0, 0.0], Norm::Euclidean), f64::INFINITY);
        assert!(length(&room[..3], [0.0, 0.0], [0.0, 9.0], Norm::Euclidean) < 30.0);
    }
}
