//! One attempt after the other, from gentle to tight.

use eigenform_apart::{Kernel, Paths, Rules};

use super::Avoidance;
use super::reroute::Parting;
use crate::motion::Motion;

/// How an attempt pushes.
#[derive(Clone, Copy, Debug)]
pub(super) struct Rung {
    /// Kernel time: how long a push lasts, in times to cover the minimum distance at mean speed.
    duration: f64,
    /// From one knot to the next the farthest agent covers so many minimum distances in the mean.
    step: f64,
    /// A push closes at most this much of a gap, of the minimum distance.
    cap: f64,
    /// What passes an obstacle on both sides where it has to.
    pub(super) parting: Parting,
    /// How the guide is bent before anybody is pushed.
    pub(super) bend: Bend,
    /// Slower than this across a knot, in minimum distances, two are pushed straight apart.
    stillness: f64,
    seed: u64,
    /// Pushed for beyond the minimum distance, and good enough at the knots.
    margins: [f64; 2],
}

/// What leads agents past one another before they are pushed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Bend {
    /// The guide as it is.
    No,
    /// Those who are stuck keep so many minimum distances to their right.
    Swirl(f64),
    /// Who goes through a gap between two obstacles closes up.
    Close,
    /// Each agent whom obstacles block goes the shortest way.
    Ways,
    /// Streams open by so much of what their files need, and lie between one another's.
    Open(f64),
}

/// Two who hardly move against one another have no way to pass each other across.
const STILL: f64 = 1e-4;

/// Measured on drill shows: the first solves most, each of the others some that are left. Where guides turn and wave, as spectral ones
/// do, two go side by side for long, and it is those that the stiller rungs push straight apart. Blocks that open by all they need pass
/// smoothly; where that leads too far, half of it is enough for agents that weave their way. On the shortest ways around obstacles most go
/// in one another's steps, and only what pushes them along the way too makes them queue.
pub(super) const RUNGS: [Rung; 21] = [
    Rung { parting: Parting::Ungrouped, ..rung(3.0, 0.4) },
    Rung { parting: Parting::Nothing, ..rung(1.5, 0.4) },
    rung(0.8, 0.3),
    Rung { bend: Bend::Close, stillness: 0.05, ..rung(1.5, 0.4) },
    Rung { bend: Bend::Close, stillness: 0.05, ..rung(0.8, 0.3) },
    Rung { bend: Bend::Open(1.0), ..rung(0.8, 0.3) },
    Rung { bend: Bend::Open(0.5), ..rung(0.8, 0.3) },
    Rung { stillness: 0.05, ..rung(1.5, 0.3) },
    Rung { stillness: 0.06, ..rung(0.8, 0.3) },
    Rung { stillness: 0.05, ..rung(0.5, 0.3) },
    Rung { cap: 0.15, seed: 1, ..rung(1.5, 0.3) },
    Rung { cap: 0.15, seed: 2, ..rung(3.0, 0.3) },
    Rung { cap: 0.15, seed: 3, ..rung(1.0, 0.4) },
    Rung { bend: Bend::Swirl(0.8), ..rung(2.0, 0.4) },
    Rung { bend: Bend::Swirl(1.6), ..rung(2.0, 0.4) },
    Rung { bend: Bend::Swirl(2.8), ..rung(2.0, 0.4) },
    Rung { bend: Bend::Swirl(4.0), ..rung(2.0, 0.4) },
    Rung { bend: Bend::Ways, stillness: 0.2, ..rung(1.5, 0.3) },
    Rung { bend: Bend::Ways, stillness: 0.2, ..rung(0.8, 0.3) },
    Rung { bend: Bend::Ways, stillness: 0.5, ..rung(0.8, 0.3) },
    Rung { bend: Bend::Ways, stillness: 0.5, cap: 0.15, ..rung(1.5, 0.3) },
];

const fn rung(duration: f64, step: f64) -> Rung {
    Rung { duration, step, cap: 0.3, parting: Parting::Groups, bend: Bend::No, stillness: STILL, seed: 0, margins: KNOT_MARGINS }
}

/// For guides that are bent on request. The margin is what keyframes on a grid of a centimeter may take away again.
pub(super) const LOOSE: Rung = Rung { margins: [0.06, 0.04], ..rung(2.0, 0.4) };

