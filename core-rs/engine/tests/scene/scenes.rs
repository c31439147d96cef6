//! Scenes that the laws are tried on.

use std::collections::BTreeMap;
use std::sync::Arc;

use eigenform::adjacency::{AdjacencySpec, Base, Weights};
use eigenform::assignment::{AssignmentSpec, Cost};
use eigenform::choice::{Alignment, Blend, Choice, Join, MethodName, Order, Timing};
use eigenform::edits::Constants;
use eigenform::error::Error;
use eigenform::formation::Formation;
use eigenform::obstacle::ObstacleShape;
use eigenform::scene::{
    Agent, Backdrop, CrowdSpec, Group, Keyframe, NodeSpec, Obstacle, PathSpec, Scene, Segment, Stage, Tempo, Track, TransitionSpec,
};
use eigenform::scene::{Units, validate};
use glam::{DVec2, DVec3};
use proptest::collection::vec;
use proptest::option;
use proptest::prelude::*;

/// Valid scenes of every kind: few agents and many fields, coordinates of any digits, pairs lower agent first.
pub fn arbitrary_scene() -> impl Strategy<Value = Scene> {
    (0_usize..24, 1_usize..5, any::<bool>(), 0_usize..4).prop_flat_map(|(agent_count, keyframe_count, is_spatial, obstacle_count)| {
        let surroundings = (title(), any::<u32>(), stage(), tempo(), 1.0..=120.0_f64, plain_or(0.0, 0.0..=1e5));
        let joining = (join(), plain_or(0.5, 0.0..=1.0), vec(obstacle(), obstacle_count));
        let counts = Counts { agents: agent_count, obstacles: obstacle_count };
        let parts = (groups(agent_count), adjacency(counts), track(counts, keyframe_count, is_spatial));
        (surroundings, joining, parts).prop_map(|(surroundings, (join, tension, obstacles), (groups, adjacency, mut track))| {
            let (title, seed, stage, tempo, frame_rate, minimum_distance) = surroundings;
            keep_nodes_of(&groups, &mut track.segments);
            supported(Scene {
                title,
                seed,
                stage,
                tempo,
                frame_rate: frame_rate_that_fits(frame_rate, &track),
                minimum_distance,
                join,
                tension,
                groups: Arc::new(groups),
                adjacency: Arc::new(adjacency),
                tracks: vec![track],
                obstacles: Arc::new(obstacles),
            })
        })
    })
}

#[derive(Clone, Copy)]
struct Counts {
    agents: usize,
    obstacles: usize,
}

/// The scene without what this program does not do yet.
fn supported(mut scene: Scene) -> Scene {
    while let Err(Error::Unsupported { place, .. }) = validate(&scene) {
        match place.as_str() {
            "join" => scene.join = Join::default(),
            _ => panic!("{place} was made by chance but is never supported"),
        }
    }
    scene
}

fn join() -> impl Strategy<Value = Join> {
    prop::sample::select(vec![Join::Separate, Join::Smooth, Join::Product])
}

fn obstacle() -> impl Strategy<Value = Obstacle> {
    let circle = (position(), 1e-6..=1e5_f64).prop_map(|(center, radius)| ObstacleShape::Circle { center, radius });
    // Corners on a ring enclose an area, whichever they are.
    let polygon = (-9e4..9e4_f64, vec(0.5..1.0_f64, 3..12)).prop_map(|(x, reaches)| {
        let turn = std::f64::consts::TAU / reaches.len() as f64;
        let corner = |(index, reach): (usize, f64)| DVec2::new(x, -x) + DVec2::from_angle(turn * index as f64) * reach * 1e3;
        ObstacleShape::Polygon { points: reaches.into_iter().enumerate().map(corner).collect() }
    });
    (name(), prop_oneof![circle, polygon]).prop_map(|(name, shape)| Obstacle { name, shape })
}

/// Of the nodes made by chance those that name a group, each once.
fn keep_nodes_of(groups: &[Group], segments: &mut [Segment]) {
    for Segment::Transition(transition) in segments {
        let mut seen = std::collections::BTreeSet::new();
        transition.nodes.retain(|node| {
            let is_there = match node.group[..] {
                [] => true,
                [band] => (band as usize) < groups.len(),
                [band, part] => groups.get(band as usize).is_some_and(|band| (part as usize) < band.children.len()),
                _ => false,
            };
            is_there && seen.insert(node.group.clone())
        });
    }
}

