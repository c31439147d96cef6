//! What a segment of a chain takes, all pieces found: its path is only put together.

use std::sync::Arc;

use glam::DVec2;

use super::Transition;
use super::carried::{Carried, Power};
use super::chain::Chain;
use super::cubic::Cubic;
use super::modal::{Drift, Modes};
use super::straight::straight_velocities;
use super::strand::Strand;
use crate::spectral::{Eigenbasis, Passage, Planes};

/// A way along a chain's segment.
pub(super) enum Route<'a> {
    /// By places alone.
    Straight,
    /// In modes that stay.
    Fixed(Strand<'a>),
    /// In modes that turn, starting turned back by `from`.
    Turning { strand: Strand<'a>, from: Option<Arc<Planes>>, turns: Vec<(Arc<Planes>, Power)> },
}

impl Route<'_> {
    /// The path.
    pub(super) fn path(self, chain: &Chain) -> Box<dyn Transition> {
        let at = chain.at();
        match self {
            Self::Straight => Box::new(straight(chain)),
            Self::Fixed(strand) => Box::new(Fixed {
                agent_count: chain.agent_count(),
                basis: strand.fixed_basis(),
                coefficients: strand.passage(at),
                drift: Drift::of(chain),
            }),
            Self::Turning { strand, from, turns } => {
                let (pair, meeting) = strand.modes_at_origin();
                let met = meeting.map(|meeting| (meeting, Power::Always(1.0)));
                let turned_back = from.map(|from| (from, Power::Always(-1.0)));
                let turns = met.into_iter().chain(turned_back).chain(turns).collect();
                Box::new(Carried::new(pair, turns, strand.passage(at), Drift::of(chain)))
            }
        }
    }
}

/// Every agent on a cubic of its own.
fn straight(chain: &Chain) -> Cubic {
    let (at, duration) = (chain.at(), chain.duration(chain.at()));
    let part = |end: usize| {
        let velocities = straight_velocities(chain, end).into_iter().map(|velocity| duration * velocity).collect();
        (chain.formation(end).places().iter().collect(), velocities)
    };
    let ((start, leaving), (stop, arriving)) = (part(at), part(at + 1));
    Cubic::new([start, leaving, stop, arriving])
}

/// Coefficients on their way in modes that stay.
struct Fixed {
    agent_count: usize,
    /// None: every agent is its own mode.
    basis: Option<Arc<Eigenbasis>>,
    coefficients: Passage,
    drift: Drift,
}

impl Transition for Fixed {
    fn agent_count(&self) -> usize {
        self.agent_count
    }

    fn matrix_count(&self) -> usize {
        usize::from(self.basis.is_some())
    }

    fn evaluate_into(&self, ts: &[f64], plan: &mut [DVec2], heights: Option<&mut [f64]>) {
        let modes = Modes { agent_count: self.agent_count, basis: self.basis.as_ref().map(|basis| basis.modes()), dimensions: 2 };
        modes.evaluate(&|t| self.drift.at(t), ts, (plan, heights), &mut |ts, columns| self.coefficients.write_columns(ts, columns));
    }
}
