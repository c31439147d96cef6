//! Leads a guide around what stands in its way, before anybody is pushed.
//!
//! A group passes on one side, each as far outside as they stand to that side of the others: a block bows out as a block. Who is in no
//! group goes with all of those who head the same way, and such a block that is wider than the obstacle on both sides opens about its
//! middle and closes behind it. The way around is the shortest about the convex hull of the obstacle, grown by the distance; it is
//! walked with the guide's own clock, by arc length. Notches are entered only by those who stand in them: straight out or in, by the
//! shortest way.

use eigenform_apart::{Kernel, Outline, Paths};
use glam::DVec2;

use super::hull::{chain, extent, grown, way_out};
use super::obstacles::Round;
use super::{Avoidance, at};
use crate::edits::NO_GROUP;

/// Obstacles may push into one another's way; after so many rounds what is left is left to the pushes.
const ROUNDS: usize = 3;

/// Beyond the minimum distance, of it: room for the smoothing and the straight pieces.
pub(super) const MARGIN: f64 = 0.08;

/// Ways that differ by less than 60° are one.
const SAME_HEADING: f64 = 0.5;

/// The way is left and met again so many radii of the obstacle before and after it.
const RUN_UP: f64 = 1.5;

/// Whoever stands just as far away as asked for may leave, meters.
const ROUND_OFF: f64 = 1e-6;

/// Sideways offsets that differ by less are one, meters.
const SAME_LANE: f64 = 1e-9;

/// Kernel time of the smoothing: at least so many knots, and as long as it takes to cover so many radii of the obstacle.
const SMOOTHING: f64 = 2.5;
const SMOOTHING_RADII: f64 = 0.4;

/// The longest one, of the whole segment.
const LONGEST_SMOOTHING: f64 = 0.1;

/// Who passes within so many minimum distances of an obstacle, or within its width, passes near by.
const NEAR_BY: f64 = 4.0;

/// What may part at an obstacle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Parting {
    /// Nobody who heads the same way.
    Nothing,
    /// Who is in no group; the members of one stay together.
    Ungrouped,
    /// Everybody, as if there were no groups.
    Groups,
}

/// Leads the paths of those who are free to go around obstacles; velocities at clamped ends stay.
pub(super) fn reroute(paths: &mut Paths, avoidance: &Avoidance, parting: Parting, free: &[usize]) {
    let outlines = &avoidance.obstacles;
    let guide = paths.clone();
    let mut is_moved = vec![false; paths.agent_count()];
    for _ in 0..ROUNDS {
        let mut has_blocked = false;
        for outline in outlines {
            has_blocked |= around(paths, outline, avoidance, free, parting, &mut is_moved);
        }
        if !has_blocked {
            break;
        }
    }
    smooth(paths, &guide, avoidance, &is_moved);
}

/// Smooths what was added to the guide of those who were moved.
pub(super) fn smooth(paths: &mut Paths, guide: &Paths, avoidance: &Avoidance, is_moved: &[bool]) {
    let Avoidance { obstacles: outlines, minimum_distance: distance, is_clamped, .. } = avoidance;
    let kernel = Kernel::new(paths.knot_count(), smoothing_time(guide, outlines, *distance), *is_clamped);
    for agent in (0..paths.agent_count()).filter(|agent| is_moved[*agent]) {
        for axis in 0..2 {
            let old = guide.path(axis, agent);
            let new = paths.path_mut(axis, agent);
            new.iter_mut().zip(old).for_each(|(new, old)| *new -= old);
            kernel.smooth(new);
            new.iter_mut().zip(old).for_each(|(new, old)| *new += old);
        }
    }
}

/// Knots: longer about large obstacles, short enough for the smallest.
fn smoothing_time(guide: &Paths, outlines: &[Outline], distance: f64) -> f64 {
    let knot_count = guide.knot_count();
    let step = |agent: usize, knot: usize| at(guide, agent, knot).distance(at(guide, agent, knot - 1));
    let way = |agent: usize| (1..knot_count).map(|knot| step(agent, knot)).sum::<f64>();
    let longest = (0..guide.agent_count()).map(way).fold(0.0, f64::max);
    let radius = outlines.iter().map(|outline| extent(&grown(outline, distance))).fold(f64::INFINITY, f64::min);
    let wanted = SMOOTHING_RADII * radius / longest * (knot_count - 1) as f64;
    wanted.clamp(SMOOTHING, (LONGEST_SMOOTHING * knot_count as f64).max(SMOOTHING))
}

