//! What agents want before anything pushes them.

/// A unit direction e (or none) and a speed v⁰ an agent.
#[derive(Clone, Debug, Default)]
pub struct Wishes {
    pub ex: Vec<f64>,
    pub ey: Vec<f64>,
    pub speed: Vec<f64>,
}

impl Wishes {
    pub fn new(agent_count: usize) -> Self {
        Self { ex: vec![0.0; agent_count], ey: vec![0.0; agent_count], speed: vec![0.0; agent_count] }
    }
}
