//! What is inside a shape, in meters.

use glam::DVec2;

use super::picture::{INSIDE, Picture, Reading};
use crate::error::Error;

/// Coverage at the edge: between pixels it changes evenly, so the edge is a line and not steps.
const EDGE: f64 = 127.5;

/// Spans end this much further inside, so that their ends are inside however they are rounded.
const INSET: f64 = 0.25;

/// Halvings that find an edge: to a thousandth of the way.
const HALVINGS: u32 = 10;

/// How much room a shape has: it becomes as large as fits, meters.
#[derive(Clone, Copy, Debug)]
pub struct Room {
    /// From left to right; infinite where only the depth counts.
    pub width: f64,
    /// Away from the audience; infinite where only the width counts.
    pub depth: f64,
}

/// The inside of a shape, its bounding box about the origin: x to the right, y up the picture.
#[derive(Clone, Debug)]
pub struct Region {
    columns: usize,
    rows: usize,
    /// Row by row from the top; the outermost pixels are empty.
    coverage: Vec<u8>,
    /// Meters a pixel.
    pixel: f64,
}

impl Region {
    /// The shape in a picture, as large as the room allows.
    ///
    /// Refuses a picture that is too small, too large or of one color, and a size that is none.
    pub fn from_picture(picture: Picture<'_>, reading: Reading, room: Room) -> Result<Self, Error> {
        let drawn = picture.coverage(reading)?;
        let (mut left, mut right, mut top, mut bottom) = (picture.width, 0, picture.height, 0);
        for (at, &covered) in drawn.iter().enumerate() {
            if covered >= INSIDE {
                let (column, row) = (at % picture.width, at / picture.width);
                (left, right, top, bottom) = (left.min(column), right.max(column), top.min(row), bottom.max(row));
            }
        }
        let (across, down) = (right + 1 - left, bottom + 1 - top);
        let pixel = (room.width / across as f64).min(room.depth / down as f64);
        // A pixel around the inside holds the other side of its edge; one around that is empty.
        let (columns, rows) = (across + 4, down + 4);
        let mut coverage = vec![0; columns * rows];
        for y in top.saturating_sub(1)..(bottom + 2).min(picture.height) {
            for x in left.saturating_sub(1)..(right + 2).min(picture.width) {
                coverage[(y + 2 - top) * columns + x + 2 - left] = drawn[y * picture.width + x];
            }
        }
        Ok(Self { columns, rows, coverage, pixel })
    }

    /// How large it is, square meters.
    pub fn area(&self) -> f64 {
        let inside = self.coverage.iter().filter(|&&covered| covered >= INSIDE).count();
        inside as f64 * self.pixel * self.pixel
    }

    /// Whether a place is inside.
    pub fn contains(&self, at: DVec2) -> bool {
        self.level(at).0 >= EDGE
    }

    /// The side of a pixel, meters.
    pub(super) fn pixel(&self) -> f64 {
        self.pixel
    }

    /// Pixels in a row, and rows.
    pub(super) fn size(&self) -> (usize, usize) {
        (self.columns, self.rows)
    }

    /// Coverage of a pixel.
    pub(super) fn covered(&self, column: usize, row: usize) -> f64 {
        f64::from(self.coverage[row * self.columns + column])
    }

    /// Where a place of the picture is, in pixels from the middle of the upper left one, on the stage.
    pub(super) fn place(&self, column: f64, row: f64) -> DVec2 {
        (DVec2::new(column, -row) + self.corner()) * self.pixel
    }

    /// Half its depth, from where rows are counted down.
    pub(super) fn top(&self) -> f64 {
        self.corner().y.abs() * self.pixel
    }

    /// The inside pixel that is nearest to the middle.
    pub(super) fn heart(&self) -> DVec2 {
        let mut nearest = DVec2::INFINITY;
        for (at, &covered) in self.coverage.iter().enumerate() {
            let place = self.place((at % self.columns) as f64, (at / self.columns) as f64);
            if covered >= INSIDE && place.length_squared() < nearest.length_squared() {
                nearest = place;
            }
        }
        nearest
    }

    /// Adds where the level line at `y` runs inside: from and to, ascending.
    pub(super) fn spans(&self, y: f64, spans: &mut Vec<(f64, f64)>) {
        let down = -y / self.pixel + self.corner().y;
        if !(0.0..(self.rows - 1) as f64).contains(&down) {
            return;
        }
        let (row, share) = (down as usize, down.fract());
        let level = |column: usize| {
            let above = self.covered(column, row);
            above + (self.covered(column, row + 1) - above) * share
        };
        let edge = EDGE + INSET;
        let (mut before, mut start) = (0.0, 0.0);
        for column in 1..self.columns {
            let here = level(column);
            if (before >= edge) != (here >= edge) {
                let x = self.place((column - 1) as f64 + (edge - before) / (here - before), 0.0).x;
                if here >= edge {
                    start = x;
                } else {
                    spans.push((start, x));
                }
            }
            before = here;
        }
    }

    /// Where somebody inside comes to who wants to go so far: as far as it is inside, and on along the edge.
    pub(super) fn moved(&self, from: DVec2, by: DVec2) -> DVec2 {
        let to = from + by;
        if self.contains(to) {
            return to;
        }
        let hit = self.last_inside(from, to);
        let inward = self.level(hit).1.normalize_or_zero();
        let rest = to - hit;
        let along = hit + (rest - inward * rest.dot(inward));
        if self.contains(along) {
            return along;
        }
        let within = along + inward * rest.length();
        self.last_inside(if self.contains(within) { within } else { hit }, along)
    }

    fn last_inside(&self, mut inside: DVec2, mut outside: DVec2) -> DVec2 {
        for _ in 0..HALVINGS {
            let middle = (inside + outside) * 0.5;
            *(if self.contains(middle) { &mut inside } else { &mut outside }) = middle;
        }
        inside
    }

    /// Coverage there, and the direction in which it grows; both 0 off the picture.
    fn level(&self, at: DVec2) -> (f64, DVec2) {
        let x = at.x / self.pixel - self.corner().x;
        let down = -at.y / self.pixel + self.corner().y;
        if !((0.0..(self.columns - 1) as f64).contains(&x) && (0.0..(self.rows - 1) as f64).contains(&down)) {
            return (0.0, DVec2::ZERO);
        }
        let (column, row, u, v) = (x as usize, down as usize, x.fract(), down.fract());
        let corner = |right: usize, below: usize| self.covered(column + right, row + below);
        let above = corner(0, 0) + (corner(1, 0) - corner(0, 0)) * u;
        let below = corner(0, 1) + (corner(1, 1) - corner(0, 1)) * u;
        let across = (corner(1, 0) - corner(0, 0)) * (1.0 - v) + (corner(1, 1) - corner(0, 1)) * v;
        (above + (below - above) * v, DVec2::new(across, above - below))
    }

    /// The middle of the upper left pixel, in pixels from the middle of the shape.
    fn corner(&self) -> DVec2 {
        DVec2::new(1.0 - self.columns as f64, self.rows as f64 - 1.0) * 0.5
    }
}
