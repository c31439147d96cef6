//! The tree of groups: small, shallow, and no agent twice.

use super::{at_most, color, length, within};
use crate::error::{Counted, Error};
use crate::scene::place::Place;
use crate::scene::{Group, limits};

/// An agent is a member of at most one group: siblings share none at any level, and a group leaves its children's agents to them.
pub(super) fn check(groups: &[Group], agent_count: usize) -> Result<(), Error> {
    let mut walk = Walk { seats: vec![None; agent_count], group_count: 0 };
    let place = Place::Top.field("groups");
    walk.level(groups, 1, &place)
}

struct Walk {
    /// By agent: the running number of the group it is a member of, and that group's place.
    seats: Vec<Option<(usize, String)>>,
    group_count: usize,
}

impl Walk {
    fn level(&mut self, groups: &[Group], depth: usize, place: &Place) -> Result<(), Error> {
        groups.iter().enumerate().try_for_each(|(index, group)| self.group(group, depth, &place.item(index)))
    }

    fn group(&mut self, group: &Group, depth: usize, place: &Place) -> Result<(), Error> {
        self.group_count += 1;
        at_most(self.group_count, limits::GROUPS, Counted::Groups, Place::Top.field("groups"))?;
        if depth > limits::GROUP_DEPTH {
            return Err(Error::GroupsTooDeep { limit: limits::GROUP_DEPTH, place: place.to_string() });
        }
        length(&group.name, limits::NAME_CHARACTERS, place.field("name"))?;
        color(&group.color, place.field("color"))?;
        if let Some(factor) = group.tie_weight {
            within(factor, &limits::FACTOR, place.field("tieWeight"))?;
        }
        let members = place.field("members");
        for (index, &agent) in group.members.iter().enumerate() {
            self.seat(agent, place, &members.item(index))?;
        }
        self.level(&group.children, depth + 1, &place.field("children"))
    }

    fn seat(&mut self, agent: u32, group: &Place, place: &Place) -> Result<(), Error> {
        let agent_count = self.seats.len();
        let Some(seat) = self.seats.get_mut(agent as usize) else {
            return Err(Error::UnknownAgent { agent, agent_count, place: place.to_string() });
        };
        match seat {
            Some((number, _)) if *number == self.group_count => Err(Error::RepeatedMember { agent, place: place.to_string() }),
            Some((_, other)) => Err(Error::SharedMember { agent, other: other.clone(), place: place.to_string() }),
            None => {
                *seat = Some((self.group_count, group.to_string()));
                Ok(())
            }
        }
    }
}
