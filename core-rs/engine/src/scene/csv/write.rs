//! Scene → keyframe CSV.

use csv::Writer;

use super::groups::paths;
use super::read::{fitted_stage, is_whole_number};
use crate::scene::number::number_text;
use crate::scene::{DEFAULT_RADIUS, Group, Scene, Segment, TransitionSpec};

/// A keyframe CSV out of a scene.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Written {
    /// The file.
    pub text: String,
    /// What it does not hold, a sentence each.
    pub notes: Vec<String>,
}

/// The keyframe CSV of a scene: its positions and times to the bit, and which group each agent is in.
///
/// Agents are called by [`Scene::agent_ids`], keyframes by their numbers.
pub fn write_csv(scene: &Scene) -> Written {
    let (groups, has_renamed) = paths(&scene.groups, scene.main_track().agents.len());
    Written { text: text(scene, &groups), notes: notes(scene, has_renamed) }
}

fn text(scene: &Scene, groups: &[String]) -> String {
    let track = scene.main_track();
    let names = Names::of(scene);
    let has_colors = track.agents.iter().any(|agent| !agent.color.is_empty());
    let mut rows = Writer::from_writer(Vec::new());
    let mut write = |fields: &mut dyn Iterator<Item = &str>| rows.write_record(fields).expect("memory takes every row");
    let is_spatial = track.keyframes.iter().any(|keyframe| keyframe.positions.heights().is_some());
    let header = ["keyframe", "time", "agent", "group", "x", "y"].into_iter().chain(is_spatial.then_some("z"));
    write(&mut header.chain(names.has_column.then_some("name")).chain(has_colors.then_some("color")));
    for (number, keyframe) in track.keyframes.iter().enumerate() {
        let (number, time) = (number.to_string(), number_text(keyframe.time));
        for (index, position) in keyframe.positions.positions().iter().enumerate() {
            let [x, y, z] = [position.x, position.y, keyframe.positions.height(index)].map(number_text);
            let agent = &track.agents[index];
            let fields = [&*number, &time, &names.ids[index], &groups[index], &x, &y].into_iter().chain(is_spatial.then_some(&*z));
            write(&mut fields.chain(names.has_column.then_some(agent.name.trim())).chain(has_colors.then_some(&*agent.color)));
        }
    }
    String::from_utf8(rows.into_inner().expect("memory takes every row")).expect("fields are text")
}

/// What agents are called, and whether that leaves their names to a column of their own.
struct Names {
    ids: Vec<String>,
    has_column: bool,
}

impl Names {
    fn of(scene: &Scene) -> Self {
        let agents = &scene.main_track().agents;
        let ids = scene.agent_ids();
        // Readers drop white space around an id and take whole numbers for no names.
        let are_plain = ids.iter().all(|id| id.trim() == id);
        let ids = if are_plain { ids } else { (0..agents.len()).map(|agent| agent.to_string()).collect() };
        let are_names = ids.iter().zip(&**agents).all(|(id, agent)| *id == agent.name) && !ids.iter().all(|id| is_whole_number(id));
        let has_column = !are_names && agents.iter().any(|agent| !agent.name.trim().is_empty());
        Self { ids, has_column }
    }
}

fn notes(scene: &Scene, has_renamed: bool) -> Vec<String> {
    let lost: Vec<&str> = losses(scene).into_iter().filter_map(|(is_lost, what)| is_lost.then_some(what)).collect();
    let mut notes = Vec::new();
    if !lost.is_empty() {
        notes.push(format!("A keyframe CSV does not hold these, so they are left out: {}.", lost.join(", ")));
    }
    if has_renamed {
        notes.push("Groups without a name, with the name of a group beside them or with / in it have another name.".to_owned());
    }
    notes
}

fn losses(scene: &Scene) -> Vec<(bool, &'static str)> {
    let (default, track) = (Scene::default(), scene.main_track());
    let is_default = |segment: &Segment| *segment == Segment::Transition(TransitionSpec::default());
    vec![
        (track.agents.is_empty(), "keyframes without agents"),
        (!scene.title.is_empty(), "the title"),
        (scene.stage != fitted_stage(&track.keyframes), "the stage"),
        (scene.tempo != default.tempo, "the tempo"),
        (scene.frame_rate.to_bits() != default.frame_rate.to_bits(), "the frame rate"),
        (scene.minimum_distance > 0.0, "the minimum distance"),
        (scene.join != default.join || scene.tension.to_bits() != default.tension.to_bits(), "how transitions join"),
        (scene.seed != 0, "the seed"),
        (track.agents.iter().any(|agent| agent.radius.to_bits() != DEFAULT_RADIUS.to_bits()), "agents' radii"),
        (any_group(&scene.groups, |group| !group.color.is_empty()), "groups' colors"),
        (any_group(&scene.groups, |group| group.tie_weight.is_some()), "groups' ties"),
        (any_group(&scene.groups, |group| group.set().is_empty()), "groups without agents"),
        (*scene.adjacency != *default.adjacency, "the scene's ties"),
        (track.keyframes.iter().any(|keyframe| keyframe.adjacency.is_some()), "keyframes' own ties"),
        (track.keyframes.iter().any(|keyframe| keyframe.hold > 0.0), "holds"),
        (track.keyframes.iter().any(|keyframe| !keyframe.absent.is_empty()), "who is absent"),
        (track.keyframes.iter().any(|keyframe| keyframe.corner), "corners"),
        (track.keyframes.iter().any(|keyframe| keyframe.between > 0), "in-between keyframes"),
        (track.keyframes.iter().any(|keyframe| !keyframe.name.is_empty()), "keyframes' names"),
        (!track.segments.iter().all(is_default), "how transitions move"),
        (!scene.obstacles.is_empty(), "obstacles"),
    ]
}

fn any_group(groups: &[Group], is_so: fn(&Group) -> bool) -> bool {
    groups.iter().any(|group| is_so(group) || any_group(&group.children, is_so))
}
