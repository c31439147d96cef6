//! From what the person says to the weighted graph at one formation.

use super::delaunay::propose;
use super::{Adjacency, AdjacencySpec, Base, Tie, Weights};
use crate::error::Error;
use crate::formation::Formation;
use crate::order;

/// Ties by groups and by hand at one keyframe, before those of one pair are merged; proposed ties are not counted.
pub const TIE_LIMIT: usize = 50_000;

/// A group of at most this many agents ties every pair.
pub const COMPLETE_GROUP_LIMIT: usize = 60;

/// A distance below this fraction of the median counts as this fraction, or one coincident pair makes the weights infinite.
const SHORTEST_RELATIVE_DISTANCE: f64 = 1e-3;

/// A group whose agents belong together.
#[derive(Clone, Debug, PartialEq)]
pub struct GroupTie {
    /// Its set, ascending, each agent once.
    pub members: Vec<u32>,
    /// What it multiplies the ties among them by.
    pub factor: f64,
}

/// A graph was asked for that has more ties than one keyframe may have.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TooManyTies {
    /// How many there would be, at least.
    pub count: usize,
}

impl TooManyTies {
    /// The refusal of the keyframe that asked for them.
    pub fn at(self, keyframe: usize) -> Error {
        Error::TooManyTies { keyframe, count: self.count, limit: TIE_LIMIT }
    }
}

/// The graph at one formation: base, then `group_ties` (outer first), then ties, then cuts. Each step adds a tie with its factor or
/// multiplies the factor of one that is there.
///
/// Weight `inverse` is factor / max(distance, 1e-3 · median), the median over the non-zero distances of this graph's ties (the mean
/// of the middle two of an even number), 1/m; without any such distance it is the factor, as `unit` always is.
pub fn build(formation: &Formation, spec: &AdjacencySpec, group_ties: &[GroupTie]) -> Result<Adjacency, TooManyTies> {
    let mut steps = expand(formation, spec, group_ties)?;
    if spec.base == Base::Delaunay {
        // First, so that the factors of one pair multiply in the order of the steps.
        steps.splice(0..0, propose(formation).into_iter().map(|pair| (pair, 1.0)));
    }
    order::sort_by_key(&mut steps, |step| order::key_of_pair(step.0));
    let mut cuts: Vec<(u32, u32)> = spec.cuts.iter().map(|&(a, b)| ascending(a, b)).collect();
    order::sort_by_key(&mut cuts, |cut| order::key_of_pair(*cut));
    let mut ties: Vec<Tie> = steps
        .chunk_by(|p, q| p.0 == q.0)
        .filter(|steps| cuts.binary_search(&steps[0].0).is_err())
        .map(|steps| {
            let ((a, b), factor) = (steps[0].0, steps.iter().map(|step| step.1).product());
            Tie { a, b, factor, weight: factor }
        })
        .collect();
    if spec.weights == Weights::Inverse {
        divide_by_distance(formation, &mut ties);
    }
    Ok(Adjacency::new(formation.agent_count(), ties))
}

/// How many ties groups and hand make at one formation, as [`TIE_LIMIT`] counts them.
pub fn expanded_tie_count(formation: &Formation, spec: &AdjacencySpec, group_ties: &[GroupTie]) -> Result<usize, TooManyTies> {
    expand(formation, spec, group_ties).map(|steps| steps.len())
}

type Step = ((u32, u32), f64);

fn expand(formation: &Formation, spec: &AdjacencySpec, group_ties: &[GroupTie]) -> Result<Vec<Step>, TooManyTies> {
    let mut steps = Vec::new();
    for group in group_ties {
        let members = &group.members;
        let mut tie = |a: u32, b: u32| push(&mut steps, (ascending(members[a as usize], members[b as usize]), group.factor));
        if members.len() <= COMPLETE_GROUP_LIMIT {
            for b in 0..members.len() as u32 {
                (0..b).try_for_each(|a| tie(a, b))?;
            }
        } else {
            for_each_pair_within_two(members.len(), &propose(&formation.only(members)), tie)?;
        }
    }
    for &(a, b, factor) in &spec.ties {
        push(&mut steps, (ascending(a, b), factor))?;
    }
    Ok(steps)
}

