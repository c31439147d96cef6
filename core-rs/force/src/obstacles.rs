//! What pushes agents off obstacles (paper D, equation 9).

use eigenform_apart::Outline;

use crate::constants::Constants;
use crate::exponential::exp;

/// The push ends where it has fallen to e⁻⁶, 1/400, of its start.
const REACHES: f64 = 6.0;

/// How far inside an obstacle the push still grows, in reaches: to twenty times what it is at the outline.
const DEEPEST: f64 = 3.0;

/// Outlines that stand in a crowd's way.
#[derive(Clone, Debug)]
pub struct Obstacles {
    outlines: Vec<(Outline, Round)>,
    /// By agent; none for whom they do not push.
    radius: Vec<Option<f64>>,
}

/// A circle about an outline: most agents are far from most obstacles.
#[derive(Clone, Debug)]
struct Round {
    center: [f64; 2],
    radius: f64,
}

impl Obstacles {
    /// `radius`: of each agent's body; none for whom nothing is to push.
    pub fn new(outlines: Vec<Outline>, radius: Vec<Option<f64>>) -> Self {
        let outlines = outlines.into_iter().map(|outline| {
            let round = Round::about(&outline);
            (outline, round)
        });
        Self { outlines: outlines.collect(), radius }
    }

    /// Adds the pushes to forces: A e^{−d/B}, d from the outline to the body.
    pub fn push_off(&self, constants: &Constants, [x, y]: [&[f64]; 2], [fx, fy]: [&mut [f64]; 2]) {
        for (outline, round) in &self.outlines {
            for (agent, radius) in self.radius.iter().enumerate().filter_map(|(agent, radius)| Some((agent, (*radius)?))) {
                let at = [x[agent], y[agent]];
                if !round.reaches(at, radius + REACHES * constants.reach) {
                    continue;
                }
                let (clearance, out) = outline.clearance(at);
                let reaches = (clearance - radius) / constants.reach;
                if reaches < REACHES {
                    let force = constants.strength * exp(-reaches.max(-DEEPEST));
                    fx[agent] += force * out[0];
                    fy[agent] += force * out[1];
                }
            }
        }
    }
}

impl Round {
    fn about(outline: &Outline) -> Self {
        let share = 1.0 / outline.points.len() as f64;
        let center = outline.points.iter().fold([0.0; 2], |sum, p| [sum[0] + share * p[0], sum[1] + share * p[1]]);
        let square = |p: &[f64; 2]| (p[0] - center[0]) * (p[0] - center[0]) + (p[1] - center[1]) * (p[1] - center[1]);
        Self { center, radius: outline.radius + outline.points.iter().map(square).fold(0.0, f64::max).sqrt() }
    }

    fn reaches(&self, at: [f64; 2], reach: f64) -> bool {
        let (dx, dy, far) = (at[0] - self.center[0], at[1] - self.center[1], self.radius + reach);
        dx * dx + dy * dy < far * far
    }
}
