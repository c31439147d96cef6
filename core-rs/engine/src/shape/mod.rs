//! From a shape to places for exactly so many agents, evenly spread (paper D, 3.1).
//!
//! A [`Region`] is what is covered of a picture. A [`SlotJob`] samples it in rows at about the spacing that gives as many places as
//! asked, deletes by roulette what is over, and lets what is left push one another apart until all are spaced alike. Only sums, products
//! and square roots: every machine gives the same bits. It refuses names, keyframes and files.

mod job;
#[cfg(test)]
mod laws;
mod outline;
mod packing;
mod picture;
mod region;
mod spread;

pub use job::{Request, SlotJob, Step, Style};
pub use picture::{Picture, Reading, THRESHOLD};
pub use region::{Region, Room};
