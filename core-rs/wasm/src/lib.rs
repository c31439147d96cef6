//! The engine as the page calls it. Every function decodes, calls and encodes; nothing is decided here.
//!
//! A refusal is thrown as the JSON text `{code, what, where}`; anything else that is thrown is a trap, and the instance is dead.

mod desk;
#[cfg(feature = "workshop")]
mod workshop;

use std::sync::Arc;

use eigenform::adjacency::Adjacency;
use eigenform::formation::Formation;
use eigenform::motion::Motion;
use eigenform::perform::{Performed, Performer, SegmentJob, Step};
use eigenform::scene::Scene;
use wasm_bindgen::prelude::wasm_bindgen;

use desk::{Refusal, encode};

/// One engine: a scene at hand, formations by the page's numbers, caches, and a job a segment under work.
#[wasm_bindgen]
#[derive(Default)]
pub struct Engine {
    formations: Vec<(u32, Arc<Formation>)>,
    scene: Option<Scene>,
    rest: String,
    performer: Performer,
    jobs: Vec<(usize, SegmentJob)>,
    /// The segment worked on last.
    at: Option<usize>,
    done: Option<Arc<Performed>>,
    #[cfg(feature = "workshop")]
    workshop: workshop::Workshop,
}

#[wasm_bindgen]
impl Engine {
    /// An engine without a scene. Keeps the message of a panic for the page.
    #[wasm_bindgen(constructor)]
    pub fn new() -> Self {
        desk::keep_panic_messages();
        Self::default()
    }

    /// Scene JSON or a link: answers JSON `{scene, source, notes}`. Nothing for any other text, which is the workshop's.
    pub fn open(&self, text: &str) -> Result<Option<String>, Refusal> {
        desk::open(text)
    }

    /// Formation number `id`: x, y an agent and, in space, their heights; meters.
    pub fn put_formation(&mut self, id: u32, xy: &[f64], heights: Option<Vec<f64>>) {
        self.drop_formation(id);
        self.formations.push((id, Arc::new(desk::formation(xy, heights))));
    }

    /// Forgets a formation.
    pub fn drop_formation(&mut self, id: u32) {
        self.formations.retain(|(own, _)| *own != id);
    }

    /// The scene at hand: its text without positions (absent: the text before), and its keyframes' formations.
    pub fn set_scene(&mut self, rest: Option<String>, formations: &[u32]) -> Result<(), Refusal> {
        if let Some(rest) = rest {
            self.rest = rest;
        }
        let of = |id: &u32| self.formations.iter().find(|(own, _)| own == id).map(|(_, formation)| formation.clone());
        let formations = formations.iter().map(|id| of(id).unwrap_or_default()).collect();
        self.scene = Some(self.performer.adopt(desk::scene(&self.rest, formations)?));
        self.stop();
        Ok(())
    }

    /// Works on a segment for a while, whatever else is under work; answers how far it is, 1 when it is done and all of it can be read.
    /// `held`: JSON list, by segment, of what to use although it says auto, or null. `counterpart`: the name of what moves it in place of
    /// what the scene says.
    #[expect(clippy::needless_pass_by_value, reason = "wasm-bindgen lends no texts that may be absent")]
    pub fn step(&mut self, segment: usize, held: Option<String>, counterpart: Option<String>) -> Result<f64, Refusal> {
        let scene = at_hand(self.scene.as_ref());
        self.at = Some(segment);
        let mut job = match self.jobs.iter().position(|(index, _)| *index == segment) {
            Some(at) => self.jobs.swap_remove(at).1,
            None => desk::begin(&mut self.performer, scene, segment, held.as_deref(), counterpart.as_deref()),
        };
        match job.step(&mut self.performer)? {
            Step::Progress(progress) => {
                self.jobs.push((segment, job));
                Ok(progress.min(0.999))
            }
            Step::Done(performed) => {
                self.done = Some(performed);
                Ok(1.0)
            }
        }
    }

    /// Whether the motion of the segment worked on last is settled, so that times, positions and heights can be read, measured or not.
    pub fn is_moved(&self) -> bool {
        self.motion().is_some()
    }

    /// Drops the jobs under way.
    pub fn stop(&mut self) {
        self.jobs.clear();
        #[cfg(feature = "workshop")]
        self.workshop.stop();
    }

    /// Sample times of the segment just moved, scene seconds.
    pub fn segment_times(&self) -> Vec<f64> {
        self.moved().times().to_vec()
    }

    /// Positions of the segment just moved: x, y an agent, sample by sample.
    pub fn segment_positions(&self) -> Vec<f32> {
        self.moved().positions().iter().flat_map(|p| [p.x as f32, p.y as f32]).collect()
    }

    /// Heights of the segment just moved, one an agent, sample by sample; nothing on the plane.
    pub fn segment_heights(&self) -> Option<Vec<f32>> {
        self.moved().heights().map(|heights| heights.iter().map(|z| *z as f32).collect())
    }

    /// Where everybody is at an instant of the segment just done, scene seconds: x, y an agent, then in space their heights.
    pub fn segment_places(&self, time: f64) -> Vec<f64> {
        desk::places(self.done(), time)
    }

    /// Curves of the segment just done, one value a sample: clearance, distortion, turning, top speed, path length.
    pub fn segment_curves(&self) -> Vec<f32> {
        desk::curves(self.done())
    }

    /// Measures of the segment just done, JSON.
    pub fn segment_report(&self) -> String {
        encode(&self.done().report())
    }

    /// Ties of a keyframe: a, b a tie, a < b, ascending.
    pub fn tie_pairs(&mut self, keyframe: usize) -> Result<Vec<u32>, Refusal> {
        let graph = self.graph(keyframe)?;
        Ok(graph.ties().iter().flat_map(|tie| [tie.a, tie.b]).collect())
    }

    /// Their factors.
    pub fn tie_factors(&mut self, keyframe: usize) -> Result<Vec<f64>, Refusal> {
        let graph = self.graph(keyframe)?;
        Ok(graph.ties().iter().map(|tie| tie.factor).collect())
    }

    /// The scene at hand as a file.
    pub fn write_scene(&self) -> String {
        eigenform::scene::write_json(at_hand(self.scene.as_ref()))
    }

    /// The scene at hand as a link: JSON `{fragment, rounding, brokenKeyframes}`.
    pub fn link(&self, is_short: bool) -> String {
        desk::link(at_hand(self.scene.as_ref()), is_short)
    }

    /// The slot of each agent, least total squared distance; x, y an agent.
    pub fn assign(&self, source: &[f64], target: &[f64]) -> Vec<u32> {
        desk::assign(&desk::formation(source, None), &desk::formation(target, None))
    }
}

impl Engine {
    /// Of the segment worked on last: of its job, or of what the job came to.
    fn motion(&self) -> Option<&Motion> {
        match self.jobs.iter().find(|(segment, _)| self.at == Some(*segment)) {
            Some((_, job)) => job.motion(),
            None => self.done.as_ref().map(|done| &done.motion),
        }
    }

    fn moved(&self) -> &Motion {
        self.motion().expect("a segment is moved before it is read")
    }

    fn done(&self) -> &Performed {
        self.done.as_deref().expect("a segment is done before it is read")
    }

    fn graph(&mut self, keyframe: usize) -> Result<Arc<Adjacency>, Refusal> {
        Ok(self.performer.graph(at_hand(self.scene.as_ref()), keyframe)?)
    }
}

/// The client sends a scene before it asks about one.
fn at_hand(scene: Option<&Scene>) -> &Scene {
    scene.expect("a scene is set before it is asked about")
}
