//! The laws of motion by groups, from a scene to its positions.

use std::sync::Arc;

use eigenform::adjacency::{AdjacencySpec, Base, Weights};
use eigenform::choice::{Blend, Join, MethodName, Order, Timing};
use eigenform::formation::Formation;
use eigenform::perform::{Performance, Performer, perform};
use eigenform::scene::{Agent, Group, Keyframe, NodeSpec, Scene, Segment, Track, TransitionSpec};
use glam::DVec2;
use proptest::prelude::*;

use crate::formations::grid;
use crate::transition::cases::scattered;

const METHODS: [MethodName; 4] = [MethodName::Linear, MethodName::Polar, MethodName::Shared, MethodName::Spectral];
const SECONDS: f64 = 4.0;

fn spec(method: MethodName) -> TransitionSpec {
    TransitionSpec { method, hierarchy: true, timing: Timing::Linear, order: Order::Hungarian, ..TransitionSpec::default() }
}

/// Keyframes four seconds apart, all segments alike.
fn scene(keyframes: &[Vec<DVec2>], groups: Vec<Group>, spec: &TransitionSpec, join: Join) -> Scene {
    let agents = Arc::new(vec![Agent::default(); keyframes[0].len()]);
    let segments = vec![Segment::Transition(spec.clone()); keyframes.len() - 1];
    let keyframes = keyframes.iter().zip(0..).map(|(positions, k)| Keyframe {
        time: SECONDS * f64::from(k),
        positions: Arc::new(Formation::new(positions.clone())),
        ..Keyframe::default()
    });
    let track = Track { agents, keyframes: keyframes.collect(), segments };
    Scene { groups: Arc::new(groups), join, frame_rate: 5.0, tracks: vec![track], ..Scene::default() }
}

fn leaf(members: impl IntoIterator<Item = u32>) -> Group {
    Group { members: members.into_iter().collect(), ..Group::default() }
}

/// Eighteen agents: two groups within one, a group beside it, two agents alone.
fn groups() -> Vec<Group> {
    vec![Group { children: vec![leaf(0..5), leaf(5..9)], ..leaf([9]) }, leaf(10..16)]
}

fn keyframes() -> Vec<Vec<DVec2>> {
    (1..=4).map(|seed| scattered(18, seed)).collect()
}

fn barycenter(positions: &[DVec2], members: &[u32]) -> DVec2 {
    members.iter().map(|agent| positions[*agent as usize]).sum::<DVec2>() / members.len() as f64
}

fn farthest(p: &[DVec2], q: &[DVec2]) -> f64 {
    assert_eq!(p.len(), q.len());
    p.iter().zip(q).map(|(p, q)| if p.is_finite() && q.is_finite() { p.distance(*q) } else { f64::INFINITY }).fold(0.0, f64::max)
}

fn performed(scene: &Scene) -> Performance {
    perform(scene).expect("the scene can be performed")
}

/// Positions of both scenes differ by at most `tolerance` at some instants inside every segment.
fn check_alike(one: &Scene, other: &Scene, tolerance: f64, what: &str) {
    let (one, other) = (performed(one), performed(other));
    for eighth in 0..=8 * (one.segments().len() as u32) {
        let time = SECONDS * f64::from(eighth) / 8.0;
        let off = farthest(&one.positions_at(time), &other.positions_at(time));
        assert!(off <= tolerance, "{what}: {off:e} apart at {time} s");
    }
}

#[test]
fn without_groups_it_is_the_flat_method_to_the_last_bit() {
    for method in METHODS {
        for join in [Join::Separate, Join::Smooth] {
            let flat = TransitionSpec { hierarchy: false, ..spec(method) };
            check_alike(&scene(&keyframes(), vec![], &spec(method), join), &scene(&keyframes(), vec![], &flat, join), 0.0, "no groups");
        }
    }
}

#[test]
fn one_group_of_everybody_is_the_flat_method() {
    // Polar lets the mean place of the agents stray from the straight line of the barycenter; a group's is held to it.
    for method in METHODS.into_iter().filter(|method| *method != MethodName::Polar) {
        for join in [Join::Separate, Join::Smooth] {
            let flat = TransitionSpec { hierarchy: false, ..spec(method) };
            let everybody = scene(&keyframes(), vec![leaf(0..18)], &spec(method), join);
            // Within a group positions and weights are rounded at 1e-11 of their size; modes amplify it by the largest eigenvalue over
            // the least gap, which for these stays below 1e4.
            check_alike(&everybody, &scene(&keyframes(), vec![], &flat, join), 1e-6, &format!("one group, {method:?} {join:?}"));
        }
    }
}

