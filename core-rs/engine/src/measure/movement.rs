//! How a movement looks as a whole (paper D, section 5.1), and how roughly it runs.
//!
//! Found on request only: who is nearest to whom and who would best go where costs more than all other measures together.

use eigenform_force::{Columns, Information, SPEED_CLASSES, Sectors, speeds_into};
use glam::DVec3;
use serde::Serialize;

use super::{Extreme, extreme};
use crate::assignment;
use crate::formation::Formation;
use crate::motion::Motion;
use crate::order;

/// Instants of the curves: more than a plot is wide in its smallest steps.
const INSTANTS: usize = 121;

/// Work on target deviations, in agents²: about a second.
const TARGET_WORK: usize = 25_000_000;

/// Instants of many agents' target deviations; between them they run straight.
const TARGET_INSTANTS: std::ops::RangeInclusive<usize> = 3..=25;

/// Work, in agents², for which every instant is looked at: a hundred agents over all of them, in some tens of milliseconds.
const LITTLE_TARGET_WORK: usize = INSTANTS * 100 * 100;

/// R of the measure, in spacings; that of the paper is not given.
const BIN_SIZE: f64 = 4.0;

/// K of the measure.
const SECTORS: u32 = 8;

/// Below this an agent rests, spacings a second.
const REST: f64 = 1e-3;

/// Jerks that a median is taken of.
const JERKS: usize = 100_000;

/// The measures of a movement.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
#[serde(rename_all = "camelCase")]
pub struct Movement {
    /// `I_d`, bits: how much place tells of direction (equation 17). It compares only among movements between the same formations.
    pub mutual_information: Extreme,
    /// `I_v`, bits: the same of speed.
    pub speed_information: Extreme,
    /// The standard deviation of the distances to the nearest (equation 24), meters.
    pub structure_deviation: Extreme,
    /// The standard deviation of the distances from the source (equation 26), meters.
    pub effort_deviation: Extreme,
    /// The mean distance to the target's slots, each agent to the one that the least sum of distances gives it, meters.
    pub target_deviation: Extreme,
    /// The median jerk over agents and samples, m/s³.
    pub roughness: f64,
}

/// One value an instant.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
#[serde(rename_all = "camelCase")]
pub struct MovementCurves {
    /// Seconds, those of samples.
    pub times: Vec<f64>,
    /// `I_d`.
    pub mutual_information: Vec<f64>,
    /// `I_v`.
    pub speed_information: Vec<f64>,
    /// Of the nearest distances.
    pub structure_deviation: Vec<f64>,
    /// Of the distances from the source.
    pub effort_deviation: Vec<f64>,
    /// To the target's slots.
    pub target_deviation: Vec<f64>,
}

/// Measures a movement toward `target`, which it need not reach.
pub fn movement(motion: &Motion, target: &Formation) -> (Movement, MovementCurves) {
    let samples = evenly(motion.times().len(), INSTANTS);
    let mut tells = Tells::new(motion);
    let (mutual_information, speed_information) = samples.iter().map(|k| tells.at(motion, *k)).unzip();
    let source = motion.places(0);
    let effort = |k: usize| deviation(&motion.places(k).iter().zip(source.iter()).map(|(at, from)| at.distance(from)).collect::<Vec<_>>());
    let curves = MovementCurves {
        times: samples.iter().map(|k| motion.times()[*k]).collect(),
        mutual_information,
        speed_information,
        structure_deviation: samples.iter().map(|k| deviation(&motion.formation(*k).nearest_distances())).collect(),
        effort_deviation: samples.iter().map(|k| effort(*k)).collect(),
        target_deviation: target_deviations(motion, &samples, target),
    };
    let movement = Movement {
        mutual_information: extreme(&curves.mutual_information),
        speed_information: extreme(&curves.speed_information),
        structure_deviation: extreme(&curves.structure_deviation),
        effort_deviation: extreme(&curves.effort_deviation),
        target_deviation: extreme(&curves.target_deviation),
        roughness: roughness(motion),
    };
    (movement, curves)
}

