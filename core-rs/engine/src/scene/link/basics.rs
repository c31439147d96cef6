//! What a link says of a scene, field by field, for both directions.
//!
//! The order here is the format: links are for ever, so nothing moves, and what later versions add goes behind the closing flag.

use std::sync::Arc;

use super::additions::{basics_of_adjacency, basics_of_segment, has_additions};
use super::document::Document;
use super::fields::{Fields, METHODS, as_integer, newer};
use super::graph::{Members, Pairs};
use super::models::{Number, Symbol, code_even};
use super::names::Texts;
use super::positions::Formations;
use super::range::{Bit, Coder};
use super::route::Cell;
use crate::adjacency::{AdjacencySpec, Base, Weights};
use crate::choice::{Alignment, Choice, DEFAULT_SHARING, MethodName, Order, Timing};
use crate::error::Error;
use crate::scene::{Agent, Backdrop, Group, Keyframe, Scene, Segment, Stage, Tempo, Track, TransitionSpec, Units, limits};

// The place in these lists is the value in the link: append only.
const BACKDROPS: [Backdrop; 6] =
    [Backdrop::Grid, Backdrop::None, Backdrop::FootballCollege, Backdrop::FootballHs, Backdrop::Soccer, Backdrop::Stage];
const UNITS: [Units; 4] = [Units::M, Units::Ft, Units::Yd, Units::Steps];
const ORDERS: [Order; 4] = [Order::Greedy, Order::Eigenvalue, Order::Maxmin, Order::Hungarian];
const ALIGNMENTS: [Alignment; 3] = [Alignment::Pca, Alignment::None, Alignment::Procrustes];
const TIMINGS: [Timing; 3] = [Timing::Smooth, Timing::Linear, Timing::Even];
const BASES: [Base; 2] = [Base::Delaunay, Base::None];
const WEIGHTS: [Weights; 2] = [Weights::Inverse, Weights::Unit];

/// Codes a whole scene; a reader starts from the default one.
pub fn code_document(coder: &mut dyn Coder, document: &mut Document) -> Result<(), Error> {
    let mut fields = Fields { coder, texts: Texts::default(), pairs: Pairs::default() };
    let Document { scene, step, cells, .. } = document;
    fields.code_surroundings(scene)?;
    step.code(fields.coder)?;
    let (agent_count, keyframe_count) = fields.code_counts(cells)?;
    if fields.coder.is_reading() {
        scene.tracks = vec![blank_track(agent_count, keyframe_count)];
        *cells = vec![vec![[0; 2]; agent_count]; keyframe_count];
    }
    let track = &mut scene.tracks[0];
    fields.code_keyframes(&mut track.keyframes, cells)?;
    fields.code_agents(Arc::<Vec<Agent>>::make_mut(&mut track.agents))?;
    fields.code_groups(Arc::make_mut(&mut scene.groups), &mut Tree { members: Members::new(agent_count), group_count: 0, depth: 0 })?;
    fields.code_adjacency(Arc::make_mut(&mut scene.adjacency))?;
    fields.code_segments(&mut track.segments)?;
    let mut has_more = has_additions(document);
    fields.coder.bit(&mut Bit::likely(false), &mut has_more);
    if has_more { fields.code_additions(document) } else { Ok(()) }
}

fn blank_track(agent_count: usize, keyframe_count: usize) -> Track {
    let keyframes = vec![Keyframe::default(); keyframe_count];
    let segments = vec![Segment::default(); keyframe_count.saturating_sub(1)];
    Track { agents: Arc::new(vec![Agent::default(); agent_count]), keyframes, segments }
}

struct Tree {
    members: Members,
    group_count: usize,
    depth: usize,
}