const FEWEST_KNOTS: usize = 24;
const MOST_KNOTS: usize = 600;

/// The shortest bump that knots can show, in knots.
const SHORTEST_TIME: f64 = 1.5;

/// The longest one, of the whole segment.
const LONGEST_SHARE: f64 = 0.2;

/// Beyond the minimum distance: pushed for, and good enough before the lift to frames.
const KNOT_MARGINS: [f64; 2] = [0.03, 0.012];
const FRAME_MARGINS: [f64; 2] = [0.01, 0.002];

const KNOT_SWEEPS: usize = 120;
const FRAME_SWEEPS: usize = 60;

/// How far the agents of a guide go.
#[derive(Clone, Copy, Debug)]
pub(super) struct Ways {
    /// Meters.
    pub(super) longest: f64,
    pub(super) mean: f64,
}

impl Ways {
    pub(super) fn of(guide: &Motion) -> Self {
        let agent_count = guide.agent_count();
        let mut lengths = vec![0.0; agent_count];
        for k in 1..guide.times().len() {
            let steps = guide.places(k - 1).iter().zip(guide.places(k).iter());
            lengths.iter_mut().zip(steps).for_each(|(length, (from, to))| *length += from.distance(to));
        }
        let sum: f64 = lengths.iter().sum();
        Self { longest: lengths.iter().copied().fold(0.0, f64::max), mean: sum / agent_count.max(1) as f64 }
    }
}

impl Rung {
    pub(super) fn knot_count(&self, ways: Ways, distance: f64, sample_count: usize) -> usize {
        let wanted = (ways.longest / (self.step * distance)).ceil();
        let most = FEWEST_KNOTS.max(MOST_KNOTS.min(sample_count));
        wanted.clamp(FEWEST_KNOTS as f64, most as f64) as usize
    }

    /// Kernel time in knots.
    fn time(&self, ways: Ways, distance: f64, knot_count: usize) -> f64 {
        let knots_to_cover = distance / ways.mean * (knot_count - 1) as f64;
        (self.duration * knots_to_cover).clamp(SHORTEST_TIME, (LONGEST_SHARE * knot_count as f64).max(SHORTEST_TIME))
    }

    pub(super) fn kernel(&self, ways: Ways, avoidance: &Avoidance, knot_count: usize) -> Kernel {
        Kernel::new(knot_count, self.time(ways, avoidance.minimum_distance, knot_count), avoidance.is_clamped)
    }

    /// For knots at the frames themselves: half as long in time.
    pub(super) fn frame_kernel(&self, ways: Ways, avoidance: &Avoidance, knot_count: usize, sample_count: usize) -> Kernel {
        let frames_per_knot = (sample_count - 1) as f64 / (knot_count - 1) as f64;
        let time = 0.5 * self.time(ways, avoidance.minimum_distance, knot_count) * frames_per_knot;
        Kernel::new(sample_count, time.clamp(SHORTEST_TIME, (LONGEST_SHARE * sample_count as f64).max(SHORTEST_TIME)), avoidance.is_clamped)
    }

    pub(super) fn rules(&self, avoidance: &Avoidance) -> Rules {
        Rules {
            distance: avoidance.minimum_distance,
            margins: self.margins,
            step_cap: self.cap,
            sweep_limit: KNOT_SWEEPS,
            stillness: self.stillness,
            seed: self.seed << 32 | u64::from(avoidance.seed),
            outlines: avoidance.outlines(),
        }
    }

    pub(super) fn frame_rules(&self, avoidance: &Avoidance) -> Rules {
        Rules { margins: FRAME_MARGINS, sweep_limit: FRAME_SWEEPS, ..self.rules(avoidance) }
    }
}

/// How far somebody gets at most from one knot to the next but one, halved: what a pair may close within half a knot.
pub(super) fn greatest_step(paths: &Paths, knot: usize) -> f64 {
    let mut greatest: f64 = 0.0;
    for agent in 0..paths.agent_count() {
        let [before, after] = [paths.place(agent, knot - 1), paths.place(agent, knot + 1)];
        let squared = (0..3).map(|axis| (after[axis] - before[axis]) * (after[axis] - before[axis])).sum::<f64>();
        greatest = greatest.max(squared);
    }
    0.5 * greatest.sqrt()
}
