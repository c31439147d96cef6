//! What a first visit does not ask for: the page fetches the engine with it when something does.

use eigenform::adjacency::Adjacency;
use eigenform::assignment::{self, Question};
use eigenform::grouping::{self, AffinityJob, Metric, Preference, Way};
use eigenform::perform::{
    Compared, ComparedWay, Comparison, ComparisonJob, ComparisonStep, Performed, Performer, Salvage, SalvageJob, SalvageStep, Seats,
};
use eigenform::scene::recording::{Recording, read_recording};
use eigenform::scene::{self, Scene};
use eigenform::spectral::{Eigenbasis, ModeMatch};
use glam::DVec2;
use serde_json::json;
use wasm_bindgen::prelude::wasm_bindgen;

use super::desk::{Refusal, encode, told};
use super::{Engine, at_hand};

/// What it keeps from call to call.
#[derive(Default)]
pub struct Workshop {
    salvage: Option<SalvageJob>,
    salvaged: Option<Box<Salvage>>,
    recording: Option<Recording>,
    errand: Option<Errand>,
    /// Places that ways compared under one cost share.
    seats: Seats,
}

impl Workshop {
    pub fn stop(&mut self) {
        self.salvage = None;
    }
}

#[wasm_bindgen]
impl Engine {
    /// Any text a person brings: scene JSON, keyframe CSV or link. Answers JSON `{scene, source, notes}`.
    pub fn open_any(&self, text: &str) -> Result<String, Refusal> {
        any(text)
    }

    /// The scene at hand as keyframe CSV: JSON `{text, notes}`.
    pub fn write_keyframes(&self) -> String {
        keyframes(at_hand(self.scene.as_ref()))
    }

    /// A recording's text: motion CSV, or the text of `JuPedSim` and `PedPy`. Answers JSON `{frameRate, frameCount, agents, notes}`.
    pub fn open_recording(&mut self, text: &str) -> Result<String, Refusal> {
        let recording = recording(text)?;
        let head = head(&recording);
        self.workshop.recording = Some(recording);
        Ok(head)
    }

    /// Positions of the recording opened last: x, y an agent, frame by frame; not a number where an agent is absent.
    ///
    /// # Panics
    /// When none was opened: a bug of the page.
    pub fn recording_positions(&self) -> Vec<f32> {
        positions(self.workshop.recording.as_ref().expect("a recording is opened before it is read"))
    }

    /// The whole motion as `csv` or `json`.
    pub fn write_motion(&mut self, format: &str) -> Result<String, Refusal> {
        let performance = self.performer.perform(at_hand(self.scene.as_ref()))?;
        Ok(if format == "csv" { performance.to_csv() } else { performance.to_json() })
    }

    /// Works for a while on letting those who are stuck in a segment spread out; answers how far it is, 1 when what was found can be
    /// read.
    pub fn salvage(&mut self, segment: usize) -> Result<f64, Refusal> {
        let scene = at_hand(self.scene.as_ref());
        let mut job = self.workshop.salvage.take().unwrap_or_else(|| self.performer.salvage(scene, segment));
        match job.step(&mut self.performer)? {
            SalvageStep::Progress(progress) => {
                self.workshop.salvage = Some(job);
                Ok(progress.min(0.999))
            }
            SalvageStep::Done(found) => {
                self.workshop.salvaged = found;
                Ok(1.0)
            }
        }
    }

    /// What was found, JSON `{keyframes, part, report}`; null where there was nothing to mend.
    pub fn salvaged(&self) -> String {
        encode(&self.workshop.salvaged)
    }

    /// How the movement of the segment just done looks as a whole, JSON `[measures, curves]`: found anew at every call.
    pub fn segment_movement(&self) -> String {
        movement(self.done())
    }

    /// The eigenbasis of those who stand in a keyframe: all eigenvalues, ascending, then the first `most` modes beside the constant one,
    /// an entry each.
    pub fn modes(&mut self, keyframe: usize, most: usize) -> Result<Vec<f64>, Refusal> {
        let (basis, _) = self.performer.eigenbasis(at_hand(self.scene.as_ref()), keyframe)?;
        Ok(modes(&basis, most))
    }

