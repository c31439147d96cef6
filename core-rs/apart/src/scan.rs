//! Which pairs are too near, and by how much.

use crate::contact::Key;
use crate::outline::Outline;
use crate::paths::Paths;

/// Two who may come near from one knot to another: agent `i` and agent `j` > i, or `j` = agent count + the number of an outline.
///
/// Lists of meetings ascend by (i, j, from), and no two of a pair share a knot.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Meeting {
    /// An agent.
    pub i: u32,
    /// Another, or an outline.
    pub j: u32,
    /// The first knot; an inner one.
    pub from: u32,
    /// The knot after the last.
    pub to: u32,
}

/// Somebody too near at a knot.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Found {
    pub(crate) key: Key,
    /// How much is missing, meters.
    pub(crate) depth: f64,
}

/// How far apart a pair must be at each knot.
///
/// A margin above the minimum distance makes the lift to frames safe. It fades toward the keyframes, where agents may stand exactly
/// that far apart.
#[derive(Clone, Debug)]
pub(crate) struct Demand {
    /// What is pushed for.
    wanted: Vec<f64>,
    /// What is good enough to stop.
    enough: Vec<f64>,
    /// Both next to a keyframe.
    edge: [f64; 2],
}

/// The margins fade over so many knots.
const RAMP_KNOTS: f64 = 6.0;

/// What the exact check lets pass, meters.
const SLACK: f64 = 1e-6;

impl Demand {
    pub(crate) fn new(distance: f64, margins: [f64; 2], knot_count: usize) -> Self {
        let last = knot_count - 1;
        let faded = |knot: usize| (knot.min(last - knot) as f64 / RAMP_KNOTS).min(1.0);
        let [margin, goal] = margins;
        let wanted = (0..knot_count).map(|knot| distance * (1.0 + margin * faded(knot))).collect();
        let enough = (0..knot_count).map(|knot| distance - SLACK + (distance * goal + SLACK) * faded(knot)).collect();
        Self { wanted, enough, edge: [distance, distance - SLACK] }
    }

    /// The greatest distance wanted anywhere.
    pub(crate) fn greatest(&self) -> f64 {
        self.wanted.iter().copied().fold(0.0, f64::max)
    }

    /// (wanted, enough) for an approach `s` knots after a knot.
    pub(crate) fn at(&self, knot: usize, s: f64) -> [f64; 2] {
        let is_edge = s.abs() > 0.5;
        if is_edge { self.edge } else { [self.wanted[knot], self.enough[knot]] }
    }

    /// From how many knots before to how many after does a knot stand for the path: half the way to the next, all of it to an end.
    pub(crate) fn window(&self, knot: usize) -> [f64; 2] {
        let before = if knot == 1 { -1.0 } else { -0.5 };
        let after = if knot + 2 == self.wanted.len() { 1.0 } else { 0.5 };
        [before, after]
    }
}

/// The least of |r + s v|² for s in a window, and s.
pub(crate) fn nearest(r: [f64; 3], v: [f64; 3], window: [f64; 2]) -> (f64, f64) {
    let speed_squared = dot(v, v);
    let closing = -dot(r, v);
    let s = if closing >= window[1] * speed_squared {
        // Also when nothing moves: any moment is as good.
        if speed_squared == 0.0 { 0.0 } else { window[1] }
    } else if closing <= window[0] * speed_squared {
        window[0]
    } else {
        closing / speed_squared
    };
    let at = [r[0] + s * v[0], r[1] + s * v[1], r[2] + s * v[2]];
    (dot(at, at), s)
}

pub(crate) fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// Lists everybody nearer than wanted, ascending by key; answers the sum of what is missing to be good enough, meters.
pub(crate) fn scan(paths: &Paths, demand: &Demand, meetings: &[Meeting], outlines: &[Outline], found: &mut Vec<Found>) -> f64 {
    found.clear();
    let agent_count = paths.agent_count();
    let mut excess = 0.0;
    for meeting in meetings {
        let (i, j) = (meeting.i as usize, meeting.j as usize);
        excess += if j < agent_count {
            scan_pair(paths, demand, meeting, found)
        } else {
            scan_outline(paths, demand, meeting, &outlines[j - agent_count], i, found)
        };
    }
    excess
}

