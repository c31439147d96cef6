//! One method along a chain, in the modes of one of its pairs of keyframes: coefficients at every keyframe, and the velocity with
//! which the agents pass one.

use std::ops::RangeInclusive;
use std::sync::Arc;

use faer::{Mat, MatRef};
use glam::{DVec2, DVec3};

use super::chain::Chain;
use super::planner::Planner;
use super::polar::about_barycenter;
use crate::choice::{Choice, MethodName};
use crate::spectral::{Beside, Eigenbasis, Pair, Passage, Passing, Planes, product, turn_between};

/// Ready to say how the method passes the keyframes it was prepared for.
pub(super) struct Strand<'a> {
    chain: &'a Chain,
    choice: Choice,
    keeps_size: bool,
    modes: Modes,
}

enum Modes {
    /// The agents themselves.
    Places,
    /// One basis for all keyframes.
    Fixed(Arc<Eigenbasis>),
    /// A basis that turns from keyframe to keyframe.
    Turning(Turning),
}

/// The source basis of one pair, carried along the chain.
pub(super) struct Turning {
    origin: usize,
    pair: Arc<Pair>,
    /// By pair of the chain: the rotation to the next keyframe; those needed.
    turns: Vec<Option<Arc<Planes>>>,
    /// By keyframe: toward the neighbors' bases; those needed, none without sharing.
    meetings: Vec<Option<Arc<Planes>>>,
    /// By pair: what is left to turn; those needed.
    rests: Vec<Option<Arc<Planes>>>,
}

impl Planner {
    /// The method in the modes of `pair`, for the velocities at keyframes `ends` and the path between them.
    ///
    /// # Panics
    /// When the method is linear, which has no modes, or auto: bugs.
    pub(super) fn strand<'a>(
        &mut self,
        chain: &'a Chain,
        choice: &Choice,
        keeps_size: bool,
        pair: usize,
        ends: RangeInclusive<usize>,
    ) -> Option<Strand<'a>> {
        let modes = match choice.method {
            MethodName::Polar => Modes::Places,
            MethodName::Shared => Modes::Fixed(self.mean_basis(&chain.couple(pair))?),
            MethodName::Spectral => Modes::Turning(self.turning(chain, choice, pair, ends)?),
            MethodName::Linear | MethodName::Auto | MethodName::Crowd => panic!("a method with modes"),
        };
        Some(Strand { chain, choice: *choice, keeps_size, modes })
    }

    fn turning(&mut self, chain: &Chain, choice: &Choice, origin: usize, ends: RangeInclusive<usize>) -> Option<Turning> {
        let (first, last) = (*chain.around(*ends.start()).start(), *chain.around(*ends.end()).end());
        let pair_count = chain.ends().len() - 1;
        let mut turning = Turning {
            origin,
            pair: self.pair(&chain.couple(origin))?,
            turns: vec![None; pair_count],
            meetings: vec![None; pair_count + 1],
            rests: vec![None; pair_count],
        };
        for pair in first..last {
            turning.turns[pair] = Some(self.turn(chain, pair, choice)?);
        }
        if choice.sharing > 0.0 {
            for end in first..=last {
                turning.meetings[end] = Some(self.meeting(chain, end, choice)?);
            }
        }
        for pair in first..last {
            turning.rests[pair] = Some(self.rest(chain, pair, choice)?);
        }
        Some(turning)
    }
}

