//! Groups as paths of names, `Band/Brass`, and back.

use std::collections::{BTreeMap, BTreeSet};

use crate::error::Error;
use crate::scene::validate::length;
use crate::scene::{Group, limits, shown};

const SEPARATOR: char = '/';

/// The tree of the groups that the agents' paths name, in order of first appearance; an empty path is no group.
pub(super) fn tree<'a>(paths: impl Iterator<Item = &'a str>) -> Result<Vec<Group>, Error> {
    let mut nodes = vec![Node::default()];
    let mut children: BTreeMap<(usize, &str), usize> = BTreeMap::new();
    for (agent, path) in (0_u32..).zip(paths) {
        let mut node = 0;
        for name in path.split(SEPARATOR).map(str::trim).filter(|name| !name.is_empty()) {
            let depth = nodes[node].depth + 1;
            if depth > limits::GROUP_DEPTH {
                return Err(Error::GroupsTooDeep { limit: limits::GROUP_DEPTH, place: format!("group {}", shown(path)) });
            }
            let parent = node;
            node = *children.entry((parent, name)).or_insert(nodes.len());
            if node == nodes.len() {
                length(name, limits::NAME_CHARACTERS, "column group")?;
                nodes.push(Node { name, depth, ..Node::default() });
                nodes[parent].children.push(node);
            }
        }
        nodes[node].members.push(agent);
    }
    Ok(nodes[0].children.iter().map(|&child| group(&nodes, child)).collect())
}

#[derive(Default)]
struct Node<'a> {
    name: &'a str,
    depth: usize,
    members: Vec<u32>,
    children: Vec<usize>,
}

fn group(nodes: &[Node], index: usize) -> Group {
    let node = &nodes[index];
    Group {
        name: node.name.to_owned(),
        members: node.members.clone(),
        children: node.children.iter().map(|&child| group(nodes, child)).collect(),
        ..Group::default()
    }
}

/// Each agent's path, empty for none, and whether any group had to take another name to be told apart.
pub(super) fn paths(groups: &[Group], agent_count: usize) -> (Vec<String>, bool) {
    let mut paths = Paths { by_agent: vec![String::new(); agent_count], has_renamed: false };
    paths.level(groups, "");
    (paths.by_agent, paths.has_renamed)
}

struct Paths {
    by_agent: Vec<String>,
    has_renamed: bool,
}

impl Paths {
    fn level(&mut self, groups: &[Group], parent: &str) {
        let mut taken = BTreeSet::new();
        for group in groups {
            let name = distinct(&group.name, &taken);
            self.has_renamed |= name != group.name;
            let path = if parent.is_empty() { name.clone() } else { format!("{parent}{SEPARATOR}{name}") };
            taken.insert(name);
            for &member in &group.members {
                self.by_agent[member as usize].clone_from(&path);
            }
            self.level(&group.children, &path);
        }
    }
}

/// The name without what a path cannot hold, numbered when a group beside it has the same.
fn distinct(name: &str, taken: &BTreeSet<String>) -> String {
    let plain = name.replace(SEPARATOR, "-");
    let plain = if plain.trim().is_empty() { "group" } else { plain.trim() };
    let numbered = (2..).map(|number| {
        let ending = format!(" {number}");
        let kept: String = plain.chars().take(limits::NAME_CHARACTERS - ending.len()).collect();
        kept + &ending
    });
    std::iter::once(plain.to_owned()).chain(numbered).find(|name| !taken.contains(name)).expect("numbers do not end")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn named(name: &str, members: &[u32], children: Vec<Group>) -> Group {
        Group { name: name.to_owned(), members: members.to_vec(), children, ..Group::default() }
    }

    #[test]
    fn paths_make_a_tree_in_order_of_appearance() {
        let tree = tree(["Band/Brass", "", "Band", "Drums", "Band/Brass"].into_iter()).unwrap();
        assert_eq!(tree, [named("Band", &[2], vec![named("Brass", &[0, 4], vec![])]), named("Drums", &[3], vec![])]);
    }

    #[test]
    fn a_tree_is_its_paths() {
        let groups = [named("Band", &[2], vec![named("Brass", &[0, 3], vec![])]), named("Drums", &[4], vec![])];
        let expected = ["Band/Brass", "", "Band", "Band/Brass", "Drums"].map(str::to_owned);
        assert_eq!(paths(&groups, 5), (expected.to_vec(), false));
    }

    #[test]
    fn groups_that_a_path_cannot_tell_apart_are_renamed() {
        let groups = [named("A/B", &[0], vec![]), named("A-B", &[1], vec![]), named("", &[2], vec![]), named(" ", &[3], vec![])];
        let expected = ["A-B", "A-B 2", "group", "group 2"].map(str::to_owned);
        assert_eq!(paths(&groups, 4), (expected.to_vec(), true));
    }
}
