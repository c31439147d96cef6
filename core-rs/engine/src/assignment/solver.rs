//! The least assignment by the costs of ways, a little at a time.

use super::augment::{Search, bearable_prices_into};
use super::costs::Ways;

/// Below this many agents a coarse problem costs more than it saves.
const COARSE_FROM: usize = 64;

/// When more than this fraction of the agents is left over by row reduction, prices of a coarse problem are tried.
///
/// Scattered agents leave a sixth and gain nothing from it; drawn shapes leave up to nine tenths and gain a factor of ten or more.
const COARSE_WORTHWHILE: f64 = 0.2;

/// A problem and, above it, the same with half of the agents, as long as that may help.
///
/// Both sample one continuous transport problem, so what each coarse source pays prices every target of the fine one.
pub(super) struct Solver {
    /// The finest first.
    levels: Vec<(Ways, Search)>,
    /// With those that are solved.
    level_count: usize,
}

impl Solver {
    /// As many sources as targets: `size`.
    pub(super) fn new(mut ways: Ways, size: usize) -> Self {
        let (mut levels, mut size) = (vec![], size);
        loop {
            let search = start(&ways, vec![0.0; size]);
            let is_hard = size >= COARSE_FROM && search.free_count() as f64 > COARSE_WORTHWHILE * size as f64;
            let coarse = is_hard.then(|| ways.halved());
            levels.push((ways, search));
            match coarse {
                Some(coarse) => ways = coarse,
                None => return Self { level_count: levels.len(), levels },
            }
            size = size.div_ceil(2);
        }
    }

    /// Looks at about `work` rows of costs; whether it is done.
    pub(super) fn step(&mut self, work: usize) -> bool {
        let Some((ways, search)) = self.levels.last_mut() else { return true };
        if !search.finish(ways, work) {
            return false;
        }
        let payments = search.least_payments(ways);
        let [.., (ways, plain), _] = &mut self.levels[..] else { return true };
        let mut prices = vec![0.0; plain.targets().len()];
        bearable_prices_into(&ways.with_half_the_sources(), &payments, &mut prices);
        let informed = start(ways, prices);
        if informed.lower_bound(ways) > plain.lower_bound(ways) {
            *plain = informed;
        }
        self.levels.pop();
        false
    }

    /// How far it is, from 0 to 1: a level with half of the sources is a quarter of the work.
    pub(super) fn progress(&self) -> f64 {
        let work = |level: usize| 1.0 / f64::from(1_u32 << (2 * level));
        let under_way = self.levels.last().map_or(0.0, |(_, search)| {
            let settled = search.targets().len() - search.free_count();
            work(self.levels.len() - 1) * settled as f64 / search.targets().len() as f64
        });
        let done: f64 = (self.levels.len()..self.level_count).map(work).sum();
        (done + under_way) / (0..self.level_count).map(work).sum::<f64>()
    }

    /// By source, its target, once it is done.
    pub(super) fn targets(&self) -> &[u32] {
        self.levels.first().map_or(&[], |(_, search)| search.targets())
    }
}

/// A search with the cheap part of the work done.
fn start(ways: &Ways, prices: Vec<f64>) -> Search {
    let mut search = Search::new(ways, prices);
    search.reduce(ways);
    search
}
