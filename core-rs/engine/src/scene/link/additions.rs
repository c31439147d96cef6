//! What a scene says beyond the format's first fields: joins, corners, avoidance, hierarchy, obstacles, heights.
//!
//! It stands behind the closing flag of `document` and ends with a flag of its own. Here, too, the order is the format.

use std::sync::Arc;

use super::absences::has_absences;
use super::crowds::has_crowds;
use super::document::Document;
use super::fields::{Fields, METHODS};
use super::graph::{Pairs, code_count};
use super::models::{Integer, Number};
use super::positions::Formations;
use super::range::Bit;
use super::recipes::has_recipes;
use super::route::Cell;
use crate::adjacency::AdjacencySpec;
use crate::choice::{Blend, Join, MethodName};
use crate::error::Error;
use crate::obstacle::ObstacleShape;
use crate::scene::{CrowdSpec, DEFAULT_TENSION, NodeSpec, Obstacle, Scene, Segment, TransitionSpec, limits};
use glam::DVec2;

// The place in this list is the value in the link: append only.
const JOINS: [Join; 3] = [Join::Separate, Join::Smooth, Join::Product];

/// Whether a document says any of it.
pub fn has_additions(document: &Document) -> bool {
    let Scene { join, tension, obstacles, adjacency, tracks, .. } = &document.scene;
    let has_ties = |spec: &AdjacencySpec| !spec.obstacle_ties.is_empty();
    let keyframes = &tracks[0].keyframes;
    *join != Join::default()
        || tension.to_bits() != DEFAULT_TENSION.to_bits()
        || !obstacles.is_empty()
        || has_ties(adjacency)
        || keyframes.iter().any(|keyframe| keyframe.corner || keyframe.adjacency.as_deref().is_some_and(has_ties))
        || tracks[0].segments.iter().any(|segment| *segment != basics_of_segment(segment))
        || !document.heights.is_empty()
        || has_crowds(&tracks[0])
        || has_absences(&tracks[0])
}

/// A segment as the first fields tell it.
pub fn basics_of_segment(Segment::Transition(transition): &Segment) -> Segment {
    Segment::Transition(TransitionSpec {
        avoidance: false,
        hierarchy: false,
        nodes: Vec::new(),
        path: None,
        crowd: CrowdSpec::default(),
        assignment: None,
        ..*transition
    })
}

/// An adjacency as the first fields tell it.
pub fn basics_of_adjacency(spec: &AdjacencySpec) -> AdjacencySpec {
    AdjacencySpec { obstacle_ties: Vec::new(), ..spec.clone() }
}