fn push(steps: &mut Vec<Step>, step: Step) -> Result<(), TooManyTies> {
    steps.push(step);
    if steps.len() > TIE_LIMIT { Err(TooManyTies { count: steps.len() }) } else { Ok(()) }
}

/// Visits every pair at graph distance 1 or 2 once, and stops when the visitor refuses: a star has quadratically many.
fn for_each_pair_within_two<E>(count: usize, edges: &[(u32, u32)], mut visit: impl FnMut(u32, u32) -> Result<(), E>) -> Result<(), E> {
    let mut neighbors: Vec<Vec<u32>> = vec![Vec::new(); count];
    for &(a, b) in edges {
        neighbors[a as usize].push(b);
        neighbors[b as usize].push(a);
    }
    let mut seen_by = vec![u32::MAX; count];
    for a in 0..count as u32 {
        let direct = &neighbors[a as usize];
        let over_one = direct.iter().flat_map(|&middle| &neighbors[middle as usize]);
        for &b in direct.iter().chain(over_one) {
            if b > a && seen_by[b as usize] != a {
                seen_by[b as usize] = a;
                visit(a, b)?;
            }
        }
    }
    Ok(())
}

fn divide_by_distance(formation: &Formation, ties: &mut [Tie]) {
    let places = formation.places();
    let distances: Vec<f64> = ties.iter().map(|tie| places.distance(tie.a as usize, tie.b as usize)).collect();
    let weights = weights_by_distance(ties.iter().map(|tie| tie.factor).collect(), &distances);
    ties.iter_mut().zip(weights).for_each(|(tie, weight)| tie.weight = weight);
}

/// Factors over distances, with the floor; without any distance above 0 the factors themselves.
pub(super) fn weights_by_distance(factors: Vec<f64>, distances: &[f64]) -> Vec<f64> {
    let Some(median) = median(distances.iter().copied().filter(|&distance| distance > 0.0).collect()) else { return factors };
    factors.into_iter().zip(distances).map(|(factor, distance)| factor / distance.max(SHORTEST_RELATIVE_DISTANCE * median)).collect()
}

fn median(mut values: Vec<f64>) -> Option<f64> {
    let middle = values.len() / 2;
    let is_even = values.len().is_multiple_of(2);
    if values.is_empty() {
        return None;
    }
    order::sort_by_key(&mut values, |value| u128::from(order::of_real(*value)));
    Some(if is_even { f64::midpoint(values[middle - 1], values[middle]) } else { values[middle] })
}

