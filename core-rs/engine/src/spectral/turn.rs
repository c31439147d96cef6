//! The turn that is taken out between two formations: an angle on the plane, a rotation in space.

use glam::{DQuat, DVec3};

use super::alignment::turn_between;
use super::space::{rotation_between, thinnest};
use crate::choice::Alignment;
use crate::formation::Formation;
use crate::trig::direction;

/// How the source turns into the target as a whole.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Turn {
    /// Both stand level: what they do in plan is all there is, to the bit. Radians, counterclockwise.
    Level(f64),
    /// Somebody climbs.
    Free {
        /// From source to target.
        rotation: DQuat,
        /// The direction in which the source is thinnest.
        thinnest: DVec3,
    },
}

impl Turn {
    /// The turn by which `alignment` brings the source to the target.
    pub(crate) fn between([source, target]: [&Formation; 2], alignment: Alignment) -> Self {
        let [from, to] = [source.places(), target.places()];
        if from.is_level() && to.is_level() {
            return Self::Level(turn_between(source, target, alignment));
        }
        Self::Free { rotation: rotation_between(from, to, alignment), thinnest: thinnest(from) }
    }

    /// What the turn took to `place`, both seen from the barycenter.
    pub(super) fn back(self, place: DVec3) -> DVec3 {
        match self {
            Self::Level(angle) => direction(-angle).rotate(place.truncate()).extend(place.z),
            Self::Free { rotation, .. } => rotation.conjugate() * place,
        }
    }
}
