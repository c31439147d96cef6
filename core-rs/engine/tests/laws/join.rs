//! The laws of segments that meet at keyframes without a stop.

mod between;
mod formula;
mod meeting;
mod obstacle_ties;
mod show;
mod stops;
mod symmetry;
mod timing;