#[test]
fn every_keyframe_is_exact_under_every_method_and_join() {
    for method in METHODS {
        for join in [Join::Separate, Join::Smooth, Join::Product] {
            let show = performed(&scene(&keyframes(), groups(), &spec(method), join));
            for (k, keyframe) in keyframes().iter().enumerate() {
                for segment in [k.checked_sub(1), (k < 3).then_some(k)].into_iter().flatten() {
                    let mut out = vec![DVec2::NAN; 18];
                    show.segments()[segment].places_into(&[SECONDS * k as f64], &mut out, None);
                    let off = farthest(&out, keyframe);
                    assert!(off <= 1e-9 * 28.0, "{method:?} {join:?}: keyframe {k} missed by {off:e}");
                }
            }
        }
    }
}

#[test]
fn the_barycenter_of_every_group_moves_as_the_node_formation_says() {
    let outer: [Vec<u32>; 4] = [(0..10).collect(), (10..16).collect(), vec![16], vec![17]];
    for method in METHODS {
        for join in [Join::Separate, Join::Smooth] {
            let show = performed(&scene(&keyframes(), groups(), &spec(method), join));
            let centers: Vec<Vec<DVec2>> =
                keyframes().iter().map(|at| outer.iter().map(|members| barycenter(at, members)).collect()).collect();
            // The same ties, summed between groups, as a scene of its own.
            let mut points = scene(&centers, vec![], &spec(method), join);
            for (k, keyframe) in points.tracks[0].keyframes.iter_mut().enumerate() {
                let graph = Performer::default().graph(show.scene(), k).expect("few ties");
                let home = |agent: u32| outer.iter().position(|members| members.contains(&agent)).expect("in one of them") as u32;
                let mut sums = std::collections::BTreeMap::new();
                for tie in graph.ties() {
                    let (a, b) = (home(tie.a), home(tie.b));
                    if a != b {
                        *sums.entry((a.min(b), a.max(b))).or_insert(0.0) += tie.weight;
                    }
                }
                let ties = sums.into_iter().map(|((a, b), weight)| (a, b, weight)).collect();
                let own = AdjacencySpec { base: Base::None, weights: Weights::Unit, ties, ..AdjacencySpec::default() };
                keyframe.adjacency = Some(Arc::new(own));
            }
            let expected = performed(&points);
            for time in [0.5, 1.7, 4.9, 7.0, 10.3] {
                let at = show.positions_at(time);
                let found: Vec<DVec2> = outer.iter().map(|members| barycenter(&at, members)).collect();
                let off = farthest(&found, &expected.positions_at(time));
                assert!(off <= 1e-7, "{method:?} {join:?}: {off:e} off at {time} s");
            }
        }
    }
}

fn renamed(agent: u32) -> u32 {
    (agent * 5 + 3) % 18
}

fn renamed_groups(groups: &[Group]) -> Vec<Group> {
    let rename = |group: &Group| Group {
        members: group.members.iter().map(|agent| renamed(*agent)).collect(),
        children: renamed_groups(&group.children),
        ..Group::default()
    };
    groups.iter().map(rename).collect()
}

#[test]
fn new_labels_relabel_the_paths() {
    let relabel = |at: &Vec<DVec2>| {
        let mut moved = at.clone();
        for agent in 0..18 {
            moved[renamed(agent) as usize] = at[agent as usize];
        }
        moved
    };
    let relabeled: Vec<Vec<DVec2>> = keyframes().iter().map(relabel).collect();
    for method in METHODS {
        let one = performed(&scene(&keyframes(), groups(), &spec(method), Join::Separate));
        let other = performed(&scene(&relabeled, renamed_groups(&groups()), &spec(method), Join::Separate));
        let (one, other) = (one.positions_at(1.3), other.positions_at(1.3));
        let back: Vec<DVec2> = (0..18).map(|agent| other[renamed(agent) as usize]).collect();
        // Rounding within groups may fall to the other side of a half, as in the law of one group.
        assert!(farthest(&one, &back) <= 1e-6, "{method:?}");
    }
}

