//! The eigenbases of two formations' Laplacians and the rotation that takes one into the other (paper A, sections 3 and 4.2).
//!
//! Everything here works on the n − 1 modes beside the constant one, which only carries the barycenter.
//! It turns graphs and coefficients into plans; it knows nothing of methods, seconds or frames.
//!
//! The road: [`Eigenbasis`] of each end → [`Pair`] (ties between equal eigenvalues decided) → [`Pairing`] (which mode becomes
//! which) → [`Matched`] (signs, rotation planes) → [`Courses`] of the coefficients between the ends.

mod alignment;
mod angle;
mod coefficients;
mod courses;
mod degenerate;
mod eigenbasis;
mod eigenspaces;
mod exponential;
mod invariant;
mod matched;
mod matching;
mod maxmin;
mod mode_match;
mod pair;
mod passage;
mod planes;
mod polar_factor;
mod runs;
mod signs;
mod space;
mod turn;

pub use eigenbasis::Eigenbasis;
pub use mode_match::ModeMatch;

pub(crate) use alignment::turn_between;
pub(crate) use courses::Courses;
pub(crate) use degenerate::{is_degenerate, nearness, with_tie_break};
pub(crate) use eigenbasis::Spectrum;
pub(crate) use eigenform_dense::{combination, product, product_into_columns};
pub(crate) use matched::Matched;
pub(crate) use matching::Pairing;
pub(crate) use mode_match::eigenvalues_between;
pub(crate) use pair::Pair;
pub(crate) use passage::{Beside, Passage, Passing, cubic_weights};
pub(crate) use planes::Planes;
pub(crate) use signs::reversals;
pub(crate) use turn::Turn;
