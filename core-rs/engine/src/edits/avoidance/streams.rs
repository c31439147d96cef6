//! Blocks that go through one another: who moves as one with whom, and guides that let such streams pass.
//!
//! Agents that keep their places to one another are a stream. Two streams pass where the files of one, seen along their relative way,
//! lie between those of the other: a shift by part of a spacing does it, for all of a stream alike. Files that are too close for that
//! open first, about the middle of the stream. So each stays whole, and is as it was once they have passed.

use eigenform_apart::Paths;
use glam::DVec2;

use super::at;
use crate::motion::{Approach, Motion};
use crate::order;

/// Places relative to one another that change by less than this stay, in minimum distances.
const TOGETHER: f64 = 0.5;

/// Fewer agents are no stream.
const FEWEST: usize = 4;

/// More streams than this are a crowd.
const MOST: usize = 12;

/// Files are wanted this far apart, in minimum distances: a little more than what pushes ask for.
const WANTED: f64 = 1.03;

/// Files nearer to one another than this are one, in minimum distances.
const SAME_FILE: f64 = 1e-3;

/// Of streams without files so many agents stand for all.
const FILE_LIMIT: usize = 512;

/// A shift may be so wide, in minimum distances.
const WIDEST: f64 = 3.0;

/// Streams open by this much at the most.
const MOST_OPEN: f64 = 1.0;

/// They are open from so much of the time between the first clash and the middle of all on.
const LATE: f64 = 0.6;

/// Streams of one guide that clash.
pub(super) struct Streams {
    /// By stream, its agents.
    members: Vec<Vec<usize>>,
    meetings: Vec<Passing>,
}

/// Two streams, and when the first and the last of them clash: 0–1.
struct Passing {
    pair: [usize; 2],
    span: [f64; 2],
}

impl Streams {
    /// None where most who clash are in no streams, or in many.
    pub(super) fn of(guide: &Motion, clashes: &[Approach], distance: f64) -> Option<Self> {
        let members = together(guide, TOGETHER * distance)?;
        let mut stream_of = vec![None; guide.agent_count()];
        for (stream, agents) in members.iter().enumerate() {
            for agent in agents {
                stream_of[*agent] = Some(stream);
            }
        }
        let (times, mut meetings) = (guide.times(), Vec::<Passing>::new());
        let mut other_count = 0;
        for clash in clashes {
            let [a, b] = [clash.agents.0, clash.agents.1].map(|agent| stream_of[agent as usize]);
            let pair = match (a, b) {
                (Some(a), Some(b)) if a != b => [a.min(b), a.max(b)],
                _ => {
                    other_count += 1;
                    continue;
                }
            };
            let at = (clash.time - times[0]) / (times[times.len() - 1] - times[0]);
            match meetings.iter_mut().find(|known| known.pair == pair) {
                Some(known) => known.span = [known.span[0].min(at), known.span[1].max(at)],
                None => meetings.push(Passing { pair, span: [at, at] }),
            }
        }
        (2 * other_count < clashes.len()).then_some(Self { members, meetings })
    }

    /// Opens streams by a `share` of what their files need to lie between one another's, and shifts them so that they do.
    pub(super) fn open(&self, paths: &mut Paths, share: f64, distance: f64) {
        let rooms: Vec<f64> = self.meetings.iter().map(|passing| between(self.files(paths, passing, distance).1, distance).1).collect();
        for stream in 0..self.members.len() {
            let own = || self.meetings.iter().zip(&rooms).filter(|(passing, _)| passing.pair.contains(&stream));
            let room = own().map(|(_, room)| *room).fold(WANTED * distance, f64::min);
            let growth = (share * (WANTED * distance / room - 1.0)).min(MOST_OPEN);
            let first = own().map(|(passing, _)| passing.span[0]).fold(1.0, f64::min);
            let last = own().map(|(passing, _)| passing.span[1]).fold(0.0, f64::max);
            // They go on opening while they meet: the first who do have most room.
            let span = [first, last].map(|end| end + LATE * (0.5 * (first + last) - end));
            let middle = self.middle(paths, stream, 0);
            let by: Vec<DVec2> = self.members[stream].iter().map(|agent| growth * (at(paths, *agent, 0) - middle)).collect();
            if growth > 0.0 {
                self.lead(paths, stream, span, |member| by[member]);
            }
        }
        let shift = |passing: &Passing| {
            let (across, offsets) = self.files(paths, passing, distance);
            0.5 * between(offsets, distance).0 * across
        };
        let shifts: Vec<DVec2> = self.meetings.iter().map(shift).collect();
        for (passing, shift) in self.meetings.iter().zip(shifts) {
            for (stream, shift) in passing.pair.iter().zip([shift, -shift]) {
                self.lead(paths, *stream, passing.span, |_| shift);
            }
        }
    }

    /// The direction across the relative way of two streams, and how much farther the files of the second lie along it than those of
    /// the first.
    fn files(&self, paths: &Paths, Passing { pair, span }: &Passing, distance: f64) -> (DVec2, Vec<f64>) {
        let last = paths.knot_count() - 1;
        let knot = ((0.5 * (span[0] + span[1]) * last as f64) as usize).clamp(1, last - 1);
        let [a, b] = pair.map(|stream| self.middle(paths, stream, knot + 1) - self.middle(paths, stream, knot - 1));
        let across = (a - b).normalize_or_zero().perp();
        let [from, to] = pair.map(|stream| {
            let mut files: Vec<f64> = self.members[stream].iter().map(|agent| at(paths, *agent, knot).dot(across)).collect();
            ascend(&mut files);
            files.dedup_by(|next, file| *next - *file < SAME_FILE * distance);
            let every = files.len().div_ceil(FILE_LIMIT);
            files.into_iter().step_by(every).collect::<Vec<f64>>()
        });
        (across, from.iter().flat_map(|from| to.iter().map(move |to| to - from)).collect())
    }

