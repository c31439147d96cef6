//! Bins of the plane, and what their agents want on average.
//!
//! Borders are soft: everybody belongs to the four bins whose middles are around, the more the nearer. Where they are sharp, what is
//! shared jumps whenever somebody crosses one, and crowds tremble: they ran twice as roughly with feedback as without.

use crate::slots::Slots;
use crate::wishes::Wishes;

/// Means by bin; its buffers serve every call.
#[derive(Clone, Debug)]
pub struct Bins {
    slots: Slots,
    /// The numbers of each agent's bins, and how much it belongs to them: 1 in all.
    of_agent: Vec<[(u32, f64); 4]>,
    /// By bin: how much belongs to it, and the sums of ex, ey and speed; then their means.
    sums: Vec<[f64; 4]>,
}

impl Bins {
    pub fn new(agent_count: usize) -> Self {
        let most = 4 * agent_count;
        Self { slots: Slots::new(most), of_agent: vec![[(0, 0.0); 4]; agent_count], sums: vec![[0.0; 4]; most] }
    }

    /// Sorts agents into bins of `bin_size` and looks what they want there.
    pub fn average(&mut self, x: &[f64], y: &[f64], bin_size: f64, wishes: &Wishes) {
        self.slots.clear();
        let wishes = wishes.ex.iter().zip(&wishes.ey).zip(&wishes.speed);
        for (bins, ((x, y), ((ex, ey), speed))) in self.of_agent.iter_mut().zip(x.iter().zip(y).zip(wishes)) {
            let ([column, across], [row, along]) = (before_and_share(*x, bin_size), before_and_share(*y, bin_size));
            let corners = [(0, 0), (1, 0), (0, 1), (1, 1)];
            *bins = corners.map(|(right, up)| {
                let part = |share: f64, is_behind: i64| if is_behind == 1 { share } else { 1.0 - share };
                let weight = part(across, right) * part(along, up);
                let known = self.slots.count();
                let number = self.slots.number((row as i64 + up) << 32 ^ (column as i64 + right) & 0xFFFF_FFFF);
                let sums = &mut self.sums[number];
                if number == known {
                    *sums = [0.0; 4];
                }
                for (sum, term) in sums.iter_mut().zip([1.0, *ex, *ey, *speed]) {
                    *sum += weight * term;
                }
                (number as u32, weight)
            });
        }
        for [weight, terms @ ..] in &mut self.sums[..self.slots.count()] {
            // Whoever stands in the very middle of one bin belongs to no other.
            let per_weight = if *weight > 0.0 { 1.0 / *weight } else { 0.0 };
            for term in terms {
                *term *= per_weight;
            }
        }
    }

    /// Moves wishes toward the means by shares of the way: the direction, turned only, and the speed.
    pub fn share(&self, [along, fast]: [f64; 2], wishes: &mut Wishes) {
        let toward = |own: f64, mean: f64, share: f64| own + share * (mean - own);
        let own = wishes.ex.iter_mut().zip(&mut wishes.ey).zip(&mut wishes.speed);
        for (bins, ((ex, ey), speed)) in self.of_agent.iter().zip(own) {
            let mean = bins.iter().fold([0.0; 3], |mean, (bin, weight)| {
                let [_, x, y, speed] = self.sums[*bin as usize];
                [mean[0] + weight * x, mean[1] + weight * y, mean[2] + weight * speed]
            });
            let (x, y) = (toward(*ex, mean[0], along), toward(*ey, mean[1], along));
            let length = (x * x + y * y).sqrt();
            if length > 0.0 {
                (*ex, *ey) = (x / length, y / length);
            }
            *speed = toward(*speed, mean[2], fast);
        }
    }
}

/// The last bin whose middle is not beyond a coordinate, and how far it is from there to the next middle, 0–1.
fn before_and_share(along: f64, bin_size: f64) -> [f64; 2] {
    let bins = along / bin_size - 0.5;
    [bins.floor(), bins - bins.floor()]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn shared(x: &[f64], wishes: &Wishes) -> Wishes {
        let mut bins = Bins::new(x.len());
        let mut shared = wishes.clone();
        bins.average(x, &vec![0.2; x.len()], 1.0, wishes);
        bins.share([0.25, 0.5], &mut shared);
        shared
    }

    #[test]
    fn who_is_alone_wants_what_it_wanted() {
        let wishes = Wishes { ex: vec![0.6, 1.0], ey: vec![0.8, 0.0], speed: vec![3.0, 1.0] };
        let shared = shared(&[0.3, 7.7], &wishes);
        let lists = [(shared.ex, wishes.ex), (shared.ey, wishes.ey), (shared.speed, wishes.speed)];
        // Sums of four terms with weights that are 1 in all.
        assert!(lists.iter().all(|(shared, own)| shared.iter().zip(own).all(|(shared, own)| (shared - own).abs() < 8e-15)));
    }

    #[test]
    fn nothing_jumps_where_somebody_crosses_a_border() {
        let wishes = Wishes { ex: vec![1.0, 0.0, 0.0, -1.0], ey: vec![0.0, 1.0, -1.0, 0.0], speed: vec![4.0, 0.0, 1.0, 2.0] };
        let mut before = shared(&[0.0, 0.3, 1.2, 1.9], &wishes);
        for k in 1..=400 {
            let after = shared(&[0.005 * f64::from(k), 0.3, 1.2, 1.9], &wishes);
            // Weights change by 0.005: a mean by that times 4, the range of speeds, over 0.2, the least weight beside it, and the way
            // between two means by that times 4.
            let most = 0.5 * (0.005 * 4.0 / 0.2 + 0.005 * 4.0);
            assert!(before.speed.iter().zip(&after.speed).all(|(before, after)| (before - after).abs() < most), "{k}");
            before = after;
        }
    }
}
