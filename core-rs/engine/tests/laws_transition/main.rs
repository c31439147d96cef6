//! The laws of the methods that make one formation from another, for every method, order, alignment and sharing.

mod cases;
mod ends;
