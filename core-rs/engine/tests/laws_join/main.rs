//! The laws of segments that meet at keyframes without a stop.

#[path = "../laws_transition/cases.rs"]
#[allow(dead_code)]
mod cases;
mod formula;
mod meeting;
mod obstacle_ties;
mod show;
mod stops;
mod symmetry;
mod timing;
