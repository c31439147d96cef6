//! Places of many agents over time, a path's numbers side by side.

/// Places at evenly spaced knots: `axis(a)[agent * knot_count + knot]`, meters.
///
/// An axis at a time and an agent at a time, so that a push over time is one run through memory.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Paths {
    agent_count: usize,
    knot_count: usize,
    axes: [Vec<f64>; 3],
    axis_count: usize,
}

impl Paths {
    /// All at the origin; two axes on the plane, three in space.
    ///
    /// # Panics
    /// For any other number of axes: a bug.
    pub fn new(agent_count: usize, knot_count: usize, axis_count: usize) -> Self {
        assert!(axis_count == 2 || axis_count == 3, "paths lie on the plane or in space");
        let axis = || vec![0.0; agent_count * knot_count];
        let height = if axis_count == 3 { axis() } else { Vec::new() };
        Self { agent_count, knot_count, axes: [axis(), axis(), height], axis_count }
    }

    /// How many agents.
    pub fn agent_count(&self) -> usize {
        self.agent_count
    }

    /// How many knots each path has.
    pub fn knot_count(&self) -> usize {
        self.knot_count
    }

    /// Two on the plane, three in space.
    pub fn axis_count(&self) -> usize {
        self.axis_count
    }

    /// One coordinate of every agent at every knot.
    pub fn axis(&self, axis: usize) -> &[f64] {
        &self.axes[axis]
    }

    /// The same to write.
    pub fn axis_mut(&mut self, axis: usize) -> &mut [f64] {
        &mut self.axes[axis]
    }

    /// One coordinate of one agent, knot by knot.
    pub fn path(&self, axis: usize, agent: usize) -> &[f64] {
        &self.axes[axis][agent * self.knot_count..(agent + 1) * self.knot_count]
    }

    /// The same to write.
    pub fn path_mut(&mut self, axis: usize, agent: usize) -> &mut [f64] {
        &mut self.axes[axis][agent * self.knot_count..(agent + 1) * self.knot_count]
    }

    /// An agent at a knot; height 0 on the plane.
    pub fn place(&self, agent: usize, knot: usize) -> [f64; 3] {
        let at = agent * self.knot_count + knot;
        [self.axes[0][at], self.axes[1][at], self.axes[2].get(at).copied().unwrap_or(0.0)]
    }

    /// What agent i is away from agent j at a knot.
    pub(crate) fn apart(&self, i: usize, j: usize, knot: usize) -> [f64; 3] {
        let [a, b] = [self.place(i, knot), self.place(j, knot)];
        [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
    }

    /// Adds `weight[axis] · bump` to an agent's path from knot `start` on.
    pub(crate) fn push(&mut self, agent: usize, start: usize, bump: &[f64], weight: [f64; 3]) {
        for (axis, weight) in weight.into_iter().enumerate().take(self.axis_count) {
            let path = &mut self.axes[axis][agent * self.knot_count + start..][..bump.len()];
            path.iter_mut().zip(bump).for_each(|(place, bump)| *place += weight * bump);
        }
    }

    /// The farthest that anyone is from where `other` has them, squared.
    pub(crate) fn greatest_shift_squared(&self, other: &Self) -> f64 {
        let mut greatest: f64 = 0.0;
        for at in 0..self.agent_count * self.knot_count {
            let mut shift = 0.0;
            for axis in 0..self.axis_count {
                let change = self.axes[axis][at] - other.axes[axis][at];
                shift += change * change;
            }
            greatest = greatest.max(shift);
        }
        greatest
    }
}
