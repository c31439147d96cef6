//! Whole scenes performed: what people see of them, and the numbers written beside them.

mod comparison;
mod examples;
mod perform;
mod space;
