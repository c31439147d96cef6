//! A file a verb: read, ask the engine, print.

pub mod assign;
pub mod check;
pub mod compare;
pub mod convert;
pub mod groups;
pub mod link;
pub mod measure;
pub mod modes;
pub mod motion;
pub mod open;
pub mod shape;
pub mod spread;
