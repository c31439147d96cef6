//! (assignment)
