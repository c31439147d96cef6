//! How what keyframes ask for beside a motion comes and goes between them.

use glam::DVec3;

/// What is asked for within so many meters of what is there already asks for nothing: nobody drags so little.
pub(super) const UNSEEN: f64 = 1e-4;

/// What is added to a motion at an instant: meters, and meters a second.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Bend {
    pub(super) aside: DVec3,
    pub(super) velocity: DVec3,
}

/// The bends at rising `times` of one agent that is to be `asides` from the motion there, and nowhere else at the first and the last.
pub(super) fn bends(times: &[f64], asides: &[DVec3]) -> Vec<Bend> {
    let slope = |pair: usize| (asides[pair + 1] - asides[pair]) / (times[pair + 1] - times[pair]);
    let is_within = |k: usize| k > 0 && k + 1 < times.len();
    let velocity = |k: usize| if is_within(k) { meeting(slope(k - 1), slope(k)) } else { DVec3::ZERO };
    asides.iter().enumerate().map(|(k, aside)| Bend { aside: *aside, velocity: velocity(k) }).collect()
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

/// The velocity between a bend that changes by `before` and one that changes by `after`, meters a second: theirs where they are the
/// same, nothing where it turns back, and never so much that it swings beyond what is asked for.
fn meeting(before: DVec3, after: DVec3) -> DVec3 {
    let squares = before.length_squared() + after.length_squared();
    if squares > 0.0 { (before + after) * (before.dot(after).max(0.0) / squares) } else { DVec3::ZERO }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_bend_goes_even_where_it_may_and_never_beyond_what_is_asked_for() {
        let times = [0.0, 1.0, 3.0, 4.0, 6.0];
        let found = bends(&times, &[0.0, 1.0, 3.0, 3.0, 0.0].map(|x| DVec3::new(x, 0.0, -x)));
        let velocities: Vec<f64> = found.iter().map(|bend| bend.velocity.x).collect();
        assert_eq!(velocities, [0.0, 1.0, 0.0, 0.0, 0.0]);
        let at = |k: i32| {
            let time = 0.01 * f64::from(k);
            let next = times.partition_point(|known| *known <= time).clamp(1, 4);
            let seconds = times[next] - times[next - 1];
            between([found[next - 1], found[next]], (time - times[next - 1]) / seconds, seconds)
        };
        assert!((0..=600).all(|k| (0.0..=3.0 + 1e-12).contains(&at(k).aside.x)));
        // A difference over 2 hundredths of cubics that turn back within a second.
        assert!((1..600).all(|k| ((at(k + 1).aside.x - at(k - 1).aside.x) / 0.02 - at(k).velocity.x).abs() < 0.05));
    }
}
