//! Who pushes whom: everybody those near, and strangers farther (paper D, equations 10 and 22).

use crate::cells::{Around, Cells};
use crate::constants::Constants;
use crate::groups::Groups;
use crate::near::{Near, Pushes};
use crate::push::Push;
use crate::ranks::Ranks;

/// A push ends where it has fallen to e⁻⁶, 1/400, of its start; what is left there is taken off throughout, so that it ends at zero.
const REACHES: f64 = 6.0;

/// The same for strangers, whose reach is long and whose push is weak: 1/5 of it, which the distance divides further.
const GROUP_REACHES: f64 = 1.5;

/// Pushes are turned by this, to everybody's right: two who meet head on pass each other, where straight ones would only stop them.
const ASIDE: (f64, f64) = (0.96, 0.28);

/// A body counts as no larger than this beyond a usual one, or it would be near everybody.
const LARGEST: f64 = 4.0;

/// Pushes between agents near one another.
#[derive(Clone, Debug)]
pub struct Repulsion {
    cells: Cells,
    ranks: Ranks,
    near: Near,
    /// How much larger a body is than usual.
    girth: Vec<f64>,
    largest: f64,
}

impl Repulsion {
    /// `girth`: how much larger each body's radius is than a usual one.
    pub fn new(girth: Vec<f64>) -> Self {
        let girth: Vec<f64> = girth.into_iter().map(|girth| girth.min(LARGEST)).collect();
        let largest = girth.iter().copied().fold(0.0, f64::max);
        Self { cells: Cells::new(girth.len()), ranks: Ranks::new(girth.len()), near: Near::new(), girth, largest }
    }

    /// Adds the pushes between agents to forces.
    pub fn push_apart(&mut self, constants: &Constants, groups: &Groups, [x, y]: [&[f64]; 2], [fx, fy]: [&mut [f64]; 2]) {
        let all = Push::new(constants.strength, constants.reach, REACHES);
        let has_strangers = groups.are_there() && constants.group_strength > 0.0;
        let strangers = has_strangers.then(|| Push::new(constants.group_strength, constants.group_reach, GROUP_REACHES));
        let range = strangers.map_or(all.range, |strangers| all.range.max(strangers.range));
        self.cells.sort(x, y, range + 2.0 * self.largest);
        self.ranks.fall_in(self.cells.members(), [x, y, &self.girth], groups.of_agent());
        self.meet(&Pushes { all, strangers });
        for (agent, [x, y]) in self.ranks.forces() {
            fx[agent] += ASIDE.0 * x - ASIDE.1 * y;
            fy[agent] += ASIDE.0 * y + ASIDE.1 * x;
        }
    }

    fn meet(&mut self, pushes: &Pushes) {
        let Self { cells, ranks, near, .. } = self;
        for Around { own, row: [row, rest], behind: [first, second] } in cells.around() {
            for here in own {
                for run in [here + 1..row.end, rest.clone(), first.clone(), second.clone()] {
                    near.look(ranks, here, run, pushes);
                }
                near.push(ranks, here, pushes);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// As the formulas say it, all with all, in double precision.
    fn by_the_book(constants: &Constants, girth: &[f64], group: &[u32], x: &[f64], y: &[f64]) -> [Vec<f64>; 2] {
        let formula = |strength: f64, reach: f64, reaches: f64, distance: f64| {
            let fallen = |distance: f64| strength * (-distance / reach).exp() / distance;
            if distance < reaches * reach { fallen(distance) - fallen(reaches * reach) } else { 0.0 }
        };
        let mut forces = [vec![0.0; x.len()], vec![0.0; x.len()]];
        for a in 0..x.len() {
            for b in (0..x.len()).filter(|b| *b != a) {
                let way = [x[a] - x[b], y[a] - y[b]];
                let apart = way[0].hypot(way[1]);
                let distance = (apart - girth[a] - girth[b]).max(0.1);
                let mut push = formula(constants.strength, constants.reach, REACHES, distance);
                if group[a] != group[b] {
                    push += formula(constants.group_strength, constants.group_reach, GROUP_REACHES, distance);
                }
                let [ux, uy] = way.map(|along| along / apart);
                forces[0][a] += push * (ASIDE.0 * ux - ASIDE.1 * uy);
                forces[1][a] += push * (ASIDE.0 * uy + ASIDE.1 * ux);
            }
        }
        forces
    }

    #[test]
    fn a_crush_of_hundreds_is_pushed_by_the_book_and_as_a_whole_by_nothing() {
        const COUNT: usize = 300;
        let constants = Constants::default();
        // A sunflower's seeds: all are near hundreds of others, no two in one place.
        let seed = |k: usize| (0.2 * (k as f64 + 0.5).sqrt(), 2.4 * k as f64);
        let (x, y): (Vec<f64>, Vec<f64>) = (0..COUNT).map(seed).map(|(far, turn)| (far * turn.cos() - 9.0, far * turn.sin() + 4.0)).unzip();
        let girth: Vec<f64> = (0..COUNT).map(|k| 0.05 * (k % 4) as f64 - 0.05).collect();
        let group: Vec<u32> = (0..COUNT).map(|k| (k % 3) as u32).collect();
        let (mut fx, mut fy) = (vec![0.0; COUNT], vec![0.0; COUNT]);
        Repulsion::new(girth.clone()).push_apart(&constants, &Groups::new(group.clone()), [&x, &y], [&mut fx, &mut fy]);
        let [expected_x, expected_y] = by_the_book(&constants, &girth, &group, &x, &y);
        // Six digits of each of 300 pushes, of at most 40.
        let most = 300.0 * 40.0 * 1e-6;
        let far = |found: &[f64], expected: &[f64]| found.iter().zip(expected).map(|(f, e)| (f - e).abs()).fold(0.0, f64::max);
        assert!(far(&fx, &expected_x) < most && far(&fy, &expected_y) < most);
        // Every push has its opposite: what is left is the round-off of 300 · 299 of them in double precision.
        let whole = [fx, fy].map(|forces| forces.iter().sum::<f64>().abs());
        assert!(whole.iter().all(|sum| *sum < 300.0 * 299.0 * 40.0 * f64::EPSILON), "{whole:?}");
    }
}
