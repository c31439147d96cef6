//! Agents in the order of their cells, so that those near each other lie side by side in memory.

/// Nearer than this two are in one place; its square is still a number of single precision.
const LEAST_WAY: f32 = 1e-12;

/// A list a property, an entry an agent.
#[derive(Clone, Debug)]
pub struct Ranks {
    /// Who it is.
    agent: Vec<u32>,
    pub x: Vec<f64>,
    pub y: Vec<f64>,
    /// How much larger a body is than usual.
    pub girth: Vec<f64>,
    /// The subgroup.
    pub group: Vec<u32>,
    /// What the pushes sum up to.
    pub fx: Vec<f64>,
    pub fy: Vec<f64>,
}

impl Ranks {
    pub fn new(agent_count: usize) -> Self {
        let zeros = || vec![0.0; agent_count];
        let (agent, group) = (vec![0; agent_count], vec![0; agent_count]);
        Self { agent, x: zeros(), y: zeros(), girth: zeros(), group, fx: zeros(), fy: zeros() }
    }

    /// Falls in line anew, nobody pushed.
    pub fn fall_in(&mut self, order: &[u32], [x, y, girth]: [&[f64]; 3], group: &[u32]) {
        self.agent.copy_from_slice(order);
        for (to, from) in [(&mut self.x, x), (&mut self.y, y), (&mut self.girth, girth)] {
            to.iter_mut().zip(order).for_each(|(to, agent)| *to = from[*agent as usize]);
        }
        self.group.iter_mut().zip(order).for_each(|(to, agent)| *to = group[*agent as usize]);
        self.fx.fill(0.0);
        self.fy.fill(0.0);
    }

    /// What everybody is pushed by, with who that is.
    pub fn forces(&self) -> impl Iterator<Item = (usize, [f64; 2])> {
        self.agent.iter().zip(self.fx.iter().zip(&self.fy)).map(|(agent, (fx, fy))| (*agent as usize, [*fx, *fy]))
    }

    /// The way from one to another. Two in one place go apart along x, the lower number first.
    #[inline]
    pub fn way(&self, here: usize, there: usize) -> [f32; 2] {
        let [x, y] = [self.x[here] - self.x[there], self.y[here] - self.y[there]].map(|along| along as f32);
        if x.abs() + y.abs() > LEAST_WAY {
            [x, y]
        } else {
            [if self.agent[here] < self.agent[there] { -LEAST_WAY } else { LEAST_WAY }, 0.0]
        }
    }
}