/// At most `most` of `count` samples, evenly, the first and the last among them.
fn evenly(count: usize, most: usize) -> Vec<usize> {
    let picked = count.min(most);
    (0..picked).map(|k| k * (count - 1) / (picked - 1).max(1)).collect()
}

/// What places tell of velocities.
struct Tells {
    spacing: f64,
    columns: [Columns; 2],
    sectors: Sectors,
    information: [Information; 2],
    classes: Vec<u32>,
}

impl Tells {
    fn new(motion: &Motion) -> Self {
        let count = motion.agent_count();
        let sectors = Sectors::new(SECTORS);
        let information = [sectors.class_count(), SPEED_CLASSES].map(|classes| Information::new(count, classes));
        let columns = [Columns::new(count), Columns::new(count)];
        Self { spacing: motion.spacing(), columns, sectors, information, classes: vec![0; count] }
    }

    /// `I_d` and `I_v` at a sample, of velocities between the samples beside it.
    fn at(&mut self, motion: &Motion, k: usize) -> (f64, f64) {
        let (before, after) = (k.saturating_sub(1), (k + 1).min(motion.times().len() - 1));
        let seconds = motion.times()[after] - motion.times()[before];
        let places = motion.sample(k).iter();
        let (x, y): (Vec<f64>, Vec<f64>) = places.map(|p| (p.x, p.y)).unzip();
        let steps = motion.sample(before).iter().zip(motion.sample(after));
        let (vx, vy): (Vec<f64>, Vec<f64>) = steps.map(|(from, to)| ((*to - *from) / seconds).into()).unzip();
        let [column, row] = &mut self.columns;
        column.sort(&x, BIN_SIZE * self.spacing);
        row.sort(&y, BIN_SIZE * self.spacing);
        let [directions, speeds] = &mut self.information;
        self.sectors.classes_into(&vx, &vy, REST * self.spacing, &mut self.classes);
        let of_direction = directions.of([column, row], &self.classes);
        speeds_into(&vx, &vy, &mut self.classes);
        (of_direction, speeds.of([column, row], &self.classes))
    }
}

/// The population's standard deviation; 0 of nobody. What is infinite, the nearest of one agent alone, counts as nothing.
fn deviation(values: &[f64]) -> f64 {
    let count = values.len().max(1) as f64;
    let finite = || values.iter().filter(|value| value.is_finite());
    let mean = finite().sum::<f64>() / count;
    // A sum of nothing would be −0.
    ((0.0 + finite().map(|value| (value - mean) * (value - mean)).sum::<f64>()) / count).sqrt()
}

fn target_deviations(motion: &Motion, samples: &[usize], target: &Formation) -> Vec<f64> {
    let agent_count = motion.agent_count().max(1);
    let most = (TARGET_WORK / (agent_count * agent_count)).clamp(*TARGET_INSTANTS.start(), *TARGET_INSTANTS.end());
    let most = most.max(LITTLE_TARGET_WORK / (agent_count * agent_count));
    let known = evenly(samples.len(), most);
    let found: Vec<f64> = known.iter().map(|place| target_deviation(&motion.formation(samples[*place]), target)).collect();
    let between = |place: usize| {
        let next = known.partition_point(|known| *known < place).max(1).min(known.len() - 1);
        let (from, to) = (known[next.saturating_sub(1)], known[next]);
        let share = if to > from { (place - from) as f64 / (to - from) as f64 } else { 0.0 };
        found[next.saturating_sub(1)] * (1.0 - share) + found[next] * share
    };
    (0..samples.len()).map(between).collect()
}

fn target_deviation(formation: &Formation, target: &Formation) -> f64 {
    let distance = |agent: usize, slot: usize| formation.places().at(agent).distance(target.places().at(slot));
    assignment::shortest(formation, target).total(distance) / formation.agent_count().max(1) as f64
}