#[test]
fn a_common_rigid_motion_moves_the_paths() {
    let turned = |p: DVec2| DVec2::from_angle(0.7).rotate(p) + DVec2::new(30.0, -4.0);
    for method in METHODS {
        let moved: Vec<Vec<DVec2>> = keyframes().iter().map(|at| at.iter().map(|p| turned(*p)).collect()).collect();
        let one = performed(&scene(&keyframes(), groups(), &spec(method), Join::Smooth)).positions_at(5.3);
        let other = performed(&scene(&moved, groups(), &spec(method), Join::Smooth)).positions_at(5.3);
        let expected: Vec<DVec2> = one.iter().map(|p| turned(*p)).collect();
        assert!(farthest(&expected, &other) <= 1e-6, "{method:?}");
    }
}

#[test]
fn a_group_moves_by_the_method_of_its_own() {
    let own = NodeSpec { group: vec![1], method: MethodName::Linear, blend: None };
    let spec = TransitionSpec { nodes: vec![own], ..spec(MethodName::Spectral) };
    let show = performed(&scene(&keyframes(), groups(), &spec, Join::Separate));
    let members: Vec<u32> = (10..16).collect();
    let about = |at: &[DVec2]| members.iter().map(|agent| at[*agent as usize] - barycenter(at, &members)).collect::<Vec<_>>();
    let [from, to] = [0, 1].map(|k| about(&keyframes()[k]));
    let halfway: Vec<DVec2> = from.iter().zip(&to).map(|(p, q)| 0.5 * (*p + *q)).collect();
    assert!(farthest(&about(&show.positions_at(2.0)), &halfway) <= 1e-9);
}

#[test]
fn a_blend_of_nothing_or_all_is_the_one_method_or_the_other() {
    let with = |method, blend| {
        let node = |group: Vec<u32>| NodeSpec { group, method, blend };
        let nodes = [vec![], vec![0], vec![0, 0], vec![0, 1], vec![1]].map(node).to_vec();
        scene(&keyframes(), groups(), &TransitionSpec { nodes, ..spec(MethodName::Polar) }, Join::Smooth)
    };
    let blend = |amount| Some(Blend { method: MethodName::Spectral, amount });
    check_alike(&with(MethodName::Linear, blend(0.0)), &with(MethodName::Linear, None), 1e-9, "nothing");
    check_alike(&with(MethodName::Linear, blend(1.0)), &with(MethodName::Spectral, None), 1e-9, "all");
    let halfway = performed(&with(MethodName::Linear, blend(0.5))).positions_at(1.0);
    let pure = [MethodName::Linear, MethodName::Spectral].map(|method| performed(&with(method, None)).positions_at(1.0));
    let mean: Vec<DVec2> = pure[0].iter().zip(&pure[1]).map(|(p, q)| 0.5 * (*p + *q)).collect();
    assert!(farthest(&halfway, &mean) <= 1e-9);
}

#[test]
fn groups_pass_a_keyframe_with_one_velocity() {
    for method in METHODS {
        let show = performed(&scene(&keyframes(), groups(), &spec(method), Join::Smooth));
        let step = 1e-4;
        for k in [1.0, 2.0] {
            let at = |shift: f64| show.positions_at(SECONDS * k + shift);
            let [before, here, after] = [at(-step), at(0.0), at(step)];
            let jump = (0..18).map(|i| ((after[i] - here[i]) - (here[i] - before[i])).length() / step).fold(0.0, f64::max);
            // A velocity that does not jump changes by the acceleration times the step: here below 100 m/s² · 1e-4 s.
            assert!(jump <= 1e-2, "{method:?}: the velocity jumps by {jump} m/s at keyframe {k}");
        }
    }
}

/// Two lines of blocks of six within groups of eighteen.
fn blocks(columns: u32) -> (Vec<DVec2>, Vec<Group>) {
    let block = |column: u32, row: u32| {
        grid(3, 2).into_iter().map(move |p| p + DVec2::new(f64::from(column) * 5.0 + 0.01 * f64::from(row * row), f64::from(row) * 4.0))
    };
    let positions = (0..columns).flat_map(|column| (0..3).flat_map(move |row| block(column, row))).collect();
    let groups = (0..columns).map(|column| {
        let children = (0..3).map(|row| leaf(18 * column + 6 * row..18 * column + 6 * row + 6)).collect();
        Group { children, tie_weight: Some(5.0), ..Group::default() }
    });
    (positions, groups.collect())
}

