//! Sweeps over all contacts, deepest first, until everybody is apart.

use crate::bytes::sort_by_bytes;
use crate::contact::{Contact, Side};
use crate::kernel::Kernel;
use crate::outline::Outline;
use crate::paths::Paths;
use crate::scan::{Demand, Found, Meeting, beside, dot, nearest, scan};

/// What a solver goes by.
#[derive(Clone, Debug)]
pub struct Rules {
    /// Nobody may be nearer than this, meters.
    pub distance: f64,
    /// What is pushed for beyond it and what is good enough, of the distance.
    pub margins: [f64; 2],
    /// A push closes at most this much of a gap, of the distance: without it whole blocks overshoot.
    pub step_cap: f64,
    /// Sweeps after which it gives up.
    pub sweep_limit: usize,
    /// Slower than this across a knot, of the distance, two stand still to one another: they are pushed straight apart, for there is no
    /// side to pass on.
    pub stillness: f64,
    /// Decides the way out of one and the same place.
    pub seed: u64,
    /// What stands still.
    pub outlines: Vec<Outline>,
}

/// Where a solver has come to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum State {
    /// Another sweep may help.
    Working,
    /// Everybody is apart at the knots and between them.
    Apart,
    /// It gave up.
    Stuck,
}

/// Good enough for so many sweeps in a row is at rest.
const CALM_SWEEPS: usize = 4;

/// What is missing must shrink by 2 % in so many sweeps.
const PATIENCE: usize = 30;
const GAIN: f64 = 0.98;

/// Pushes an agent, in the mean, after which it gives up.
const VISITS_PER_AGENT: usize = 4_000;

/// Whoever is this far on the left, of the distance, passes on the left; all others on the right, so that equals pass alike.
const SIDE_BIAS: f64 = 0.15;

/// Nearer than this, of the distance wanted, the direction between two is too rough to push along.
const CORE: f64 = 0.35;

/// Deeper than this, of the distance, is a strike; so many in a row change the side, every few sweeps from one on.
const STRIKE_DEPTH: f64 = 0.04;
const STRIKES: u8 = 6;
const FIRST_FLIP: usize = 8;
const FLIP_INTERVAL: usize = 2;

/// A list of near pairs serves until somebody has moved this far, of the distance, or so many sweeps.
const LIST_SHIFT: f64 = 0.17;
const LIST_SWEEPS: usize = 12;

/// What a list must reach beyond the distance wanted, of the distance: both of a pair may move.
const LIST_REACH: f64 = 0.4;

/// Pushes paths apart around a guide.
///
/// The caller lists who may meet whenever [`Solver::needs_list`] says so, then sweeps.
pub struct Solver {
    guide: Paths,
    paths: Paths,
    listed: Paths,
    kernel: Kernel,
    rules: Rules,
    demand: Demand,
    meetings: Vec<Meeting>,
    list_age: usize,
    contacts: Vec<Contact>,
    merged: Vec<Contact>,
    found: Vec<Found>,
    order: Vec<u64>,
    spare: Vec<u64>,
    sweep_count: usize,
    calm: usize,
    visits: usize,
    least_excess: f64,
    last_gain: usize,
}

impl Solver {
    /// Nothing is pushed yet: the paths are the guide.
    pub fn new(guide: Paths, kernel: Kernel, rules: Rules) -> Self {
        let demand = Demand::new(rules.distance, rules.margins, guide.knot_count());
        let (paths, listed) = (guide.clone(), guide.clone());
        Self {
            guide,
            paths,
            listed,
            kernel,
            rules,
            demand,
            meetings: Vec::new(),
            list_age: usize::MAX,
            contacts: Vec::new(),
            merged: Vec::new(),
            found: Vec::new(),
            order: Vec::new(),
            spare: Vec::new(),
            sweep_count: 0,
            calm: 0,
            visits: 0,
            least_excess: f64::INFINITY,
            last_gain: 0,
        }
    }

    /// The paths so far.
    pub fn paths(&self) -> &Paths {
        &self.paths
    }

    /// The guide they started from.
    pub fn guide(&self) -> &Paths {
        &self.guide
    }

    /// How many pushes it took so far: what time it takes is proportional to.
    pub fn visits(&self) -> usize {
        self.visits
    }

    /// How many sweeps so far.
    pub fn sweep_count(&self) -> usize {
        self.sweep_count
    }

    /// What pairs are still missing in the mean of all knots, meters; falls toward zero.
    pub fn excess(&self) -> f64 {
        self.least_excess
    }

    /// Whether the list of meetings may miss somebody.
    pub fn needs_list(&self) -> bool {
        let shift = LIST_SHIFT * self.rules.distance;
        self.list_age >= LIST_SWEEPS || self.paths.greatest_shift_squared(&self.listed) > shift * shift
    }

