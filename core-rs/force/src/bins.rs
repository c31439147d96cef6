//! Bins of the plane, and what their agents want on average.

use crate::columns::Columns;
use crate::slots::Slots;
use crate::wishes::Wishes;

/// Means by bin; its buffers serve every call.
#[derive(Clone, Debug)]
pub struct Bins {
    slots: Slots,
    /// The number of each agent's bin.
    of_agent: Vec<u32>,
    /// By bin, how many agents and their mean ex, ey and speed.
    count: Vec<f64>,
    mean: Vec<[f64; 3]>,
}

impl Bins {
    pub fn new(agent_count: usize) -> Self {
        Self {
            slots: Slots::new(agent_count),
            of_agent: vec![0; agent_count],
            count: vec![0.0; agent_count],
            mean: vec![[0.0; 3]; agent_count],
        }
    }

    /// Sorts agents into bins and looks what they want there.
    pub fn average(&mut self, column: &Columns, row: &Columns, wishes: &Wishes) {
        self.slots.clear();
        self.count.fill(0.0);
        self.mean.fill([0.0; 3]);
        let wishes = wishes.ex.iter().zip(&wishes.ey).zip(&wishes.speed);
        let places = column.of_agent().iter().zip(row.of_agent());
        for (bin, ((column, row), ((ex, ey), speed))) in self.of_agent.iter_mut().zip(places.zip(wishes)) {
            let number = self.slots.number(i64::from(*row) << 32 | i64::from(*column));
            *bin = number as u32;
            self.count[number] += 1.0;
            let [x, y, fast] = &mut self.mean[number];
            (*x, *y, *fast) = (*x + ex, *y + ey, *fast + speed);
        }
        for (mean, count) in self.mean.iter_mut().zip(&self.count).take(self.slots.count()) {
            *mean = mean.map(|sum| sum / count);
        }
    }

    /// Moves wishes toward the means by shares of the way: the direction, turned only, and the speed.
    pub fn share(&self, [along, fast]: [f64; 2], wishes: &mut Wishes) {
        let toward = |own: f64, mean: f64, share: f64| own + share * (mean - own);
        let own = wishes.ex.iter_mut().zip(&mut wishes.ey).zip(&mut wishes.speed);
        for (bin, ((ex, ey), speed)) in self.of_agent.iter().zip(own) {
            let mean = self.mean[*bin as usize];
            let (x, y) = (toward(*ex, mean[0], along), toward(*ey, mean[1], along));
            let length = (x * x + y * y).sqrt();
            if length > 0.0 {
                (*ex, *ey) = (x / length, y / length);
            }
            *speed = toward(*speed, mean[2], fast);
        }
    }
}
