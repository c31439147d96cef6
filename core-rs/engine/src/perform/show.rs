//! The whole show: what was performed, at any instant.

use std::sync::Arc;

use glam::DVec2;

use super::performed::Performed;
use crate::formation::{Formation, Places};
use crate::scene::Scene;

/// A scene with every segment performed.
pub struct Performance {
    scene: Scene,
    segments: Vec<Arc<Performed>>,
}

/// Where the show stands at an instant.
enum Moment {
    /// In keyframe k.
    Standing(usize),
    /// In segment k.
    Moving(usize),
}

impl Performance {
    pub(super) fn new(scene: Scene, segments: Vec<Arc<Performed>>) -> Self {
        Self { scene, segments }
    }

    /// What was performed.
    pub fn scene(&self) -> &Scene {
        &self.scene
    }

    /// One a segment, in order.
    pub fn segments(&self) -> &[Arc<Performed>] {
        &self.segments
    }

    /// The formation at `time` (scene seconds), from the method itself. Before the first keyframe the agents stand in it, after the
    /// last in that.
    pub fn formation_at(&self, time: f64) -> Formation {
        let keyframes = &self.scene.main_track().keyframes;
        match self.moment(time) {
            Moment::Standing(keyframe) => (*keyframes[keyframe].positions).clone(),
            Moment::Moving(segment) => {
                let agent_count = self.scene.main_track().agents.len();
                let mut plan = vec![DVec2::ZERO; agent_count];
                let mut heights = keyframes[segment].positions.heights().map(|_| vec![0.0; agent_count]);
                self.segments[segment].places_into(&[time], &mut plan, heights.as_deref_mut());
                match heights {
                    Some(heights) => Formation::spatial(plan, heights),
                    None => Formation::new(plan),
                }
            }
        }
    }

    /// Positions at `time` as seen from above; else as [`Self::formation_at`].
    pub fn positions_at(&self, time: f64) -> Vec<DVec2> {
        self.formation_at(time).positions().to_vec()
    }

    /// Who is not there at `time`, ascending.
    pub fn absent_at(&self, time: f64) -> Vec<u32> {
        let keyframes = &self.scene.main_track().keyframes;
        match self.moment(time) {
            Moment::Standing(keyframe) => keyframes[keyframe].absent.clone(),
            Moment::Moving(segment) => keyframes[segment].absent_too(&keyframes[segment + 1]),
        }
    }

    /// The time of every frame: f / frame rate up to the end of the last hold.
    pub fn frame_times(&self) -> impl Iterator<Item = f64> + use<> {
        let frame_rate = self.scene.frame_rate;
        (0..self.scene.frame_count()).map(move |frame| frame as f64 / frame_rate)
    }

    /// Visits every frame in order: its number, its time and where everybody is. Frames in motion were sampled when the segment
    /// was performed, so nothing is evaluated again.
    pub fn for_each_frame(&self, mut visit: impl FnMut(usize, f64, Places<'_>)) {
        let mut cursor = 0;
        let mut last_segment = usize::MAX;
        for (frame, time) in self.frame_times().enumerate() {
            match self.moment(time) {
                Moment::Standing(keyframe) => visit(frame, time, self.scene.main_track().keyframes[keyframe].positions.places()),
                Moment::Moving(segment) => {
                    if segment != last_segment {
                        (cursor, last_segment) = (0, segment);
                    }
                    let motion = &self.segments[segment].motion;
                    while motion.times()[cursor] < time - FRAME_SLACK {
                        cursor += 1;
                    }
                    visit(frame, time, motion.places(cursor));
                }
            }
        }
    }

    fn moment(&self, time: f64) -> Moment {
        let keyframes = &self.scene.main_track().keyframes;
        let reached = keyframes.partition_point(|keyframe| keyframe.time <= time);
        let Some(keyframe) = reached.checked_sub(1) else { return Moment::Standing(0) };
        let at = &keyframes[keyframe];
        let is_leaving = time > at.time + at.hold && reached < keyframes.len();
        if is_leaving { Moment::Moving(keyframe) } else { Moment::Standing(keyframe) }
    }
}

/// A sample nearer in time than this is the frame itself: sample times closer than that are merged, seconds.
const FRAME_SLACK: f64 = 1e-9;
