//! One way to write what means the same: applied to every scene that is read, before it is checked.

use super::{Group, Track};
use crate::adjacency::AdjacencySpec;
use crate::order::sort_by_key;

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

/// The parts of a transition that keyframes lie in are told what its first part is. The track is valid.
pub(super) fn normalize_segments(track: &mut Track) {
    for pair in track.anchors().windows(2) {
        let [first, rest @ ..] = &mut track.segments[pair[0]..pair[1]] else { continue };
        rest.fill(first.clone());
    }
}

/// The group's set, ascending.
fn leave_to_children(group: &mut Group) -> Vec<u32> {
    let mut set: Vec<u32> = group.children.iter_mut().flat_map(leave_to_children).collect();
    ascend(&mut set);
    group.members.retain(|agent| set.binary_search(agent).is_err());
    set.extend(&group.members);
    ascend(&mut set);
    set
}

fn ascend(agents: &mut [u32]) {
    sort_by_key(agents, |agent| u128::from(*agent));
}

fn order(a: &mut u32, b: &mut u32) {
    if a > b {
        std::mem::swap(a, b);
    }
}

#[cfg(test)]
mod tests {
    use super::{Group, normalize_groups};
    use crate::choice::MethodName;
    use crate::scene::{Segment, link, read_json, write_json};

    #[test]
    fn parts_of_a_transition_move_as_its_first_does() {
        let text = r#"{ "format": "eigenform", "version": 1, "keyframes": [
            { "positions": [[0, 0]] }, { "time": 1, "between": 1, "positions": [[1, 0]] },
            { "time": 2, "positions": [[2, 0]] }, { "time": 3, "positions": [[3, 0]] }
        ], "segments": [{ "method": "polar", "avoidance": true }, { "method": "linear" }, { "method": "shared" }] }"#;
        let scene = read_json(text).expect("the scene is valid");
        let methods: Vec<MethodName> = scene.main_track().segments.iter().map(|Segment::Transition(spec)| spec.method).collect();
        assert_eq!(methods, [MethodName::Polar, MethodName::Polar, MethodName::Shared]);
        assert_eq!(scene.main_track().segments[0], scene.main_track().segments[1]);
        assert_eq!(read_json(&write_json(&scene)), Ok(scene.clone()));
        assert_eq!(link::decode(&link::encode(&scene, link::Precision::Exact).fragment), Ok(scene));
    }

    #[test]
    fn a_parent_leaves_its_childrens_agents_to_them() {
        let inner = Group { members: vec![2, 1], ..Group::default() };
        let mut groups = [Group { members: vec![3, 1, 0, 2], children: vec![inner.clone()], ..Group::default() }];
        normalize_groups(&mut groups);
        assert_eq!(groups[0].members, [3, 0]);
        assert_eq!(groups[0].children, [inner]);
    }
}
