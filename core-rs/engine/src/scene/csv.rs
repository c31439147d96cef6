//! Keyframe CSV: one row an agent and keyframe, `keyframe,time,agent,group,x,y`.
//!
//! The columns may stand in any order; `group`, `z`, `name` and `color` may be absent, and where every z is 0 the scene is plane.
//! Groups within groups are written as `Band/Brass`. Everything else that a scene has is out of its reach: it is said on the way out,
//! and has its default on the way in.

mod columns;
mod groups;
mod read;
mod table;
mod write;

pub use read::{Read, read_csv};
pub use write::{Written, write_csv};
