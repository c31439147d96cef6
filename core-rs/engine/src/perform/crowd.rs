//! Leads a segment's agents along their guide by social forces, once it is known where the guide has them.

use super::brief::Brief;
use super::counterpart::Counterpart;
use super::innermost::innermost_groups;
use super::outcome::Crowded;
use crate::COMPARES;
use crate::edits::{Aim, CrowdJob, CrowdRules, CrowdStep, Ending, Feedback, Led, NO_GROUP};
use crate::measure::Extreme;
use crate::motion::Motion;

/// A crowd's guide keeps this far from obstacles at least, meters: the body of a person.
const LEAST_CLEARANCE: f64 = 0.25;

/// The walk along a guide.
pub(super) struct Crowding {
    job: CrowdJob,
    progress: f64,
}

impl Crowding {
    /// The walk; the guide back where nobody walks by forces.
    pub(super) fn of(brief: &Brief, guide: Motion) -> Result<Self, Motion> {
        if !brief.has_crowd() || guide.agent_count() == 0 {
            return Err(guide);
        }
        Ok(Self { job: CrowdJob::new(rules(brief, &guide), guide), progress: 0.0 })
    }

    /// Walks for some milliseconds; the motion and what came of it once it is done.
    pub(super) fn step(&mut self) -> Option<(Motion, Box<Crowded>)> {
        match self.job.step() {
            CrowdStep::Progress(progress) => {
                self.progress = progress;
                None
            }
            CrowdStep::Done(led) => {
                let Led { motion, deviation, distance, arrival_error, arrived_after } = *led;
                let extreme = |[mean, max]: [f64; 2]| Extreme { mean, max };
                let (guide_deviation, arrival_error) = (extreme(distance), extreme(arrival_error));
                Some((motion, Box::new(Crowded { guide_deviation, arrival_error, arrived_after, hurried: Vec::new(), deviation })))
            }
        }
    }

    /// 0–1; never falls.
    pub(super) fn progress(&self) -> f64 {
        self.progress
    }
}

fn rules(brief: &Brief, guide: &Motion) -> CrowdRules {
    let told = &brief.own.transition.crowd;
    let counterpart = brief.aside.counterpart.filter(|_| COMPARES);
    let (aim, ending) = match counterpart {
        None => (Aim::Guide, Ending::Exact),
        Some(Counterpart::GuidedForce) => (Aim::Guide, Ending::Smoothed(brief.minimum_distance)),
        Some(Counterpart::PlainForce) => (Aim::Target, Ending::AsItComes),
        #[cfg(feature = "comparison")]
        Some(Counterpart::Orca) => (Aim::Target, Ending::AsItComes),
    };
    let pace = brief.aside.pace;
    // Paper A has neither feedback nor subgroups in its forces.
    let is_crowd = counterpart.is_none();
    CrowdRules {
        constants: told.constants,
        feedback: Feedback { direction: is_crowd && told.direction_feedback, speed: is_crowd && told.speed_feedback },
        unit: guide.spacing(),
        radius: radii(brief, guide),
        top_speed: brief.agents.iter().map(|agent| agent.max_speed.unwrap_or(f64::INFINITY)).collect(),
        group: if is_crowd { innermost_groups(&brief.groups, guide.agent_count()) } else { vec![NO_GROUP; guide.agent_count()] },
        obstacles: brief.outlines(),
        // Both papers have forces alone keep agents off: what is compared with does, too.
        clearance: if is_crowd { brief.minimum_distance.max(LEAST_CLEARANCE) } else { 0.0 },
        seed: brief.seed,
        #[cfg(feature = "comparison")]
        is_reciprocal: brief.aside.counterpart == Some(Counterpart::Orca),
        aim,
        ending: if pace.is_some() { Ending::AsItComes } else { ending },
        waits: brief.aside.waits,
        pace,
    }
}

