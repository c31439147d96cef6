//! Bins along one axis (paper D, equations 12 and 13).

use crate::slots::Slots;

/// Which bin each agent is in, numbered as they are first met.
#[derive(Clone, Debug)]
pub struct Columns {
    slots: Slots,
    of_agent: Vec<u32>,
}

impl Columns {
    /// Of so many agents.
    pub fn new(agent_count: usize) -> Self {
        Self { slots: Slots::new(agent_count), of_agent: vec![0; agent_count] }
    }

    /// Looks anew: column i is from i to i + 1 times `bin_size`.
    pub fn sort(&mut self, places: &[f64], bin_size: f64) {
        self.slots.clear();
        for (column, place) in self.of_agent.iter_mut().zip(places) {
            *column = self.slots.number((place / bin_size).floor() as i64) as u32;
        }
    }

    /// How many bins hold somebody.
    pub fn count(&self) -> usize {
        self.slots.count()
    }

    /// The number of each agent's bin.
    pub fn of_agent(&self) -> &[u32] {
        &self.of_agent
    }
}
