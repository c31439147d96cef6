//! The rows gathered by agent and keyframe, whatever their order.

use std::collections::BTreeMap;

use glam::DVec2;

use super::columns::{Cell, Row};
use crate::error::{Counted, Error, TableError};
use crate::formation::Formation;
use crate::scene::validate::{at_most, color, length, within};
use crate::scene::{limits, shown};

/// What the rows say, by agent and keyframe in order of first appearance.
#[derive(Default)]
pub(super) struct Table {
    pub(super) agents: Vec<AgentRow>,
    pub(super) keyframes: Vec<KeyframeRows>,
    agent_numbers: BTreeMap<String, usize>,
    keyframe_numbers: BTreeMap<String, usize>,
    /// Whether any height is not 0: a file of zeros is on the plane.
    is_spatial: bool,
    /// The first row that gives no height.
    first_flat_row: Option<u64>,
}

/// An agent as its first row has it.
pub(super) struct AgentRow {
    pub(super) id: String,
    pub(super) name: Option<String>,
    pub(super) color: String,
    pub(super) group: String,
    pub(super) changes_group: bool,
}

/// One keyframe as far as its rows were met.
pub(super) struct KeyframeRows {
    pub(super) label: String,
    pub(super) time: f64,
    /// By agent, with its height; shorter than there are agents while the last ones are missing.
    positions: Vec<Option<(DVec2, f64)>>,
}

impl Table {
    pub(super) fn add(&mut self, row: &Row) -> Result<(), Error> {
        let position = self.position(row)?;
        let keyframe = self.keyframe(row)?;
        let agent = self.agent(row)?;
        let count = self.agents.len() * self.keyframes.len();
        at_most(count, limits::POSITIONS, Counted::Positions, row.place("agent"))?;
        let positions = &mut self.keyframes[keyframe].positions;
        if positions.len() <= agent {
            positions.resize(agent + 1, None);
        }
        if positions[agent].replace(position).is_some() {
            let (agent, keyframe) = (shown(row.text("agent")), shown(row.text("keyframe")));
            return Err(TableError::RepeatedRow { row: row.number, agent, keyframe }.into());
        }
        Ok(())
    }

    /// Where every agent stands at a keyframe.
    pub(super) fn formation(&self, keyframe: &KeyframeRows) -> Result<Formation, Error> {
        let positions = (0..self.agents.len()).map(|agent| keyframe.positions.get(agent).copied().flatten());
        let found = positions.zip(&self.agents).map(|(position, agent)| {
            position.ok_or_else(|| TableError::MissingRow { agent: shown(&agent.id), keyframe: shown(&keyframe.label) })
        });
        let (positions, heights) = found.collect::<Result<Vec<_>, _>>()?.into_iter().unzip();
        Ok(if self.is_spatial { Formation::spatial(positions, heights) } else { Formation::new(positions) })
    }

    /// Refuses a row without a height where others stand in space.
    pub(super) fn dimensions_agree(&self) -> Result<(), Error> {
        match self.first_flat_row {
            Some(row) if self.is_spatial => {
                Err(Error::MixedDimensions { found: 2, expected: 3, place: Cell { row, column: "z" }.to_string() })
            }
            _ => Ok(()),
        }
    }

    fn position(&mut self, row: &Row) -> Result<(DVec2, f64), Error> {
        let position = DVec2::new(row.number("x")?, row.number("y")?);
        within(position.x, &limits::COORDINATE, row.place("x"))?;
        within(position.y, &limits::COORDINATE, row.place("y"))?;
        if row.text("z").is_empty() {
            self.first_flat_row.get_or_insert(row.number);
            return Ok((position, 0.0));
        }
        let height = row.number("z")?;
        within(height, &limits::COORDINATE, row.place("z"))?;
        self.is_spatial |= height != 0.0;
        Ok((position, height))
    }

    fn keyframe(&mut self, row: &Row) -> Result<usize, Error> {
        let (label, time) = (row.text("keyframe"), row.number("time")?);
        let Some(&number) = self.keyframe_numbers.get(label) else {
            at_most(self.keyframes.len() + 1, limits::KEYFRAMES, Counted::Keyframes, row.place("keyframe"))?;
            within(time, &limits::TIME, row.place("time"))?;
            if let Some(before) = self.keyframes.last().filter(|before| time - before.time < limits::SHORTEST_SEGMENT) {
                return Err(Error::TimesDoNotRise { time, end: before.time, place: row.place("time").to_string() });
            }
            length(label, limits::NAME_CHARACTERS, row.place("keyframe"))?;
            self.keyframe_numbers.insert(label.to_owned(), self.keyframes.len());
            self.keyframes.push(KeyframeRows { label: label.to_owned(), time, positions: Vec::new() });
            return Ok(self.keyframes.len() - 1);
        };
        let expected = self.keyframes[number].time;
        if time.to_bits() == expected.to_bits() {
            Ok(number)
        } else {
            Err(TableError::TimesDiffer { row: row.number, keyframe: shown(label), time, expected }.into())
        }
    }

    fn agent(&mut self, row: &Row) -> Result<usize, Error> {
        let (id, group) = (row.text("agent"), row.text("group"));
        if let Some(&number) = self.agent_numbers.get(id) {
            let agent = &mut self.agents[number];
            agent.changes_group |= agent.group != group;
            return Ok(number);
        }
        at_most(self.agents.len() + 1, limits::AGENTS, Counted::Agents, row.place("agent"))?;
        length(id, limits::NAME_CHARACTERS, row.place("agent"))?;
        length(row.text("name"), limits::NAME_CHARACTERS, row.place("name"))?;
        color(row.text("color"), row.place("color"))?;
        self.agent_numbers.insert(id.to_owned(), self.agents.len());
        self.agents.push(AgentRow {
            id: id.to_owned(),
            name: row.has("name").then(|| row.text("name").to_owned()),
            color: row.text("color").to_owned(),
            group: group.to_owned(),
            changes_group: false,
        });
        Ok(self.agents.len() - 1)
    }
}
