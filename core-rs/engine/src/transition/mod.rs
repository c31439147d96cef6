//! How one formation becomes the next: a file a method behind one trait.
//!
//! A method is planned once from a [`Chain`] of formations and their ties, then evaluated at as many instants as anyone asks for.
//! It knows nothing of scenes or frames. A segment on its own is two formations; where agents pass a keyframe without stopping, the
//! chain holds its neighbors too, and the segments meet there with one velocity.

mod bent;
mod blend;
mod carried;
mod chain;
mod course;
mod cubic;
mod held;
mod hierarchical;
mod hierarchy;
mod interpolated;
mod linear;
mod modal;
mod nodes;
mod pairs;
mod piece;
mod planner;
mod polar;
mod product;
mod route;
mod shared;
mod smooth;
mod space;
mod spectral;
mod straight;
mod strand;
mod travel;
mod turns;

use glam::DVec2;

pub use chain::{Chain, End, Way, Ways};
pub use held::{Tied, held, tied};
pub use hierarchical::Hierarchical;
pub use hierarchy::Hierarchy;
pub(crate) use interpolated::interpolated;
pub(crate) use nodes::nodes_at;
pub use planner::Planner;
pub use travel::{Travel, turned};

use blend::Blend;

/// A planned way from a source formation to a target formation.
pub trait Transition: Send + Sync {
    /// How many agents it moves.
    fn agent_count(&self) -> usize;

    /// How many matrices of agents × agents it keeps alive.
    fn matrix_count(&self) -> usize {
        0
    }

    /// Places at each `t` (0 = source, 1 = target, after timing): `plan[k * agent_count + i]` is where agent i is at `ts[k]` as seen
    /// from above, `heights` how high it is there, if anybody asks; meters.
    ///
    /// Both ends are exact to 1e-9 · max(1 m, extent).
    fn evaluate_into(&self, ts: &[f64], plan: &mut [DVec2], heights: Option<&mut [f64]>);
}
