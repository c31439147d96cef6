//! How one formation becomes the next: a file a method behind one trait.
//!
//! A method is planned once from two formations and their ties, then evaluated at as many instants as anyone asks for.
//! It knows nothing of seconds, scenes or frames.

mod ends;
mod linear;
mod modal;
mod planner;
mod polar;
mod shared;
mod spectral;

use glam::DVec2;

pub use ends::{End, Ends};
pub use planner::{Planner, plan};

/// A planned way from a source formation to a target formation.
pub trait Transition: Send + Sync {
    /// How many agents it moves.
    fn agent_count(&self) -> usize;

    /// Positions at each `t` (0 = source, 1 = target, after timing): `out[k * agent_count + i]` is agent i at `ts[k]`, meters.
    ///
    /// Both ends are exact to 1e-9 · max(1 m, extent).
    fn evaluate_into(&self, ts: &[f64], out: &mut [DVec2]);
}
