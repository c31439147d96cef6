//! Mutual information fed back: agents of one bin share their direction and their speed (paper D, equations 18 and 19).
//!
//! As printed, a sum of lengths is added to a vector and to a speed, and raises both whatever the neighbors do. Here e moves toward the
//! mean of its bin by `I_d` and v⁰ by `I_v`, as the text beneath the equations says.

use crate::bins::Bins;
use crate::columns::Columns;
use crate::constants::Constants;
use crate::information::Information;
use crate::sectors::Sectors;
use crate::speeds::{SPEED_CLASSES, speeds_into};
use crate::wishes::Wishes;

/// Below this speed an agent rests, lengths a second.
const REST: f64 = 1e-3;

/// No wish goes farther toward its bin's than this, however much is told: one's own aim weighs three times as much as all neighbors', or
/// some would arrive late, and beyond one bit it would pass the mean. Few agents in many bins always seem to tell so much.
const MOST: f64 = 0.25;

/// Which feedback there is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Feedback {
    /// Of direction, `I_d`.
    pub direction: bool,
    /// Of speed, `I_v`.
    pub speed: bool,
}

/// What the crowd's places tell of its velocities, and what is shared for it.
#[derive(Clone, Debug)]
pub struct Sharing {
    columns: [Columns; 2],
    bins: Bins,
    sectors: Sectors,
    classes: Vec<u32>,
    directions: Information,
    speeds: Information,
}

impl Sharing {
    pub fn new(agent_count: usize, sectors: u32) -> Self {
        let sectors = Sectors::new(sectors);
        Self {
            columns: [Columns::new(agent_count), Columns::new(agent_count)],
            bins: Bins::new(agent_count),
            classes: vec![0; agent_count],
            directions: Information::new(agent_count, sectors.class_count()),
            speeds: Information::new(agent_count, SPEED_CLASSES),
            sectors,
        }
    }

    /// Moves wishes toward those of their bin, by what places tell of velocities now.
    pub fn feed_back(&mut self, constants: &Constants, feedback: Feedback, [x, y, vx, vy]: [&[f64]; 4], wishes: &mut Wishes) {
        let Self { columns: [column, row], bins, sectors, classes, directions, speeds } = self;
        column.sort(x, constants.bin_size);
        row.sort(y, constants.bin_size);
        let mut shares = [0.0; 2];
        if feedback.direction {
            sectors.classes_into(vx, vy, REST, classes);
            shares[0] = directions.of([column, row], classes).min(MOST);
        }
        if feedback.speed {
            speeds_into(vx, vy, classes);
            shares[1] = speeds.of([column, row], classes).min(MOST);
        }
        bins.average(x, y, constants.bin_size, wishes);
        bins.share(shares, wishes);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn agents_of_one_bin_turn_toward_their_mean_and_no_farther_than_a_quarter_of_the_way() {
        // The places tell all of the directions: two bins, two directions, one bit along x and along y.
        let (x, y) = ([0.5, 0.5, 2.5, 2.5], [0.5, 0.5, 2.5, 2.5]);
        let (vx, vy) = ([1.0, 1.0, -1.0, -1.0], [0.1; 4]);
        let mut wishes = Wishes { ex: vec![1.0, 0.0, -1.0, 0.0], ey: vec![0.0, 1.0, 0.0, 1.0], speed: vec![1.0, 3.0, 2.0, 2.0] };
        let constants = Constants { bin_size: 1.0, ..Constants::default() };
        let mut sharing = Sharing::new(4, constants.sectors);
        sharing.feed_back(&constants, Feedback { direction: true, speed: false }, [&x, &y, &vx, &vy], &mut wishes);
        // A quarter of the way to (½, ½): seven eighths and an eighth.
        let length = 50.0_f64.sqrt();
        for (found, expected) in wishes.ex.iter().zip([7.0, 1.0, -7.0, -1.0]) {
            // A sum of four terms and a root.
            assert!((found - expected / length).abs() < 1e-15, "{found}");
        }
        assert_eq!(wishes.speed, [1.0, 3.0, 2.0, 2.0]);
    }
}
