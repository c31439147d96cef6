//! What a valid scene asks for and cannot have: told, never refused.

use glam::DVec3;

use super::{Keyframe, Scene, Segment, Stage};
use crate::choice::MethodName;
use crate::formation::PairSearch;
use crate::obstacle::{ObstacleShape, crossing_on_the_way};

/// More agents in one obstacle are counted, not listed.
const MOST_LISTED: usize = 5;

/// Places are exact to a thousandth of this, meters: what avoidance lets pass.
const ROUND_OFF: f64 = 1e-6;

/// A sentence each: what, where and what helps.
pub fn cautions(scene: &Scene) -> Vec<String> {
    crowding(scene).into_iter().chain(too_near(scene)).chain(covered(scene)).chain(crossed(scene)).chain(late(scene)).collect()
}

/// A minimum distance that the stage cannot hold, for whoever stays on it: it is no wall.
fn crowding(scene: &Scene) -> Option<String> {
    let Scene { stage: Stage { width, depth, .. }, minimum_distance: distance, .. } = *scene;
    let track = scene.main_track();
    let is_level = track.keyframes.iter().all(|keyframe| keyframe.positions.places().is_level());
    let count = track.agents.len();
    let most = most_apart([width, depth], distance);
    (is_level && most < count).then(|| {
        let fitting = widest_apart([width, depth], count);
        let agents = if most == 1 { "agent" } else { "agents" };
        format!(
            "a stage of {width} × {depth} m holds at most {most} {agents} {distance} m apart, and the scene has {count}; \
             {fitting:.2} m fits, or a larger stage (minimumDistance)"
        )
    })
}

/// How many places of a rectangle can be `distance` apart, at most (Oler's bound).
fn most_apart([width, depth]: [f64; 2], distance: f64) -> usize {
    if distance <= 0.0 {
        return usize::MAX;
    }
    let [w, d] = [width / distance, depth / distance];
    // As a hexagonal lattice fills the plane, and half a row more along the edges; a float ends at the greatest integer.
    (2.0 / 3.0_f64.sqrt() * w * d + (w + d) + 1.0 + 1e-9) as usize
}

/// A distance at which so many places surely fit: the widest of square grids, in whole centimeters.
fn widest_apart([width, depth]: [f64; 2], count: usize) -> f64 {
    let spacing = |rows: usize| {
        let columns = count.div_ceil(rows);
        let along = |length: f64, places: usize| if places > 1 { length / (places - 1) as f64 } else { f64::INFINITY };
        along(width, columns).min(along(depth, rows))
    };
    let widest = (1..=count).map(spacing).fold(0.0, f64::max);
    (widest * 100.0 + 1e-9).floor() / 100.0
}

/// Keyframes in which agents stand nearer to one another than the minimum distance.
fn too_near(scene: &Scene) -> impl Iterator<Item = String> {
    let least = scene.minimum_distance - ROUND_OFF;
    let keyframes: &[Keyframe] = if least > 0.0 { &scene.main_track().keyframes } else { &[] };
    keyframes.iter().enumerate().filter_map(move |(index, keyframe)| {
        let places = keyframe.positions.places();
        let is_there = |agent: u32| keyframe.absent.binary_search(&agent).is_err();
        let (mut nearest, mut count) = ((f64::INFINITY, 0, 0), 0_usize);
        PairSearch::default().for_each_within(places.plan(), least, |a, b, _| {
            let distance = places.at(a as usize).distance(places.at(b as usize));
            if distance < least && is_there(a) && is_there(b) {
                count += 1;
                nearest = if distance < nearest.0 { (distance, a, b) } else { nearest };
            }
        });
        let (distance, a, b) = nearest;
        let others = if count > 1 { format!(", the nearest of {count} pairs") } else { String::new() };
        (count > 0).then(|| {
            format!(
                "agents {a} and {b} stand {distance:.3} m apart{others}, and the minimum distance is {} m; a keyframe is never changed, \
                 so move them or lower the distance (keyframes[{index}])",
                scene.minimum_distance
            )
        })
    })
}

