//! Letting those who are stuck in a segment spread out, on request: keyframes between its two that keep everybody apart.
//!
//! The guide is bent and pushed apart, and the motion that comes of it is told in as few keyframes as hold it. They are tried in the
//! scene itself and offered only when everybody keeps the distance there, so that what is accepted is what was seen. Never by itself:
//! the motion may go far from what was asked for.

mod keeping;
mod report;

use std::sync::Arc;

use serde::Serialize;

use super::Performer;
use super::avoid;
use super::brief::Brief;
use super::cast::Cast;
use super::job::{SegmentJob, Step};
use super::performed::Performed;
use crate::choice::Join;
use crate::edits::{SpreadJob, SpreadStep};
use crate::error::Error;
use crate::scene::{Keyframe, Scene, Segment};
use crate::transition::Chain;

use keeping::Keeping;
pub use report::SalvageReport;

/// Where segments meet with one velocity, those so many beside one depend on its keyframes.
const REACH: usize = 2;

/// A bump needs two samples between the keyframes.
const FEWEST_SAMPLES: usize = 4;

/// How much of the progress is performing the scene as it is, and how much bending; the rest is trying keyframes.
const PERFORMING_SHARE: f64 = 0.1;
const SPREADING_SHARE: f64 = 0.5;

/// A segment mended by keyframes within it.
#[derive(Serialize)]
#[serde(rename_all = "camelCase")]
pub struct Salvage {
    /// Between the segment's two keyframes, in order; none where nothing keeps everybody apart.
    pub keyframes: Vec<Keyframe>,
    /// What each part of the segment then is.
    pub part: Segment,
    /// What it comes to.
    pub report: SalvageReport,
}

impl Salvage {
    /// The scene with segment `index` in parts, by way of the keyframes found.
    pub fn apply(&self, scene: &Scene, index: usize) -> Scene {
        in_parts(scene, index, &self.keyframes, &self.part)
    }
}

/// What a step came to.
pub enum SalvageStep {
    /// How far it is, 0–1.
    Progress(f64),
    /// What was found; none where there is nothing to mend, or a keyframe itself is to blame.
    Done(Option<Box<Salvage>>),
}

/// The work on one segment.
pub struct SalvageJob {
    scene: Scene,
    cast: Option<Arc<Cast>>,
    index: usize,
    stage: Stage,
}

enum Stage {
    /// The segment and those beside it, as they are.
    Performing(Vec<Arc<Performed>>, Option<SegmentJob>),
    Spreading(Vec<Arc<Performed>>, Box<SpreadJob>),
    Keeping(Box<Keeping>),
    Finished,
}

impl Performer {
    /// Starts to let those spread out who are stuck in segment `index`.
    pub fn salvage(&mut self, scene: &Scene, index: usize) -> SalvageJob {
        let (scene, cast) = self.casting.of(scene, index);
        SalvageJob { scene, cast, index, stage: Stage::Performing(Vec::new(), None) }
    }
}

impl SalvageJob {
    /// Works for a while: usually some milliseconds.
    ///
    /// # Panics
    /// After it was done: a bug of the caller.
    pub fn step(&mut self, performer: &mut Performer) -> Result<SalvageStep, Error> {
        match std::mem::replace(&mut self.stage, Stage::Finished) {
            Stage::Performing(known, job) => self.perform(known, job, performer),
            Stage::Spreading(known, mut job) => match job.step() {
                SpreadStep::Progress(progress) => {
                    self.stage = Stage::Spreading(known, job);
                    Ok(SalvageStep::Progress(PERFORMING_SHARE + SPREADING_SHARE * progress))
                }
                SpreadStep::Done(spread) => {
                    let own = self.index - first_beside(&self.scene, self.index);
                    self.stage = Stage::Keeping(Box::new(Keeping::new(&self.scene, self.index, own, known, spread)));
                    Ok(SalvageStep::Progress(PERFORMING_SHARE + SPREADING_SHARE))
                }
            },
            Stage::Keeping(mut keeping) => {
                if let Some(mut salvage) = keeping.step(performer)? {
                    if let Some(cast) = &self.cast {
                        let keyframes = &self.scene.main_track().keyframes[self.index..];
                        cast.fill_salvage(&mut salvage, [keyframes[0].time + keyframes[0].hold, keyframes[1].time]);
                    }
                    return Ok(SalvageStep::Done(Some(Box::new(salvage))));
                }
                let done = PERFORMING_SHARE + SPREADING_SHARE;
                let progress = SalvageStep::Progress(done + (1.0 - done) * keeping.progress());
                self.stage = Stage::Keeping(keeping);
                Ok(progress)
            }
            Stage::Finished => panic!("the job was done"),
        }
    }

    fn perform(
        &mut self,
        mut known: Vec<Arc<Performed>>,
        job: Option<SegmentJob>,
        performer: &mut Performer,
    ) -> Result<SalvageStep, Error> {
        let first = first_beside(&self.scene, self.index);
        let last = last_beside(&self.scene, self.index);
        let mut job = job.unwrap_or_else(|| performer.begin(&self.scene, first + known.len(), &[]));
        let job = match job.step(performer)? {
            Step::Progress(_) => Some(job),
            Step::Done(performed) => {
                known.push(performed);
                None
            }
        };
        let count = last + 1 - first;
        if known.len() < count {
            let progress = PERFORMING_SHARE * known.len() as f64 / count as f64;
            self.stage = Stage::Performing(known, job);
            return Ok(SalvageStep::Progress(progress));
        }
        let own = &known[self.index - first];
        let Some(avoided) = own.avoided.as_ref().filter(|avoided| avoided.breaches.is_empty() && own.open_count() > 0) else {
            return Ok(SalvageStep::Done(None));
        };
        if own.motion.times().len() < FEWEST_SAMPLES {
            return Ok(SalvageStep::Done(None));
        }
        let left: Vec<_> = avoided.unsolved.iter().map(avoid::approach).collect();
        let chain = Chain::between(performer.end(&self.scene, self.index)?, performer.end(&self.scene, self.index + 1)?);
        let guide = own.guide(own.motion.times().to_vec());
        let avoidance = avoid::avoidance(&Brief::of(&self.scene, self.index, &[]), &chain, &guide);
        let spread = SpreadJob::new(avoidance, guide, &left);
        self.stage = Stage::Spreading(known, Box::new(spread));
        Ok(SalvageStep::Progress(PERFORMING_SHARE))
    }
}

fn in_parts(scene: &Scene, index: usize, between: &[Keyframe], part: &Segment) -> Scene {
    let mut scene = scene.clone();
    let track = &mut scene.tracks[0];
    if !between.is_empty() {
        track.segments.splice(index..=index, vec![part.clone(); between.len() + 1]);
        track.keyframes.splice(index + 1..=index, between.iter().cloned());
    }
    scene
}

fn first_beside(scene: &Scene, index: usize) -> usize {
    index.saturating_sub(reach(scene))
}

fn last_beside(scene: &Scene, index: usize) -> usize {
    (index + reach(scene)).min(scene.main_track().segments.len() - 1)
}

fn reach(scene: &Scene) -> usize {
    let track = scene.main_track();
    // A keyframe within a transition that others lie in makes two of it.
    if track.keyframes.iter().any(|keyframe| keyframe.between > 0) {
        track.segments.len()
    } else if scene.join == Join::Separate {
        0
    } else {
        REACH
    }
}