impl Fields<'_> {
    pub(super) fn code_additions(&mut self, document: &mut Document) -> Result<(), Error> {
        let Document { scene, cells, heights, .. } = document;
        self.code_word(&JOINS, &mut scene.join)?;
        self.code_usual(DEFAULT_TENSION, &mut scene.tension);
        let track = &mut scene.tracks[0];
        let mut is_corner = Bit::likely(false);
        for keyframe in &mut track.keyframes {
            self.coder.bit(&mut is_corner, &mut keyframe.corner);
        }
        self.code_edits(&mut track.segments)?;
        self.code_obstacles(Arc::make_mut(&mut scene.obstacles))?;
        let mut pairs = Pairs::default();
        self.code_obstacle_ties(&mut pairs, Arc::make_mut(&mut scene.adjacency))?;
        for own in track.keyframes.iter_mut().filter_map(|keyframe| keyframe.adjacency.as_mut()) {
            self.code_obstacle_ties(&mut pairs, Arc::make_mut(own))?;
        }
        self.code_heights(cells, heights)?;
        let track = &mut scene.tracks[0];
        let mut has_more = has_crowds(track) || has_recipes(track);
        self.coder.bit(&mut Bit::likely(false), &mut has_more);
        if has_more { self.code_crowds(track) } else { Ok(()) }
    }

    /// Avoidance and hierarchy; segments are mostly alike.
    fn code_edits(&mut self, segments: &mut [Segment]) -> Result<(), Error> {
        let mut alike = Bit::likely(true);
        let mut last = TransitionSpec::default();
        for Segment::Transition(transition) in segments {
            let TransitionSpec { avoidance, hierarchy, nodes, .. } = transition;
            let mut is_alike = (*avoidance, *hierarchy, &*nodes) == (last.avoidance, last.hierarchy, &last.nodes);
            self.coder.bit(&mut alike, &mut is_alike);
            if is_alike {
                (*avoidance, *hierarchy) = (last.avoidance, last.hierarchy);
                nodes.clone_from(&last.nodes);
            } else {
                self.coder.bit(&mut Bit::default(), avoidance);
                self.coder.bit(&mut Bit::default(), hierarchy);
                self.code_nodes(nodes)?;
                last.clone_from(transition);
            }
        }
        Ok(())
    }

    fn code_nodes(&mut self, nodes: &mut Vec<NodeSpec>) -> Result<(), Error> {
        let (mut lengths, mut indices, mut amounts) = (Integer::default(), Integer::default(), Number::default());
        let mut blends = Bit::default();
        let count = code_count(&mut Integer::default(), self.coder, nodes.len(), limits::NODES)?;
        nodes.resize(count, NodeSpec { group: Vec::new(), method: MethodName::default(), blend: None });
        for node in nodes {
            let depth = code_count(&mut lengths, self.coder, node.group.len(), limits::GROUP_DEPTH)?;
            node.group.resize(depth, 0);
            for index in &mut node.group {
                *index = code_count(&mut indices, self.coder, *index as usize, limits::GROUPS)? as u32;
            }
            self.code_word(&METHODS, &mut node.method)?;
            let mut is_blended = node.blend.is_some();
            self.coder.bit(&mut blends, &mut is_blended);
            if is_blended {
                let blend = node.blend.get_or_insert(Blend { method: MethodName::default(), amount: 0.0 });
                self.code_word(&METHODS, &mut blend.method)?;
                amounts.code(self.coder, &mut blend.amount);
            }
        }
        Ok(())
    }

    fn code_obstacles(&mut self, obstacles: &mut Vec<Obstacle>) -> Result<(), Error> {
        let (mut coordinates, mut radii, mut corners) = (Number::default(), Number::default(), Integer::default());
        let mut circles = Bit::default();
        let count = code_count(&mut Integer::default(), self.coder, obstacles.len(), limits::OBSTACLES)?;
        let blank = Obstacle { name: String::new(), shape: ObstacleShape::Circle { center: DVec2::ZERO, radius: 0.0 } };
        obstacles.resize(count, blank);
        for Obstacle { name, shape } in obstacles {
            self.texts.code_name(self.coder, name)?;
            let mut is_circle = matches!(shape, ObstacleShape::Circle { .. });
            self.coder.bit(&mut circles, &mut is_circle);
            if !is_circle && self.coder.is_reading() {
                *shape = ObstacleShape::Polygon { points: Vec::new() };
            }
            match shape {
                ObstacleShape::Circle { center, radius } => {
                    self.code_point(&mut coordinates, center);
                    radii.code(self.coder, radius);
                }
                ObstacleShape::Polygon { points } => {
                    let count = code_count(&mut corners, self.coder, points.len(), *limits::CORNERS.end())?;
                    points.resize(count, DVec2::ZERO);
                    for point in points {
                        self.code_point(&mut coordinates, point);
                    }
                }
            }
        }
        Ok(())
    }

    fn code_point(&mut self, coordinates: &mut Number, point: &mut DVec2) {
        coordinates.code(self.coder, &mut point.x);
        coordinates.code(self.coder, &mut point.y);
    }

    fn code_obstacle_ties(&mut self, pairs: &mut Pairs, spec: &mut AdjacencySpec) -> Result<(), Error> {
        let ties = &mut spec.obstacle_ties;
        let count = pairs.code_count(self.coder, ties.len(), limits::TIES_PER_KEYFRAME)?;
        ties.resize(count, (0, 0, 1.0));
        let mut last = (0, 0, 1.0);
        for tie in ties {
            pairs.code_pair(self.coder, (last.0, last.1), (&mut tie.0, &mut tie.1))?;
            pairs.code_factor(self.coder, last.2, &mut tie.2);
            last = *tie;
        }
        Ok(())
    }

    /// As formations of their own: what makes those short makes heights short.
    fn code_heights(&mut self, cells: &[Vec<Cell>], heights: &mut Vec<Vec<i64>>) -> Result<(), Error> {
        let mut is_spatial = !heights.is_empty();
        self.coder.bit(&mut Bit::default(), &mut is_spatial);
        if !is_spatial {
            return Ok(());
        }
        heights.resize(cells.len(), Vec::new());
        let mut formations = Formations::default();
        for (heights, cells) in heights.iter_mut().zip(cells) {
            heights.resize(cells.len(), 0);
            let mut raised: Vec<Cell> = heights.iter().map(|height| [*height, 0]).collect();
            formations.code(self.coder, &mut raised)?;
            *heights = raised.into_iter().map(|[height, _]| height).collect();
        }
        Ok(())
    }
}