    /// A list must have every pair whose closest approach within half a knot is at most this, meters.
    pub fn reach(&self) -> f64 {
        self.demand.greatest() + LIST_REACH * self.rules.distance
    }

    /// Takes the list of who may meet.
    pub fn list(&mut self, meetings: Vec<Meeting>) {
        self.meetings = meetings;
        self.list_age = 0;
        self.listed.clone_from(&self.paths);
    }

    /// The list it was given, to be filled anew.
    pub fn take_list(&mut self) -> Vec<Meeting> {
        std::mem::take(&mut self.meetings)
    }

    /// Looks at every meeting once and pushes whoever is too near.
    pub fn sweep(&mut self) -> State {
        let excess = scan(&self.paths, &self.demand, &self.meetings, &self.rules.outlines, &mut self.found);
        self.calm = if excess > 0.0 { 0 } else { self.calm + 1 };
        if self.calm >= CALM_SWEEPS {
            return State::Apart;
        }
        if excess < GAIN * self.least_excess {
            self.last_gain = self.sweep_count;
        }
        self.least_excess = self.least_excess.min(excess);
        let is_stuck = self.calm == 0 && self.sweep_count > self.last_gain + PATIENCE;
        if is_stuck || self.sweep_count >= self.rules.sweep_limit || self.visits > VISITS_PER_AGENT * self.paths.agent_count() {
            return State::Stuck;
        }
        self.merge();
        self.sort();
        for at in 0..self.order.len() {
            self.visit(contact_of(self.order[at]));
        }
        self.visits += self.order.len();
        if self.sweep_count >= FIRST_FLIP && self.sweep_count.is_multiple_of(FLIP_INTERVAL) {
            self.flip();
        }
        self.sweep_count += 1;
        self.list_age = self.list_age.saturating_add(1);
        State::Working
    }

    /// Makes contacts of everybody found; those that were contacts before keep what they remember.
    fn merge(&mut self) {
        self.merged.clear();
        let mut found = self.found.iter().peekable();
        for contact in &mut self.contacts {
            while let Some(new) = found.next_if(|new| new.key < contact.key) {
                self.merged.push(Contact::new(new.key, new.depth));
            }
            contact.depth = found.next_if(|new| new.key == contact.key).map_or(0.0, |again| again.depth);
            self.merged.push(contact.clone());
        }
        self.merged.extend(found.map(|new| Contact::new(new.key, new.depth)));
        std::mem::swap(&mut self.contacts, &mut self.merged);
    }

    /// Deepest first; of equals the first.
    fn sort(&mut self) {
        self.order.clear();
        let per_meter = f64::from(1 << 20) / self.rules.distance;
        for (index, contact) in (0_u64..).zip(&self.contacts) {
            if !contact.is_at_rest() {
                let depth = (contact.depth * per_meter).min(f64::from(u32::MAX)) as u32;
                self.order.push(u64::from(u32::MAX - depth) << 32 | index);
            }
        }
        // By depth; indices ascend already.
        sort_by_bytes(&mut self.order, &mut self.spare, 4..8, |order, place| order.to_le_bytes()[place]);
    }

    fn visit(&mut self, index: usize) {
        let key = self.contacts[index].key;
        let ((i, j), knot) = (key.pair(), key.knot());
        let is_pair = j < self.paths.agent_count();
        let (gap, n) = if is_pair { self.pair_gap(index) } else { self.outline_gap(i, j, knot) };
        let cap = self.rules.step_cap * self.rules.distance;
        let bump = self.kernel.bump(knot);
        let movers = if is_pair { 2.0 } else { 1.0 };
        let contact = &mut self.contacts[index];
        let impulse = (dot(contact.impulse, n) - gap.clamp(-cap, cap) / (movers * bump.peak)).max(0.0);
        let after = [impulse * n[0], impulse * n[1], impulse * n[2]];
        let change = [after[0] - contact.impulse[0], after[1] - contact.impulse[1], after[2] - contact.impulse[2]];
        contact.impulse = after;
        contact.strikes = if gap < -STRIKE_DEPTH * self.rules.distance { contact.strikes.saturating_add(1) } else { 0 };
        if change != [0.0; 3] {
            self.paths.push(i, bump.start, &bump.values, change);
            if is_pair {
                self.paths.push(j, bump.start, &bump.values, change.map(|change| -change));
            }
        }
    }