/// One obstacle, for those who have a way; whether anybody of them was blocked.
fn around(paths: &mut Paths, outline: &Outline, avoidance: &Avoidance, free: &[usize], parting: Parting, is_moved: &mut [bool]) -> bool {
    let distance = avoidance.minimum_distance;
    let group_of = |agent: usize| if parting == Parting::Groups { NO_GROUP } else { avoidance.group_of(agent) };
    let columns = columns(paths, (outline, distance), free, group_of, parting != Parting::Nothing);
    let is_in_column = |agent: usize| columns.iter().any(|column| is_among(&column.members, agent));
    let near = distance * (1.0 + MARGIN);
    for Column { heading, side, members } in &columns {
        // Also those who would pass free, where the others are pushed out to.
        let is_beside = |agent: usize| heading_of(paths, agent).dot(*heading) > SAME_HEADING && !is_in_column(agent);
        let everybody: Vec<usize> = free.iter().copied().filter(|agent| is_among(members, *agent) || is_beside(*agent)).collect();
        let offsets = |agents: &[usize]| agents.iter().map(|agent| offset(paths, *agent, outline, *side)).collect::<Vec<_>>();
        let own = offsets(members);
        let [innermost, outermost] = [f64::min, f64::max].map(|of| own.iter().copied().reduce(of).unwrap_or(0.0));
        let lanes: Vec<f64> = offsets(&everybody).into_iter().map(|offset| offset - innermost).collect();
        // A group sets out as one, early enough for all of it.
        let run_up = RUN_UP * extent(&grown(outline, near + outermost - innermost));
        for (&agent, lane) in everybody.iter().zip(lanes).filter(|(_, lane)| *lane >= 0.0) {
            let run_up = (is_among(members, agent) && group_of(agent) != NO_GROUP).then_some(run_up);
            is_moved[agent] |= lead(paths, agent, outline, [distance, near + lane], run_up, heading.perp().dot(*side) > 0.0);
        }
    }
    !columns.is_empty()
}

/// Those who pass an obstacle on one side.
struct Column {
    heading: DVec2,
    /// A unit vector across the heading.
    side: DVec2,
    /// In order.
    members: Vec<usize>,
}

/// Who is blocked, and the groups of those, by side.
fn columns(
    paths: &Paths,
    (outline, distance): (&Outline, f64),
    free: &[usize],
    group_of: impl Fn(usize) -> u32,
    may_split: bool,
) -> Vec<Column> {
    let mut columns = Vec::<Column>::new();
    let mut left: Vec<usize> = free.iter().copied().filter(|agent| is_blocked(paths, *agent, outline, distance)).collect();
    while let Some(&leader) = left.first() {
        let group = group_of(leader);
        let mates = if group == NO_GROUP { &left } else { free };
        let mates: Vec<usize> = mates.iter().copied().filter(|agent| group_of(*agent) == group).collect();
        let heading = if group == NO_GROUP { heading(paths, leader) } else { common_heading(paths, &mates, leader) };
        let is_alike = |agent: usize| heading_of(paths, agent).dot(heading) > SAME_HEADING;
        let party: Vec<usize> = mates.into_iter().filter(|agent| *agent == leader || is_alike(*agent)).collect();
        left.retain(|agent| !is_among(&party, *agent));
        let right = -heading.perp();
        let parts = if group == NO_GROUP && may_split {
            let everybody: Vec<usize> = free.iter().copied().filter(|agent| is_among(&party, *agent) || is_alike(*agent)).collect();
            split(paths, (outline, distance), &party, &everybody, right)
        } else {
            None
        };
        for (side, members) in parts.unwrap_or_else(|| vec![(better_side(paths, outline, &party, right), party)]) {
            // Who goes the same way on the same side goes in the same lanes.
            let is_same = |column: &&mut Column| column.heading.dot(heading) > SAME_HEADING && column.side.dot(side) > 0.0;
            match columns.iter_mut().find(is_same) {
                Some(column) => {
                    let is_either = |agent: &usize| is_among(&column.members, *agent) || is_among(&members, *agent);
                    column.members = free.iter().copied().filter(is_either).collect();
                }
                None => columns.push(Column { heading, side, members }),
            }
        }
    }
    columns
}

