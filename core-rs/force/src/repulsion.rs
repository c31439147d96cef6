//! What pushes agents apart (paper D, equations 10 and 22).

use crate::cells::{Cells, Near};
use crate::constants::Constants;
use crate::groups::Groups;

/// A push ends where it has fallen to e⁻⁶, 1/400, of its start; what is left there is taken off throughout, so that it ends at zero.
const REACHES: f64 = 6.0;

/// The same for strangers, whose reach is long and whose push is weak: 1/5 of it, which the distance divides further.
const GROUP_REACHES: f64 = 1.5;

/// 1/d is taken no nearer than this: one step must not throw anybody.
const NEAREST: f64 = 0.1;

/// Pushes are turned by this, to everybody's right: two who meet head on pass each other, where straight ones would only stop them.
const ASIDE: (f64, f64) = (0.96, 0.28);

/// A body counts as no larger than this beyond a usual one, or it would be near everybody.
const LARGEST: f64 = 4.0;

/// Pushes between agents near one another.
#[derive(Clone, Debug)]
pub struct Repulsion {
    cells: Cells,
    /// How much larger a body is than usual.
    girth: Vec<f64>,
    largest: f64,
}

/// A e^{−d/B}/d, zero from `range` on.
struct Push {
    strength: f64,
    reach: f64,
    range: f64,
    /// What is taken off.
    rest: f64,
}

impl Push {
    fn new(strength: f64, reach: f64, reaches: f64) -> Self {
        let range = reaches * reach;
        let rest = strength * libm::exp(-reaches) / range;
        Self { strength, reach, range, rest }
    }

    fn at(&self, distance: f64) -> f64 {
        if distance < self.range { self.strength * libm::exp(-distance / self.reach) / distance - self.rest } else { 0.0 }
    }
}

impl Repulsion {
    /// `girth`: how much larger each body's radius is than a usual one.
    pub fn new(girth: Vec<f64>) -> Self {
        let girth: Vec<f64> = girth.into_iter().map(|girth| girth.min(LARGEST)).collect();
        Self { cells: Cells::new(girth.len()), largest: girth.iter().copied().fold(0.0, f64::max), girth }
    }

    /// Adds the pushes between agents to forces. Larger bodies are that much nearer.
    pub fn push_apart(&mut self, constants: &Constants, groups: &Groups, [at_x, at_y]: [&[f64]; 2], [fx, fy]: [&mut [f64]; 2]) {
        let push = Push::new(constants.strength, constants.reach, REACHES);
        let has_strangers = groups.are_there() && constants.group_strength > 0.0;
        let strange = Push::new(if has_strangers { constants.group_strength } else { 0.0 }, constants.group_reach, GROUP_REACHES);
        let range = if has_strangers { push.range.max(strange.range) } else { push.range };
        self.cells.for_each_pair(at_x, at_y, range + 2.0 * self.largest, |near| {
            let Near { agents: [a, b], way, distance_squared } = near;
            let apart = distance_squared.sqrt();
            let distance = (apart - self.girth[a] - self.girth[b]).max(NEAREST);
            let mut force = push.at(distance);
            if has_strangers && groups.are_apart([a, b]) {
                force += strange.at(distance);
            }
            if force <= 0.0 {
                return;
            }
            // Two in one place go apart along x, the lower number first.
            let [x, y] = if apart > 0.0 { [way[0] / apart, way[1] / apart] } else { [if a < b { -1.0 } else { 1.0 }, 0.0] };
            let (ux, uy) = (ASIDE.0 * x - ASIDE.1 * y, ASIDE.0 * y + ASIDE.1 * x);
            fx[a] += force * ux;
            fy[a] += force * uy;
            fx[b] -= force * ux;
            fy[b] -= force * uy;
        });
    }
}
