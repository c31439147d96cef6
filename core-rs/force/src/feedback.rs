//! Mutual information fed back: agents of one bin share their direction and their speed (paper D, equations 18 and 19).
//!
//! As printed, a sum of lengths is added to a vector and to a speed, and raises both whatever the neighbors do. Here e moves toward the
//! mean of its bin by `I_d` and v⁰ by `I_v`, as the text beneath the equations says.

use crate::constants::Constants;
use crate::information::{Information, SPEED_CLASSES, directions_into, speeds_into};
use crate::slots::{Slots, bin};

/// Below this speed an agent rests, lengths a second.
const REST: f64 = 1e-3;

/// No wish goes farther toward its bin's than this, however much is told: one's own aim weighs as much as all neighbors', or some would
/// never arrive; and beyond one bit it would pass the mean.
const MOST: f64 = 0.5;

/// Which feedback there is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Feedback {
    /// Of direction, `I_d`.
    pub direction: bool,
    /// Of speed, `I_v`.
    pub speed: bool,
}

/// What agents want: a unit direction (or none) and a speed.
#[derive(Clone, Debug, Default)]
pub struct Wishes {
    pub ex: Vec<f64>,
    pub ey: Vec<f64>,
    pub speed: Vec<f64>,
}

/// The bins and what their agents want on average.
#[derive(Clone, Debug)]
pub struct Bins {
    slots: Slots,
    slot_of: Vec<u32>,
    count: Vec<f64>,
    mean: Wishes,
    classes: Vec<u32>,
    directions: Information,
    speeds: Information,
}

impl Wishes {
    pub fn new(agent_count: usize) -> Self {
        Self { ex: vec![0.0; agent_count], ey: vec![0.0; agent_count], speed: vec![0.0; agent_count] }
    }
}

impl Bins {
    pub fn new(agent_count: usize, sectors: u32) -> Self {
        Self {
            slots: Slots::new(agent_count),
            slot_of: vec![0; agent_count],
            count: vec![0.0; agent_count],
            mean: Wishes::new(agent_count),
            classes: vec![0; agent_count],
            directions: Information::new(agent_count, sectors + 1),
            speeds: Information::new(agent_count, SPEED_CLASSES),
        }
    }

    /// Moves wishes toward those of their bin, by what the crowd's places tell of its velocities now.
    pub fn feed_back(&mut self, constants: &Constants, feedback: Feedback, [x, y, vx, vy]: [&[f64]; 4], wishes: &mut Wishes) {
        if feedback.direction {
            directions_into(vx, vy, constants.sectors, REST, &mut self.classes);
        }
        let along = if feedback.direction { self.directions.of(x, y, &self.classes, constants.bin_size) } else { 0.0 };
        if feedback.speed {
            speeds_into(vx, vy, &mut self.classes);
        }
        let fast = if feedback.speed { self.speeds.of(x, y, &self.classes, constants.bin_size) } else { 0.0 };
        self.average(constants.bin_size, x, y, wishes);
        let (along, fast) = (along.min(MOST), fast.min(MOST));
        for (agent, slot) in self.slot_of.iter().enumerate() {
            let slot = *slot as usize;
            let toward = |own: f64, mean: f64, share: f64| own + share * (mean - own);
            let ex = toward(wishes.ex[agent], self.mean.ex[slot], along);
            let ey = toward(wishes.ey[agent], self.mean.ey[slot], along);
            let length = (ex * ex + ey * ey).sqrt();
            if length > 0.0 {
                (wishes.ex[agent], wishes.ey[agent]) = (ex / length, ey / length);
            }
            wishes.speed[agent] = toward(wishes.speed[agent], self.mean.speed[slot], fast);
        }
    }

    fn average(&mut self, bin_size: f64, x: &[f64], y: &[f64], wishes: &Wishes) {
        self.slots.clear();
        for (agent, (x, y)) in x.iter().zip(y).enumerate() {
            let known = self.slots.count();
            let slot = self.slots.number(bin(*y, bin_size) << 32 ^ bin(*x, bin_size) & 0xFFFF_FFFF);
            if slot == known {
                self.count[slot] = 0.0;
                (self.mean.ex[slot], self.mean.ey[slot], self.mean.speed[slot]) = (0.0, 0.0, 0.0);
            }
            self.slot_of[agent] = slot as u32;
            self.count[slot] += 1.0;
            self.mean.ex[slot] += wishes.ex[agent];
            self.mean.ey[slot] += wishes.ey[agent];
            self.mean.speed[slot] += wishes.speed[agent];
        }
        for slot in 0..self.slots.count() {
            let share = 1.0 / self.count[slot];
            self.mean.ex[slot] *= share;
            self.mean.ey[slot] *= share;
            self.mean.speed[slot] *= share;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn agents_of_one_bin_turn_toward_their_mean_and_no_farther_than_half_of_the_way() {
        // The places tell all of the directions: two bins, two directions, one bit along x and along y.
        let (x, y) = ([0.5, 0.6, 1.5, 1.6], [0.5, 0.6, 1.5, 1.6]);
        let (vx, vy) = ([1.0, 1.0, -1.0, -1.0], [0.1; 4]);
        let mut wishes = Wishes { ex: vec![1.0, 0.0, -1.0, 0.0], ey: vec![0.0, 1.0, 0.0, 1.0], speed: vec![1.0, 3.0, 2.0, 2.0] };
        let constants = Constants { bin_size: 1.0, ..Constants::default() };
        let mut bins = Bins::new(4, constants.sectors);
        bins.feed_back(&constants, Feedback { direction: true, speed: false }, [&x, &y, &vx, &vy], &mut wishes);
        // Half of the way to (½, ½): three quarters and a quarter.
        let length = 10.0_f64.sqrt();
        for (found, expected) in wishes.ex.iter().zip([3.0, 1.0, -3.0, -1.0]) {
            // A sum of four terms and a root.
            assert!((found - expected / length).abs() < 1e-15, "{found}");
        }
        assert_eq!(wishes.speed, [1.0, 3.0, 2.0, 2.0]);
    }
}
