//! The places of a shape, in steps that can be stopped between.

use glam::DVec2;

use super::outline::Outline;
use super::packing::pack;
use super::region::Region;
use super::spread::Spread;
use crate::error::Error;
use crate::formation::{Formation, PairSearch};
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
    /// The largest spacing known to give enough places, and the smallest known not to.
    Searching {
        enough: Option<f64>,
        too_few: f64,
        trials: u32,
    },
    Spreading(Spread),
    /// Along the edge there are too many: one fewer at a time, until they keep the distance.
    Thinning {
        outline: Outline,
        most: usize,
        count: usize,
    },
}

impl SlotJob {
    /// Begins; refuses a number of agents that no scene has.
    pub fn new(region: Region, request: Request) -> Result<Self, Error> {
        if !(1..=limits::AGENTS).contains(&request.count) {
            let (value, high) = (request.count as f64, limits::AGENTS as f64);
            return Err(Error::OutOfRange { value, low: 1.0, high, place: "agents".to_owned() });
        }
        let work = Work::Searching { enough: None, too_few: f64::INFINITY, trials: 0 };
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
        match (self.request.style, &mut self.work) {
            _ if self.request.count == 1 => Ok(Step::Done(Formation::new(vec![self.lone()]))),
            (Style::Filled, Work::Searching { .. }) => self.search(),
            (Style::Outline, Work::Searching { .. }) => Ok(self.line()),
            (_, Work::Thinning { .. }) => self.thin(),
            (_, Work::Spreading(spread)) => {
                let done = spread.step(&self.region);
                if done < 1.0 {
                    return Ok(Step::Progress(SEARCHING[1] + (1.0 - SEARCHING[1]) * done));
                }
                let spread = std::mem::replace(spread, Spread::new(Vec::new(), 0.0));
                Ok(Step::Done(Formation::new(spread.settle(&self.region, self.request.least_distance))))
            }
        }
    }

    /// One agent has nobody to keep away from.
    fn lone(&self) -> DVec2 {
        match self.request.style {
            Style::Filled => self.region.heart(),
            Style::Outline => Outline::new(&self.region).places(1, self.phase())[0],
        }
    }

    /// Tries one more spacing; goes on to spreading when it is known well enough.
    fn search(&mut self) -> Result<Step, Error> {
        let Request { count, least_distance, .. } = self.request;
        let Work::Searching { enough, too_few, trials } = &mut self.work else { unreachable!("only asked while searching") };
        let spacing = match *enough {
            // Each place of a triangular lattice takes √3/2 of its squared spacing.
            None if too_few.is_infinite() => (self.region.area() / (0.75_f64.sqrt() * count as f64)).sqrt().max(least_distance),
            None => (*too_few / 1.5).max(least_distance),
            Some(enough) if too_few.is_infinite() => enough * 1.25,
            Some(enough) if *too_few > enough * (1.0 + PRECISION) => (enough * *too_few).sqrt(),
            Some(enough) => {
                let places = self.scattered(pack(&self.region, enough, usize::MAX), enough);
                self.work = Work::Spreading(Spread::new(places, enough));
                return Ok(Step::Progress(SEARCHING[1]));
            }
        };
        if pack(&self.region, spacing, count).len() == count {
            *enough = Some(spacing);
        } else if spacing <= least_distance {
            let largest = pack(&self.region, spacing, count).len();
            return Err(Error::TooCrowded { count, distance: least_distance, largest });
        } else if spacing < FINEST * self.region.pixel() {
            return Err(Error::TooCrowded { count, distance: spacing, largest: pack(&self.region, spacing, count).len() });
        } else {
            *too_few = spacing;
        }
        *trials += 1;
        Ok(Step::Progress((SEARCHING[0] * f64::from(*trials)).min(SEARCHING[1])))
    }

    /// Exactly as many as asked: which of those that are over go, chance says. Then a little unrest, as far as the least distance allows.
    fn scattered(&self, mut places: Vec<DVec2>, spacing: f64) -> Vec<DVec2> {
        let mut chance = Chance(u64::from(self.request.seed));
        while places.len() > self.request.count {
            places.remove((chance.next() * places.len() as f64) as usize);
        }
        let reach = UNREST * spacing;
        // Along an edge a move can come out half as long again.
        if spacing - 3.0 * reach < self.request.least_distance {
            return places;
        }
        let mut aside = || (2.0 * chance.next() - 1.0) * reach * 0.5_f64.sqrt();
        places.into_iter().map(|place| self.region.moved(place, DVec2::new(aside(), aside()))).collect()
    }

    /// Along the edge.
    fn line(&mut self) -> Step {
        let Request { count, least_distance, .. } = self.request;
        let outline = Outline::new(&self.region);
        let places = outline.places(count, self.phase());
        if keeps(&places, least_distance) {
            return Step::Done(Formation::new(places));
        }
        let most = outline.most(least_distance).min(count - 1);
        self.work = Work::Thinning { outline, most, count: most };
        Step::Progress(0.0)
    }

    /// How many along the edge would be no refusal.
    fn thin(&mut self) -> Result<Step, Error> {
        let Request { count: asked, least_distance: distance, .. } = self.request;
        let phase = self.phase();
        let Work::Thinning { outline, most, count } = &mut self.work else { unreachable!("only asked while thinning") };
        // One agent keeps any distance.
        if *count <= 1 || keeps(&outline.places(*count, phase), distance) {
            return Err(Error::TooCrowded { count: asked, distance, largest: (*count).max(1) });
        }
        *count -= 1;
        Ok(Step::Progress(1.0 - *count as f64 / *most as f64))
    }

    /// Where on the edge the first one stands, in steps.
    fn phase(&self) -> f64 {
        Chance(u64::from(self.request.seed)).next()
    }
}

/// Whether nobody is nearer than `distance` to another, meters.
fn keeps(places: &[DVec2], distance: f64) -> bool {
    let mut is_kept = true;
    PairSearch::default().for_each_within(places, distance, |_, _, squared| is_kept &= squared >= distance * distance);
    is_kept
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