/// Keyframes that have agents within obstacles.
fn covered(scene: &Scene) -> impl Iterator<Item = String> {
    let keyframes = scene.main_track().keyframes.iter().enumerate();
    keyframes.flat_map(|(index, keyframe)| {
        let plan = keyframe.positions.positions();
        let is_there = |agent: usize| keyframe.absent.binary_search(&(agent as u32)).is_err();
        let within = move |shape: &ObstacleShape| -> Vec<usize> {
            (0..plan.len()).filter(|agent| is_there(*agent) && shape.contains(plan[*agent])).collect()
        };
        let agents = scene.obstacles.iter().map(move |obstacle| within(&obstacle.shape)).enumerate();
        agents.filter(|(_, agents)| !agents.is_empty()).map(move |(obstacle, agents)| {
            let place = format!("keyframes[{index}].positions[{}]", agents[0]);
            format!("{} within obstacle {obstacle}; a keyframe is never changed, so move them or the obstacle ({place})", listed(&agents))
        })
    })
}

/// Paths that cross themselves. They are followed all the same: at no instant is the formation in two places, and its agents are as far
/// apart as on any other path.
fn crossed(scene: &Scene) -> impl Iterator<Item = String> {
    scene.main_track().segments.iter().enumerate().filter_map(|(index, Segment::Transition(transition))| {
        let plan: Vec<_> = transition.path.as_ref()?.points.iter().copied().map(DVec3::truncate).collect();
        let (first, second) = crossing_on_the_way(&plan)?;
        Some(format!(
            "the path crosses itself after points {first} and {second}, so the formation passes there twice; nobody comes nearer to \
             anybody for it, and other points take the crossing out (segments[{index}].path)"
        ))
    })
}

/// Crowds in which somebody cannot arrive at its top speed, not even straight on. It arrives all the same, faster than that.
fn late(scene: &Scene) -> impl Iterator<Item = String> {
    let track = scene.main_track();
    track.segments.iter().enumerate().filter_map(move |(index, Segment::Transition(transition))| {
        let [from, to] = [&track.keyframes[index], &track.keyframes[index + 1]];
        let seconds = to.time - (from.time + from.hold);
        let is_there = |agent: usize| [from, to].iter().all(|keyframe| keyframe.absent.binary_search(&(agent as u32)).is_err());
        let way = |agent: usize| to.positions.positions()[agent].distance(from.positions.positions()[agent]);
        let limited = track.agents.iter().enumerate().filter(|(agent, _)| is_there(*agent));
        let needs = limited.filter_map(|(agent, body)| Some((agent, body.max_speed?, way(agent) / body.max_speed?)));
        let late: Vec<_> = needs.filter(|(_, _, needed)| *needed > seconds).collect();
        let (agent, max_speed, needed) = *late.iter().max_by(|a, b| a.2.total_cmp(&b.2))?;
        let others = if late.len() > 1 { format!(" and {} more have", late.len() - 1) } else { " has".to_owned() };
        (transition.method == MethodName::Crowd).then(|| {
            format!(
                "agent {agent}{others} farther to go than a top speed allows: {:.2} m in {seconds:.1} s are {:.2} m/s, and {max_speed} m/s \
                 need {needed:.1} s at least; everybody arrives in time all the same, faster than they can (segments[{index}])",
                way(agent),
                way(agent) / seconds,
            )
        })
    })
}

