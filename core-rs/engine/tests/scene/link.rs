//! Links: what they promise, now and later, and how long they are.

mod forever;
mod laws;
mod sizes;