    fn middle(&self, paths: &Paths, stream: usize, knot: usize) -> DVec2 {
        let agents = &self.members[stream];
        agents.iter().map(|agent| at(paths, *agent, knot)).sum::<DVec2>() / agents.len() as f64
    }

    /// Moves the agents of a stream by so much within a span of time, gently before and after it.
    fn lead(&self, paths: &mut Paths, stream: usize, span: [f64; 2], by: impl Fn(usize) -> DVec2) {
        let last = paths.knot_count() - 1;
        for (member, &agent) in self.members[stream].iter().enumerate() {
            for knot in 1..last {
                let by = by(member) * plateau(knot as f64 / last as f64, span);
                paths.path_mut(0, agent)[knot] += by.x;
                paths.path_mut(1, agent)[knot] += by.y;
            }
        }
    }
}

/// Agents by the way they have made after each quarter, in streams of a few at least.
fn together(guide: &Motion, tolerance: f64) -> Option<Vec<Vec<usize>>> {
    let last = guide.times().len() - 1;
    let quarters = [last / 4, last / 2, 3 * last / 4, last];
    let mut streams: Vec<([DVec2; 4], Vec<usize>)> = Vec::new();
    for agent in 0..guide.agent_count() {
        let own = quarters.map(|k| guide.sample(k)[agent] - guide.sample(0)[agent]);
        let is_alike = |other: &[DVec2; 4]| own.iter().zip(other).all(|(own, other)| own.distance(*other) <= tolerance);
        match streams.iter().position(|(other, _)| is_alike(other)) {
            Some(stream) => streams[stream].1.push(agent),
            None if streams.len() < MOST * FEWEST => streams.push((own, vec![agent])),
            None => return None,
        }
    }
    let members: Vec<Vec<usize>> = streams.into_iter().map(|(_, members)| members).filter(|members| members.len() >= FEWEST).collect();
    (2..=MOST).contains(&members.len()).then_some(members)
}

/// The least shift that leaves `distance` and a little to all `offsets`, or else as much as can be; and what it leaves, no more than that.
fn between(mut offsets: Vec<f64>, distance: f64) -> (f64, f64) {
    ascend(&mut offsets);
    let wanted = WANTED * distance;
    let mut best: (f64, f64) = (0.0, 0.0);
    for pair in offsets.windows(2) {
        let room = (0.5 * (pair[1] - pair[0])).min(wanted);
        let shift = 0.0_f64.clamp(pair[0] + room, (pair[1] - room).max(pair[0] + room));
        let is_better = if (room - best.1).abs() < SAME_FILE * distance { shift.abs() < best.0.abs() } else { room > best.1 };
        if is_better && shift.abs() <= WIDEST * distance {
            best = (shift, room);
        }
    }
    best
}

fn ascend(values: &mut [f64]) {
    order::sort_by_key(values, |value| u128::from(order::of_real(*value)));
}

/// 0 at both ends, 1 within a span, with two derivatives everywhere.
fn plateau(t: f64, [from, to]: [f64; 2]) -> f64 {
    let rise = |x: f64| {
        let x = x.min(1.0);
        x * x * x * (10.0 - x * (15.0 - 6.0 * x))
    };
    if t <= 0.0 || t >= 1.0 { 0.0 } else { rise(t / from.max(f64::MIN_POSITIVE)) * rise((1.0 - t) / (1.0 - to).max(f64::MIN_POSITIVE)) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn files_lie_between_one_another_after_the_least_shift() {
        let check = |offsets: &[f64], distance: f64, expected: (f64, f64)| {
            let (shift, room) = between(offsets.to_vec(), distance);
            assert!((shift.abs() - expected.0).abs() < 1e-12 && (room - expected.1).abs() < 1e-12, "{offsets:?}: {shift} {room}");
        };
        // Room enough: just so far as is wanted. Too little: halfway.
        check(&[-2.0, 0.0, 2.0], 0.5, (0.515, 0.515));
        check(&[-2.0, 0.0, 2.0], 1.0, (1.0, 1.0));
        check(&[-1.0, -0.3, 0.6, 2.0], 0.3, (0.009, 0.309));
        // A wider gap that is too far to go is none.
        check(&[-0.1, 0.1, 9.0], 0.5, (0.615, 0.515));
    }

    #[test]
    fn a_plateau_starts_and_ends_at_nothing() {
        let span = [0.3, 0.6];
        let values = [0.0, 0.3, 0.45, 0.6, 1.0].map(|t| plateau(t, span));
        assert_eq!(values, [0.0, 1.0, 1.0, 1.0, 0.0]);
        assert_eq!([plateau(0.0, [0.0, 1.0]), plateau(0.5, [0.0, 1.0]), plateau(1.0, [0.0, 1.0])], [0.0, 1.0, 0.0]);
    }

    #[test]
    fn those_who_move_as_one_are_a_stream_and_a_lone_agent_is_none() {
        let start: Vec<DVec2> = (0..9).map(|k| DVec2::new(f64::from(k), 0.0)).collect();
        let end = start.iter().enumerate().map(|(k, p)| {
            *p + if k < 4 {
                DVec2::X
            } else if k < 8 {
                DVec2::Y
            } else {
                -DVec2::X
            }
        });
        let guide = Motion::new(vec![0.0, 1.0], 9, start.iter().copied().chain(end).collect());
        assert_eq!(together(&guide, 0.25), Some(vec![vec![0, 1, 2, 3], vec![4, 5, 6, 7]]));
        assert_eq!(together(&guide, 3.0), None);
    }
}