/// The default half of the time: most fields of most scenes are absent.
fn plain_or(plain: f64, values: impl Strategy<Value = f64> + 'static) -> impl Strategy<Value = f64> {
    prop_oneof![Just(plain), values]
}

fn frame_rate_that_fits(frame_rate: f64, track: &Track) -> f64 {
    let samples = track.agents.len() as f64 * 3_600.0 * frame_rate;
    if samples < 1.9e7 { frame_rate } else { 30.0 }
}

fn title() -> impl Strategy<Value = String> {
    prop_oneof![Just(String::new()), "[a-z ]{1,12}", "\\PC{0,200}"]
}

fn name() -> impl Strategy<Value = String> {
    prop_oneof![Just(String::new()), "[A-Z][0-9]{1,2}", "[ -~]{1,20}", "\\PC{0,64}"]
}

fn color() -> impl Strategy<Value = String> {
    prop_oneof![Just(String::new()), "#[0-9a-f]{6}", "#[0-9A-F]{6}"]
}

fn stage() -> impl Strategy<Value = Stage> {
    use Backdrop::{FootballCollege, FootballHs, Grid, None, Soccer};
    let backdrop = prop::sample::select(vec![None, Grid, FootballCollege, FootballHs, Soccer, Backdrop::Stage]);
    let units = prop::sample::select(vec![Units::M, Units::Ft, Units::Yd, Units::Steps]);
    (plain_or(100.0, 0.1..=2e5), plain_or(60.0, 0.1..=2e5), plain_or(0.0, 0.0..=1e5), backdrop, units)
        .prop_map(|(width, depth, height, backdrop, units)| Stage { width, depth, height, backdrop, units })
}

fn tempo() -> impl Strategy<Value = Tempo> {
    (plain_or(120.0, 1.0..=1e3), 1_u32..=64, plain_or(0.0, -3_600.0..=3_600.0)).prop_map(|(beats_per_minute, beats_per_bar, start)| Tempo {
        beats_per_minute,
        beats_per_bar,
        start,
    })
}

fn track(counts: Counts, keyframe_count: usize, is_spatial: bool) -> impl Strategy<Value = Track> {
    let agents = prop_oneof![Just(vec![Agent::default(); counts.agents]), vec(agent(), counts.agents)];
    (agents, keyframes(counts, keyframe_count, is_spatial), vec(segment(counts.agents, is_spatial), keyframe_count - 1))
        .prop_map(|(agents, keyframes, segments)| with_alike_parts(Track { agents: Arc::new(agents), keyframes, segments }))
}

/// Parts of one transition say the same: any other scene is read as this one.
fn with_alike_parts(mut track: Track) -> Track {
    for ends in track.anchors().windows(2) {
        let first = track.segments[ends[0]].clone();
        track.segments[ends[0]..ends[1]].fill(first);
    }
    track
}

fn agent() -> impl Strategy<Value = Agent> {
    let max_speed = option::weighted(0.3, prop_oneof![Just(2.0), 0.01..=1e3_f64]);
    (name(), color(), plain_or(0.25, 0.0..=1e5), max_speed).prop_map(|(name, color, radius, max_speed)| Agent {
        name,
        color,
        radius,
        max_speed,
    })
}

fn keyframes(counts: Counts, keyframe_count: usize, is_spatial: bool) -> impl Strategy<Value = Vec<Keyframe>> {
    let times = vec((plain_or(4.0, 0.001..400.0), plain_or(0.0, 0.0..400.0)), keyframe_count);
    let part = (name(), flags(), formation(counts.agents, is_spatial), absent(counts.agents), option::weighted(0.2, adjacency(counts)));
    let parts = vec(part, keyframe_count);
    (plain_or(0.0, 0.0..400.0), times, parts).prop_map(|(start, times, parts)| {
        let mut time = start;
        let mut keyframes = Vec::new();
        for ((gap, hold), (name, (corner, between), formation, absent, adjacency)) in times.into_iter().zip(parts) {
            let (positions, adjacency) = (Arc::new(formation), adjacency.map(Arc::new));
            keyframes.push(Keyframe { name, time, hold, corner, between, positions, absent, adjacency });
            time += hold + gap;
        }
        keyframes
    })
}

/// A corner, and how deep it lies in a transition.
fn flags() -> impl Strategy<Value = (bool, u32)> {
    (any::<bool>(), prop_oneof![3 => Just(0), 2 => 1..=200_u32])
}

