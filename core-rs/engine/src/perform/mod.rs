//! From a scene to its motion: scene → tracks → segments → motion → numbers.
//!
//! A [`Performer`] keeps what it made for as long as the parts of the scene it came from are the same objects, so that moving one
//! agent performs two segments anew and nothing else (four where segments meet with one velocity, six where they share bases too). Long work is a [`SegmentJob`] that is stepped.

mod auto;
mod avoid;
mod bends;
mod brief;
mod cast;
mod clock;
#[cfg(feature = "comparison")]
mod comparison;
mod counterpart;
mod crowd;
mod free;
mod graphs;
mod hurry;
mod innermost;
mod job;
mod levels;
mod modes;
mod outcome;
mod outline;
mod part;
mod performed;
mod plan;
mod resorts;
mod salvage;
mod sampling;
mod show;
mod text;
mod tied;
mod travel;
mod trial;
mod whole;

use std::sync::Arc;

use crate::adjacency::{Adjacency, AdjacencySpec};
use crate::choice::Choice;
use crate::error::Error;
use crate::recent::Recent;
use crate::scene::{Group, Obstacle, Scene};
use crate::transition::Planner;

#[cfg(feature = "comparison")]
pub use comparison::{Compared, ComparedWay, Comparison, ComparisonJob, ComparisonStep, Seats};
pub use counterpart::{Aside, Counterpart};
pub use hurry::Hurry;
pub use job::{SegmentJob, Step};
pub use outcome::{Avoided, Crowded, Suggestion};
pub use performed::{Candidate, Performed, Report};
pub use salvage::{Salvage, SalvageJob, SalvageReport, SalvageStep};
pub use show::Performance;

use brief::Brief;
use cast::{Casting, among_all};
use graphs::Graphs;
use levels::Levels;
use travel::Turnings;
use trial::Tables;
use whole::Whole;

/// Motions of one segment of 1,260 agents over 10 s are 6 MB.
const MOTION_BYTE_LIMIT: usize = 256 << 20;

/// Makes motions, and remembers the latest.
pub struct Performer {
    graphs: Graphs,
    planner: Planner,
    tables: Tables,
    levels: Levels,
    turnings: Turnings,
    casting: Casting,
    performed: Recent<Brief, Arc<Performed>>,
    groups: Arc<Vec<Group>>,
    obstacles: Arc<Vec<Obstacle>>,
    adjacency: Arc<AdjacencySpec>,
    own_adjacency: Vec<Arc<AdjacencySpec>>,
}

impl Default for Performer {
    fn default() -> Self {
        Self {
            graphs: Graphs::default(),
            planner: Planner::default(),
            tables: Tables::default(),
            levels: Levels::default(),
            turnings: Turnings::default(),
            casting: Casting::default(),
            performed: Recent::new(MOTION_BYTE_LIMIT),
            groups: Arc::default(),
            obstacles: Arc::default(),
            adjacency: Arc::default(),
            own_adjacency: Vec::new(),
        }
    }
}

impl Performer {
    /// The same scene with parts that equal those of the scene before as the same objects: text that is parsed anew makes new ones.
    pub fn adopt(&mut self, mut scene: Scene) -> Scene {
        keep(&mut self.groups, &mut scene.groups);
        keep(&mut self.obstacles, &mut scene.obstacles);
        keep(&mut self.adjacency, &mut scene.adjacency);
        let mut own = Vec::new();
        for spec in scene.tracks.iter_mut().flat_map(|track| &mut track.keyframes).filter_map(|keyframe| keyframe.adjacency.as_mut()) {
            if let Some(known) = self.own_adjacency.iter().find(|known| *known == spec) {
                *spec = known.clone();
            }
            own.push(spec.clone());
        }
        self.own_adjacency = own;
        scene
    }

    /// The ties of a keyframe; who is absent there has none.
    pub fn graph(&mut self, scene: &Scene, keyframe: usize) -> Result<Arc<Adjacency>, Error> {
        match self.casting.standing(scene, keyframe) {
            None => self.graphs.of(scene, keyframe),
            Some((part, there)) => Ok(Arc::new(among_all(&*self.graphs.of(&part, keyframe)?, &there, scene.main_track().agents.len()))),
        }
    }

    /// Starts on segment `index`. `held`: by segment, what to use although it says `auto`; a neighbor's choice counts where segments
    /// meet with one velocity.
    pub fn begin(&mut self, scene: &Scene, index: usize, held: &[Option<Choice>]) -> SegmentJob {
        self.begin_compared(scene, index, held, Aside::default())
    }

    /// As [`Self::begin`], with the segment moved as scenes cannot ask for it.
    pub fn begin_compared(&mut self, scene: &Scene, index: usize, held: &[Option<Choice>], aside: Aside) -> SegmentJob {
        let Some(whole) = Whole::above(scene, index, held) else { return self.begin_whole(scene, index, held, aside) };
        let job = self.begin_compared(&whole.scene, whole.index, &whole.held, aside);
        if whole.has_parts() { SegmentJob::part(job, scene.clone(), index, whole.ends) } else { job }
    }

    fn begin_whole(&mut self, scene: &Scene, index: usize, held: &[Option<Choice>], aside: Aside) -> SegmentJob {
        let (scene, cast) = self.casting.of(scene, index);
        let brief = Brief::of(&scene, index, held).compared(aside).with_cast(cast);
        self.known_or_new(scene, brief)
    }

    fn begin_part(&mut self, scene: &Scene, index: usize, ends: [usize; 2], whole: Arc<Performed>) -> SegmentJob {
        let (scene, cast) = self.casting.of(scene, index);
        let brief = Brief::part(&scene, index, ends, whole).with_cast(cast);
        self.known_or_new(scene, brief)
    }

    fn known_or_new(&mut self, scene: Scene, brief: Brief) -> SegmentJob {
        match self.performed.get(&brief) {
            Some(known) => SegmentJob::done(known),
            None => SegmentJob::new(scene, brief),
        }
    }

    /// The whole show, at once.
    pub fn perform(&mut self, scene: &Scene) -> Result<Performance, Error> {
        let segments = (0..scene.main_track().segments.len())
            .map(|index| {
                let mut job = self.begin(scene, index, &[]);
                loop {
                    if let Step::Done(performed) = job.step(self)? {
                        return Ok(performed);
                    }
                }
            })
            .collect::<Result<_, Error>>()?;
        Ok(Performance::new(scene.clone(), segments))
    }
}

/// A scene's motion and numbers.
pub fn perform(scene: &Scene) -> Result<Performance, Error> {
    Performer::default().perform(scene)
}

fn keep<T: PartialEq>(known: &mut Arc<T>, new: &mut Arc<T>) {
    if **known == **new {
        *new = known.clone();
    } else {
        *known = new.clone();
    }
}