/// Third differences of samples that are evenly apart, as nearly all are.
fn roughness(motion: &Motion) -> f64 {
    const EVEN: f64 = 1e-6;
    let times = motion.times();
    let runs = times.len().saturating_sub(3) * motion.agent_count();
    let stride = runs.div_ceil(JERKS).max(1);
    let mut jerks = Vec::new();
    for k in (0..times.len().saturating_sub(3)).step_by(stride) {
        let step = times[k + 1] - times[k];
        if (1..3).any(|next| (times[k + next + 1] - times[k + next] - step).abs() > EVEN * step) {
            continue;
        }
        let places = [0, 1, 2, 3].map(|next| motion.places(k + next));
        let jerk = |agent: usize| {
            let [a, b, c, d]: [DVec3; 4] = places.map(|places| places.at(agent));
            (d - 3.0 * (c - b) - a).length() / (step * step * step)
        };
        jerks.extend((0..motion.agent_count()).map(jerk));
    }
    order::sort_by_key(&mut jerks, |jerk| u128::from(order::of_real(*jerk)));
    jerks.get(jerks.len() / 2).copied().unwrap_or(0.0)
}

#[cfg(test)]
mod tests {
    use glam::DVec2;

    use super::*;

    /// `place` by agent and time, ten samples a second for 2 s.
    fn moving(agent_count: usize, place: impl Fn(usize, f64) -> DVec2) -> Motion {
        let times: Vec<f64> = (0..=20).map(|k| f64::from(k) / 10.0).collect();
        let positions = times.iter().flat_map(|time| (0..agent_count).map(|agent| place(agent, *time)).collect::<Vec<_>>()).collect();
        Motion::new(times.clone(), agent_count, positions)
    }

    fn grid(agent: usize) -> DVec2 {
        DVec2::new((agent % 12) as f64, (agent / 12) as f64)
    }

    #[test]
    fn a_crowd_in_step_tells_nothing_and_stays_in_shape() {
        let motion = moving(144, |agent, time| grid(agent) + DVec2::new(3.0 * time, 0.0));
        let (movement, curves) = movement(&motion, &motion.formation(20));
        assert_eq!(movement.mutual_information.max, 0.0);
        assert_eq!(movement.speed_information.max, 0.0);
        // Sums of 144 numbers near 1 and near 6.
        assert!(movement.structure_deviation.max < 1e-12 && movement.effort_deviation.max < 1e-12);
        assert!((curves.target_deviation[0] - 6.0).abs() < 1e-12 && curves.target_deviation[20] == 0.0);
        // Third differences cancel to a few units in the last place of 20 over a thousandth.
        assert!(movement.roughness < 1e-10);
    }

    #[test]
    fn two_halves_that_part_are_told_by_place() {
        let way = |agent: usize| if grid(agent).x < 6.0 { DVec2::NEG_X } else { DVec2::X };
        let motion = moving(144, |agent, time| grid(agent) + DVec2::new(0.5, 0.0) + time * way(agent));
        let (movement, _) = movement(&motion, &motion.formation(20));
        // I(X, D) is nearly one bit, for a bin of four straddles the middle of twelve at first; I(Y, D) is none.
        assert!((0.3..=0.5).contains(&movement.mutual_information.mean), "{:?}", movement.mutual_information);
        assert!(movement.mutual_information.max <= 0.5 + 1e-12);
    }

    #[test]
    fn the_target_is_as_near_as_the_shortest_ways_have_it() {
        // Squares would send both on, by 1 m and √1.04 m; who stands in a place already may stay.
        let slots = Formation::new(vec![DVec2::X, DVec2::new(1.2, 1.0)]);
        let still = moving(2, |agent, _| DVec2::new(agent as f64, 0.0));
        let (movement, _) = movement(&still, &slots);
        assert!((movement.target_deviation.mean - 2.44_f64.sqrt() / 2.0).abs() < 1e-12, "{:?}", movement.target_deviation);
    }

    #[test]
    fn deviations_are_those_of_the_population() {
        assert_eq!(deviation(&[1.0, 3.0]), 1.0);
        assert_eq!(deviation(&[]), 0.0);
        assert_eq!(deviation(&[f64::INFINITY]), 0.0);
        let jerky = moving(1, |_, time| DVec2::new(time * time * time, 0.0));
        // The third derivative of t³; round-off of 8 over a thousandth.
        assert!((movement(&jerky, &jerky.formation(20)).0.roughness - 6.0).abs() < 1e-10);
    }
}
