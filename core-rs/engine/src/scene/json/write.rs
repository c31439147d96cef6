//! Scene → scene file: what is required and what differs from its default.

use super::crowd::write_crowd;
use super::layout::Layout;
use super::written::{flag, number, numbers, required_word, string, word};
use crate::adjacency::AdjacencySpec;
use crate::assignment::AssignmentSpec;
use crate::choice::Choice;
use crate::formation::Formation;
use crate::obstacle::ObstacleShape;
use crate::scene::{Agent, Group, Keyframe, NodeSpec, Obstacle, Scene, Segment, Stage, Tempo, Track, TransitionSpec};

/// The scene file; [`super::read_json`] gives an equal scene.
///
/// # Panics
/// When the scene has no track: a bug, not input.
pub fn write_json(scene: &Scene) -> String {
    let default = Scene::default();
    let mut layout = Layout::default();
    layout.object(|out| {
        out.key("format").string("eigenform");
        out.key("version").number(1.0);
        string(out, "title", &scene.title);
        number(out, "seed", f64::from(scene.seed), 0.0);
        if scene.stage != default.stage {
            stage(out.key("stage"), &scene.stage);
        }
        if scene.tempo != default.tempo {
            tempo(out.key("tempo"), &scene.tempo);
        }
        number(out, "frameRate", scene.frame_rate, default.frame_rate);
        number(out, "minimumDistance", scene.minimum_distance, default.minimum_distance);
        word(out, "join", &scene.join);
        number(out, "tension", scene.tension, default.tension);
        let track = scene.main_track();
        agents(out, &track.agents);
        if !scene.groups.is_empty() {
            out.key("groups").list(&scene.groups, group);
        }
        if scene.adjacency != default.adjacency {
            adjacency(out.key("adjacency"), &scene.adjacency);
        }
        out.key("keyframes").list(&track.keyframes, keyframe);
        segments(out, track);
        if !scene.obstacles.is_empty() {
            out.key("obstacles").list(&scene.obstacles, obstacle);
        }
    });
    layout.finish()
}

fn stage(out: &mut Layout, stage: &Stage) {
    let default = Stage::default();
    out.object_line(|out| {
        number(out, "width", stage.width, default.width);
        number(out, "depth", stage.depth, default.depth);
        number(out, "height", stage.height, default.height);
        word(out, "backdrop", &stage.backdrop);
        word(out, "units", &stage.units);
    });
}

fn tempo(out: &mut Layout, tempo: &Tempo) {
    let default = Tempo::default();
    out.object_line(|out| {
        number(out, "beatsPerMinute", tempo.beats_per_minute, default.beats_per_minute);
        number(out, "beatsPerBar", f64::from(tempo.beats_per_bar), f64::from(default.beats_per_bar));
        number(out, "start", tempo.start, default.start);
    });
}

fn agents(out: &mut Layout, agents: &[Agent]) {
    let default = Agent::default();
    if agents.iter().all(|agent| *agent == default) {
        return;
    }
    out.key("agents").list(agents, |out, agent| {
        out.object_line(|out| {
            string(out, "name", &agent.name);
            string(out, "color", &agent.color);
            number(out, "radius", agent.radius, default.radius);
            if let Some(speed) = agent.max_speed {
                out.key("maxSpeed").number(speed);
            }
        });
    });
}

fn group(out: &mut Layout, group: &Group) {
    if group.children.is_empty() {
        out.object_line(|out| group_fields(out, group));
    } else {
        out.object(|out| {
            group_fields(out, group);
            out.key("children").list(&group.children, self::group);
        });
    }
}

fn group_fields(out: &mut Layout, group: &Group) {
    string(out, "name", &group.name);
    string(out, "color", &group.color);
    if !group.members.is_empty() {
        out.key("members").list_line(&group.members, |out, member| out.number(f64::from(*member)));
    }
    if let Some(factor) = group.tie_weight {
        out.key("tieWeight").number(factor);
    }
}

fn adjacency(out: &mut Layout, spec: &AdjacencySpec) {
    if spec.ties.is_empty() && spec.cuts.is_empty() && spec.obstacle_ties.is_empty() {
        out.object_line(|out| adjacency_words(out, spec));
    } else {
        out.object(|out| {
            adjacency_words(out, spec);
            ties(out, "ties", &spec.ties);
            if !spec.cuts.is_empty() {
                out.key("cuts").list(&spec.cuts, |out, &(a, b)| numbers(out, &[f64::from(a), f64::from(b)]));
            }
            ties(out, "obstacleTies", &spec.obstacle_ties);
        });
    }
}

