//! Costs that are computed when they are asked for.

use glam::DVec2;

/// What it costs each source to take each target; finite.
pub(super) trait Costs {
    /// How many sources, and how many targets.
    fn agent_count(&self) -> usize;

    /// The cost of one pair.
    fn between(&self, source: usize, target: usize) -> f64;

    /// The costs of one source, by target: the inner loop of everything, so its form decides the speed.
    fn row(&self, source: usize) -> impl Iterator<Item = f64>;
}

/// Costs by any function.
pub(super) struct ByFunction<F> {
    pub(super) agent_count: usize,
    pub(super) cost: F,
}

impl<F: Fn(usize, usize) -> f64> Costs for ByFunction<F> {
    fn agent_count(&self) -> usize {
        self.agent_count
    }

    fn between(&self, source: usize, target: usize) -> f64 {
        (self.cost)(source, target)
    }

    fn row(&self, source: usize) -> impl Iterator<Item = f64> {
        (0..self.agent_count).map(move |target| (self.cost)(source, target))
    }
}

/// Squared distances. The targets' coordinates lie apart, so that the inner loop becomes vector instructions.
pub(super) struct SquaredDistances {
    sources: Vec<DVec2>,
    target_x: Vec<f64>,
    target_y: Vec<f64>,
}

impl SquaredDistances {
    /// As many sources as targets.
    pub(super) fn new(sources: Vec<DVec2>, targets: &[DVec2]) -> Self {
        assert_eq!(sources.len(), targets.len(), "as many sources as targets");
        let (target_x, target_y) = targets.iter().map(|target| (target.x, target.y)).unzip();
        Self { sources, target_x, target_y }
    }

    /// The problem of half of the sources and half of the targets.
    pub(super) fn halved(&self) -> Self {
        Self { target_x: half_of(&self.target_x), target_y: half_of(&self.target_y), ..self.with_half_the_sources() }
    }

    /// The costs of half of the sources to all targets.
    pub(super) fn with_half_the_sources(&self) -> Self {
        Self { sources: half_of(&self.sources), target_x: self.target_x.clone(), target_y: self.target_y.clone() }
    }
}

impl Costs for SquaredDistances {
    fn agent_count(&self) -> usize {
        self.sources.len()
    }

    fn between(&self, source: usize, target: usize) -> f64 {
        let away = self.sources[source] - DVec2::new(self.target_x[target], self.target_y[target]);
        away.x * away.x + away.y * away.y
    }

    fn row(&self, source: usize) -> impl Iterator<Item = f64> {
        let DVec2 { x, y } = self.sources[source];
        self.target_x.iter().zip(&self.target_y).map(move |(&target_x, &target_y)| {
            let (away_x, away_y) = (x - target_x, y - target_y);
            away_x * away_x + away_y * away_y
        })
    }
}

/// One of every two, now the first, now the second, by the Thue-Morse sequence: a strict every other would take every other column of
/// a grid.
fn half_of<T: Copy>(values: &[T]) -> Vec<T> {
    values.chunks(2).enumerate().map(|(pair, chunk)| chunk[pair.count_ones() as usize % chunk.len()]).collect()
}
