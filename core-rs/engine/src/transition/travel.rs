//! Formations that travel along drawn paths while they change, and turn with the paths' headings.
//!
//! Every method works in the frame of the formation: there each keyframe stands turned back by what the paths have turned since the
//! segment's source, and nobody knows of a path. Then the whole is led along the path and turned with it. So a formation that is drawn
//! at the end as the path would have turned it goes as one body, and what it is drawn beyond that is the method's to do.
//!
//! Where segments meet without a stop the barycenter and the turn have one velocity as everything else has: the paths' own on both
//! sides, weighted as places are (Catmull-Rom for uneven times). A straight path is no path.

use std::sync::Arc;

use glam::{DVec2, DVec3};

use super::Transition;
use super::chain::{Chain, End};
use super::course::Course;
use crate::formation::Formation;
use crate::spectral::cubic_weights;
use crate::trig::direction;

/// A segment of a chain that follows a path, or passes a keyframe beside one that does.
#[derive(Clone, Debug)]
pub struct Travel {
    /// The chain in the frame of the segment's formation.
    chart: Chain,
    /// As methods have it: straight, and past keyframes as places go.
    plain: Led,
    led: Led,
}

/// Where the point goes that a segment's formation moves about, and how the formation is turned.
#[derive(Clone, Debug)]
struct Led {
    course: Course,
    /// What the course's velocity lacks at both ends, a whole way a unit of time.
    lacks: [(DVec3, f64); 2],
}

/// A formation in a frame that is turned by an angle, radians: shared by all who ask for the same.
pub type Turned<'a> = &'a mut dyn FnMut(&Arc<Formation>, f64) -> Arc<Formation>;

impl Travel {
    /// The segment of a chain. `paths[pair]` has the points of the path from keyframe `pair` to the next, at least two of them apart;
    /// none where agents take the method's way. None when there is no path at all.
    pub fn of(chain: &Chain, paths: &[Option<&[DVec3]>], turned: Turned) -> Option<Self> {
        if paths.iter().all(Option::is_none) {
            return None;
        }
        let center = |end: usize| chain.formation(end).places().barycenter();
        let ends = |pair: usize| [center(pair), center(pair + 1)];
        let straight: Vec<Course> = (0..paths.len()).map(|pair| Course::straight(ends(pair))).collect();
        let course = |(pair, path): (usize, Option<&[DVec3]>)| {
            path.map_or_else(|| straight[pair].clone(), |points| Course::along(points, ends(pair)))
        };
        let courses: Vec<Course> = paths.iter().copied().enumerate().map(course).collect();
        let at = chain.at();
        let mut turns = vec![0.0; chain.ends().len()];
        for pair in at..courses.len() {
            turns[pair + 1] = turns[pair] + courses[pair].turn();
        }
        for pair in (0..at).rev() {
            turns[pair] = turns[pair + 1] - courses[pair].turn();
        }
        let seen = |(end, turn): (&End, f64)| {
            if turn == 0.0 { end.clone() } else { End { formation: turned(&end.formation, -turn), adjacency: end.adjacency.clone() } }
        };
        let chart = chain.with_ends(chain.ends().iter().zip(turns).map(seen).collect());
        Some(Self { chart, plain: Led::of(chain, &straight), led: Led::of(chain, &courses) })
    }

    /// The chain as methods see it.
    pub fn chart(&self) -> &Chain {
        &self.chart
    }

    /// What a method does in the chart, led along the path.
    pub fn led(&self, shape: Arc<dyn Transition>) -> Arc<dyn Transition> {
        Arc::new(Traveling { shape, plain: self.plain.clone(), led: self.led.clone() })
    }
}

/// What the segment's course lacks at its source (0) or target (1) to pass as its neighbors do.
fn lack(chain: &Chain, courses: &[Course], end: usize) -> (DVec3, f64) {
    let (at, keyframe) = (chain.at(), chain.at() + end);
    let [before, after] = chain.pace(keyframe);
    let duration = chain.duration(at);
    let (own_place, own_turn) = courses[at].rate(end);
    let (mut place, mut turn) = (-own_place, -own_turn);
    let mut add = |pace: f64, (by_place, by_turn): (DVec3, f64)| {
        place += duration * pace * by_place;
        turn += duration * pace * by_turn;
    };
    if before != 0.0 {
        add(before, courses[keyframe - 1].rate(1));
    }
    if after != 0.0 {
        add(after, courses[keyframe].rate(0));
    }
    (place, turn)
}

impl Led {
    /// By the courses from each keyframe of a chain to the next.
    fn of(chain: &Chain, courses: &[Course]) -> Self {
        let lacks = if chain.is_alone() { [(DVec3::ZERO, 0.0); 2] } else { [0, 1].map(|end| lack(chain, courses, end)) };
        Self { course: courses[chain.at()].clone(), lacks }
    }

    /// The point's place and the formation's turn.
    fn at(&self, t: f64) -> (DVec3, f64) {
        let [_, leaving, _, arriving] = cubic_weights(t);
        let (place, turn) = self.course.at(t);
        let [first, last] = self.lacks;
        (place + leaving * first.0 + arriving * last.0, turn + leaving * first.1 + arriving * last.1)
    }
}

/// A method's way in the chart, led along a path.
struct Traveling {
    shape: Arc<dyn Transition>,
    plain: Led,
    led: Led,
}

impl Transition for Traveling {
    fn agent_count(&self) -> usize {
        self.shape.agent_count()
    }

    fn matrix_count(&self) -> usize {
        self.shape.matrix_count()
    }

    fn evaluate_into(&self, ts: &[f64], plan: &mut [DVec2], mut heights: Option<&mut [f64]>) {
        self.shape.evaluate_into(ts, plan, heights.as_deref_mut());
        let agent_count = self.agent_count();
        for (k, t) in ts.iter().enumerate() {
            let frame = k * agent_count..(k + 1) * agent_count;
            let plan = &mut plan[frame.clone()];
            let heights = heights.as_deref_mut().map(|heights| &mut heights[frame]);
            let ((center, _), (place, turn)) = (self.plain.at(*t), self.led.at(*t));
            let turn = direction(turn);
            for spot in plan {
                *spot = place.truncate() + turn.rotate(*spot - center.truncate());
            }
            for height in heights.into_iter().flatten() {
                *height += place.z - center.z;
            }
        }
    }
}

/// The formation turned about its barycenter.
pub fn turned(formation: &Formation, angle: f64) -> Formation {
    let (center, turn) = (formation.barycenter(), direction(angle));
    let plan = formation.positions().iter().map(|spot| center + turn.rotate(*spot - center)).collect();
    match formation.heights() {
        Some(heights) => Formation::spatial(plan, heights.to_vec()),
        None => Formation::new(plan),
    }
}
