//! The laws of the methods that make one formation from another, for every method, order, alignment and sharing.

pub mod cases;
mod ends;
mod inside;
mod reversal;
mod symmetry;
mod turns;
