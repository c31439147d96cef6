//! Which agents a set of ties connects.

/// Disjoint sets of agents, joined tie by tie.
pub(crate) struct Components {
    parent: Vec<u32>,
}

impl Components {
    /// Every agent by itself.
    pub(crate) fn new(agent_count: usize) -> Self {
        Self { parent: (0..agent_count as u32).collect() }
    }

    /// Joins the components of two agents; whether they were two.
    pub(crate) fn join(&mut self, a: u32, b: u32) -> bool {
        let (a, b) = (self.root(a), self.root(b));
        // Toward the lower root, so that the trees do not depend on the order of a and b.
        self.parent[a.max(b) as usize] = a.min(b);
        a != b
    }

    fn root(&mut self, mut agent: u32) -> u32 {
        while self.parent[agent as usize] != agent {
            let above = self.parent[self.parent[agent as usize] as usize];
            self.parent[agent as usize] = above;
            agent = above;
        }
        agent
    }
    /// Everybody by component, each list ascending, lists by their first.
    pub(crate) fn lists(mut self) -> Vec<Vec<u32>> {
        let mut lists: Vec<Vec<u32>> = vec![Vec::new(); self.parent.len()];
        for agent in 0..self.parent.len() as u32 {
            lists[self.root(agent) as usize].push(agent);
        }
        lists.retain(|list| !list.is_empty());
        lists
    }
}
