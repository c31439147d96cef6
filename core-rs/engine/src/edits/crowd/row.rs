//! One sample of a guide.

use crate::edits::grain::rounded_along;
use crate::motion::Motion;

/// Where everybody is, in units, an axis at a time.
pub(super) struct Row {
    sample: Option<usize>,
    x: Vec<f64>,
    y: Vec<f64>,
}

impl Row {
    pub(super) fn new(agent_count: usize) -> Self {
        Self { sample: None, x: vec![0.0; agent_count], y: vec![0.0; agent_count] }
    }

    /// Becomes a sample, as edits see it; what it is already is not read again.
    pub(super) fn read(&mut self, motion: &Motion, sample: usize, unit: f64) {
        if self.sample == Some(sample) {
            return;
        }
        let per_unit = 1.0 / unit;
        for (place, (x, y)) in motion.sample(sample).iter().zip(self.x.iter_mut().zip(&mut self.y)) {
            (*x, *y) = (rounded_along(place.x) * per_unit, rounded_along(place.y) * per_unit);
        }
        self.sample = Some(sample);
    }

    /// Where everybody is on the straight way to another sample.
    pub(super) fn toward(&self, to: &Self, share: f64, [x, y]: [&mut [f64]; 2]) {
        for (place, from, to) in [(x, &self.x, &to.x), (y, &self.y, &to.y)] {
            place.iter_mut().zip(from.iter().zip(to)).for_each(|(place, (from, to))| *place = from + share * (to - from));
        }
    }

    /// From one agent's place to its other.
    pub(super) fn greatest_distance(&self, other: &Self) -> f64 {
        let x = self.x.iter().zip(&other.x).map(|(from, to)| to - from);
        let y = self.y.iter().zip(&other.y).map(|(from, to)| to - from);
        x.zip(y).map(|(x, y)| x * x + y * y).fold(0.0, f64::max).sqrt()
    }
}
