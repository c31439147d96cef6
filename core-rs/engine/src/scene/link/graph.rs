//! Who belongs with whom: group members and ties.

use super::models::{Integer, Number};
use super::range::{Bit, Coder};
use crate::error::Error;

/// Members of the groups of a tree; an agent is in one group at the most.
pub struct Members {
    is_grouped: Vec<bool>,
}

impl Members {
    /// Of a scene with so many agents.
    pub fn new(agent_count: usize) -> Self {
        Self { is_grouped: vec![false; agent_count] }
    }

    /// Codes one group's members: rising ones as a yes or no for every agent still in no group, others one by one.
    pub fn code(&mut self, coder: &mut dyn Coder, members: &mut Vec<u32>) -> Result<(), Error> {
        let agent_count = self.is_grouped.len();
        let mut is_empty = members.is_empty();
        coder.bit(&mut Bit::default(), &mut is_empty);
        if is_empty {
            return Ok(());
        }
        let mut rises = members.is_sorted_by(|a, b| a < b);
        coder.bit(&mut Bit::likely(true), &mut rises);
        if rises {
            self.code_rising(coder, members);
        } else {
            let count = code_count(&mut Integer::default(), coder, members.len(), agent_count)?;
            members.resize(count, 0);
            for member in members.iter_mut() {
                coder.even(agent_count as u32, member);
            }
        }
        for member in members {
            self.is_grouped[*member as usize] = true;
        }
        Ok(())
    }

    fn code_rising(&self, coder: &mut dyn Coder, members: &mut Vec<u32>) {
        let mut left = members.iter().copied().peekable();
        let mut read = Vec::new();
        // Neighbors by index are often in one group.
        let mut models = [Bit::default(); 2];
        let mut is_member = false;
        for agent in (0..self.is_grouped.len()).filter(|agent| !self.is_grouped[*agent]).map(|agent| agent as u32) {
            let model = &mut models[usize::from(is_member)];
            is_member = left.next_if_eq(&agent).is_some();
            coder.bit(model, &mut is_member);
            if is_member {
                read.push(agent);
            }
        }
        *members = read;
    }
}

/// Ties and cuts of one adjacency after the other.
#[derive(Default)]
pub struct Pairs {
    count: Integer,
    first: Integer,
    second: Integer,
    repeats: Bit,
    factor: Number,
}

impl Pairs {
    /// Codes how long a list is.
    pub fn code_count(&mut self, coder: &mut dyn Coder, count: usize, limit: usize) -> Result<usize, Error> {
        code_count(&mut self.count, coder, count, limit)
    }

    /// Codes a pair by the pair before it.
    pub fn code_pair(&mut self, coder: &mut dyn Coder, last: (u32, u32), pair: (&mut u32, &mut u32)) -> Result<(), Error> {
        let (a, b) = pair;
        let mut step = i64::from(*a) - i64::from(last.0);
        self.first.code(coder, &mut step);
        *a = offset(last.0, step)?;
        // Sorted lists go on from the last partner, others start from the agent itself.
        let from = if step == 0 { last.1 } else { *a };
        let mut reach = i64::from(*b) - i64::from(from);
        self.second.code(coder, &mut reach);
        *b = offset(from, reach)?;
        Ok(())
    }

    /// Codes a factor by the factor before it.
    pub fn code_factor(&mut self, coder: &mut dyn Coder, last: f64, factor: &mut f64) {
        let mut repeats = factor.to_bits() == last.to_bits();
        coder.bit(&mut self.repeats, &mut repeats);
        if repeats {
            *factor = last;
        } else {
            self.factor.code(coder, factor);
        }
    }
}

/// Codes how long a list is.
pub fn code_count(model: &mut Integer, coder: &mut dyn Coder, count: usize, limit: usize) -> Result<usize, Error> {
    let mut count = i64::try_from(count).expect("a count within the limits");
    model.code(coder, &mut count);
    usize::try_from(count).ok().filter(|count| *count <= limit).ok_or(Error::LinkTooLarge)
}

fn offset(from: u32, by: i64) -> Result<u32, Error> {
    i64::from(from).checked_add(by).and_then(|index| u32::try_from(index).ok()).ok_or(Error::LinkDamaged)
}
