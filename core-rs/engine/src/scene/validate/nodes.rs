//! Groups with a method of their own: groups that exist, once each.

use super::{at_most, certain, within};
use crate::error::{Counted, Error};
use crate::scene::place::Place;
use crate::scene::{Group, NodeSpec, limits};

pub(super) fn check(nodes: &[NodeSpec], groups: &[Group], place: &Place) -> Result<(), Error> {
    at_most(nodes.len(), limits::NODES, Counted::Nodes, place)?;
    for (index, node) in nodes.iter().enumerate() {
        let here = place.item(index);
        if !leads_to_a_group(&node.group, groups) {
            return Err(Error::UnknownGroup { place: here.field("group").to_string() });
        }
        if let Some(other) = nodes[..index].iter().position(|other| other.group == node.group) {
            return Err(Error::RepeatedNode { other: place.item(other).to_string(), place: here.to_string() });
        }
        certain(node.method, here.field("method"))?;
        if let Some(blend) = node.blend {
            certain(blend.method, here.field("blend").field("method"))?;
            within(blend.amount, &limits::BLEND, here.field("blend").field("amount"))?;
        }
    }
    Ok(())
}

/// The root always does.
fn leads_to_a_group(path: &[u32], mut groups: &[Group]) -> bool {
    path.iter().all(|&index| match groups.get(index as usize) {
        Some(group) => {
            groups = &group.children;
            true
        }
        None => false,
    })
}
