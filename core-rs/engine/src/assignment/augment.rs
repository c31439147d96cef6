//! Shortest augmenting paths.
//!
//! Every target has a price. A source that holds a target holds one that is cheapest for it, price deducted; each further source is
//! let in along a shortest path of reassignments, which keeps that so. When all hold one, nobody can gain: the optimum.

use super::costs::Costs;

/// No slot yet.
const FREE: u32 = u32::MAX;

/// Rounds of [`Search::reduce`]; a third hardly finds anything more.
const REDUCTION_ROUNDS: usize = 2;

/// An assignment in the making. Every call is given the same costs.
pub(super) struct Search {
    /// By target.
    prices: Vec<f64>,
    source_of: Vec<u32>,
    target_of: Vec<u32>,
    /// Sources below hold a target for good.
    let_in: usize,
    path: Path,
    /// The costs of one source.
    row: Vec<f64>,
}

impl Search {
    /// Tightens any starting `prices` (one a target), and gives each source in turn the first free target that is cheapest for it.
    pub(super) fn new(costs: &dyn Costs, mut prices: Vec<f64>) -> Self {
        let (agent_count, mut row) = (costs.source_count(), vec![0.0; prices.len()]);
        let least = least_payments(costs, &prices);
        bearable_prices_into(costs, &least, &mut prices);
        let mut search = Self {
            source_of: vec![FREE; prices.len()],
            target_of: vec![FREE; agent_count],
            let_in: 0,
            path: Path::new(&prices),
            row: vec![],
            prices,
        };
        for (source, least) in least.into_iter().enumerate() {
            costs.row_into(source, &mut row);
            let mut slots = row.iter().zip(&search.prices).zip(&search.source_of);
            // Exact: a tight price is this very difference.
            let tight = slots.position(|((cost, &price), &holder)| holder == FREE && cost - least == price);
            if let Some(target) = tight {
                search.assign(source, target);
            }
        }
        search.row = row;
        search
    }

    /// No assignment costs less than this; the best prices make it the optimum.
    pub(super) fn lower_bound(&self, costs: &dyn Costs) -> f64 {
        self.prices.iter().chain(&self.least_payments(costs)).sum()
    }

    /// What each source pays at least, at these prices.
    pub(super) fn least_payments(&self, costs: &dyn Costs) -> Vec<f64> {
        least_payments(costs, &self.prices)
    }

    /// How many sources have no target.
    pub(super) fn free_count(&self) -> usize {
        self.free_sources().count()
    }

    /// Sources without a target, ascending.
    fn free_sources(&self) -> impl Iterator<Item = usize> {
        self.target_of.iter().enumerate().filter(|(_, target)| **target == FREE).map(|(source, _)| source)
    }

    /// Augmenting row reduction: each free source takes its cheapest target and lowers its price to what the second cheapest would
    /// cost; whoever held it looks again.
    pub(super) fn reduce(&mut self, costs: &dyn Costs) {
        for _ in 0..REDUCTION_ROUNDS {
            // Prices that differ by rounding could pass a target to and fro for ever.
            let mut steps = 4 * costs.source_count();
            for source in self.free_sources().collect::<Vec<_>>() {
                let mut next = Some(source);
                while let Some(source) = next.filter(|_| steps > 0) {
                    steps -= 1;
                    next = self.reduce_one(costs, source);
                }
            }
        }
    }

    /// Gives one source a target; the source it was taken from when that should look again at once.
    fn reduce_one(&mut self, costs: &dyn Costs, source: usize) -> Option<usize> {
        let (mut least, mut target) = (f64::INFINITY, 0);
        let (mut second_least, mut second) = (f64::INFINITY, 0);
        costs.row_into(source, &mut self.row);
        for (slot, (cost, price)) in self.row.iter().zip(&self.prices).enumerate() {
            let reduced = cost - price;
            if reduced < least {
                (second_least, second) = (least, target);
                (least, target) = (reduced, slot);
            } else if reduced < second_least {
                (second_least, second) = (reduced, slot);
            }
        }
        let is_strict = least < second_least;
        if is_strict && second_least.is_finite() {
            self.prices[target] -= second_least - least;
        } else if !is_strict && self.source_of[target] != FREE {
            target = second;
        }
        let before = self.source_of[target];
        if before != FREE {
            self.target_of[before as usize] = FREE;
        }
        self.assign(source, target);
        (is_strict && before != FREE).then_some(before as usize)
    }

    /// Lets in sources that are still free until about `work` rows were looked at, one at least; whether all hold a target now. The
    /// prices are the best ones then.
    pub(super) fn finish(&mut self, costs: &dyn Costs, work: usize) -> bool {
        let mut done = 0;
        while let Some(source) = (self.let_in..self.target_of.len()).find(|source| self.target_of[*source] == FREE) {
            if done >= work {
                return false;
            }
            done += self.augment(costs, source);
            self.let_in = source + 1;
        }
        true
    }

    /// By source, the target it holds, once [`Search::finish`] is done.
    pub(super) fn targets(&self) -> &[u32] {
        &self.target_of
    }

