//! Costs that are computed when they are asked for.

use glam::DVec3;

use super::terrain::Around;

/// What it costs each source to take each target; finite.
pub(super) trait Costs {
    /// How many sources.
    fn source_count(&self) -> usize;

    /// The costs of one source, by target: the inner loop of everything.
    fn row_into(&self, source: usize, row: &mut [f64]);

    /// Sources of one kind have the same costs.
    fn kind(&self, source: usize) -> usize {
        source
    }
}

/// Costs by any function.
pub(super) struct ByFunction<F> {
    pub(super) source_count: usize,
    pub(super) cost: F,
}

impl<F: Fn(usize, usize) -> f64> Costs for ByFunction<F> {
    fn source_count(&self) -> usize {
        self.source_count
    }

    fn row_into(&self, source: usize, row: &mut [f64]) {
        for (target, out) in row.iter_mut().enumerate() {
            *out = (self.cost)(source, target);
        }
    }
}

/// What a way costs by its length along each axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Measure {
    Squared,
    Euclidean,
    Manhattan,
}

/// Costs of ways between points, an axis at a time: coordinates lie apart, so that the inner loop becomes vector instructions.
#[derive(Clone)]
pub(super) struct Ways {
    measure: Measure,
    source_count: usize,
    axes: Vec<Axis>,
    /// Where ways lead around something: their lengths in plan, in place of those axes.
    around: Option<Around>,
    effort: Option<Effort>,
    /// By source, where sources are alike; empty where none are.
    kinds: Vec<u32>,
    /// By target, whether it costs nothing whoever takes it; empty where none does.
    spared: Vec<bool>,
}

/// One coordinate of everybody.
#[derive(Clone)]
struct Axis {
    sources: Vec<f64>,
    targets: Vec<f64>,
}

/// The second term of least effort: how differently dense agents stand at both ends.
#[derive(Clone)]
struct Effort {
    lambda: f64,
    spacing: Axis,
}

impl Ways {
    /// From each of `sources` to each of `targets`; the axis along which nobody moves is left out.
    pub(super) fn new(measure: Measure, sources: &[DVec3], targets: &[DVec3]) -> Self {
        let axis = |of: fn(&DVec3) -> f64| Axis { sources: sources.iter().map(of).collect(), targets: targets.iter().map(of).collect() };
        let mut axes = vec![axis(|p| p.x), axis(|p| p.y), axis(|p| p.z)];
        axes.retain(|axis| axis.sources.iter().chain(&axis.targets).any(|&at| at != axis.sources[0]));
        Self { measure, source_count: sources.len(), axes, around: None, effort: None, kinds: vec![], spared: vec![] }
    }

    /// The same; in plan the ways are those.
    pub(super) fn leading(mut self, around: Around) -> Self {
        self.around = Some(around);
        self
    }

    /// λ times the way, and 1 − λ times the squared difference of the spacings.
    pub(super) fn with_effort(mut self, lambda: f64, sources: Vec<f64>, targets: Vec<f64>) -> Self {
        self.effort = Some(Effort { lambda, spacing: Axis { sources, targets } });
        self
    }

    /// The same; sources of one kind stand at one point.
    pub(super) fn with_kinds(mut self, kinds: Vec<u32>) -> Self {
        self.kinds = kinds;
        self
    }

    /// The same; some targets cost nothing.
    pub(super) fn sparing(mut self, spared: Vec<bool>) -> Self {
        self.spared = spared;
        self
    }

    /// The problem of half of the sources and half of the targets.
    pub(super) fn halved(&self) -> Self {
        let half = self.with_half_the_sources().map_axes(|axis| Axis { targets: half_of(&axis.targets), ..axis });
        let spared = half_of(&half.spared);
        Self { around: half.around.map(|around| Around { slots: half_of(&around.slots), ..around }), spared, ..half }
    }

    /// The costs of half of the sources to all targets.
    pub(super) fn with_half_the_sources(&self) -> Self {
        let half = self.clone().map_axes(|axis| Axis { sources: half_of(&axis.sources), ..axis });
        let around = half.around.map(|around| Around { sources: half_of(&around.sources), ..around });
        Self { source_count: self.source_count.div_ceil(2), kinds: half_of(&self.kinds), around, ..half }
    }

    fn map_axes(self, change: fn(Axis) -> Axis) -> Self {
        let effort = self.effort.map(|Effort { lambda, spacing }| Effort { lambda, spacing: change(spacing) });
        Self { axes: self.axes.into_iter().map(change).collect(), effort, ..self }
    }
}

impl Costs for Ways {
    fn source_count(&self) -> usize {
        self.source_count
    }

    fn row_into(&self, source: usize, row: &mut [f64]) {
        match &self.around {
            Some(around) => around.row_into(source, self.measure != Measure::Manhattan, row),
            None => row.fill(0.0),
        }
        for Axis { sources, targets } in &self.axes {
            let from = sources[source];
            match self.measure {
                Measure::Manhattan => row.iter_mut().zip(targets).for_each(|(out, to)| *out += (from - to).abs()),
                _ => row.iter_mut().zip(targets).for_each(|(out, to)| *out += (from - to) * (from - to)),
            }
        }
        if self.measure == Measure::Euclidean {
            for out in &mut *row {
                *out = out.sqrt();
            }
        }
        if let Some(Effort { lambda, spacing }) = &self.effort {
            let from = spacing.sources[source];
            for (out, to) in row.iter_mut().zip(&spacing.targets) {
                *out = lambda * *out + (1.0 - lambda) * (from - to) * (from - to);
            }
        }
        for (out, _) in row.iter_mut().zip(&self.spared).filter(|(_, is_spared)| **is_spared) {
            *out = 0.0;
        }
    }

    fn kind(&self, source: usize) -> usize {
        self.kinds.get(source).map_or(source, |kind| *kind as usize)
    }
}

/// One of every two, now the first, now the second, by the Thue-Morse sequence: a strict every other would take every other column of
/// a grid.
fn half_of<T: Copy>(values: &[T]) -> Vec<T> {
    values.chunks(2).enumerate().map(|(pair, chunk)| chunk[pair.count_ones() as usize % chunk.len()]).collect()
}
