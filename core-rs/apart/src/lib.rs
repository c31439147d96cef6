//! Keeps sampled paths apart: kernel Gauss–Seidel, a dual ascent on pushes between pairs.
//!
//! Paper C (section 6.1) pushes the nearest pair apart and smooths the push over time, again and again. Here a push acts only at a
//! pair's closest approach, across the guide's relative velocity, and through a smooth bump; it is remembered, so that it can be
//! taken back. What is left at rest is the least τ⁴/4 |u''|² + |u|² of deviations u that keep every pair apart.
//!
//! Numbers in, numbers out: no seconds, no scene, and no search for near pairs, which the caller lists. A crate of its own, because
//! in the browser's build it is compiled for speed while the engine is compiled for size.

#![forbid(unsafe_code)]

mod bytes;
mod contact;
mod kernel;
mod outline;
mod paths;
mod scan;
mod solver;

pub use bytes::sort_by_bytes;
pub use kernel::Kernel;
pub use outline::Outline;
pub use paths::Paths;
pub use scan::Meeting;
pub use solver::{Rules, Solver, State};
