//! Shortest augmenting paths.
//!
//! Every target has a price. A source that holds a target holds one that is cheapest for it, price deducted; each further source is
//! let in along a shortest path of reassignments, which keeps that so. When all hold one, nobody can gain: the optimum.

use super::Assignment;
use super::costs::Costs;

/// No slot yet.
const FREE: u32 = u32::MAX;

/// Rounds of [`Search::reduce`]; a third hardly finds anything more.
const REDUCTION_ROUNDS: usize = 2;

/// An assignment in the making.
pub(super) struct Search<'a, C> {
    costs: &'a C,
    /// By target.
    prices: Vec<f64>,
    source_of: Vec<u32>,
    target_of: Vec<u32>,
}

impl<'a, C: Costs> Search<'a, C> {
    /// Tightens any starting `prices` (one a target), and gives each source in turn the first free target that is cheapest for it.
    pub(super) fn new(costs: &'a C, mut prices: Vec<f64>) -> Self {
        let agent_count = costs.agent_count();
        let least: Vec<f64> = (0..agent_count).map(|source| least_reduced_cost(costs, source, &prices)).collect();
        bearable_prices_into(costs, &least, &mut prices);
        let mut search = Self { costs, prices, source_of: vec![FREE; agent_count], target_of: vec![FREE; agent_count] };
        for (source, least) in least.into_iter().enumerate() {
            let slots = search.prices.iter().zip(&search.source_of);
            // Exact: a tight price is this very difference.
            #[allow(clippy::float_cmp)]
            let tight = costs.row(source).zip(slots).position(|(cost, (&price, &holder))| holder == FREE && cost - least == price);
            if let Some(target) = tight {
                search.assign(source, target);
            }
        }
        search
    }

    /// No assignment costs less than this; the best prices make it the optimum.
    pub(super) fn lower_bound(&self) -> f64 {
        self.prices.iter().chain(&self.least_payments()).sum()
    }

    /// What each source pays at least, at these prices.
    pub(super) fn least_payments(&self) -> Vec<f64> {
        (0..self.costs.agent_count()).map(|source| least_reduced_cost(self.costs, source, &self.prices)).collect()
    }

    /// Sources without a target, ascending.
    pub(super) fn free_sources(&self) -> Vec<u32> {
        (0..).zip(&self.target_of).filter(|&(_, &target)| target == FREE).map(|(source, _)| source).collect()
    }

    /// Augmenting row reduction: each free source takes its cheapest target and lowers its price to what the second cheapest would
    /// cost; whoever held it looks again.
    pub(super) fn reduce(&mut self) {
        for _ in 0..REDUCTION_ROUNDS {
            // Prices that differ by rounding could pass a target to and fro for ever.
            let mut steps = 4 * self.costs.agent_count();
            for source in self.free_sources() {
                let mut next = Some(source as usize);
                while let Some(source) = next.filter(|_| steps > 0) {
                    steps -= 1;
                    next = self.reduce_one(source);
                }
            }
        }
    }

    /// Gives one source a target; the source it was taken from when that should look again at once.
    fn reduce_one(&mut self, source: usize) -> Option<usize> {
        let (mut least, mut target) = (f64::INFINITY, 0);
        let (mut second_least, mut second) = (f64::INFINITY, 0);
        for (slot, (cost, price)) in self.costs.row(source).zip(&self.prices).enumerate() {
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

    /// Lets in every source that is still free: the prices are the best ones then.
    pub(super) fn finish(&mut self) {
        let agent_count = self.costs.agent_count();
        let mut path =
            Path { distance: vec![0.0; agent_count], open_price: vec![0.0; agent_count], from: vec![0; agent_count], reached: vec![] };
        for source in self.free_sources() {
            self.augment(source as usize, &mut path);
        }
    }

    /// The assignment found, after [`Search::finish`].
    pub(super) fn into_assignment(self) -> Assignment {
        Assignment::new(self.target_of).expect("every source holds a target of its own")
    }

    /// Dijkstra from a free source over reduced costs to the nearest free target, then a shift of everyone along the path.
    fn augment(&mut self, start: usize, path: &mut Path) {
        path.reset(&self.prices);
        let (mut source, mut offset) = (start, 0.0);
        let (end, length) = loop {
            path.relax(source as u32, offset, self.costs.row(source));
            let (target, distance) = path.nearest(&self.source_of);
            if self.source_of[target] == FREE {
                break (target, distance);
            }
            path.close(target, distance);
            source = self.source_of[target] as usize;
            offset = distance - (self.costs.between(source, target) - self.prices[target]);
        };
        for &(target, distance) in &path.reached {
            self.prices[target as usize] += distance - length;
        }
        let mut target = end;
        loop {
            let source = path.from[target] as usize;
            let before = self.target_of[source];
            self.assign(source, target);
            if source == start {
                break;
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
    /// Closed targets and their distances.
    reached: Vec<(u32, f64)>,
}

impl Path {
    fn reset(&mut self, prices: &[f64]) {
        self.distance.fill(f64::INFINITY);
        self.open_price.copy_from_slice(prices);
        self.reached.clear();
    }

    /// Without a branch, or it would not become vector instructions.
    fn relax(&mut self, source: u32, offset: f64, costs: impl Iterator<Item = f64>) {
        let targets = self.open_price.iter().zip(&mut self.distance).zip(&mut self.from);
        for (cost, ((price, distance), from)) in costs.zip(targets) {
            let length = offset + (cost - price);
            let is_shorter = length < *distance;
            *distance = if is_shorter { length } else { *distance };
            *from = if is_shorter { source } else { *from };
        }
    }

    /// The nearest open target, a free one before a held one, then the lowest.
    fn nearest(&self, source_of: &[u32]) -> (usize, f64) {
        let least = least(&self.distance);
        assert!(least.is_finite(), "costs are finite");
        // Exact: it is one of them.
        #[allow(clippy::float_cmp)]
        let mut nearest = self.distance.iter().zip(source_of).enumerate().filter(|(_, (distance, _))| **distance == least);
        let first = nearest.next().map_or(0, |(target, _)| target);
        if source_of[first] == FREE {
            return (first, least);
        }
        (nearest.find(|(_, (_, source))| **source == FREE).map_or(first, |(target, _)| target), least)
    }

    fn close(&mut self, target: usize, distance: f64) {
        self.reached.push((target as u32, distance));
        self.distance[target] = f64::INFINITY;
        self.open_price[target] = f64::NEG_INFINITY;
    }
}

fn least_reduced_cost(costs: &impl Costs, source: usize, prices: &[f64]) -> f64 {
    costs.row(source).zip(prices).map(|(cost, price)| cost - price).fold(f64::INFINITY, f64::min)
}

/// The greatest price of each target (one of `prices` each) at which no source pays less there than its `payments`.
pub(super) fn bearable_prices_into(costs: &impl Costs, payments: &[f64], prices: &mut [f64]) {
    prices.fill(f64::INFINITY);
    for (source, least) in payments.iter().enumerate() {
        for (cost, price) in costs.row(source).zip(&mut *prices) {
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