fn listed(agents: &[usize]) -> String {
    match agents {
        [agent] => format!("agent {agent} stands"),
        _ if agents.len() > MOST_LISTED => format!("{} agents stand", agents.len()),
        _ => {
            let numbers: Vec<String> = agents.iter().map(usize::to_string).collect();
            format!("agents {} stand", numbers.join(", "))
        }
    }
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use glam::DVec2;

    use super::*;
    use crate::formation::Formation;
    use crate::scene::{Agent, Obstacle};

    #[test]
    fn no_lattice_holds_more_than_is_said_and_what_fits_does() {
        for (stage, count) in [([6.0, 4.0], 35), ([6.0, 4.0], 6), ([10.0, 1e-3], 11), ([3.0, 3.0], 2)] {
            let fitting = widest_apart(stage, count);
            assert!(most_apart(stage, fitting) >= count, "{stage:?} {count}: {fitting}");
        }
        assert_eq!(widest_apart([6.0, 4.0], 35), 1.0);
        // A square grid of 1 m, a hexagonal lattice of 1 m: neither holds more than the bound.
        assert!((35..=39).contains(&most_apart([6.0, 4.0], 1.0)));
        assert!(most_apart([6.0, 4.0 * 0.75_f64.sqrt()], 1.0) >= 33);
        assert_eq!(most_apart([6.0, 4.0], 0.0), usize::MAX);
    }

    #[test]
    fn what_a_scene_cannot_have_is_told_with_what_helps() {
        let mut scene = Scene::default();
        scene.tracks[0].agents = Arc::new(vec![Agent::default(); 3]);
        scene.tracks[0].keyframes[0].positions = Arc::new(Formation::from(vec![[0.0, 0.0], [1.0, 0.0], [9.0, 0.0]]));
        assert_eq!(cautions(&scene), [] as [String; 0]);
        (scene.stage.width, scene.stage.depth, scene.minimum_distance) = (8.0, 3.0, 30.0);
        scene.obstacles =
            Arc::new(vec![Obstacle { name: String::new(), shape: ObstacleShape::Circle { center: DVec2::ZERO, radius: 1.5 } }]);
        assert_eq!(
            cautions(&scene),
            [
                "a stage of 8 × 3 m holds at most 1 agent 30 m apart, and the scene has 3; 4.00 m fits, or a larger stage (minimumDistance)",
                "agents 0 and 1 stand 1.000 m apart, the nearest of 3 pairs, and the minimum distance is 30 m; a keyframe is never changed, \
                 so move them or lower the distance (keyframes[0])",
                "agents 0, 1 stand within obstacle 0; a keyframe is never changed, so move them or the obstacle (keyframes[0].positions[0])",
            ]
        );
    }

    #[test]
    fn who_stands_too_near_is_told_save_for_who_is_absent() {
        let told = |distance: f64, absent: &str| {
            let text = format!(
                r#"{{ "format": "eigenform", "version": 1, "minimumDistance": {distance},
                    "keyframes": [{{ "positions": [[0, 0], [0.5, 0], [3, 0]], "absent": {absent} }}] }}"#
            );
            cautions(&crate::scene::read_json(&text).expect("it is a scene")).len()
        };
        assert_eq!([told(0.0, "[]"), told(0.5, "[]"), told(0.6, "[]"), told(0.6, "[2]"), told(0.6, "[1]")], [0, 0, 1, 1, 0]);
    }

    #[test]
    fn who_cannot_arrive_at_a_top_speed_is_told_before_anybody_moves() {
        let told = |method: &str, max_speed: f64, end: f64| {
            let text = format!(
                r#"{{ "format": "eigenform", "version": 1, "agents": [{{ "maxSpeed": {max_speed} }}, {{}}],
                    "keyframes": [{{ "positions": [[0, 0], [1, 0]] }}, {{ "time": {end}, "positions": [[0, 20], [1, 20]] }}],
                    "segments": [{{ "method": "{method}" }}] }}"#
            );
            cautions(&crate::scene::read_json(&text).expect("it is a scene"))
        };
        assert_eq!(
            told("crowd", 0.5, 5.0),
            [
                "agent 0 has farther to go than a top speed allows: 20.00 m in 5.0 s are 4.00 m/s, and 0.5 m/s need 40.0 s at least; everybody \
              arrives in time all the same, faster than they can (segments[0])"
            ]
        );
        // What is fast enough, long enough, or heeds no top speed needs no word.
        for (method, max_speed, end) in [("crowd", 4.0, 5.0), ("crowd", 0.5, 40.0), ("linear", 0.5, 5.0)] {
            assert_eq!(told(method, max_speed, end), [] as [String; 0], "{method} {max_speed} {end}");
        }
    }
}