fn ties(out: &mut Layout, name: &str, ties: &[(u32, u32, f64)]) {
    if !ties.is_empty() {
        out.key(name).list(ties, |out, &(a, b, factor)| numbers(out, &[f64::from(a), f64::from(b), factor]));
    }
}

fn adjacency_words(out: &mut Layout, spec: &AdjacencySpec) {
    word(out, "base", &spec.base);
    word(out, "weights", &spec.weights);
}

fn keyframe(out: &mut Layout, keyframe: &Keyframe) {
    out.object(|out| {
        string(out, "name", &keyframe.name);
        number(out, "time", keyframe.time, 0.0);
        number(out, "hold", keyframe.hold, 0.0);
        flag(out, "corner", keyframe.corner);
        number(out, "between", f64::from(keyframe.between), 0.0);
        positions(out.key("positions"), &keyframe.positions);
        if !keyframe.absent.is_empty() {
            out.key("absent").list_line(&keyframe.absent, |out, agent| out.number(f64::from(*agent)));
        }
        if let Some(own) = &keyframe.adjacency {
            adjacency(out.key("adjacency"), own);
        }
    });
}

fn positions(out: &mut Layout, formation: &Formation) {
    let mut agent = 0;
    out.list(formation.positions(), |out, position| {
        let spot = [position.x, position.y, formation.height(agent)];
        numbers(out, if formation.heights().is_some() { &spot } else { &spot[..2] });
        agent += 1;
    });
}

fn segments(out: &mut Layout, track: &Track) {
    let default = Segment::default();
    if track.segments.iter().any(|segment| *segment != default) {
        out.key("segments").list(&track.segments, |out, Segment::Transition(transition)| {
            out.object_line(|out| transition_fields(out, transition));
        });
    }
}

fn transition_fields(out: &mut Layout, transition: &TransitionSpec) {
    let default = TransitionSpec::default();
    word(out, "method", &transition.method);
    if let Some(chosen) = &transition.chosen {
        choice(out.key("chosen"), chosen);
    }
    word(out, "order", &transition.order);
    word(out, "alignment", &transition.alignment);
    number(out, "sharing", transition.sharing, default.sharing);
    flag(out, "keepSize", transition.keep_size);
    word(out, "timing", &transition.timing);
    flag(out, "avoidance", transition.avoidance);
    flag(out, "hierarchy", transition.hierarchy);
    if !transition.nodes.is_empty() {
        out.key("nodes").list_line(&transition.nodes, node);
    }
    if let Some(path) = &transition.path {
        out.key("path").list_line(&path.points, |out, point| numbers(out, path.numbers(point)));
    }
    if transition.crowd != default.crowd {
        write_crowd(out.key("crowd"), &transition.crowd);
    }
    if let Some(spec) = &transition.assignment {
        assignment(out.key("assignment"), spec);
    }
}

fn assignment(out: &mut Layout, spec: &AssignmentSpec) {
    out.object_line(|out| {
        word(out, "cost", &spec.cost);
        number(out, "lambda", spec.lambda, AssignmentSpec::default().lambda);
        if !spec.locks.is_empty() {
            out.key("locks").list_line(&spec.locks, |out, &(agent, slot)| numbers(out, &[f64::from(agent), f64::from(slot)]));
        }
        flag(out, "keepGroups", spec.keep_groups);
    });
}

fn node(out: &mut Layout, node: &NodeSpec) {
    out.object_line(|out| {
        if !node.group.is_empty() {
            out.key("group").list_line(&node.group, |out, index| out.number(f64::from(*index)));
        }
        required_word(out, "method", &node.method);
        if let Some(blend) = &node.blend {
            out.key("blend").object_line(|out| {
                required_word(out, "method", &blend.method);
                out.key("amount").number(blend.amount);
            });
        }
    });
}

fn obstacle(out: &mut Layout, obstacle: &Obstacle) {
    out.object_line(|out| {
        string(out, "name", &obstacle.name);
        match &obstacle.shape {
            ObstacleShape::Circle { center, radius } => {
                out.key("kind").string("circle");
                numbers(out.key("center"), &center.to_array());
                out.key("radius").number(*radius);
            }
            ObstacleShape::Polygon { points } => {
                out.key("kind").string("polygon");
                out.key("points").list_line(points, |out, point| numbers(out, &point.to_array()));
            }
        }
    });
}

fn choice(out: &mut Layout, choice: &Choice) {
    out.object_line(|out| {
        word(out, "method", &choice.method);
        word(out, "order", &choice.order);
        word(out, "alignment", &choice.alignment);
        number(out, "sharing", choice.sharing, TransitionSpec::default().sharing);
    });
}
