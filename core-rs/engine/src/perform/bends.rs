//! How what keyframes ask for beside a motion comes and goes between them.

use glam::DVec3;

/// What is asked for within so many meters of what is there already asks for nothing: nobody drags so little.
pub(super) const UNSEEN: f64 = 1e-4;

/// Sets of so many keyframes are tried in less than a millisecond an agent.
const MOST_CHOSEN_AMONG: usize = 10;

/// What is added to a motion at an instant: meters, and meters a second.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Bend {
    pub(super) aside: DVec3,
    pub(super) velocity: DVec3,
}

/// The bends at rising `times` of one agent that is to be `asides` from the motion there, and nowhere else at the first and the last.
///
/// Where others lead through what one asks for, its velocity is theirs: a keyframe that is inserted changes no bend.
pub(super) fn bends(times: &[f64], asides: &[DVec3]) -> Vec<Bend> {
    let knots = needed(times, asides);
    let curve = Curve { times, asides, knots: &knots };
    times.iter().zip(asides).map(|(time, aside)| Bend { aside: *aside, velocity: curve.at(*time).velocity }).collect()
}

/// A share `u` of the way from one bend to another that is `seconds` later.
pub(super) fn between([from, to]: [Bend; 2], u: f64, seconds: f64) -> Bend {
    let v = 1.0 - u;
    let way = to.aside - from.aside;
    Bend {
        aside: from.aside + way * (u * u * (3.0 - 2.0 * u)) + (from.velocity * v - to.velocity * u) * (u * v * seconds),
        velocity: way * (6.0 * u * v / seconds) + from.velocity * (v * (1.0 - 3.0 * u)) + to.velocity * (u * (1.0 - 3.0 * v)),
    }
}

/// The fewest times whose curve leads through what is asked for at all of them; all, where these are many.
fn needed(times: &[f64], asides: &[DVec3]) -> Vec<usize> {
    let (last, inner) = (times.len() - 1, times.len() - 2);
    let chosen = |set: u32| -> Vec<usize> { (0..=last).filter(|k| *k == 0 || *k == last || set >> (k - 1) & 1 == 1).collect() };
    if inner > MOST_CHOSEN_AMONG {
        return (0..=last).collect();
    }
    let sets = (0..=inner as u32).flat_map(|size| (0..1 << inner).filter(move |set: &u32| set.count_ones() == size));
    let leads = |knots: &Vec<usize>| Curve { times, asides, knots }.leads();
    sets.map(chosen).find(leads).expect("all of them lead through all")
}

/// A curve through what is asked for at some of the times, at rest at the first and the last.
struct Curve<'a> {
    times: &'a [f64],
    asides: &'a [DVec3],
    knots: &'a [usize],
}

impl Curve<'_> {
    fn at(&self, time: f64) -> Bend {
        let next = self.knots.partition_point(|knot| self.times[*knot] <= time).clamp(1, self.knots.len() - 1);
        let seconds = self.seconds(next - 1);
        between([self.knot(next - 1), self.knot(next)], (time - self.times[self.knots[next - 1]]) / seconds, seconds)
    }

    /// Whether nobody could tell it from one that leads through everything that is asked for.
    fn leads(&self) -> bool {
        (0..self.times.len()).all(|k| self.asides[k].distance(self.at(self.times[k]).aside) <= UNSEEN)
    }

    fn knot(&self, place: usize) -> Bend {
        let is_within = place > 0 && place + 1 < self.knots.len();
        let velocity = if is_within { meeting(self.slope(place - 1), self.slope(place)) } else { DVec3::ZERO };
        Bend { aside: self.asides[self.knots[place]], velocity }
    }

    fn slope(&self, place: usize) -> DVec3 {
        (self.asides[self.knots[place + 1]] - self.asides[self.knots[place]]) / self.seconds(place)
    }

    fn seconds(&self, place: usize) -> f64 {
        self.times[self.knots[place + 1]] - self.times[self.knots[place]]
    }
}

/// The velocity between a bend that changes by `before` and one that changes by `after`, meters a second: theirs where they are the
/// same, nothing where it turns back, and never so much that it swings beyond what is asked for.
fn meeting(before: DVec3, after: DVec3) -> DVec3 {
    let squares = before.length_squared() + after.length_squared();
    if squares > 0.0 { (before + after) * (before.dot(after).max(0.0) / squares) } else { DVec3::ZERO }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn along(times: &[f64], asides: &[DVec3], time: f64) -> DVec3 {
        let known = bends(times, asides);
        let next = times.partition_point(|known| *known <= time).clamp(1, times.len() - 1);
        let seconds = times[next] - times[next - 1];
        between([known[next - 1], known[next]], (time - times[next - 1]) / seconds, seconds).aside
    }

    #[test]
    fn a_knot_on_the_curve_changes_no_curve() {
        let times = [0.0, 0.7, 1.0, 3.0, 3.5, 6.0];
        let asides = [0.0, 1.0, 3.0, 2.5, -2.0, 0.0].map(|x| DVec3::new(x, 0.5 * x, -x));
        for count in 1..5 {
            let (mut times, mut asides) = (times[..=count].to_vec(), asides[..=count].to_vec());
            times.push(6.0);
            asides.push(DVec3::ZERO);
            let before: Vec<DVec3> = (0..=60).map(|k| along(&times, &asides, 0.1 * f64::from(k))).collect();
            for time in [0.35, 2.0, 2.1, 4.9, 5.0] {
                let aside = along(&times, &asides, time);
                let place = times.partition_point(|known| *known < time);
                times.insert(place, time);
                asides.insert(place, aside);
            }
            let after = (0..=60).map(|k| along(&times, &asides, 0.1 * f64::from(k)));
            let apart = before.iter().zip(after).map(|(before, after)| before.distance(after)).fold(0.0, f64::max);
            assert!(apart < 1e-12, "{count} that ask for something: {apart}");
        }
    }

    #[test]
    fn what_is_asked_for_is_reached_and_what_cannot_be_seen_bends_nothing_else() {
        let times = [0.0, 1.0, 2.0, 3.0];
        let asides = [DVec3::ZERO, DVec3::X, DVec3::new(0.5 + 0.5 * UNSEEN, 0.0, 0.0), DVec3::ZERO];
        let found = bends(&times, &asides);
        assert_eq!(found.iter().map(|bend| bend.aside).collect::<Vec<_>>(), asides);
        // Halfway back to nothing a bend is at its fastest: one and a half times as fast as on average.
        assert!((found[2].velocity.x + 0.75).abs() < 1e-12, "{found:?}");
    }
}
