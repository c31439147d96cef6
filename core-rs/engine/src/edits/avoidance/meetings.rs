//! Lists who may meet at which knots.

use std::ops::Range;

use eigenform_apart::{Meeting, Outline, Paths, Solver};
use glam::DVec2;

use super::breaches::{Breach, Other};
use super::obstacles::Round;
use super::rungs::greatest_step;
use super::shut::ShutOff;
use super::{Avoidance, is_among};
use crate::formation::PairSearch;
use crate::order;

/// Knots read together: a line of memory holds that many numbers of a path.
const BLOCK: usize = 8;

/// Lists for one guide after another; its buffers serve them all.
#[derive(Default)]
pub(super) struct Lister {
    search: PairSearch,
    places: [Vec<DVec2>; BLOCK],
    keys: Vec<u64>,
    spare: Vec<u64>,
}

impl Lister {
    /// Gives the solver a new list of all who may meet, save those that a keyframe has too near, next to it, and
    /// of agents without a way with what stands in it.
    pub(super) fn list(&mut self, solver: &mut Solver, breaches: &[Breach], shut_off: &[ShutOff], avoidance: &Avoidance) {
        let mut meetings = solver.take_list();
        let reach = solver.reach();
        let paths = solver.paths();
        self.near_pairs(paths, reach);
        meetings.clear();
        runs_into(&self.keys, &mut meetings);
        let outlines = avoidance.outlines();
        let obstacle_count = avoidance.obstacles.len();
        for (number, outline) in outlines.iter().enumerate() {
            let agents = match number.checked_sub(obstacle_count) {
                None => 0..paths.agent_count(),
                Some(hold) => {
                    let agent = avoidance.holds[hold].agent as usize;
                    agent..agent + 1
                }
            };
            near_outline_into(paths, agents, (number, outline), reach, &mut meetings);
        }
        if !shut_off.is_empty() {
            meetings.retain(|meeting| meeting.j < paths.agent_count() as u32 || !is_among(shut_off, meeting.i as usize));
        }
        if !breaches.is_empty() {
            let knot_count = paths.knot_count();
            meetings =
                meetings.into_iter().filter_map(|meeting| without_breaches(meeting, breaches, paths.agent_count(), knot_count)).collect();
        }
        if !outlines.is_empty() {
            order::sort_by_key(&mut meetings, |meeting| {
                order::key_of_two(u64::from(meeting.i) << 32 | u64::from(meeting.j), u64::from(meeting.from))
            });
        }
        solver.list(meetings);
    }

    /// (i, j, knot) of every near pair as one number each, ascending.
    fn near_pairs(&mut self, paths: &Paths, reach: f64) {
        self.keys.clear();
        let last = paths.knot_count() - 1;
        for start in (1..last).step_by(BLOCK) {
            let end = (start + BLOCK).min(last);
            self.read(paths, start, end);
            for knot in start..end {
                let is_edge = knot == 1 || knot + 1 == last;
                let share = if is_edge { 1.0 } else { 0.5 };
                let radius = reach + 2.0 * share * greatest_step(paths, knot);
                let keys = &mut self.keys;
                self.search.for_each_within(&self.places[knot - start], radius, |i, j, distance_squared| {
                    // What a pair closes within its window; most that are within the radius move alike.
                    let near = reach + share * relative_step(paths, i as usize, j as usize, knot);
                    if distance_squared <= near * near {
                        keys.push(key(i, j, knot));
                    }
                });
            }
        }
        order::sort_by_bytes(&mut self.keys, &mut self.spare, 0..size_of::<u64>(), |key, place| key.to_le_bytes()[place]);
    }

    fn read(&mut self, paths: &Paths, start: usize, end: usize) {
        self.places.iter_mut().for_each(Vec::clear);
        for agent in 0..paths.agent_count() {
            let [x, y] = [paths.path(0, agent), paths.path(1, agent)];
            for knot in start..end {
                self.places[knot - start].push(DVec2::new(x[knot], y[knot]));
            }
        }
    }
}

const KNOT_BITS: u32 = 16;
const AGENT_BITS: u32 = 24;

fn key(i: u32, j: u32, knot: usize) -> u64 {
    ((u64::from(i) << AGENT_BITS | u64::from(j)) << KNOT_BITS) | knot as u64
}

/// How far two move against one another from one knot to the next.
fn relative_step(paths: &Paths, i: usize, j: usize, knot: usize) -> f64 {
    let [before, after] = [knot - 1, knot + 1].map(|knot| {
        let [a, b] = [paths.place(i, knot), paths.place(j, knot)];
        [a[0] - b[0], a[1] - b[1]]
    });
    let [x, y] = [after[0] - before[0], after[1] - before[1]];
    0.5 * (x * x + y * y).sqrt()
}

/// Joins the knots of a pair that follow one another.
fn runs_into(keys: &[u64], meetings: &mut Vec<Meeting>) {
    let mut last = None;
    for &key in keys {
        let knot = (key % (1 << KNOT_BITS)) as u32;
        match meetings.last_mut() {
            Some(meeting) if last == Some(key - 1) && knot > 0 => meeting.to = knot + 1,
            _ => {
                let pair = key >> KNOT_BITS;
                let [i, j] = [pair >> AGENT_BITS, pair % (1 << AGENT_BITS)].map(|agent| agent as u32);
                meetings.push(Meeting { i, j, from: knot, to: knot + 1 });
            }
        }
        last = Some(key);
    }
}

fn near_outline_into(paths: &Paths, agents: Range<usize>, (number, outline): (usize, &Outline), reach: f64, meetings: &mut Vec<Meeting>) {
    let last = paths.knot_count() - 1;
    let j = (paths.agent_count() + number) as u32;
    let round = Round::about(outline);
    for agent in agents {
        let mut open: Option<Meeting> = None;
        for knot in 1..last {
            let [x, y, _] = paths.place(agent, knot);
            let [before, after] = [knot - 1, knot + 1].map(|knot| paths.place(agent, knot));
            let near = reach + 0.5 * DVec2::new(after[0] - before[0], after[1] - before[1]).length();
            let is_near = round.reaches(x, y, near) && outline.clearance([x, y]).0 < near;
            match &mut open {
                Some(meeting) if is_near => meeting.to = knot as u32 + 1,
                None if is_near => open = Some(Meeting { i: agent as u32, j, from: knot as u32, to: knot as u32 + 1 }),
                _ => meetings.extend(open.take()),
            }
        }
        meetings.extend(open);
    }
}

/// What is left of a meeting when the sixth next to a keyframe that has the pair too near is taken away.
fn without_breaches(mut meeting: Meeting, breaches: &[Breach], agent_count: usize, knot_count: usize) -> Option<Meeting> {
    let sixth = (knot_count / 6) as u32;
    for breach in breaches {
        let other = match breach.other {
            Other::Agent(agent) => agent,
            Other::Obstacle(obstacle) => agent_count as u32 + obstacle,
        };
        if (breach.agent, other) == (meeting.i, meeting.j) {
            if breach.end == 0 {
                meeting.from = meeting.from.max(sixth);
            } else {
                meeting.to = meeting.to.min(knot_count as u32 - sixth);
            }
        }
    }
    (meeting.from < meeting.to).then_some(meeting)
}