    /// Dijkstra from a free source over reduced costs to the nearest free target, then a shift of everyone along the path. Answers how
    /// many rows it looked at.
    fn augment(&mut self, costs: &dyn Costs, start: usize) -> usize {
        let path = &mut self.path;
        path.reset(&self.prices);
        costs.row_into(start, &mut self.row);
        path.see(costs.kind(start));
        path.relax(start, 0.0, &self.row);
        let mut rows = 1;
        let (end, length) = loop {
            let (least, free) = path.close_nearest(&self.source_of);
            if let Some(end) = free {
                break (end, least);
            }
            for at in 0..path.closed.len() {
                let target = path.closed[at] as usize;
                let source = self.source_of[target] as usize;
                // Of sources with the same costs the first to be reached reaches all that the others do, and not later.
                if path.see(costs.kind(source)) {
                    costs.row_into(source, &mut self.row);
                    path.relax(source, least - (self.row[target] - self.prices[target]), &self.row);
                    rows += 1;
                }
            }
        };
        for &(target, distance) in &path.reached {
            self.prices[target as usize] += distance - length;
        }
        let mut target = end;
        loop {
            let source = self.path.from[target] as usize;
            let before = self.target_of[source];
            self.assign(source, target);
            if source == start {
                return rows;
            }
            target = before as usize;
        }
    }

    fn assign(&mut self, source: usize, target: usize) {
        self.source_of[target] = source as u32;
        self.target_of[source] = target as u32;
    }
}

/// A shortest-path search over the targets; its buffers serve every search.
struct Path {
    /// By target: length of the shortest path so far; infinite once the target is closed.
    distance: Vec<f64>,
    /// By target: its price; minus infinity once it is closed, so that no path leads there again.
    open_price: Vec<f64>,
    /// By target: the source before it on that path.
    from: Vec<u32>,
    /// Targets closed last, all equally far.
    closed: Vec<u32>,
    /// All closed targets and their distances.
    reached: Vec<(u32, f64)>,
    /// By kind of source.
    is_seen: Vec<bool>,
}

impl Path {
    fn new(prices: &[f64]) -> Self {
        let size = prices.len();
        let (distance, open_price) = (vec![0.0; size], vec![0.0; size]);
        Self { distance, open_price, from: vec![0; size], closed: vec![], reached: vec![], is_seen: vec![] }
    }

    fn reset(&mut self, prices: &[f64]) {
        self.distance.fill(f64::INFINITY);
        self.open_price.copy_from_slice(prices);
        self.reached.clear();
        self.is_seen.fill(false);
    }

    /// Whether sources of this kind come for the first time.
    fn see(&mut self, kind: usize) -> bool {
        if kind >= self.is_seen.len() {
            self.is_seen.resize(kind + 1, false);
        }
        !std::mem::replace(&mut self.is_seen[kind], true)
    }

    /// Without a branch, or it would not become vector instructions.
    fn relax(&mut self, source: usize, offset: f64, row: &[f64]) {
        let targets = self.open_price.iter().zip(&mut self.distance).zip(&mut self.from);
        for (cost, ((price, distance), from)) in row.iter().zip(targets) {
            let length = offset + (cost - price);
            let is_shorter = length < *distance;
            *distance = if is_shorter { length } else { *distance };
            *from = if is_shorter { source as u32 } else { *from };
        }
    }

    /// The least distance, and the lowest free target of those that are so near; without one, all of them are closed.
    fn close_nearest(&mut self, source_of: &[u32]) -> (f64, Option<usize>) {
        let least = least(&self.distance);
        assert!(least.is_finite(), "costs are finite");
        self.closed.clear();
        for (target, (distance, holder)) in self.distance.iter().zip(source_of).enumerate() {
            // Exact: it is one of them.
            if *distance == least {
                if *holder == FREE {
                    return (least, Some(target));
                }
                self.closed.push(target as u32);
            }
        }
        for &target in &self.closed {
            self.reached.push((target, least));
            self.distance[target as usize] = f64::INFINITY;
            self.open_price[target as usize] = f64::NEG_INFINITY;
        }
        (least, None)
    }
}

fn least_payments(costs: &dyn Costs, prices: &[f64]) -> Vec<f64> {
    let mut row = vec![0.0; prices.len()];
    let mut payment = |source| {
        costs.row_into(source, &mut row);
        row.iter().zip(prices).map(|(cost, price)| cost - price).fold(f64::INFINITY, f64::min)
    };
    (0..costs.source_count()).map(&mut payment).collect()
}

/// The greatest price of each target (one of `prices` each) at which no source pays less there than its `payments`.
pub(super) fn bearable_prices_into(costs: &dyn Costs, payments: &[f64], prices: &mut [f64]) {
    let mut row = vec![0.0; prices.len()];
    prices.fill(f64::INFINITY);
    for (source, least) in payments.iter().enumerate() {
        costs.row_into(source, &mut row);
        for (cost, price) in row.iter().zip(&mut *prices) {
            let bearable = cost - least;
            *price = if bearable < *price { bearable } else { *price };
        }
    }
}

/// The least of many values, in lanes so that it becomes vector instructions.
fn least(values: &[f64]) -> f64 {
    let (chunks, rest) = values.as_chunks::<8>();
    let mut lanes = [f64::INFINITY; 8];
    for chunk in chunks {
        for (lane, &value) in lanes.iter_mut().zip(chunk) {
            *lane = if value < *lane { value } else { *lane };
        }
    }
    lanes.iter().chain(rest).copied().fold(f64::INFINITY, f64::min)
}
