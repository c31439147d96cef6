//! Laws of formations with heights (spectral.md, sections 2, 5 and 10): what the plane promises holds in space, and what is level is
//! the plane.

mod adjacency;
mod cases;
mod ends;
mod joins;
mod level;
mod measures;
mod symmetry;
mod turns;
