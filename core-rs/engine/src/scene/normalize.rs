//! One way to write what means the same: applied to every scene that is read, before it is checked.

use std::collections::BTreeSet;

use super::Group;
use crate::adjacency::AdjacencySpec;

/// Ties and cuts name the lower agent first; the order of the lists stays.
pub(super) fn normalize_adjacency(spec: &mut AdjacencySpec) {
    for (a, b, _) in &mut spec.ties {
        order(a, b);
    }
    for (a, b) in &mut spec.cuts {
        order(a, b);
    }
}

/// A group leaves to its children the agents they have: its set stays the same.
pub(super) fn normalize_groups(groups: &mut [Group]) {
    for group in groups {
        leave_to_children(group);
    }
}

/// The group's set.
fn leave_to_children(group: &mut Group) -> BTreeSet<u32> {
    let mut set = BTreeSet::new();
    for child in &mut group.children {
        set.append(&mut leave_to_children(child));
    }
    group.members.retain(|agent| !set.contains(agent));
    set.extend(&group.members);
    set
}

fn order(a: &mut u32, b: &mut u32) {
    if a > b {
        std::mem::swap(a, b);
    }
}

#[cfg(test)]
mod tests {
    use super::{Group, normalize_groups};

    #[test]
    fn a_parent_leaves_its_childrens_agents_to_them() {
        let inner = Group { members: vec![2, 1], ..Group::default() };
        let mut groups = [Group { members: vec![3, 1, 0, 2], children: vec![inner.clone()], ..Group::default() }];
        normalize_groups(&mut groups);
        assert_eq!(groups[0].members, [3, 0]);
        assert_eq!(groups[0].children, [inner]);
    }
}