fn absent(agent_count: usize) -> impl Strategy<Value = Vec<u32>> {
    let some =
        vec(any::<bool>(), agent_count).prop_map(|gone| (0..).zip(gone).filter_map(|(agent, is_gone)| is_gone.then_some(agent)).collect());
    prop_oneof![3 => Just(Vec::new()), 1 => some]
}

fn formation(agent_count: usize, is_spatial: bool) -> impl Strategy<Value = Formation> {
    (vec(position(), agent_count), vec(coordinate(), agent_count))
        .prop_map(move |(positions, heights)| if is_spatial { Formation::spatial(positions, heights) } else { Formation::new(positions) })
}

fn position() -> impl Strategy<Value = DVec2> {
    (coordinate(), coordinate()).prop_map(|(x, y)| DVec2::new(x, y))
}

fn coordinate() -> impl Strategy<Value = f64> {
    prop_oneof![(-400_i32..400).prop_map(|step| f64::from(step) / 8.0), -50.0..50.0_f64, -1e5..=1e5_f64]
}

/// Points apart, of as many numbers as positions.
fn path(is_spatial: bool) -> impl Strategy<Value = PathSpec> {
    let point = (position(), coordinate()).prop_map(move |(place, height)| place.extend(if is_spatial { height } else { 0.0 }));
    vec(point, 2..12).prop_map(move |mut points| {
        points[1] = points[0] + if points[0].x > 0.0 { -DVec3::X } else { DVec3::X };
        PathSpec { points, is_spatial }
    })
}

fn segment(agent_count: usize, is_spatial: bool) -> impl Strategy<Value = Segment> {
    let method = prop_oneof![4 => certain_method(), 1 => Just(MethodName::Auto), 1 => Just(MethodName::Crowd)];
    let timing = prop::sample::select(vec![Timing::Linear, Timing::Smooth, Timing::Even]);
    let basics = (method, option::of(choice()), order(), alignment(), plain_or(0.5, 0.0..=1.0), any::<bool>(), timing);
    let edits = (any::<bool>(), any::<bool>(), vec(node(), 0..4), crowd(), option::weighted(0.3, assignment(agent_count)));
    let path = option::weighted(0.2, path(is_spatial));
    let transition = (basics, edits, path).prop_map(|(basics, (avoidance, hierarchy, nodes, crowd, assignment), path)| {
        let (method, chosen, order, alignment, sharing, keep_size, timing) = basics;
        TransitionSpec {
            method,
            chosen,
            order,
            alignment,
            sharing,
            keep_size,
            timing,
            avoidance,
            hierarchy,
            nodes,
            path,
            crowd,
            assignment,
        }
    });
    prop_oneof![Just(TransitionSpec::default()), transition].prop_map(Segment::Transition)
}

fn crowd() -> impl Strategy<Value = CrowdSpec> {
    let usual = Constants::default();
    let forces = (plain_or(usual.strength, 0.0..=100.0), plain_or(usual.reach, 0.01..=5.0), plain_or(usual.group_strength, 0.0..=100.0));
    let told = (certain_method(), any::<bool>(), any::<bool>(), forces, plain_or(usual.fluctuation, 0.0..=100.0), 1_u32..=64);
    let crowd =
        told.prop_map(move |(guide, direction_feedback, speed_feedback, (strength, reach, group_strength), fluctuation, sectors)| {
            let constants = Constants { strength, reach, group_strength, fluctuation, sectors, ..usual };
            CrowdSpec { guide, direction_feedback, speed_feedback, constants }
        });
    prop_oneof![Just(CrowdSpec::default()), crowd]
}

fn assignment(agent_count: usize) -> impl Strategy<Value = AssignmentSpec> {
    let cost = prop::sample::select(vec![Cost::Squared, Cost::LeastEffort, Cost::Euclidean, Cost::Manhattan, Cost::Keep]);
    let everybody = Just((0..agent_count as u32).collect::<Vec<_>>());
    let locks = (everybody.clone().prop_shuffle(), everybody.prop_shuffle(), 0..=agent_count)
        .prop_map(|(agents, slots, count)| agents.into_iter().zip(slots).take(count).collect());
    (cost, plain_or(0.9, 0.0..=1.0), locks, any::<bool>()).prop_map(|(cost, lambda, locks, keep_groups)| AssignmentSpec {
        cost,
        lambda,
        locks,
        keep_groups,
    })
}