impl Strand<'_> {
    /// The common turn from keyframe `pair` to the next, as seen from above.
    pub(super) fn turn(&self, pair: usize) -> f64 {
        turn_between(self.chain.formation(pair), self.chain.formation(pair + 1), self.choice.alignment)
    }

    /// The coefficients of keyframe `end`, in the modes carried there.
    pub(super) fn coefficients(&self, end: usize) -> Vec<DVec2> {
        let formation = self.chain.formation(end);
        match &self.modes {
            Modes::Places => about_barycenter(formation),
            Modes::Fixed(basis) => basis.coefficients(formation).into_iter().map(DVec3::truncate).collect(),
            Modes::Turning(turning) => turning.coefficients(about_barycenter(formation), end),
        }
    }

    /// How the coefficients pass keyframe `end`.
    pub(super) fn passing(&self, end: usize) -> Passing {
        let around = self.chain.around(end);
        let before = (*around.start() < end).then(|| self.coefficients(end - 1));
        let after = (*around.end() > end).then(|| self.coefficients(end + 1));
        let beside = |coefficients, pair| Beside { coefficients, turn: self.turn(pair), steepest: self.chain.steepest(pair) };
        let before = before.as_deref().map(|coefficients| beside(coefficients, end - 1));
        let after = after.as_deref().map(|coefficients| beside(coefficients, end));
        Passing::new(before, &self.coefficients(end), after, self.chain.pace(end))
    }

    /// How fast each agent passes keyframe `end`, meters a second.
    pub(super) fn velocities(&self, end: usize) -> Vec<DVec3> {
        let drift = self.chain.velocity(end, |end| self.chain.formation(end).places().barycenter());
        let coefficients = self.passing(end).velocities(&self.coefficients(end), self.keeps_size());
        let velocities = match &self.modes {
            Modes::Places => coefficients,
            Modes::Fixed(basis) => over_modes(basis.modes(), &coefficients),
            Modes::Turning(turning) => {
                let mut own = turning.over_agents(&coefficients, end);
                let places = about_barycenter(self.chain.formation(end));
                let [before, after] = self.chain.pace(end);
                let mut add = |pace: f64, pair: usize| {
                    let turned = needed(&turning.rests, pair).velocities(&places);
                    own.iter_mut().zip(turned).for_each(|(velocity, by_turning)| *velocity += pace * by_turning);
                };
                if before > 0.0 {
                    add(before, end - 1);
                }
                if after > 0.0 {
                    add(after, end);
                }
                own
            }
        };
        velocities.into_iter().map(|velocity| velocity.extend(0.0) + drift).collect()
    }

    /// The path of the coefficients from keyframe `pair` to the next.
    pub(super) fn passage(&self, pair: usize) -> Passage {
        let [source, target] = [pair, pair + 1].map(|end| (self.coefficients(end), self.passing(end)));
        let duration = self.chain.duration(pair);
        Passage::new((&source.0, &source.1), (&target.0, &target.1), self.turn(pair), duration, self.keeps_size())
    }

    /// The modes that turn, those of the source, and the rotation by which they have met their neighbors' at the keyframe where their
    /// pair starts.
    pub(super) fn modes_at_origin(&self) -> (Arc<Pair>, Option<Arc<Planes>>) {
        match &self.modes {
            Modes::Turning(turning) => (turning.pair.clone(), turning.meetings[turning.origin].clone()),
            Modes::Places | Modes::Fixed(_) => panic!("modes that turn"),
        }
    }

    /// The modes that do not turn; none where the agents themselves move.
    pub(super) fn fixed_basis(&self) -> Option<Arc<Eigenbasis>> {
        if let Modes::Fixed(basis) = &self.modes { Some(basis.clone()) } else { None }
    }

    /// Whether the coefficients are scaled to keep the formation's size.
    pub(super) fn keeps_size(&self) -> bool {
        self.keeps_size && !matches!(self.modes, Modes::Places)
    }
}

impl Turning {
    /// The coefficients of `places` about their barycenter at keyframe `end`.
    fn coefficients(&self, places: Vec<DVec2>, end: usize) -> Vec<DVec2> {
        let met = match &self.meetings[end] {
            Some(meeting) => meeting.turned(&places, -1.0),
            None => places,
        };
        let modes = self.pair.source_modes();
        over_modes(modes.transpose(), &self.carried(met, end, self.origin))
    }

    /// Coefficients at keyframe `end` as places about the barycenter.
    fn over_agents(&self, coefficients: &[DVec2], end: usize) -> Vec<DVec2> {
        let places = self.carried(over_modes(self.pair.source_modes(), coefficients), self.origin, end);
        match &self.meetings[end] {
            Some(meeting) => meeting.turned(&places, 1.0),
            None => places,
        }
    }

    fn carried(&self, places: Vec<DVec2>, from: usize, to: usize) -> Vec<DVec2> {
        if from < to {
            (from..to).fold(places, |places, pair| needed(&self.turns, pair).turned(&places, 1.0))
        } else {
            (to..from).rev().fold(places, |places, pair| needed(&self.turns, pair).turned(&places, -1.0))
        }
    }
}

fn needed(planes: &[Option<Arc<Planes>>], pair: usize) -> &Planes {
    planes[pair].as_deref().expect("a strand is asked about the keyframes it was prepared for")
}

fn over_modes(modes: MatRef<'_, f64>, coefficients: &[DVec2]) -> Vec<DVec2> {
    let rows = Mat::from_fn(coefficients.len(), 2, |row, column| coefficients[row][column]);
    let places = product(modes, rows.as_ref());
    (0..places.nrows()).map(|row| DVec2::new(places[(row, 0)], places[(row, 1)])).collect()
}
