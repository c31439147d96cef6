//! What the plane does by angles, in three dimensions: the rotation between two formations and the courses of the coefficients.

mod arcs;
mod rotation;

pub(crate) use arcs::Arcs;
pub(super) use rotation::{rotation_between, thinnest};
