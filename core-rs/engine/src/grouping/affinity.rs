//! Groups of those who keep their distances on the way to the next formation, by affinity propagation (paper D, section 3.4).
//!
//! Equation 20 is printed as a similarity but grows with the difference: it is negated here.

use eigenform_dense::messages::Messages;

use super::Branch;
use crate::formation::Formation;
use crate::order;

/// How much of a message is kept from round to round.
const DAMPING: f64 = 0.9;

/// So many rounds without change, and it has settled.
const STEADY_ROUNDS: u32 = 15;

/// After so many rounds what there is counts.
const MOST_ROUNDS: u32 = 500;

/// Messages passed in a step: some ten milliseconds in a browser.
const STEP_MESSAGES: usize = 1 << 22;

/// Of more agents so many are grouped, evenly by index, and the others join whom they resemble most: three squares of numbers of this
/// size are 96 MB.
pub const MOST_SAMPLED: usize = 2_000;

/// Distances that change by less, relative to the extent, are kept: what is left of a turn is round-off.
const KEPT: f64 = 1e-9;

/// How far apart two agents are.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Metric {
    /// As the crow flies: a group that merely turns stays one.
    #[default]
    Euclidean,
    /// Along the axes, as in the paper.
    Manhattan,
}

/// How readily agents stand for groups: the similarity of an agent to itself. The greater, the more groups.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Preference {
    /// So many times the median of all similarities, those to oneself included as 0; of their mean where most are 0.
    OfMedian(f64),
    /// Square meters; similarities are at most 0.
    Of(f64),
}

/// Looking for groups between two formations of the same agents.
pub struct AffinityJob {
    agents: Vec<u32>,
    similarity: Similarity,
    /// Of `agents`, those that are grouped first.
    sample: Vec<u32>,
    preference: f64,
    /// None where nothing is to be found out.
    messages: Option<Messages>,
    stands: Vec<bool>,
    rounds: u32,
    steady: u32,
}

struct Similarity {
    ends: [Formation; 2],
    metric: Metric,
    kept: f64,
}

impl AffinityJob {
    /// Of `agents` (any order, each once); the formations have the same agents.
    pub fn new(source: &Formation, target: &Formation, agents: &[u32], metric: Metric, preference: Preference) -> Self {
        let mut agents = agents.to_vec();
        order::sort_by_key(&mut agents, |agent| u128::from(*agent));
        agents.dedup();
        let kept = KEPT * source.extent().max(target.extent());
        let similarity = Similarity { ends: [source.only(&agents), target.only(&agents)], metric, kept };
        let size = agents.len().min(MOST_SAMPLED);
        let sample: Vec<u32> = (0..size).map(|index| (index * agents.len() / size) as u32).collect();
        let mut table = similarity.table(&sample);
        let preference = preference.among(&table);
        let is_plain = size < 2 || table.iter().enumerate().all(|(at, s)| at % (size + 1) == 0 || *s == table[1]);
        let messages = (!is_plain).then(|| {
            tell_apart(&mut table, size, preference);
            Messages::new(size, table)
        });
        // Sorted out at once: all alike are one group, or one each where that is preferred.
        let stands = if is_plain && size > 1 && preference > similarity.of(0, 1) { vec![true; size] } else { vec![false; size] };
        Self { agents, similarity, sample, preference, messages, stands, rounds: 0, steady: 0 }
    }

    /// The preference used, square meters.
    pub fn preference(&self) -> f64 {
        self.preference
    }

    /// Passes messages for a moment; how far it is, 1 when it is done. Nobody knows how many rounds it takes.
    pub fn step(&mut self) -> f64 {
        let Some(messages) = &mut self.messages else { return 1.0 };
        let size = self.sample.len();
        for _ in 0..(STEP_MESSAGES / (size * size)).max(1) {
            messages.pass(DAMPING);
            let stands: Vec<bool> = messages.evidence(DAMPING).map(|evidence| evidence > 0.0).collect();
            self.steady = if stands == self.stands { self.steady + 1 } else { 1 };
            self.stands = stands;
            self.rounds += 1;
            let has_settled = self.rounds > STEADY_ROUNDS && self.steady >= STEADY_ROUNDS && self.stands.contains(&true);
            if has_settled || self.rounds == MOST_ROUNDS {
                return 1.0;
            }
        }
        f64::from(self.rounds) / f64::from(self.rounds + 100)
    }

    /// The groups, once it is done: every agent in one, agents ascending, groups by their lowest.
    pub fn groups(&self) -> Vec<Branch> {
        let leaders = self.leaders();
        let mut numbers = vec![None; leaders.len()];
        let mut groups: Vec<Vec<u32>> = Vec::new();
        for (local, agent) in (0..).zip(&self.agents) {
            let Some(leader) = self.similarity.nearest(local, &leaders) else { continue };
            let number = *numbers[leader].get_or_insert(groups.len());
            if number == groups.len() {
                groups.push(Vec::new());
            }
            groups[number].push(*agent);
        }
        groups.into_iter().map(Branch::leaf).collect()
    }

