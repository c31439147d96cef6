//! What the person says about who goes where.

use serde::{Deserialize, Serialize};

use crate::error::Error;

/// The λ of least effort where none is given.
pub const DEFAULT_LAMBDA: f64 = 0.9;

/// How an assignment was found, kept with the transition it was made for; playing does not look at it.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
#[serde(rename_all = "camelCase")]
pub struct AssignmentSpec {
    /// What is least in sum.
    pub cost: Cost,
    /// 0–1: how much the way counts in least effort, beside how densely agents stand at both ends.
    pub lambda: f64,
    /// Agents and the slots they have whatever it costs.
    pub locks: Vec<(u32, u32)>,
    /// Groups get regions of slots first, and their agents slots within them.
    pub keep_groups: bool,
}

/// What the sum is of.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
#[serde(rename_all = "kebab-case")]
pub enum Cost {
    /// Squared distances: agents that walk straight and in step keep apart.
    #[default]
    Squared,
    /// Paper D, equation 3: λ · squared distance + (1 − λ) · squared difference of the mean lengths of the Delaunay edges at both ends.
    LeastEffort,
    /// Distances.
    Euclidean,
    /// Distances along the axes.
    Manhattan,
    /// Nothing: everybody keeps the slot of their number, and who loses it to a lock takes the one that the lock leaves.
    Keep,
}

impl Default for AssignmentSpec {
    fn default() -> Self {
        Self { cost: Cost::default(), lambda: DEFAULT_LAMBDA, locks: Vec::new(), keep_groups: false }
    }
}

/// Refuses locks of agents or slots that are not there, two slots of one agent and two agents of one slot. `place`: of a lock.
pub fn check_locks(locks: &[(u32, u32)], agent_count: usize, place: impl Fn(usize) -> String) -> Result<(), Error> {
    let (mut slots, mut agents) = (vec![None; agent_count], vec![None; agent_count]);
    for (index, &(agent, slot)) in locks.iter().enumerate() {
        if agent as usize >= agent_count {
            return Err(Error::UnknownAgent { agent, agent_count, place: place(index) });
        }
        if slot as usize >= agent_count {
            return Err(Error::UnknownSlot { slot, agent_count, place: place(index) });
        }
        if let Some(other) = slots[agent as usize].replace(slot) {
            return Err(Error::TwoSlots { agent, slots: [other, slot], place: place(index) });
        }
        if let Some(other) = agents[slot as usize].replace(agent) {
            return Err(Error::SlotTaken { slot, agents: [other, agent], place: place(index) });
        }
    }
    Ok(())
}
