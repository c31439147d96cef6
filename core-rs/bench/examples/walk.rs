//! A crowd's walk as a bare WebAssembly module, also of more agents than a scene file may have.

use eigenform::choice::MethodName;
use eigenform::perform::Performer;
use eigenform_bench::{crowd, move_first};

/// Walks so many agents 300 steps by forces, or along the straight guide alone.
#[unsafe(no_mangle)]
pub extern "C" fn walk(agent_count: usize, has_forces: bool) {
    let method = if has_forces { MethodName::Crowd } else { MethodName::Linear };
    move_first(&mut Performer::default(), &crowd(agent_count, method));
}