    /// Who stands for a group, after all in a group have had a say in who resembles them most.
    fn leaders(&self) -> Vec<u32> {
        let mut leaders: Vec<u32> = self.sample.iter().zip(&self.stands).filter(|(_, stands)| **stands).map(|(local, _)| *local).collect();
        if leaders.is_empty() {
            leaders.extend(self.likeliest());
        }
        let mut groups = vec![Vec::new(); leaders.len()];
        for &local in &self.sample {
            if let Some(group) = self.similarity.nearest(local, &leaders) {
                groups[group].push(local);
            }
        }
        groups.iter().filter_map(|group| self.similarity.middle(group)).collect()
    }

    /// Where it settles on nobody: the one for whom most speaks.
    fn likeliest(&self) -> Option<u32> {
        let Some(messages) = &self.messages else { return self.sample.first().copied() };
        let evidence = messages.evidence(DAMPING).zip(&self.sample);
        evidence.reduce(|best, other| if other.0 > best.0 { other } else { best }).map(|(_, local)| *local)
    }
}

impl Similarity {
    /// Minus the squared change of the distance of two agents, square meters.
    fn of(&self, a: u32, b: u32) -> f64 {
        let [before, after] = [0, 1].map(|end| {
            let places = self.ends[end].places();
            let away = places.at(a as usize) - places.at(b as usize);
            match self.metric {
                Metric::Euclidean => away.length(),
                Metric::Manhattan => away.abs().element_sum(),
            }
        });
        let change = before - after;
        if change.abs() <= self.kept { 0.0 } else { -change * change }
    }

    /// Row by row, 0 to oneself.
    fn table(&self, agents: &[u32]) -> Vec<f64> {
        let size = agents.len();
        let mut table = vec![0.0; size * size];
        for (row, a) in agents.iter().enumerate() {
            for (column, b) in agents.iter().enumerate().take(row) {
                let similarity = self.of(*a, *b);
                table[row * size + column] = similarity;
                table[column * size + row] = similarity;
            }
        }
        table
    }

    /// Which of the leaders an agent resembles most: itself if it is one; of equals the one it stands nearest to, else the first.
    fn nearest(&self, agent: u32, leaders: &[u32]) -> Option<usize> {
        let likeness = |leader: u32| if leader == agent { f64::INFINITY } else { self.of(agent, leader) };
        let ranked = leaders.iter().map(|leader| (likeness(*leader), -self.apart(agent, *leader))).enumerate();
        ranked.reduce(|best, other| if other.1 > best.1 { other } else { best }).map(|(index, _)| index)
    }

    /// How far apart two agents are at both ends together, meters.
    fn apart(&self, a: u32, b: u32) -> f64 {
        self.ends.iter().map(|end| end.places().at(a as usize).distance(end.places().at(b as usize))).sum()
    }

    /// Whom all of a group resemble most; of equals the first.
    fn middle(&self, group: &[u32]) -> Option<u32> {
        let total = |leader: u32| group.iter().filter(|other| **other != leader).map(|other| self.of(*other, leader)).sum::<f64>();
        let ranked = group.iter().map(|leader| (*leader, total(*leader)));
        ranked.reduce(|best, other| if other.1 > best.1 { other } else { best }).map(|(leader, _)| leader)
    }
}

impl Preference {
    fn among(self, table: &[f64]) -> f64 {
        let times = match self {
            Self::Of(preference) => return preference,
            Self::OfMedian(times) => times,
        };
        if table.is_empty() {
            return 0.0;
        }
        let middle = |rank: usize| ranked(table, rank);
        let median = -f64::midpoint(middle((table.len() - 1) / 2), middle(table.len() / 2));
        times * if median < 0.0 { median } else { table.iter().sum::<f64>() / table.len() as f64 }
    }
}

/// The magnitude of which `rank` others are not greater, by halving: the bits of magnitudes rise with them, and a sort of a million
/// numbers would be kilobytes of code for one of them.
fn ranked(values: &[f64], rank: usize) -> f64 {
    let (mut low, mut high) = (0, f64::MAX.to_bits());
    while low < high {
        let middle = u64::midpoint(low, high);
        let count = values.iter().filter(|value| value.abs().to_bits() <= middle).count();
        if count > rank { high = middle } else { low = middle + 1 }
    }
    f64::from_bits(low)
}

/// Puts the preference on the diagonal, and on all a trace of noise, the same every time: what symmetry makes equal would swing to and
/// fro for ever.
fn tell_apart(table: &mut [f64], size: usize, preference: f64) {
    let mut state = 0_u32;
    for (at, similarity) in table.iter_mut().enumerate() {
        if at % (size + 1) == 0 {
            *similarity = preference;
        }
        state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        let noise = f64::from(state) / f64::from(u32::MAX) - 0.5;
        *similarity += f64::EPSILON * (similarity.abs() + preference.abs()) * noise;
    }
}