/// Whether an agent is among some of them, in order.
fn is_among(agents: &[usize], agent: usize) -> bool {
    agents.binary_search(&agent).is_ok()
}

/// Of a group as a whole; that of its leader, should it be another.
fn common_heading(paths: &Paths, group: &[usize], leader: usize) -> DVec2 {
    let last = paths.knot_count() - 1;
    let common = group.iter().map(|agent| at(paths, *agent, last) - at(paths, *agent, 0)).sum::<DVec2>().normalize_or_zero();
    let own = heading(paths, leader);
    if own.dot(common) > SAME_HEADING { common } else { own }
}

/// Whether an agent comes nearer to an outline than the distance.
pub(super) fn is_blocked(paths: &Paths, agent: usize, outline: &Outline, distance: f64) -> bool {
    span(paths, agent, outline, distance).is_some()
}

/// From start to end; none for who returns.
fn heading_of(paths: &Paths, agent: usize) -> DVec2 {
    (at(paths, agent, paths.knot_count() - 1) - at(paths, agent, 0)).normalize_or_zero()
}

fn heading(paths: &Paths, agent: usize) -> DVec2 {
    let heading = heading_of(paths, agent);
    if heading == DVec2::ZERO { DVec2::X } else { heading }
}

/// Who of a group passes on which side, where others who head the same way pass free and near by on both: whoever is beyond its middle.
fn split(
    paths: &Paths,
    (outline, distance): (&Outline, f64),
    group: &[usize],
    everybody: &[usize],
    right: DVec2,
) -> Option<Vec<(DVec2, Vec<usize>)>> {
    let across = || outline.points.iter().map(|p| DVec2::from_array(*p).dot(right));
    let [low, high] = [across().fold(f64::INFINITY, f64::min), across().fold(f64::NEG_INFINITY, f64::max)];
    let middle = 0.5 * (low + high);
    let near_by = high - low + 2.0 * outline.radius + NEAR_BY * distance;
    let is_free = |side: f64| {
        let is_there = |agent: &usize| {
            let out = side * (offset(paths, *agent, outline, right) - middle);
            !group.contains(agent) && (0.0..near_by).contains(&out)
        };
        everybody.iter().any(is_there)
    };
    if !is_free(1.0) || !is_free(-1.0) {
        return None;
    }
    let (on_right, on_left): (Vec<usize>, Vec<usize>) =
        group.iter().partition(|agent| offset(paths, **agent, outline, right) >= middle - SAME_LANE);
    Some([(right, on_right), (-right, on_left)].into_iter().filter(|(_, group)| !group.is_empty()).collect())
}

/// A unit vector to the side on which the innermost has the shorter detour; of equals the right.
fn better_side(paths: &Paths, outline: &Outline, group: &[usize], right: DVec2) -> DVec2 {
    let detour = |side: DVec2| {
        let edge = outline.points.iter().map(|p| DVec2::from_array(*p).dot(side)).fold(f64::NEG_INFINITY, f64::max);
        edge - group.iter().map(|agent| offset(paths, *agent, outline, side)).fold(f64::INFINITY, f64::min)
    };
    if detour(right) <= detour(-right) + SAME_LANE { right } else { -right }
}

/// How far to a side an agent is where it is nearest to the obstacle.
fn offset(paths: &Paths, agent: usize, outline: &Outline, side: DVec2) -> f64 {
    at(paths, agent, nearest(paths, agent, outline)).dot(side)
}

/// The knot at which an agent is nearest to the obstacle.
fn nearest(paths: &Paths, agent: usize, outline: &Outline) -> usize {
    let round = Round::about(outline);
    let mut nearest = (f64::INFINITY, 0);
    for knot in 0..paths.knot_count() {
        let place = at(paths, agent, knot);
        if round.reaches(place.x, place.y, nearest.0) {
            let here = outline.clearance(place.to_array()).0;
            if here < nearest.0 {
                nearest = (here, knot);
            }
        }
    }
    nearest.1
}

