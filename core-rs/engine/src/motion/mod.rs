//! (motion)
