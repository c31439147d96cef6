//! The places of a shape, in steps that can be stopped between.

use glam::DVec2;

use super::outline::Outline;
use super::packing::pack;
use super::region::Region;
use super::spread::Spread;
use crate::error::Error;
use crate::formation::Formation;
use crate::scene::limits;

/// The spacing at which rows give as many places as asked is found to this share of it.
const PRECISION: f64 = 0.01;

/// How far places may be off their rows at first, as a share of the spacing: a lattice that nothing disturbs stays one.
const UNREST: f64 = 0.05;

/// Places nearer than this, in pixels, tell nothing of the shape any more.
const FINEST: f64 = 1e-3;

/// What the search for the spacing counts for in the progress of the whole: a trial, and all of them.
const SEARCHING: [f64; 2] = [0.03, 0.4];

/// How places stand in a shape.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Style {
    /// All over it.
    Filled,
    /// Along its edge.
    Outline,
}

/// What is asked of a shape.
#[derive(Clone, Copy, Debug)]
pub struct Request {
    /// How many places, 1 to 5,000.
    pub count: usize,
    /// How near two may be, meters; 0 where it does not matter.
    pub least_distance: f64,
    /// All over or along the edge.
    pub style: Style,
    /// Another seed gives other places, the same seed the same.
    pub seed: u32,
}

/// How far a job is.
#[derive(Debug)]
pub enum Step {
    /// 0..1
    Progress(f64),
    /// The places, as many as asked, all inside or on the edge; from the top down, about.
    Done(Formation),
}

/// Places under way.
pub struct SlotJob {
    region: Region,
    request: Request,
    work: Work,
}

enum Work {
    Searching(Search),
    Spreading(Spread),
    /// Along the edge there are too many: one fewer at a time, until they keep the distance.
    Thinning {
        outline: Outline,
        most: usize,
        count: usize,
    },
}

/// The search for the spacing at which rows give as many places as asked, meters.
struct Search {
    /// The largest known to give enough; 0 while there is none.
    enough: f64,
    /// The smallest known to give too few; infinite while there is none.
    too_few: f64,
    trials: u32,
}

impl SlotJob {
    /// Begins; refuses a number of agents that no scene has.
    pub fn new(region: Region, request: Request) -> Result<Self, Error> {
        if !(1..=limits::AGENTS).contains(&request.count) {
            let (value, high) = (request.count as f64, limits::AGENTS as f64);
            return Err(Error::OutOfRange { value, low: 1.0, high, place: "agents".to_owned() });
        }
        let work = Work::Searching(Search { enough: 0.0, too_few: f64::INFINITY, trials: 0 });
        Ok(Self { region, request, work })
    }

    /// All steps at once.
    pub fn finish(mut self) -> Result<Formation, Error> {
        loop {
            if let Step::Done(places) = self.step()? {
                return Ok(places);
            }
        }
    }

    /// Works for a few milliseconds. Refuses more agents than the shape holds at the least distance.
    ///
    /// After it is done it must not be asked again.
    pub fn step(&mut self) -> Result<Step, Error> {
        let Self { region, request, work } = self;
        let mut chance = Chance(u64::from(request.seed));
        match work {
            Work::Searching(_) if request.style == Style::Outline => Ok(self.line(chance.next())),
            // One agent has nobody to keep away from.
            Work::Searching(_) if request.count == 1 => Ok(Step::Done(Formation::new(vec![region.heart()]))),
            Work::Searching(search) => {
                if let Some(progress) = search.step(region, *request)? {
                    return Ok(Step::Progress(progress));
                }
                let spacing = search.enough;
                let places = scattered(region, *request, pack(region, spacing, usize::MAX), spacing, &mut chance);
                *work = Work::Spreading(Spread::new(places, spacing));
                Ok(Step::Progress(SEARCHING[1]))
            }
            Work::Spreading(spread) => {
                let done = spread.step(region);
                if done < 1.0 {
                    return Ok(Step::Progress(SEARCHING[1] + (1.0 - SEARCHING[1]) * done));
                }
                Ok(Step::Done(Formation::new(spread.settle(region, request.least_distance))))
            }
            Work::Thinning { outline, most, count } => {
                // One agent keeps any distance.
                let places = outline.places(*count, chance.next());
                if *count <= 1 || Spread::new(places, 0.0).keeps(region, request.least_distance) {
                    return Err(too_crowded(*request, (*count).max(1)));
                }
                *count -= 1;
                Ok(Step::Progress(1.0 - *count as f64 / *most as f64))
            }
        }
    }

    /// Along the edge, from `phase` of a step on.
    fn line(&mut self, phase: f64) -> Step {
        let Request { count, least_distance, .. } = self.request;
        let outline = Outline::new(&self.region);
        let places = outline.places(count, phase);
        if count == 1 || Spread::new(places.clone(), 0.0).keeps(&self.region, least_distance) {
            return Step::Done(Formation::new(places));
        }
        let most = outline.most(least_distance).min(count - 1);
        self.work = Work::Thinning { outline, most, count: most };
        Step::Progress(0.0)
    }
}

impl Search {
    /// Tries one more spacing; nothing when it is known well enough.
    fn step(&mut self, region: &Region, request: Request) -> Result<Option<f64>, Error> {
        let Request { count, least_distance, .. } = request;
        let spacing = match (self.enough > 0.0, self.too_few.is_finite()) {
            // Each place of a triangular lattice takes √3/2 of its squared spacing.
            (false, false) => (region.area() / (0.75_f64.sqrt() * count as f64)).sqrt().max(least_distance),
            (false, true) => (self.too_few / 1.5).max(least_distance),
            (true, false) => self.enough * 1.25,
            (true, true) if self.too_few > self.enough * (1.0 + PRECISION) => (self.enough * self.too_few).sqrt(),
            (true, true) => return Ok(None),
        };
        let found = pack(region, spacing, count).len();
        if found == count {
            self.enough = spacing;
        } else if spacing <= least_distance.max(FINEST * region.pixel()) {
            return Err(too_crowded(request, found));
        } else {
            self.too_few = spacing;
        }
        self.trials += 1;
        Ok(Some((SEARCHING[0] * f64::from(self.trials)).min(SEARCHING[1])))
    }
}

/// Exactly as many as asked: which of those that are over go, chance says. Then a little unrest, as far as the least distance allows.
fn scattered(region: &Region, request: Request, mut places: Vec<DVec2>, spacing: f64, chance: &mut Chance) -> Vec<DVec2> {
    while places.len() > request.count {
        places.remove((chance.next() * places.len() as f64) as usize);
    }
    let reach = UNREST * spacing;
    // Along an edge a move can come out half as long again.
    if spacing - 3.0 * reach >= request.least_distance {
        for place in &mut places {
            let aside = DVec2::new(chance.next(), chance.next()) * 2.0 - DVec2::ONE;
            *place = region.moved(*place, aside * (reach * 0.5_f64.sqrt()));
        }
    }
    places
}

fn too_crowded(Request { count, least_distance: distance, .. }: Request, largest: usize) -> Error {
    Error::TooCrowded { count, distance, largest }
}

/// Numbers by chance, the same for the same seed (`SplitMix64`).
struct Chance(u64);

impl Chance {
    /// At least 0, less than 1.
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut mixed = self.0;
        mixed = (mixed ^ mixed >> 30).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        mixed = (mixed ^ mixed >> 27).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((mixed ^ mixed >> 31) >> 11) as f64 / (1_u64 << 53) as f64
    }
}
