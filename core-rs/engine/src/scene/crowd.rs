//! How a segment's crowd moves: the guide it follows and the table of its forces.

use eigenform_force::Constants;
use serde::Serialize;

use crate::choice::MethodName;

/// What method `crowd` is told. Lengths are in median spacings of the formations; every scalar is its default where it is absent.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
#[serde(rename_all = "camelCase")]
pub struct CrowdSpec {
    /// The interpolation that agents follow, with the segment's own options: never `auto` nor `crowd`.
    pub guide: MethodName,
    /// Feedback of direction, by `I_d`.
    pub direction_feedback: bool,
    /// Feedback of speed, by `I_v`.
    pub speed_feedback: bool,
    /// τ, seconds: how fast agents take up the velocity they want.
    pub reaction_time: f64,
    /// Seconds that agents look ahead on the guide.
    pub look_ahead: f64,
    /// A: repulsion of agents and obstacles.
    pub strength: f64,
    /// B: the length over which that falls to 1/e.
    pub reach: f64,
    /// A′: attraction within a group and repulsion between groups.
    pub group_strength: f64,
    /// B′: the length over which those change.
    pub group_reach: f64,
    /// ξ: the greatest random acceleration along each axis.
    pub fluctuation: f64,
    /// R: the side of the bins within which agents share direction and speed.
    pub bin_size: f64,
    /// K: sectors of a full turn.
    pub sectors: u32,
}

impl Default for CrowdSpec {
    fn default() -> Self {
        let Constants { reaction_time, look_ahead, strength, reach, group_strength, group_reach, fluctuation, bin_size, sectors } =
            Constants::default();
        Self {
            guide: MethodName::Linear,
            direction_feedback: true,
            speed_feedback: true,
            reaction_time,
            look_ahead,
            strength,
            reach,
            group_strength,
            group_reach,
            fluctuation,
            bin_size,
            sectors,
        }
    }
}

impl CrowdSpec {
    /// The table.
    pub fn constants(&self) -> Constants {
        let Self { reaction_time, look_ahead, strength, reach, group_strength, group_reach, fluctuation, bin_size, sectors, .. } = *self;
        Constants { reaction_time, look_ahead, strength, reach, group_strength, group_reach, fluctuation, bin_size, sectors }
    }

    /// Its real numbers by their names in the scene file. Links keep this order for ever: append only.
    pub(super) fn numbers_mut(&mut self) -> [(&'static str, &mut f64); 8] {
        [
            ("reactionTime", &mut self.reaction_time),
            ("lookAhead", &mut self.look_ahead),
            ("strength", &mut self.strength),
            ("reach", &mut self.reach),
            ("groupStrength", &mut self.group_strength),
            ("groupReach", &mut self.group_reach),
            ("fluctuation", &mut self.fluctuation),
            ("binSize", &mut self.bin_size),
        ]
    }
}