fn node() -> impl Strategy<Value = NodeSpec> {
    let blend = (certain_method(), 0.0..=1.0_f64).prop_map(|(method, amount)| Blend { method, amount });
    (vec(0_u32..3, 0..3), certain_method(), option::of(blend)).prop_map(|(group, method, blend)| NodeSpec { group, method, blend })
}

fn certain_method() -> impl Strategy<Value = MethodName> {
    prop::sample::select(vec![MethodName::Spectral, MethodName::Shared, MethodName::Polar, MethodName::Linear])
}

fn choice() -> impl Strategy<Value = Choice> {
    (certain_method(), order(), alignment(), plain_or(0.5, 0.0..=1.0)).prop_map(|(method, order, alignment, sharing)| Choice {
        method,
        order,
        alignment,
        sharing,
    })
}

fn order() -> impl Strategy<Value = Order> {
    prop::sample::select(vec![Order::Eigenvalue, Order::Greedy, Order::Maxmin, Order::Hungarian])
}

fn alignment() -> impl Strategy<Value = Alignment> {
    prop::sample::select(vec![Alignment::None, Alignment::Pca, Alignment::Procrustes])
}

fn factor() -> impl Strategy<Value = f64> {
    prop_oneof![Just(1.0), Just(10.0), 1e-6..=1e6_f64]
}

fn adjacency(counts: Counts) -> impl Strategy<Value = AdjacencySpec> {
    let base = prop::sample::select(vec![Base::Delaunay, Base::None]);
    let weights = prop::sample::select(vec![Weights::Inverse, Weights::Unit]);
    let lists = (pairs(counts.agents), pairs(counts.agents), vec(factor(), 8), obstacle_ties(counts));
    let own = (base, weights, lists).prop_map(|(base, weights, (ties, cuts, factors, obstacle_ties))| AdjacencySpec {
        base,
        weights,
        ties: ties.into_iter().zip(factors).map(|((a, b), factor)| (a, b, factor)).collect(),
        cuts,
        obstacle_ties,
    });
    prop_oneof![Just(AdjacencySpec::default()), own]
}

fn obstacle_ties(counts: Counts) -> impl Strategy<Value = Vec<(u32, u32, f64)>> {
    vec((0_u32..24, 0_u32..4, factor()), 0..4).prop_map(move |mut ties| {
        let mut seen = std::collections::BTreeSet::new();
        ties.retain(|(agent, obstacle, _)| {
            (*agent as usize) < counts.agents && (*obstacle as usize) < counts.obstacles && seen.insert((*agent, *obstacle))
        });
        ties
    })
}

/// At most eight pairs, each once, in any order.
fn pairs(agent_count: usize) -> impl Strategy<Value = Vec<(u32, u32)>> {
    let agents = agent_count.max(1) as u32;
    vec((0..agents, 0..agents), 0..8).prop_map(|pairs| {
        let mut seen = std::collections::BTreeSet::new();
        let ordered = pairs.into_iter().map(|(a, b)| (a.min(b), a.max(b)));
        ordered.filter(|(a, b)| a != b && seen.insert((*a, *b))).collect()
    })
}

/// Up to three levels; every agent in at most one group, some in none.
fn groups(agent_count: usize) -> impl Strategy<Value = Vec<Group>> {
    let seats = vec(option::weighted(0.8, (0_usize..3, 0_usize..3)), agent_count).prop_shuffle();
    let looks = vec((name(), color(), option::weighted(0.3, factor())), 9);
    prop_oneof![Just(Vec::new()), (seats, looks, Just(agent_count)).prop_map(|(seats, looks, _)| tree(&seats, &looks))]
}

type Look = (String, String, Option<f64>);

/// Seat (band, 0) is a member of the band itself, seats (band, 1) and (band, 2) of groups within it.
fn tree(seats: &[Option<(usize, usize)>], looks: &[Look]) -> Vec<Group> {
    let mut members: BTreeMap<(usize, usize), Vec<u32>> = BTreeMap::new();
    for (agent, seat) in seats.iter().enumerate() {
        members.entry(seat.unwrap_or((usize::MAX, 0))).or_default().push(agent as u32);
    }
    let mut group = |band: usize, part: usize| {
        let (name, color, tie_weight) = looks[3 * band + part].clone();
        Group { name, color, tie_weight, members: members.remove(&(band, part)).unwrap_or_default(), children: Vec::new() }
    };
    let bands = (0..3).map(|band| Group { children: vec![group(band, 1), group(band, 2)], ..group(band, 0) });
    bands.collect()
}
