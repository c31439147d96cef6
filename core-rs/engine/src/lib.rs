//! Eigenform's engine: a scene in, a motion out.
//!
//! Pure: no browser, no files, no clock, no threads of its own. The page, the command line and the tests run the same code.
//! [`scene`] is the one door for untrusted input; [`perform`] turns a scene into motion.

#![forbid(unsafe_code)]

pub mod adjacency;
pub mod assignment;
pub mod choice;
pub mod edits;
pub mod error;
pub mod formation;
pub mod grouping;
pub mod measure;
pub mod motion;
pub mod obstacle;
mod order;
pub mod perform;
mod recent;
pub mod scene;
pub mod shape;
pub mod spectral;
mod spline;
pub mod text;
pub mod transition;
mod trig;

/// Whether anything is compared: what only comparisons ask for is left out of an engine without.
pub(crate) const COMPARES: bool = cfg!(feature = "comparison");
