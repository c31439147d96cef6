//! Which group an agent is in, where a tree of them holds it.

use crate::edits::NO_GROUP;
use crate::scene::Group;

/// By agent the group whose own member it is, numbered from 0 in the order of the tree.
pub(super) fn innermost_groups(groups: &[Group], agent_count: usize) -> Vec<u32> {
    fn number(groups: &[Group], next: &mut u32, of_agent: &mut [u32]) {
        for group in groups {
            for agent in &group.members {
                of_agent[*agent as usize] = *next;
            }
            *next += 1;
            number(&group.children, next, of_agent);
        }
    }
    let mut of_agent = vec![NO_GROUP; agent_count];
    number(groups, &mut 0, &mut of_agent);
    of_agent
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_agent_is_in_the_group_whose_own_member_it_is() {
        let group = |members: &[u32], children: Vec<Group>| Group { members: members.to_vec(), children, ..Group::default() };
        let nested = group(&[6], vec![group(&[4, 5], vec![]), group(&[7], vec![])]);
        assert_eq!(innermost_groups(&[group(&[0, 1, 2, 3], vec![]), nested], 9), [0, 0, 0, 0, 2, 2, 1, 3, NO_GROUP]);
    }
}
