//! (perform)
