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
