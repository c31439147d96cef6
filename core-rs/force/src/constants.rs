//! The one table of constants.

/// What a crowd's forces are made of, by the paper's symbols. Forces are accelerations. Lengths are in the crowd's unit: the
/// defaults want the median spacing of its agents for one.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "types", derive(ts_rs::TS), ts(rename_all = "camelCase"))]
pub struct Constants {
    /// τ, seconds: how fast agents take up the velocity they want (equation 8).
    pub reaction_time: f64,
    /// Seconds that agents look ahead on their way; where that is, they aim. Not of the paper, whose aim is the target itself.
    pub look_ahead: f64,
    /// A: repulsion of agents and of obstacles (equations 9 and 10).
    pub strength: f64,
    /// B: the length over which that falls to 1/e.
    pub reach: f64,
    /// A′: attraction within a subgroup and repulsion between them (equations 21 and 22).
    pub group_strength: f64,
    /// B′: the length over which those change.
    pub group_reach: f64,
    /// ξ: the greatest random acceleration along each axis (equation 7).
    pub fluctuation: f64,
    /// R: the side of the bins within which agents share direction and speed (equations 12 and 13).
    pub bin_size: f64,
    /// K: sectors of a full turn (equation 14); whoever rests has one more.
    pub sectors: u32,
}

impl Default for Constants {
    fn default() -> Self {
        Self {
            reaction_time: 0.5,
            look_ahead: 0.5,
            strength: 5.0,
            reach: 0.3,
            group_strength: 0.5,
            group_reach: 2.0,
            fluctuation: 0.0,
            bin_size: 4.0,
            sectors: 8,
        }
    }
}