/// Body radii, meters.
fn radii(brief: &Brief, guide: &Motion) -> Vec<f64> {
    let bodies = brief.agents.iter().map(|agent| agent.radius);
    #[cfg(feature = "comparison")]
    if brief.aside.counterpart == Some(Counterpart::Orca) {
        // It keeps bodies from touching: what the scene wants apart is as large a body, but no larger than both keyframes have room for, less
        // a hundredth, so that standing side by side is no collision by round-off.
        let [source, target] = [0, guide.times().len() - 1].map(|end| guide.formation(end).nearest_distances());
        let room = source.into_iter().zip(target).map(|(from, to)| 0.99 * 0.5 * from.min(to));
        return bodies.zip(room).map(|(body, room)| body.max(0.5 * brief.minimum_distance).min(room)).collect();
    }
    #[cfg(not(feature = "comparison"))]
    let _ = guide;
    bodies.collect()
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use super::*;
    use crate::choice::MethodName;
    use crate::perform::{Aside, Performed, Performer, Step, perform};
    use crate::scene::{Scene, Segment, read_json};

    /// Two rows of four that change sides in 4 s, each a group, with one slow agent.
    fn show() -> Scene {
        let text = r#"{
            "format": "eigenform", "version": 1, "frameRate": 10, "minimumDistance": 0.4,
            "agents": [{}, {}, {}, {}, {}, {}, {}, { "maxSpeed": 0.5 }],
            "groups": [{ "members": [0, 1, 2, 3] }, { "children": [{ "members": [4, 5] }, { "members": [7] }], "members": [6] }],
            "keyframes": [
                { "positions": [[0, 0], [0, 1], [0, 2], [0, 3], [6.3, 0], [6.3, 1], [6.3, 2], [6.3, 3]] },
                { "time": 4, "positions": [[6.3, 0], [6.3, 1], [6.3, 2], [6.3, 3], [0, 0], [0, 1], [0, 2], [0, 3]] }
            ],
            "segments": [{ "method": "crowd", "avoidance": true }]
        }"#;
        read_json(text).expect("the show is valid")
    }

    fn compared(scene: &Scene, counterpart: Counterpart) -> Arc<Performed> {
        let mut performer = Performer::default();
        let mut job = performer.begin_compared(scene, 0, &[], Aside { counterpart: Some(counterpart), waits: true, pace: None });
        loop {
            if let Step::Done(performed) = job.step(&mut performer).expect("the show can be performed") {
                return performed;
            }
        }
    }

    #[test]
    fn a_crowd_is_at_its_keyframes_and_keeps_apart_between() {
        let scene = show();
        let performance = perform(&scene).expect("the show can be performed");
        let performed = &performance.segments()[0];
        assert_eq!(performed.choice.method, MethodName::Crowd);
        assert!(performed.avoided.as_ref().is_some_and(|avoided| avoided.unsolved.is_empty()));
        assert!(performed.crowded.as_ref().is_some_and(|crowded| crowded.guide_deviation.max > 0.05));
        for keyframe in &scene.main_track().keyframes {
            let at = performance.positions_at(keyframe.time);
            // An answer is the guide and what was added to it: a sum of numbers below 10.
            assert!(at.iter().zip(keyframe.positions.positions()).all(|(found, due)| found.distance(*due) < 1e-12));
        }
        performance.for_each_frame(|_, time, places| {
            let exact = performance.positions_at(time);
            assert!(places.plan().iter().zip(&exact).all(|(sample, exact)| sample.distance(*exact) < 1e-9), "at {time}");
        });
    }

    #[test]
    fn who_is_too_slow_arrives_is_named_and_has_time_enough_in_the_duration_told() {
        let mut scene = show();
        let hurried = |scene: &Scene| perform(scene).expect("it can").segments()[0].crowded.as_ref().expect("forces led").hurried.clone();
        let [slow] = hurried(&scene)[..] else { panic!("one is limited: {:?}", hurried(&scene)) };
        let motion = perform(&scene).expect("it can").segments()[0].motion.clone();
        let step = |k: usize| motion.sample(k)[7].distance(motion.sample(k - 1)[7]) / (motion.times()[k] - motion.times()[k - 1]);
        let fastest = (1..motion.times().len()).map(step).fold(0.0, f64::max);
        assert!((slow.agent, slow.max_speed) == (7, 0.5) && (slow.speed - fastest).abs() < 1e-12 * fastest, "{slow:?}");
        // It goes 6.3 m in 4 s, so no slower than that all the time; and all of it, slower, takes as much longer, in whole tenths.
        assert!(slow.speed >= 6.3 / 4.0 && (0.0..0.1).contains(&(slow.duration - 4.0 * slow.speed / 0.5)), "{slow:?}");
        scene.tracks[0].keyframes[1].time = slow.duration;
        assert_eq!(hurried(&scene), []);
        scene.tracks[0].keyframes[1].time = 4.0;
        Arc::make_mut(&mut scene.tracks[0].agents)[7].max_speed = None;
        assert_eq!(hurried(&scene), []);
    }

    #[test]
    fn counterparts_are_judged_as_the_scene_would_be_and_are_kept_apart_in_the_cache() {
        let scene = show();
        let guided = compared(&scene, Counterpart::GuidedForce);
        let plain = compared(&scene, Counterpart::PlainForce);
        let last = guided.motion.times().len() - 1;
        let targets = scene.main_track().keyframes[1].positions.positions();
        assert!(guided.motion.sample(last).iter().zip(targets).all(|(at, due)| at.distance(*due) < 1e-12));
        for performed in [&guided, &plain] {
            let (avoided, clearance) =
                (performed.avoided.as_ref().expect("it is judged"), performed.measures.clearance.expect("there are many"));
            assert_eq!(avoided.unsolved.is_empty(), clearance.distance >= 0.4 - 1e-6);
        }
        let stranded = plain.motion.sample(last).iter().zip(targets).map(|(at, due)| at.distance(*due)).fold(0.0, f64::max);
        assert!((stranded - plain.crowded.as_ref().expect("forces led").arrival_error.max).abs() < 1e-9);
    }

    #[test]
    fn a_neighbor_passes_a_crowd_with_its_guides_velocity() {
        let mut scene = show();
        let track = &mut scene.tracks[0];
        let mut third = track.keyframes[0].clone();
        third.time = 8.0;
        track.keyframes.push(third);
        track.segments.push(Segment::default());
        scene.join = crate::choice::Join::Smooth;
        let performance = perform(&scene).expect("the show can be performed");
        let velocity = |from: f64, to: f64| {
            let (from, to) = (performance.positions_at(4.0 + from), performance.positions_at(4.0 + to));
            from.iter().zip(&to).map(|(from, to)| (*to - *from) / 1e-5).collect::<Vec<_>>()
        };
        // Difference quotients over 1e-5 s of accelerations below 100 m/s².
        let (before, after) = (velocity(-1e-5, 0.0), velocity(0.0, 1e-5));
        assert!(before.iter().zip(&after).all(|(before, after)| before.distance(*after) < 2e-3), "{before:?} {after:?}");
    }
}