    /// How much more than wanted a pair is apart, and along which direction that counts.
    fn pair_gap(&mut self, index: usize) -> (f64, [f64; 3]) {
        let key = self.contacts[index].key;
        let ((i, j), knot) = (key.pair(), key.knot());
        let r = self.paths.apart(i, j, knot);
        let (_, s) = nearest(r, across(&self.paths, i, j, knot), self.demand.window(knot));
        let v = across(&self.paths, i, j, knot);
        let r = [r[0] + s * v[0], r[1] + s * v[1], r[2] + s * v[2]];
        let distance = dot(r, r).sqrt();
        let [wanted, _] = self.demand.at(knot, s);
        let n = self.direction(index, r, distance, across(&self.guide, i, j, knot), wanted);
        (dot(r, n) - wanted, n)
    }

    /// Away from j for i: straight where they are on the side they pass, else to that side of the guide's relative way.
    fn direction(&mut self, index: usize, r: [f64; 3], distance: f64, way: [f64; 3], wanted: f64) -> [f64; 3] {
        let straight = || [r[0] / distance, r[1] / distance, r[2] / distance];
        let speed = (way[0] * way[0] + way[1] * way[1]).sqrt();
        if speed <= self.rules.stillness * self.rules.distance {
            return if distance > 0.0 { straight() } else { any_direction(self.contacts[index].key.hash(self.rules.seed)) };
        }
        let right = [way[1] / speed, -way[0] / speed];
        let rightward = r[0] * right[0] + r[1] * right[1];
        if self.contacts[index].side == Side::Undecided {
            let side = if rightward > -SIDE_BIAS * self.rules.distance { Side::Right } else { Side::Left };
            self.take_side(index, side);
        }
        let sign = self.contacts[index].side.sign();
        if distance > CORE * wanted && sign * rightward > 0.0 { straight() } else { [sign * right[0], sign * right[1], 0.0] }
    }

    fn outline_gap(&self, i: usize, j: usize, knot: usize) -> (f64, [f64; 3]) {
        let (distance, n) = beside(&self.paths, &self.rules.outlines[j - self.paths.agent_count()], i, knot);
        let [wanted, _] = self.demand.at(knot, 0.0);
        (distance - wanted, [n[0], n[1], 0.0])
    }

    /// Everything remembered of a pair in a sixth of the segment: contacts are sorted, so they lie together.
    fn pass_of(&self, index: usize) -> std::ops::Range<usize> {
        let (key, knot_count) = (self.contacts[index].key, self.paths.knot_count());
        let is_same = |contact: &Contact| contact.key.is_one_pass(key, knot_count);
        let before = self.contacts[..index].iter().rev().take_while(|contact| is_same(contact)).count();
        let after = self.contacts[index..].iter().take_while(|contact| is_same(contact)).count();
        index - before..index + after
    }

    /// The side that a contact of the same pass has taken already, else the one offered.
    fn take_side(&mut self, index: usize, offered: Side) {
        let pass = self.pass_of(index);
        let contacts = &mut self.contacts[pass];
        let known = contacts.iter().map(|contact| contact.side).find(|side| *side != Side::Undecided);
        for contact in contacts {
            contact.side = known.unwrap_or(offered);
        }
    }

    /// Whoever stays far too near takes back all pushes of that pass and tries the other side; one pass an agent at a time.
    fn flip(&mut self) {
        let mut is_taken = vec![false; self.paths.agent_count()];
        for at in 0..self.order.len() {
            let index = contact_of(self.order[at]);
            let (i, j) = self.contacts[index].key.pair();
            let is_free = j < is_taken.len() && !is_taken[i] && !is_taken[j];
            if !is_free || self.contacts[index].strikes < STRIKES {
                continue;
            }
            (is_taken[i], is_taken[j]) = (true, true);
            for index in self.pass_of(index) {
                let contact = &mut self.contacts[index];
                let change = contact.impulse.map(|impulse| -impulse);
                (contact.impulse, contact.strikes, contact.side) = ([0.0; 3], 0, contact.side.other());
                if change != [0.0; 3] {
                    let bump = self.kernel.bump(contact.key.knot());
                    self.paths.push(i, bump.start, &bump.values, change);
                    self.paths.push(j, bump.start, &bump.values, change.map(|change| -change));
                }
            }
        }
    }
}

fn contact_of(order: u64) -> usize {
    (order % (1 << 32)) as usize
}

/// How i moves against j from one knot to the next, about a knot.
fn across(paths: &Paths, i: usize, j: usize, knot: usize) -> [f64; 3] {
    let [before, after] = [paths.apart(i, j, knot - 1), paths.apart(i, j, knot + 1)];
    [0.5 * (after[0] - before[0]), 0.5 * (after[1] - before[1]), 0.5 * (after[2] - before[2])]
}

