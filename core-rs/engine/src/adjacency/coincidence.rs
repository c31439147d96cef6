//! Agents that stand in one place.

use std::collections::BTreeMap;

use glam::DVec3;

/// Cells this many tolerances wide: wide enough that nearly every point has its surroundings in one cell.
const CELL_TOLERANCES: f64 = 64.0;

/// `result[i]` is the lowest agent, not itself a twin, within `tolerance` of agent i; i itself when there is none before it.
///
/// Tolerance 0 is for points that are all one.
pub(super) fn representatives(points: &[DVec3], tolerance: f64) -> Vec<u32> {
    if tolerance == 0.0 {
        return vec![0; points.len()];
    }
    let cell = |x: f64| (x / (CELL_TOLERANCES * tolerance)).floor() as i64;
    let mut standing: BTreeMap<(i64, i64, i64), Vec<u32>> = BTreeMap::new();
    (0..)
        .zip(points)
        .map(|(agent, &point)| {
            let (low, high) = (point - tolerance, point + tolerance);
            let span = |axis: usize| cell(low[axis])..=cell(high[axis]);
            let twin_of = span(0)
                .flat_map(|x| span(1).flat_map(move |y| span(2).map(move |z| (x, y, z))))
                .filter_map(|key| standing.get(&key))
                .filter_map(|agents| agents.iter().copied().find(|&other| points[other as usize].distance(point) <= tolerance))
                .min();
            twin_of.unwrap_or_else(|| {
                standing.entry((cell(point.x), cell(point.y), cell(point.z))).or_default().push(agent);
                agent
            })
        })
        .collect()
}
