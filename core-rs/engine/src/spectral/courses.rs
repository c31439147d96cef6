//! The courses of the coefficients from end to end, on the plane or in space.

use glam::DVec3;

use super::coefficients::Coefficients;
use super::space::Arcs;
use super::turn::Turn;

/// One way a mode, or an agent about the barycenter.
#[derive(Clone, Debug)]
pub(crate) enum Courses {
    /// x and y.
    Level(Coefficients),
    /// x, y and z.
    Free(Arcs),
}

impl Courses {
    /// From `source` to `target`, of equal number, once the common turn is taken out. Level ends have no heights about their barycenters.
    pub(crate) fn between(source: &[DVec3], target: &[DVec3], turn: Turn) -> Self {
        match turn {
            Turn::Level(angle) => {
                let [source, target] = [source, target].map(|ends| ends.iter().map(|end| end.truncate()).collect::<Vec<_>>());
                Self::Level(Coefficients::between(&source, &target, angle))
            }
            Turn::Free { rotation, thinnest } => Self::Free(Arcs::between(source, target, rotation, thinnest)),
        }
    }

    /// The same, scaled at every t so that the root of the summed squares runs linearly too.
    pub(crate) fn keeping_size(self) -> Self {
        match self {
            Self::Level(curves) => Self::Level(curves.keeping_size()),
            Self::Free(arcs) => Self::Free(arcs.keeping_size()),
        }
    }

    /// How many columns there are for every t: 2 or 3.
    pub(crate) fn dimensions(&self) -> usize {
        match self {
            Self::Level(_) => 2,
            Self::Free(_) => 3,
        }
    }

    /// Writes the coefficients at every `t` in 0..1: for each t a column of all x, one of all y and, in space, one of all z.
    pub(crate) fn write_columns(&self, ts: &[f64], columns: &mut [f64]) {
        match self {
            Self::Level(curves) => curves.write_columns(ts, columns),
            Self::Free(arcs) => arcs.write_columns(ts, columns),
        }
    }
}
