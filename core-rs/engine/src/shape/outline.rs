//! The edge of a shape, and places along it.

use glam::DVec2;

use super::picture::INSIDE;
use super::region::Region;

/// The level at which the edge lies between two pixels.
const EDGE: f64 = 127.5;

/// No edge of a pixel.
const NONE: u32 = u32::MAX;

/// Closed lines around everything that is inside, and around every hole in it.
pub(super) struct Outline {
    loops: Vec<Loop>,
}

struct Loop {
    corners: Vec<DVec2>,
    length: f64,
}

impl Outline {
    /// Follows the edge from each place where it crosses between two pixels to the next.
    pub(super) fn new(region: &Region) -> Self {
        let mut next = crossings(region);
        let mut loops = Vec::new();
        for start in 0..next.len() {
            let (mut corners, mut at) = (Vec::new(), start);
            while next[at] != NONE {
                corners.push(crossing(region, at));
                at = std::mem::replace(&mut next[at], NONE) as usize;
            }
            if !corners.is_empty() {
                let length = corners.iter().zip(after(&corners)).map(|(p, q)| p.distance(*q)).sum();
                loops.push(Loop { corners, length });
            }
        }
        Self { loops }
    }

    /// More places than this cannot be `distance` meters apart: each line has one, or no more than steps of it.
    pub(super) fn most(&self, distance: f64) -> usize {
        self.loops.iter().map(|line| ((line.length / distance) as usize).max(1)).sum()
    }

    /// Exactly `count` places: each line has its share by length, evenly along it from `phase` of a step.
    pub(super) fn places(&self, count: usize, phase: f64) -> Vec<DVec2> {
        let whole: f64 = self.loops.iter().map(|line| line.length).sum();
        let (mut places, mut passed) = (Vec::with_capacity(count), 0.0);
        for line in &self.loops {
            passed += line.length;
            // Up to here, rounded: what one line has too much the next has too little.
            let due = ((passed / whole * count as f64).round() as usize).min(count);
            line.add_places(due - places.len(), phase, &mut places);
        }
        places
    }
}

impl Loop {
    fn add_places(&self, count: usize, phase: f64, places: &mut Vec<DVec2>) {
        let step = self.length / count as f64;
        let (mut added, mut passed) = (0, 0.0);
        for (from, to) in self.corners.iter().zip(after(&self.corners)) {
            let length = from.distance(*to);
            while added < count {
                let due = (added as f64 + phase) * step - passed;
                if due > length {
                    break;
                }
                places.push(*from + (*to - *from) * (due / length.max(f64::MIN_POSITIVE)));
                added += 1;
            }
            passed += length;
        }
        // Rounding can leave the last one just past the end.
        places.extend((added..count).map(|_| self.corners[0]));
    }
}

/// The corner after each, around.
fn after(corners: &[DVec2]) -> impl Iterator<Item = &DVec2> {
    corners.iter().cycle().skip(1)
}

/// By edge between two pixels that the outline crosses: where it crosses next, with the inside always on the same hand.
///
/// Edge 2 · pixel lies between a pixel and the one to its right, 2 · pixel + 1 between it and the one below.
fn crossings(region: &Region) -> Vec<u32> {
    let (columns, rows) = region.size();
    let mut next = vec![NONE; 2 * columns * rows];
    for row in 0..rows - 1 {
        for column in 0..columns - 1 {
            // Clockwise from the upper left pixel, and the edge from each to the one after it.
            let corners = [(0, 0), (1, 0), (1, 1), (0, 1)].map(|(right, below)| region.covered(column + right, row + below));
            let pixel = row * columns + column;
            let edges = [2 * pixel, 2 * (pixel + 1) + 1, 2 * (pixel + columns), 2 * pixel + 1];
            let turns = |edge: usize, from: bool| {
                let inside = |at: usize| corners[at % 4] >= f64::from(INSIDE);
                inside(edge) == from && inside(edge + 1) != from
            };
            let is_joined = corners.iter().sum::<f64>() >= 4.0 * EDGE;
            for leaving in (0..4).filter(|&edge| turns(edge, true)) {
                // Where both diagonals differ, the middle says whether the inside is one piece or two.
                let around = [1, 2, 3].map(|turn| if is_joined { leaving + turn } else { leaving + 4 - turn });
                if let Some(entering) = around.into_iter().find(|&edge| turns(edge % 4, false)) {
                    next[edges[leaving]] = edges[entering % 4] as u32;
                }
            }
        }
    }
    next
}

/// Where the outline crosses an edge between two pixels.
fn crossing(region: &Region, edge: usize) -> DVec2 {
    let (columns, _) = region.size();
    let (pixel, is_below) = (edge / 2, edge % 2 == 1);
    let (column, row) = (pixel % columns, pixel / columns);
    let here = region.covered(column, row);
    let there = if is_below { region.covered(column, row + 1) } else { region.covered(column + 1, row) };
    let share = (EDGE - here) / (there - here);
    let (right, below) = if is_below { (0.0, share) } else { (share, 0.0) };
    region.place(column as f64 + right, row as f64 + below)
}
