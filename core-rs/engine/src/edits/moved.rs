//! A motion and what is added to it.

use eigenform_apart::Paths;
use glam::DVec2;

use crate::motion::Motion;

/// The guide with a deviation added, a knot a sample.
pub(super) fn moved(guide: &Motion, deviation: &Paths) -> Motion {
    let agent_count = guide.agent_count();
    let mut positions = guide.positions().to_vec();
    let mut heights = guide.heights().map(<[f64]>::to_vec);
    for agent in 0..agent_count {
        for k in 0..guide.times().len() {
            let [x, y, z] = deviation.place(agent, k);
            positions[k * agent_count + agent] += DVec2::new(x, y);
            if let Some(heights) = &mut heights {
                heights[k * agent_count + agent] += z;
            }
        }
    }
    Motion::sampled(guide.times().to_vec(), agent_count, positions, heights)
}
