//! The tree of groups, read by what it ties.

use super::Group;
use crate::adjacency::GroupTie;
use crate::order;

/// What the groups tie, outer before inner and in the order of the document; groups without a tie weight tie nothing.
pub fn group_ties(groups: &[Group]) -> Vec<GroupTie> {
    let mut ties = Vec::new();
    for group in groups {
        if let Some(factor) = group.tie_weight {
            ties.push(GroupTie { members: group.set(), factor });
        }
        ties.extend(group_ties(&group.children));
    }
    ties
}

/// By level from the outermost in: the group of each agent, numbered throughout the tree; none for agents in no group so deep.
pub fn group_levels(groups: &[Group], agent_count: usize) -> Vec<Vec<Option<u32>>> {
    fn fill(groups: &[Group], level: usize, count: &mut u32, levels: &mut Vec<Vec<Option<u32>>>, agent_count: usize) {
        for group in groups {
            if level == levels.len() {
                levels.push(vec![None; agent_count]);
            }
            for agent in group.set() {
                levels[level][agent as usize] = Some(*count);
            }
            *count += 1;
            fill(&group.children, level + 1, count, levels, agent_count);
        }
    }
    let mut levels = Vec::new();
    fill(groups, 0, &mut 0, &mut levels, agent_count);
    levels
}

impl Group {
    /// Its members and its children's sets: ascending, each agent once.
    pub fn set(&self) -> Vec<u32> {
        let mut set = self.members.clone();
        for child in &self.children {
            set.extend(child.set());
        }
        order::sort_by_key(&mut set, |agent| u128::from(*agent));
        set.dedup();
        set
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_group_ties_its_childrens_agents_too_and_comes_before_them() {
        let brass = Group { members: vec![4, 3], tie_weight: Some(2.0), ..Group::default() };
        let drums = Group { members: vec![7], ..Group::default() };
        let band = Group { members: vec![9, 1], tie_weight: Some(10.0), children: vec![brass, drums], ..Group::default() };
        let expected = [GroupTie { members: vec![1, 3, 4, 7, 9], factor: 10.0 }, GroupTie { members: vec![3, 4], factor: 2.0 }];
        assert_eq!(group_ties(&[band]), expected);
    }

    #[test]
    fn levels_go_from_the_outermost_in() {
        let inner = Group { members: vec![2], ..Group::default() };
        let outer = Group { members: vec![0], children: vec![inner], ..Group::default() };
        let other = Group { members: vec![3], ..Group::default() };
        let levels = [vec![Some(0), None, Some(0), Some(2)], vec![None, None, Some(1), None]];
        assert_eq!(group_levels(&[outer, other], 4), levels);
        assert!(group_levels(&[], 4).is_empty());
    }
}