    /// How alike the modes at both ends of a segment are: of the first `most` source modes a row of one number a target mode, then
    /// the target that each of them has under eigenvalue, greedy, max-min and hungarian order, an order at a time.
    pub fn mode_match(&mut self, segment: usize, most: usize) -> Result<Vec<f32>, Refusal> {
        Ok(mode_match(&self.performer.mode_match(at_hand(self.scene.as_ref()), segment)?, most))
    }

    /// Eigenvalues of the graph between both ends of a segment, all of them at t = 0, 1/steps, …, 1.
    pub fn eigenvalues_between(&mut self, segment: usize, steps: usize) -> Result<Vec<f64>, Refusal> {
        Ok(self.performer.eigenvalues_between(at_hand(self.scene.as_ref()), segment, steps)?.concat())
    }

    /// Groups of some agents by their ties at a keyframe, JSON: `bisect` so often, into so many `parts`, or `connected` by such ties.
    pub fn propose_groups(&mut self, keyframe: usize, agents: &[u32], way: &str, amount: f64) -> Result<String, Refusal> {
        let graph = self.graph(keyframe)?;
        Ok(groups(at_hand(self.scene.as_ref()), keyframe, &graph, agents, way_of(way, amount)))
    }

    /// Sets out to find who goes where between the ends of a segment, as `recipe` (JSON) says; takes the place of any other errand.
    /// `stays`: whoever takes the place of an absent agent stays where it is.
    pub fn begin_assignment(
        &mut self,
        segment: usize,
        recipe: &str,
        is_flipped: bool,
        is_predicted: bool,
        stays: bool,
    ) -> Result<(), Refusal> {
        self.workshop.errand = Some(assignment(at_hand(self.scene.as_ref()), segment, recipe, [is_flipped, is_predicted], stays)?);
        Ok(())
    }

    /// Sets out to find who keeps together from a keyframe to the next, at `times` the usual preference.
    pub fn begin_affinity(&mut self, keyframe: usize, agents: &[u32], metric: &str, times: f64) -> Result<(), Refusal> {
        self.workshop.errand = Some(affinity(at_hand(self.scene.as_ref()), keyframe, agents, metric, times)?);
        Ok(())
    }

    /// Sets out to move a segment one way, under the cost of a recipe (JSON), and at a pace where everybody arrives when they do.
    pub fn begin_comparison(&mut self, segment: usize, way: &str, recipe: &str, pace: Option<f64>) -> Result<(), Refusal> {
        let asked = comparison(way, recipe, pace)?;
        let job = ComparisonJob::new(at_hand(self.scene.as_ref()), segment, asked, &mut self.workshop.seats)?;
        self.workshop.errand = Some(Errand::Comparison(Box::new(job), None));
        Ok(())
    }

    /// Goes on with the errand for a while; answers how far it is, 1 when its result can be read.
    pub fn step_errand(&mut self) -> Result<f64, Refusal> {
        let Workshop { errand, seats, .. } = &mut self.workshop;
        errand.as_mut().map_or(Ok(1.0), |errand| errand.step(&mut self.performer, seats))
    }

    /// JSON, once: of an assignment `{slots, bends, ownBends}`, by agent its slot and where its way
    /// there and to the slot of its own number bends around obstacles; of affinity the groups; of a comparison its numbers and curves.
    ///
    /// # Panics
    /// When there is no errand: a bug of the page.
    pub fn errand_result(&mut self) -> String {
        self.workshop.errand.take().expect("an errand is done before it is read").result()
    }
}

fn any(text: &str) -> Result<String, Refusal> {
    Ok(told(&scene::open(text)?))
}

fn keyframes(scene: &Scene) -> String {
    let written = scene::write_csv(scene);
    encode(&json!({ "text": written.text, "notes": written.notes }))
}

fn recording(text: &str) -> Result<Recording, Refusal> {
    Ok(read_recording(text)?)
}

fn head(recording: &Recording) -> String {
    let Recording { frame_rate, frame_count, agents, notes, .. } = recording;
    encode(&json!({ "frameRate": frame_rate, "frameCount": frame_count, "agents": agents, "notes": notes }))
}

fn positions(recording: &Recording) -> Vec<f32> {
    let places = (0..recording.frame_count).flat_map(|frame| (0..recording.agents.len()).map(move |agent| (frame, agent)));
    places.flat_map(|(frame, agent)| recording.position(frame, agent).unwrap_or(DVec2::NAN).to_array()).map(|x| x as f32).collect()
}

