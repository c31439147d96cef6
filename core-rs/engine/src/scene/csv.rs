//! Keyframe CSV: one row an agent and keyframe, `keyframe,time,agent,group,x,y`.
//!
//! The columns may stand in any order; `group`, `z`, `name` and `color` may be absent, and where every z is 0 the scene is plane.
//! Groups within groups are written as `Band/Brass`. Everything else that a scene has is out of its reach: it is said on the way out,
//! and has its default on the way in.

pub(in crate::scene) mod columns;
mod groups;
mod read;
pub(in crate::scene) mod rows;
mod table;
mod write;

pub use read::{Read, read_csv};
pub(in crate::scene) use read::{checked, fitted_stage, is_whole_number};
pub use write::{Written, write_csv};