/// A direction on the plane, from numbers without order.
fn any_direction(hash: u64) -> [f64; 3] {
    // Odd numerators are never zero.
    let part = |bits: u64| (2.0 * (bits % (1 << 20)) as f64 + 1.0) / f64::from(1 << 20) - 1.0;
    let (x, y) = (part(hash), part(hash >> 20));
    let length = (x * x + y * y).sqrt();
    [x / length, y / length, 0.0]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn rules() -> Rules {
        Rules { distance: 0.5, margins: [0.03, 0.012], step_cap: 0.3, sweep_limit: 120, stillness: 1e-4, seed: 1, outlines: Vec::new() }
    }

    /// Straight ways, evenly walked.
    fn straight(ways: &[[f64; 4]], knot_count: usize) -> Paths {
        let mut paths = Paths::new(ways.len(), knot_count, 2);
        for (agent, way) in ways.iter().enumerate() {
            for knot in 0..knot_count {
                let t = knot as f64 / (knot_count - 1) as f64;
                paths.path_mut(0, agent)[knot] = way[0] * (1.0 - t) + way[2] * t;
                paths.path_mut(1, agent)[knot] = way[1] * (1.0 - t) + way[3] * t;
            }
        }
        paths
    }

    fn everybody(agent_count: u32, knot_count: usize) -> Vec<Meeting> {
        let pairs = (0..agent_count).flat_map(|i| (i + 1..agent_count).map(move |j| (i, j)));
        pairs.map(|(i, j)| Meeting { i, j, from: 1, to: knot_count as u32 - 1 }).collect()
    }

    fn solved(guide: Paths, rules: Rules, meetings: &[Meeting]) -> Solver {
        let kernel = Kernel::new(guide.knot_count(), 6.0, [false, false]);
        let mut solver = Solver::new(guide, kernel, rules);
        loop {
            if solver.needs_list() {
                solver.list(meetings.to_vec());
            }
            match solver.sweep() {
                State::Working => {}
                State::Apart => return solver,
                State::Stuck => panic!("stuck after {} sweeps", solver.sweep_count()),
            }
        }
    }

    fn least_distance(paths: &Paths) -> f64 {
        let mut least = f64::INFINITY;
        for knot in 0..paths.knot_count() {
            for i in 0..paths.agent_count() {
                for j in i + 1..paths.agent_count() {
                    let r = paths.apart(i, j, knot);
                    least = least.min(dot(r, r).sqrt());
                }
            }
        }
        least
    }

    #[test]
    fn two_who_meet_head_on_pass_each_on_the_right() {
        let solver = solved(straight(&[[-3.0, 0.0, 3.0, 0.0], [3.0, 0.0, -3.0, 0.0]], 31), rules(), &everybody(2, 31));
        assert!(least_distance(solver.paths()) > 0.5);
        let [first, second] = [solver.paths().place(0, 15)[1], solver.paths().place(1, 15)[1]];
        // Equals pass alike: each to its own right, by half the distance.
        assert!(first < -0.25 && second > 0.25 && (first + second).abs() < 1e-9, "{first} {second}");
    }

    #[test]
    fn ends_stay_where_they_are() {
        let guide = straight(&[[-3.0, 0.0, 3.0, 0.0], [0.0, -3.0, 0.0, 3.0], [3.0, 0.2, -3.0, 0.1]], 31);
        let solver = solved(guide.clone(), rules(), &everybody(3, 31));
        for agent in 0..3 {
            for knot in [0, 30] {
                assert_eq!(solver.paths().place(agent, knot), guide.place(agent, knot));
            }
        }
    }

    #[test]
    fn two_in_one_place_all_the_way_but_at_the_ends_part() {
        let mut guide = straight(&[[0.0; 4], [0.0; 4]], 31);
        for knot in [0, 1, 29, 30] {
            guide.path_mut(0, 0)[knot] = -0.5;
            guide.path_mut(0, 1)[knot] = 0.5;
        }
        assert!(least_distance(solved(guide, rules(), &everybody(2, 31)).paths()) > 0.5);
    }

    #[test]
    fn a_path_is_pushed_out_of_what_stands_still() {
        let outlines = vec![Outline { points: vec![[0.0, 0.4]], radius: 0.5 }];
        let guide = straight(&[[-3.0, 0.0, 3.0, 0.0]], 31);
        let meetings = [Meeting { i: 0, j: 1, from: 1, to: 30 }];
        let solver = solved(guide, Rules { outlines: outlines.clone(), ..rules() }, &meetings);
        let clearance = |knot| {
            let [x, y, _] = solver.paths().place(0, knot);
            outlines[0].clearance([x, y]).0
        };
        assert!((0..31).all(|knot| clearance(knot) >= 0.5));
    }
}
