//! How much where agents are tells of what they do: mutual information, in bits (paper D, equations 11–17).
//!
//! It is the plug-in estimate, which few agents in many bins raise: numbers compare only at equal N, R and K.

use crate::columns::Columns;

/// Counts agents; its buffers serve every call.
#[derive(Clone, Debug)]
pub struct Information {
    /// By column, then by class.
    joint: Vec<u32>,
    of_column: Vec<u32>,
    of_class: Vec<u32>,
    /// n log₂ n by n.
    terms: Vec<f64>,
}

impl Information {
    /// Of so many agents in at most so many classes.
    pub fn new(agent_count: usize, class_count: u32) -> Self {
        Self {
            joint: vec![0; agent_count * class_count as usize],
            of_column: vec![0; agent_count],
            of_class: vec![0; class_count as usize],
            terms: (0..=agent_count).map(|n| n as f64 * libm::log2(n.max(1) as f64)).collect(),
        }
    }

    /// The mean of I(X, class) and I(Y, class).
    pub fn of(&mut self, columns: [&Columns; 2], classes: &[u32]) -> f64 {
        0.5 * (self.along(columns[0], classes) + self.along(columns[1], classes))
    }

    /// Σ p(i, j) log₂ (p(i, j) / p(i) p(j)), by counts.
    fn along(&mut self, columns: &Columns, classes: &[u32]) -> f64 {
        let class_count = self.of_class.len();
        let joint = &mut self.joint[..columns.count() * class_count];
        joint.fill(0);
        for (column, class) in columns.of_agent().iter().zip(classes) {
            joint[*column as usize * class_count + *class as usize] += 1;
        }
        let of_column = &mut self.of_column[..columns.count()];
        self.of_class.fill(0);
        for (of_column, joint) in of_column.iter_mut().zip(joint.chunks_exact(class_count)) {
            *of_column = joint.iter().sum();
            self.of_class.iter_mut().zip(joint).for_each(|(of_class, joint)| *of_class += joint);
        }
        let sum = |counts: &[u32]| counts.iter().map(|n| self.terms[*n as usize]).sum::<f64>();
        let count = classes.len();
        let bits = sum(joint) - sum(of_column) - sum(&self.of_class);
        // Round-off may leave a hair below zero.
        ((bits + self.terms[count]) / count.max(1) as f64).max(0.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn check(x: &[f64], classes: &[u32], expected: f64) {
        let mut columns = [Columns::new(x.len()), Columns::new(x.len())];
        columns[0].sort(x, 1.0);
        columns[1].sort(&vec![0.0; x.len()], 1.0);
        let found = Information::new(x.len(), 4).of([&columns[0], &columns[1]], classes);
        // Half the sum of I(X, class) and of nothing, for all have one y; three sums of a few terms of at most 8.
        assert!((found - expected / 2.0).abs() < 1e-14, "{x:?} {classes:?}: {found}");
    }

    #[test]
    fn it_is_the_bits_that_a_place_tells_of_a_class() {
        check(&[0.5, 1.5, 2.5, 3.5], &[0, 1, 2, 3], 2.0);
        check(&[0.5, 0.5, 1.5, 1.5], &[0, 0, 1, 1], 1.0);
        check(&[0.5, 0.5, 1.5, 1.5], &[0, 1, 0, 1], 0.0);
        check(&[0.5, 0.5, 1.5, -7.5], &[2, 2, 2, 2], 0.0);
        // Three of four tell: H(class) − H(class | place) = 0.8113 − 0.5.
        check(&[0.5, 0.5, 1.5, 1.5], &[0, 0, 0, 1], 0.811_278_124_459_132_8 - 0.5);
        check(&[], &[], 0.0);
    }
}
