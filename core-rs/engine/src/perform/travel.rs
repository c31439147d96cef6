//! Segments that travel along the paths of a scene, and the formations as they see them.

use std::sync::Arc;

use crate::formation::Formation;
use crate::recent::{Recent, Same};
use crate::scene::PathSpec;
use crate::transition::{Chain, Travel, turned};

/// A formation of 1,260 agents is 20 kB.
const BYTE_LIMIT: usize = 8 << 20;

/// Formations turned lately, by their angles to the bit: an unchanged one stays the same object, so that what was made from it is
/// found again.
pub(super) struct Turnings(Recent<(Same<Formation>, u64), Arc<Formation>>);

impl Default for Turnings {
    fn default() -> Self {
        Self(Recent::new(BYTE_LIMIT))
    }
}

impl Turnings {
    fn turned(&mut self, formation: &Arc<Formation>, angle: f64) -> Arc<Formation> {
        let key = (Same(formation.clone()), angle.to_bits());
        self.0.get(&key).unwrap_or_else(|| {
            let turned = Arc::new(turned(formation, angle));
            self.0.put(key, turned.clone(), size_of_val(turned.positions()));
            turned
        })
    }
}

/// A chain's segment as it travels; `paths`: one a pair of its keyframes. None where there is no path.
pub(super) fn travel(chain: &Chain, paths: &[Option<PathSpec>], turnings: &mut Turnings) -> Option<Travel> {
    let paths: Vec<_> = paths.iter().map(|path| path.as_ref().map(|path| &path.points[..])).collect();
    Travel::of(chain, &paths, &mut |formation, angle| turnings.turned(formation, angle))
}

/// The chain as methods see it.
pub(super) fn charted(chain: Chain, paths: &[Option<PathSpec>], turnings: &mut Turnings) -> Chain {
    match travel(&chain, paths, turnings) {
        Some(travel) => travel.chart().clone(),
        None => chain,
    }
}