fn ascending(a: u32, b: u32) -> (u32, u32) {
    (a.min(b), a.max(b))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn square() -> Formation {
        Formation::from(vec![[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0]])
    }

    fn check(spec: &AdjacencySpec, groups: &[GroupTie], expected: &[(u32, u32, f64, f64)]) {
        let adjacency = build(&square(), spec, groups).unwrap();
        let ties: Vec<_> = adjacency.ties().iter().map(|tie| (tie.a, tie.b, tie.factor, tie.weight)).collect();
        assert_eq!(ties, expected);
    }

    fn group(members: &[u32], factor: f64) -> GroupTie {
        GroupTie { members: members.to_vec(), factor }
    }

    #[test]
    fn a_weight_is_the_factor_over_the_distance() {
        check(&AdjacencySpec::default(), &[], &[(0, 1, 1.0, 0.5), (0, 3, 1.0, 0.5), (1, 2, 1.0, 0.5), (2, 3, 1.0, 0.5)]);
    }

    #[test]
    fn unit_weights_are_the_factors() {
        let spec = AdjacencySpec { weights: Weights::Unit, base: Base::None, ties: vec![(2, 0, 7.0)], ..AdjacencySpec::default() };
        check(&spec, &[], &[(0, 2, 7.0, 7.0)]);
    }

    #[test]
    fn each_step_adds_or_multiplies_and_a_cut_comes_last() {
        let spec = AdjacencySpec {
            weights: Weights::Unit,
            base: Base::Delaunay,
            ties: vec![(1, 0, 3.0), (1, 3, 5.0)],
            cuts: vec![(3, 2), (2, 0)],
            ..AdjacencySpec::default()
        };
        let groups = [group(&[0, 1, 2], 10.0), group(&[0, 1], 0.5)];
        check(&spec, &groups, &[(0, 1, 15.0, 15.0), (0, 3, 1.0, 1.0), (1, 2, 10.0, 10.0), (1, 3, 5.0, 5.0)]);
    }

    #[test]
    fn coincident_agents_are_a_thousandth_of_the_median_apart() {
        let formation = Formation::from(vec![[0.0, 0.0], [4.0, 0.0], [0.0, 4.0], [0.0, 0.0]]);
        let adjacency = build(&formation, &AdjacencySpec::default(), &[]).unwrap();
        let twin = adjacency.ties().iter().find(|tie| (tie.a, tie.b) == (0, 3)).unwrap();
        // Non-zero distances 4, 4, 4√2: the median is 4.
        assert!((twin.weight - 1.0 / 4e-3).abs() < 1e-12);
    }

    #[test]
    fn agents_all_in_one_place_weigh_their_factors() {
        let adjacency = build(&Formation::from(vec![[1.0, 1.0]; 3]), &AdjacencySpec::default(), &[group(&[0, 1], 10.0)]).unwrap();
        let weights: Vec<f64> = adjacency.ties().iter().map(|tie| tie.weight).collect();
        assert_eq!(weights, [10.0, 1.0]);
    }

    #[test]
    fn a_large_group_ties_neighbors_and_their_neighbors() {
        let in_a_row = |count: u32| Formation::from((0..count).map(|i| [f64::from(i), 0.0]).collect::<Vec<_>>());
        let spec = AdjacencySpec { base: Base::None, ..AdjacencySpec::default() };
        for (count, expected) in [(60, 60 * 59 / 2), (61, 60 + 59)] {
            let everyone = [group(&(0..count).collect::<Vec<_>>(), 2.0)];
            assert_eq!(build(&in_a_row(count), &spec, &everyone).unwrap().ties().len(), expected);
            assert_eq!(expanded_tie_count(&in_a_row(count), &spec, &everyone), Ok(expected));
        }
    }

    #[test]
    fn a_star_of_thousands_is_refused_without_being_built() {
        let formation = Formation::from(vec![[0.0, 0.0]; 5_000]);
        let everyone = [group(&(0..5_000).collect::<Vec<_>>(), 2.0)];
        assert_eq!(build(&formation, &AdjacencySpec::default(), &everyone), Err(TooManyTies { count: TIE_LIMIT + 1 }));
    }

    #[test]
    fn the_limit_itself_is_admitted() {
        // 317 agents have 50,086 pairs.
        let formation = Formation::from((0..317).map(|i| [f64::from(i), 0.0]).collect::<Vec<_>>());
        let pairs: Vec<_> = (0..317).flat_map(|b| (0..b).map(move |a| (a, b, 1.0))).take(TIE_LIMIT + 1).collect();
        let with = |count: usize| AdjacencySpec { base: Base::None, ties: pairs[..count].to_vec(), ..AdjacencySpec::default() };
        assert_eq!(build(&formation, &with(TIE_LIMIT), &[]).unwrap().ties().len(), TIE_LIMIT);
        assert!(build(&formation, &with(TIE_LIMIT + 1), &[]).is_err());
    }
}