/// The first and the last knot about which an agent is nearer than `reach`.
fn span(paths: &Paths, agent: usize, outline: &Outline, reach: f64) -> Option<(usize, usize)> {
    let round = Round::about(outline);
    let is_near = |knot: usize| {
        let [from, to] = [knot, knot + 1].map(|knot| at(paths, agent, knot));
        round.reaches(from.x, from.y, reach + from.distance(to)) && outline.least_clearance(from.to_array(), to.to_array()).0 < reach
    };
    let mut near = (0..paths.knot_count() - 1).filter(|knot| is_near(*knot));
    let first = near.next()?;
    Some((first, near.next_back().unwrap_or(first) + 1))
}

/// Leads one agent around at `reach` from the outline, no nearer than `least` out of a notch; whether there was need and a way. With a
/// run-up of its own also where it would pass free on the other side.
fn lead(paths: &mut Paths, agent: usize, outline: &Outline, [least, reach]: [f64; 2], own: Option<f64>, is_left: bool) -> bool {
    let blocked = span(paths, agent, outline, reach);
    let beside = || own.map(|_| [nearest(paths, agent, outline); 2].into());
    let Some((first, last)) = blocked.or_else(beside) else { return false };
    let knot_count = paths.knot_count();
    let places: Vec<DVec2> = (0..knot_count).map(|knot| at(paths, agent, knot)).collect();
    let grown = grown(outline, reach);
    let run_up = own.unwrap_or_else(|| RUN_UP * extent(&grown));
    let leave = (0..first).rev().find(|knot| places[*knot].distance(places[first]) >= run_up).unwrap_or(0);
    let meet = (last..knot_count).find(|knot| places[*knot].distance(places[last]) >= run_up).unwrap_or(knot_count - 1);
    let out = |knot: usize| way_out(&grown, outline, places[knot], least - ROUND_OFF);
    let (Some(start), Some(end)) = (out(leave), out(meet)) else { return false };
    let Some(chain) = chain(&grown, start, end, is_left) else { return false };
    if blocked.is_none() && chain.len() == 2 {
        return false;
    }
    let way = [&places[..=leave], &chain, &places[meet..]].concat();
    let moved = walked(&places, &way);
    for (knot, place) in moved.into_iter().enumerate().take(knot_count - 1).skip(1) {
        paths.path_mut(0, agent)[knot] = place.x;
        paths.path_mut(1, agent)[knot] = place.y;
    }
    true
}

/// Where one is on a new way, a knot each, who has covered as much of it as of the old one. Who stands still stays there, and so does who
/// only has to be back where they were.
pub(super) fn walked(old: &[DVec2], way: &[DVec2]) -> Vec<DVec2> {
    let lengths = |points: &[DVec2]| {
        let mut sum = 0.0;
        let mut lengths = vec![0.0];
        lengths.extend(points.windows(2).map(|pair| {
            sum += pair[0].distance(pair[1]);
            sum
        }));
        lengths
    };
    let (old, new) = (lengths(old), lengths(way));
    let [whole, whole_new] = [old[old.len() - 1], new[new.len() - 1]];
    if whole == 0.0 || way.len() == 1 {
        return vec![way[0]; old.len()];
    }
    let mut piece = 0;
    let place = |covered: &f64| {
        let target = covered / whole * whole_new;
        while piece + 2 < new.len() && new[piece + 1] < target {
            piece += 1;
        }
        let length = new[piece + 1] - new[piece];
        let t = if length > 0.0 { ((target - new[piece]) / length).clamp(0.0, 1.0) } else { 0.0 };
        way[piece].lerp(way[piece + 1], t)
    };
    old.iter().map(place).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_longer_way_is_walked_in_the_same_time() {
        let old = [0.0, 1.0, 3.0, 4.0].map(|x| DVec2::new(x, 0.0));
        let way = [DVec2::ZERO, DVec2::new(0.0, 4.0), DVec2::new(4.0, 4.0)];
        assert_eq!(walked(&old, &way), [way[0], DVec2::new(0.0, 2.0), DVec2::new(2.0, 4.0), way[2]]);
    }

    #[test]
    fn who_stands_or_returns_stays() {
        let [here, there] = [DVec2::ONE, DVec2::new(5.0, 1.0)];
        assert_eq!(walked(&[here; 3], &[here, there, here]), [here; 3]);
        assert_eq!(walked(&[here, there, here], &[here]), [here; 3]);
    }
}