fn scan_pair(paths: &Paths, demand: &Demand, meeting: &Meeting, found: &mut Vec<Found>) -> f64 {
    let (i, j) = (meeting.i as usize, meeting.j as usize);
    let in_space = paths.axis_count() == 3;
    let [xi, xj] = [paths.path(0, i), paths.path(0, j)];
    let [yi, yj] = [paths.path(1, i), paths.path(1, j)];
    let empty: &[f64] = &[];
    let [zi, zj] = if in_space { [paths.path(2, i), paths.path(2, j)] } else { [empty, empty] };
    let apart = |k: usize| [xi[k] - xj[k], yi[k] - yj[k], if in_space { zi[k] - zj[k] } else { 0.0 }];
    let mut excess = 0.0;
    let [mut before, mut r] = [apart(meeting.from as usize - 1), apart(meeting.from as usize)];
    for knot in meeting.from as usize..meeting.to as usize {
        let after = apart(knot + 1);
        let v = [0.5 * (after[0] - before[0]), 0.5 * (after[1] - before[1]), 0.5 * (after[2] - before[2])];
        let wanted = demand.wanted[knot];
        // (a + b)² ≤ 2a² + 2b²: most are too far off for any moment of the window.
        let is_possible = dot(r, r) < 2.0 * (wanted * wanted + dot(v, v));
        if is_possible {
            let (distance_squared, s) = nearest(r, v, demand.window(knot));
            let [wanted, enough] = demand.at(knot, s);
            if distance_squared < wanted * wanted {
                let distance = distance_squared.sqrt();
                excess += (enough - distance).max(0.0);
                found.push(Found { key: Key::new(meeting.i, meeting.j, knot), depth: wanted - distance });
            }
        }
        (before, r) = (r, after);
    }
    excess
}

/// How far an agent is from an outline about a knot, and the direction that leads away.
///
/// On the straight way between the middles of the pieces before and after: it cuts a corner as much as the pieces do.
pub(crate) fn beside(paths: &Paths, outline: &Outline, agent: usize, knot: usize) -> (f64, [f64; 2]) {
    let [before, here, after] = [knot - 1, knot, knot + 1].map(|knot| paths.place(agent, knot));
    let middle = |other: [f64; 3]| [0.5 * (here[0] + other[0]), 0.5 * (here[1] + other[1])];
    let (from, to) = (middle(before), middle(after));
    let (_, t) = outline.least_clearance(from, to);
    outline.clearance([from[0] + t * (to[0] - from[0]), from[1] + t * (to[1] - from[1])])
}

fn scan_outline(paths: &Paths, demand: &Demand, meeting: &Meeting, outline: &Outline, agent: usize, found: &mut Vec<Found>) -> f64 {
    let mut excess = 0.0;
    for knot in meeting.from as usize..meeting.to as usize {
        let (distance, _) = beside(paths, outline, agent, knot);
        let [wanted, enough] = demand.at(knot, 0.0);
        if distance < wanted {
            found.push(Found { key: Key::new(meeting.i, meeting.j, knot), depth: wanted - distance });
            excess += (enough - distance).max(0.0);
        }
    }
    excess
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_nearest_moment_lies_in_its_window() {
        let check = |r, v, window, expected| assert_eq!(nearest(r, v, window), expected);
        check([0.2, 1.0, 0.0], [-1.0, 0.0, 0.0], [-0.5, 0.5], (1.0, 0.2));
        check([2.0, 0.0, 0.0], [-1.0, 0.0, 0.0], [-0.5, 0.5], (2.25, 0.5));
        check([-2.0, 0.0, 0.0], [-1.0, 0.0, 0.0], [-0.5, 0.5], (2.25, -0.5));
        check([0.0, 0.0, 3.0], [0.0, 0.0, 0.0], [-0.5, 0.5], (9.0, 0.0));
        check([0.0, 0.0, 3.0], [0.0, 0.0, 3.0], [-1.0, 0.5], (0.0, -1.0));
    }

    #[test]
    fn a_crossing_between_knots_is_found_and_one_far_off_is_not() {
        let mut paths = Paths::new(2, 9, 2);
        for knot in 0..9 {
            // They cross at knot 4.4, 0.3 apart, 0.8 nearer every knot.
            paths.path_mut(0, 0)[knot] = 0.8 * (knot as f64 - 4.4);
            paths.path_mut(1, 1)[knot] = 0.3;
        }
        let demand = Demand::new(0.5, [0.0, 0.0], 9);
        let mut found = Vec::new();
        let excess = scan(&paths, &demand, &[Meeting { i: 0, j: 1, from: 1, to: 8 }], &[], &mut found);
        assert_eq!(found.iter().map(|found| found.key).collect::<Vec<_>>(), [Key::new(0, 1, 4), Key::new(0, 1, 5)]);
        // Half a knot from its own, the second sees them 0.08 past one another.
        let missing = [0.2, 0.5 - (0.3_f64 * 0.3 + 0.08 * 0.08).sqrt()];
        assert!((found[0].depth - missing[0]).abs() < 1e-12 && (found[1].depth - missing[1]).abs() < 1e-12, "{found:?}");
        assert!((excess - missing[0] - missing[1]).abs() < 4.0 * SLACK, "{excess}");
    }
}