impl Fields<'_> {
    fn code_surroundings(&mut self, scene: &mut Scene) -> Result<(), Error> {
        self.texts.code_name(self.coder, &mut scene.title)?;
        let mut seed = f64::from(scene.seed);
        self.code_usual(0.0, &mut seed);
        scene.seed = as_integer(seed)?;
        let blank = Scene::default();
        let Stage { width, depth, height, backdrop, units } = &mut scene.stage;
        self.code_usual(blank.stage.width, width);
        self.code_usual(blank.stage.depth, depth);
        self.code_usual(blank.stage.height, height);
        self.code_word(&BACKDROPS, backdrop)?;
        self.code_word(&UNITS, units)?;
        let Tempo { beats_per_minute, beats_per_bar, start } = &mut scene.tempo;
        self.code_usual(blank.tempo.beats_per_minute, beats_per_minute);
        let mut beats = f64::from(*beats_per_bar);
        self.code_usual(f64::from(blank.tempo.beats_per_bar), &mut beats);
        *beats_per_bar = as_integer(beats)?;
        self.code_usual(blank.tempo.start, start);
        self.code_usual(blank.frame_rate, &mut scene.frame_rate);
        self.code_usual(blank.minimum_distance, &mut scene.minimum_distance);
        Ok(())
    }

    /// How many agents and keyframes; a reader refuses too many before it makes room for them.
    fn code_counts(&mut self, cells: &[Vec<Cell>]) -> Result<(usize, usize), Error> {
        let mut agent_count = cells.first().map_or(0, Vec::len) as u64;
        let mut keyframe_count = cells.len() as u64;
        code_even(self.coder, 1 << 13, &mut agent_count);
        code_even(self.coder, 1 << 8, &mut keyframe_count);
        let (agents, keyframes) = (agent_count as usize, keyframe_count as usize);
        let fits = agents <= limits::AGENTS && keyframes <= limits::KEYFRAMES && agents * keyframes <= limits::POSITIONS;
        if fits { Ok((agents, keyframes)) } else { Err(Error::LinkTooLarge) }
    }

    fn code_keyframes(&mut self, keyframes: &mut [Keyframe], cells: &mut [Vec<Cell>]) -> Result<(), Error> {
        let (mut times, mut holds) = (Number::default(), Number::default());
        let (mut holds_on, mut has_own) = (Bit::likely(false), Bit::likely(false));
        let mut formations = Formations::default();
        for (keyframe, cells) in keyframes.iter_mut().zip(cells) {
            self.texts.code_name(self.coder, &mut keyframe.name)?;
            times.code(self.coder, &mut keyframe.time);
            let mut holds_here = keyframe.hold.to_bits() != 0;
            self.coder.bit(&mut holds_on, &mut holds_here);
            if holds_here {
                holds.code(self.coder, &mut keyframe.hold);
            }
            formations.code(self.coder, cells)?;
            let mut has_own_here = keyframe.adjacency.is_some();
            self.coder.bit(&mut has_own, &mut has_own_here);
            if has_own_here {
                self.code_adjacency(Arc::make_mut(keyframe.adjacency.get_or_insert_default()))?;
            }
        }
        Ok(())
    }

    fn code_agents(&mut self, agents: &mut [Agent]) -> Result<(), Error> {
        let blank = Agent::default();
        let (mut is_usual, mut radius) = (Bit::likely(true), Number::default());
        for agent in agents {
            self.texts.code_name(self.coder, &mut agent.name)?;
            self.texts.code_color(self.coder, &mut agent.color)?;
            self.code_number(&mut is_usual, &mut radius, blank.radius, &mut agent.radius);
        }
        Ok(())
    }

    fn code_groups(&mut self, groups: &mut Vec<Group>, tree: &mut Tree) -> Result<(), Error> {
        let mut at = 0;
        loop {
            let mut has_next = at < groups.len();
            self.coder.bit(&mut Bit::likely(tree.depth == 0 && tree.group_count > 0), &mut has_next);
            if !has_next {
                return Ok(());
            }
            tree.group_count += 1;
            if tree.group_count > limits::GROUPS || tree.depth >= limits::GROUP_DEPTH {
                return Err(Error::LinkTooLarge);
            }
            if at == groups.len() {
                groups.push(Group::default());
            }
            self.code_group(&mut groups[at], tree)?;
            at += 1;
        }
    }

    fn code_group(&mut self, group: &mut Group, tree: &mut Tree) -> Result<(), Error> {
        self.texts.code_name(self.coder, &mut group.name)?;
        self.texts.code_color(self.coder, &mut group.color)?;
        tree.members.code(self.coder, &mut group.members)?;
        let mut has_weight = group.tie_weight.is_some();
        self.coder.bit(&mut Bit::likely(false), &mut has_weight);
        if has_weight {
            Number::default().code(self.coder, group.tie_weight.get_or_insert_default());
        }
        tree.depth += 1;
        self.code_groups(&mut group.children, tree)?;
        tree.depth -= 1;
        Ok(())
    }

    fn code_adjacency(&mut self, spec: &mut AdjacencySpec) -> Result<(), Error> {
        let mut is_blank = basics_of_adjacency(spec) == AdjacencySpec::default();
        self.coder.bit(&mut Bit::likely(true), &mut is_blank);
        if is_blank {
            return Ok(());
        }
        self.code_word(&BASES, &mut spec.base)?;
        self.code_word(&WEIGHTS, &mut spec.weights)?;
        let count = self.pairs.code_count(self.coder, spec.ties.len(), limits::TIES_PER_KEYFRAME)?;
        spec.ties.resize(count, (0, 0, 1.0));
        let mut last = (0, 0, 1.0);
        for tie in &mut spec.ties {
            self.pairs.code_pair(self.coder, (last.0, last.1), (&mut tie.0, &mut tie.1))?;
            self.pairs.code_factor(self.coder, last.2, &mut tie.2);
            last = *tie;
        }
        let count = self.pairs.code_count(self.coder, spec.cuts.len(), limits::CUTS)?;
        spec.cuts.resize(count, (0, 0));
        let mut last = (0, 0);
        for cut in &mut spec.cuts {
            self.pairs.code_pair(self.coder, last, (&mut cut.0, &mut cut.1))?;
            last = *cut;
        }
        Ok(())
    }

    /// Segments are mostly alike: each says whether it is as the one before.
    fn code_segments(&mut self, segments: &mut [Segment]) -> Result<(), Error> {
        let mut alike = Bit::likely(true);
        let mut last = Segment::default();
        for segment in segments {
            let mut is_alike = basics_of_segment(segment) == last;
            self.coder.bit(&mut alike, &mut is_alike);
            if is_alike {
                if self.coder.is_reading() {
                    segment.clone_from(&last);
                }
            } else {
                let mut kind = 0;
                Symbol::new(2).code(self.coder, &mut kind);
                if kind != 0 {
                    return Err(newer());
                }
                let Segment::Transition(transition) = segment;
                self.code_transition(transition)?;
            }
            last = basics_of_segment(segment);
        }
        Ok(())
    }

    fn code_transition(&mut self, transition: &mut TransitionSpec) -> Result<(), Error> {
        let TransitionSpec { method, chosen, order, alignment, sharing, keep_size, timing, .. } = transition;
        self.code_word(&METHODS, method)?;
        self.code_word(&ORDERS, order)?;
        self.code_word(&ALIGNMENTS, alignment)?;
        self.code_usual(DEFAULT_SHARING, sharing);
        self.coder.bit(&mut Bit::likely(false), keep_size);
        self.code_word(&TIMINGS, timing)?;
        let mut is_chosen = chosen.is_some();
        self.coder.bit(&mut Bit::default(), &mut is_chosen);
        if is_chosen {
            let blank = Choice {
                method: MethodName::default(),
                order: Order::default(),
                alignment: Alignment::default(),
                sharing: DEFAULT_SHARING,
            };
            let choice = chosen.get_or_insert(blank);
            self.code_word(&METHODS, &mut choice.method)?;
            self.code_word(&ORDERS, &mut choice.order)?;
            self.code_word(&ALIGNMENTS, &mut choice.alignment)?;
            self.code_usual(DEFAULT_SHARING, &mut choice.sharing);
        }
        Ok(())
    }
}
