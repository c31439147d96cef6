//! A crowd under social forces: what moves each agent from one moment to the next.
//!
//! Driving, repulsion, obstacles, subgroups and fluctuation (paper D, sections 3.3 and 3.5; paper A, section 4.3), with mutual
//! information fed back (equations 11–19). Agents aim where the caller says; what leads them there is not known here.
//!
//! Numbers in, numbers out: no scene, no methods; lengths in any unit, the one of [`Constants`]. A step allocates nothing and gives
//! the same bits on every machine. A crate of its own, because in the browser's build it is compiled for speed.

#![forbid(unsafe_code)]

mod bins;
mod cells;
mod columns;
mod constants;
mod crowd;
mod exponential;
mod feedback;
mod groups;
mod information;
mod near;
mod noise;
mod obstacles;
mod push;
mod ranks;
mod repulsion;
mod sectors;
mod slots;
mod speeds;
mod wishes;

pub use columns::Columns;
pub use constants::Constants;
pub use crowd::{Bodies, Crowd, Setting};
pub use eigenform_apart::Outline;
pub use feedback::Feedback;
pub use groups::NO_GROUP;
pub use information::Information;
pub use sectors::Sectors;
pub use speeds::{SPEED_CLASSES, speeds_into};