fn movement(performed: &Performed) -> String {
    encode(&performed.movement())
}

fn modes(basis: &Eigenbasis, most: usize) -> Vec<f64> {
    let modes = basis.modes().col_iter().take(most).flat_map(|mode| mode.iter().copied());
    basis.eigenvalues().iter().copied().chain(modes).collect()
}

fn mode_match(matched: &ModeMatch, most: usize) -> Vec<f32> {
    let shown = matched.mode_count.min(most);
    let amounts = matched.amounts[..shown * matched.mode_count].iter().map(|amount| *amount as f32);
    let targets = matched.targets.iter().flat_map(|targets| targets[..shown].iter().map(|target| *target as f32));
    amounts.chain(targets).collect()
}

fn way_of(name: &str, amount: f64) -> Way {
    match name {
        "bisect" => Way::Bisect { levels: amount as u32 },
        "parts" => Way::Parts { count: amount as u32 },
        _ => Way::Connected { factor: amount },
    }
}

fn groups(scene: &Scene, keyframe: usize, graph: &Adjacency, agents: &[u32], way: Way) -> String {
    encode(&grouping::propose(&scene.main_track().keyframes[keyframe].positions, graph, agents, way))
}

/// Long work for one answer.
enum Errand {
    Assignment(assignment::Job),
    Affinity(AffinityJob),
    Comparison(Box<ComparisonJob>, Option<Box<Compared>>),
}

impl Errand {
    fn step(&mut self, performer: &mut Performer, seats: &mut Seats) -> Result<f64, Refusal> {
        Ok(match self {
            Self::Assignment(job) => job.step()?,
            Self::Affinity(job) => job.step(),
            Self::Comparison(job, compared) => match job.step(performer, seats)? {
                ComparisonStep::Progress(progress) => progress.min(0.999),
                ComparisonStep::Done(found) => {
                    *compared = Some(found);
                    1.0
                }
            },
        })
    }

    fn result(self) -> String {
        match self {
            Self::Assignment(job) => {
                let own: Vec<u32> = (0..job.slots().len() as u32).collect();
                let bends = |slots: &[u32]| job.bends_to(slots).iter().map(|way| places(way)).collect::<Vec<_>>();
                encode(&json!({ "slots": job.slots(), "bends": bends(job.slots()), "ownBends": bends(&own) }))
            }
            Self::Affinity(job) => encode(&job.groups()),
            Self::Comparison(_, compared) => encode(&compared),
        }
    }
}

fn places(way: &[DVec2]) -> Vec<[f64; 2]> {
    way.iter().map(DVec2::to_array).collect()
}

fn assignment(scene: &Scene, segment: usize, recipe: &str, [is_flipped, is_predicted]: [bool; 2], stays: bool) -> Result<Errand, Refusal> {
    let spec = &scene::document::read_assignment(recipe)?;
    let [source, target] = scene.way_at(segment)?;
    let sections = &scene::group_levels(&scene.groups, source.agent_count());
    let question = Question { source, target, spec, sections, is_flipped, is_predicted };
    let absent = scene.main_track().keyframes.get(segment + 1).map_or(&[][..], |target| &target.absent);
    let job = assignment::Job::around(&question, &scene.obstacle_shapes(), scene.minimum_distance)?;
    Ok(Errand::Assignment(job.sparing(if stays { absent } else { &[] })))
}

fn comparison(way: &str, recipe: &str, pace: Option<f64>) -> Result<Comparison, Refusal> {
    let way = ComparedWay::named(way).expect("the page knows the ways by their names");
    Ok(Comparison { way, cost: scene::document::read_assignment(recipe)?.cost, pace })
}

fn affinity(scene: &Scene, keyframe: usize, agents: &[u32], metric: &str, times: f64) -> Result<Errand, Refusal> {
    let metric = if metric == "manhattan" { Metric::Manhattan } else { Metric::Euclidean };
    let [source, target] = scene.way_at(keyframe)?;
    Ok(Errand::Affinity(AffinityJob::new(source, target, agents, metric, Preference::OfMedian(times))))
}