#[test]
fn what_is_remembered_of_a_segment_changes_nothing() {
    let (first, groups) = blocks(6);
    let second: Vec<DVec2> = first.iter().map(|p| DVec2::from_angle(1.1).rotate(*p) * 1.2).collect();
    let mut show = scene(&[first.clone(), second.clone(), first], groups, &spec(MethodName::Spectral), Join::Smooth);
    let mut performer = Performer::default();
    performer.perform(&show).expect("the scene can be performed");
    for (step, by) in [DVec2::new(2.13, -0.4), DVec2::new(-7.7, 3.0)].into_iter().enumerate() {
        let mut moved = second.clone();
        for p in &mut moved[18..36] {
            *p += by * (step + 1) as f64;
        }
        show.tracks[0].keyframes[1].positions = Arc::new(Formation::new(moved));
        let again = performer.perform(&show).expect("the scene can be performed");
        let fresh = performed(&show);
        for time in [0.8, 3.9, 4.0, 6.1] {
            assert_eq!(again.positions_at(time), fresh.positions_at(time));
        }
        for (again, fresh) in again.segments().iter().zip(fresh.segments()) {
            assert_eq!(again.motion, fresh.motion);
        }
    }
}

#[test]
fn auto_tries_its_candidates_as_the_method_of_every_group_without_one() {
    let node = NodeSpec { group: vec![1], method: MethodName::Linear, blend: None };
    let auto = TransitionSpec { nodes: vec![node], ..spec(MethodName::Auto) };
    let show = performed(&scene(&keyframes(), groups(), &auto, Join::Separate));
    let taken = show.segments()[0].choice;
    assert_eq!(show.segments()[0].candidates.len(), 11);
    let fixed = TransitionSpec { chosen: Some(taken), ..auto.clone() };
    assert_eq!(performed(&scene(&keyframes(), groups(), &fixed, Join::Separate)).positions_at(1.0), show.positions_at(1.0));
}

/// Every agent somewhere in a tree of up to four levels, with groups of one and of nobody.
fn any_tree(agent_count: u32) -> impl Strategy<Value = Vec<Group>> {
    prop::collection::vec((0_usize..4, 0_usize..3, 0_usize..3), agent_count as usize).prop_map(|seats| {
        fn group(seats: &[(u32, Vec<usize>)], depth: usize) -> Group {
            let members = seats.iter().filter(|(_, seat)| seat.len() == depth).map(|(agent, _)| *agent).collect();
            let inner = |child: usize| -> Vec<_> { seats.iter().filter(|(_, seat)| seat.get(depth) == Some(&child)).cloned().collect() };
            let children = if depth < 3 { (0..3).map(|child| group(&inner(child), depth + 1)).collect() } else { Vec::new() };
            Group { members, children, ..Group::default() }
        }
        let seats: Vec<(u32, Vec<usize>)> = (0..)
            .zip(&seats)
            .map(|(agent, &(depth, a, b))| (agent, [a, b, a + b].iter().take(depth).map(|step| step % 3).collect()))
            .collect();
        let root = group(&seats, 0);
        root.children
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(40))]

    #[test]
    fn any_tree_has_exact_ends_and_no_answer_is_nan(
        groups in any_tree(14),
        (source, target) in (crate::formations::any_formation(), crate::formations::any_formation()),
        method in prop::sample::select(METHODS.to_vec()),
    ) {
        let pad = |mut points: Vec<DVec2>| { points.truncate(14); points.resize(14, DVec2::new(3.0, 4.0)); points };
        let ends = [pad(source), pad(target)];
        let show = performed(&scene(&ends, groups, &spec(method), Join::Separate));
        let extent = ends.iter().map(|end| Formation::new(end.clone()).extent()).fold(1.0, f64::max);
        for (time, end) in [(0.0, &ends[0]), (SECONDS, &ends[1])] {
            let mut out = vec![DVec2::NAN; 14];
            show.segments()[0].places_into(&[time], &mut out, None);
            prop_assert!(farthest(&out, end) <= 1e-9 * extent);
        }
        prop_assert!(show.positions_at(1.1).iter().all(|p| p.is_finite()));
    }
}
