//! Scene file → scene.

use std::sync::Arc;

use super::crowd::crowd;
use super::fields::{Fields, Only};
use super::places::{entry, formation, obstacle, path};
use super::value::Value;
use crate::adjacency::AdjacencySpec;
use crate::assignment::{AssignmentSpec, DEFAULT_LAMBDA};
use crate::choice::{Blend, Choice, DEFAULT_SHARING};
use crate::error::{Counted, Error};
use crate::formation::Formation;
use crate::order;
use crate::scene::normalize::{normalize_adjacency, normalize_groups, normalize_segments};
use crate::scene::place::Place;
use crate::scene::validate::exactly;
use crate::scene::{Agent, DEFAULT_FRAME_RATE, DEFAULT_TENSION, Group, Keyframe, NodeSpec, Scene, Segment, Stage, Tempo, Track};
use crate::scene::{TransitionSpec, limits, shown, validate};

const SCENE: &[&str] = &[
    "format",
    "version",
    "title",
    "seed",
    "stage",
    "tempo",
    "frameRate",
    "minimumDistance",
    "join",
    "tension",
    "agents",
    "groups",
    "adjacency",
    "keyframes",
    "segments",
    "obstacles",
    "recordings",
];
const STAGE: &[&str] = &["width", "depth", "height", "backdrop", "units"];
const TEMPO: &[&str] = &["beatsPerMinute", "beatsPerBar", "start"];
const AGENT: &[&str] = &["name", "color", "radius", "maxSpeed"];
const GROUP: &[&str] = &["name", "color", "members", "tieWeight", "children"];
const ADJACENCY: &[&str] = &["base", "weights", "ties", "cuts", "obstacleTies"];
const KEYFRAME: &[&str] = &["name", "time", "hold", "corner", "between", "positions", "absent", "adjacency"];
const STANDING_KEYFRAME: &[&str] = &["name", "time", "hold", "corner", "between", "absent", "adjacency"];
const SEGMENT: &[&str] = &[
    "kind",
    "method",
    "chosen",
    "order",
    "alignment",
    "sharing",
    "keepSize",
    "timing",
    "avoidance",
    "hierarchy",
    "nodes",
    "path",
    "assignment",
    "crowd",
];
const ASSIGNMENT: &[&str] = &["cost", "lambda", "locks", "keepGroups"];
const CHOICE: &[&str] = &["method", "order", "alignment", "sharing"];
const NODE: &[&str] = &["group", "method", "blend"];
const BLEND: &[&str] = &["method", "amount"];

const KINDS: &[&str] = &["transition"];

/// The scene of a scene file.
pub fn read_json(text: &str) -> Result<Scene, Error> {
    fits(text)?;
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    if text.trim_ascii().is_empty() {
        return Err(Error::Empty);
    }
    let document = Value::document(text)?;
    let fields = document.fields(SCENE)?;
    head(&fields)?;
    fields.refuse_strangers()?;
    settled(scene(&fields, &mut Standing::default())?)
}

/// The scene of a scene file without a head whose keyframes have these formations and no positions.
pub fn read_rest(text: &str, formations: Vec<Arc<Formation>>) -> Result<Scene, Error> {
    fits(text)?;
    let fields = Value::document(text)?.object(SCENE)?;
    let found = formations.len();
    let mut standing = Standing { given: Some(formations.into_iter()), ..Standing::default() };
    let scene = scene(&fields, &mut standing)?;
    exactly(found, scene.main_track().keyframes.len(), "formations", "keyframes")?;
    settled(scene)
}

fn settled(mut scene: Scene) -> Result<Scene, Error> {
    validate(&scene)?;
    normalize_segments(&mut scene.tracks[0]);
    Ok(scene)
}

/// A list of methods with their options, or null.
pub fn read_choices(text: &str) -> Result<Vec<Option<Choice>>, Error> {
    let list = Value::document(text)?;
    let entries = list.items(limits::KEYFRAMES, Counted::Segments)?.into_iter().map(|text| Value { text, place: list.place });
    entries.map(|entry| if entry.is_null() { Ok(None) } else { choice(entry).map(Some) }).collect()
}

fn fits(text: &str) -> Result<(), Error> {
    if text.len() <= limits::FILE_BYTES { Ok(()) } else { Err(Error::FileTooLarge { bytes: text.len(), limit: limits::FILE_BYTES }) }
}

/// Says what this is before any field of it is judged.
fn head(fields: &Fields) -> Result<(), Error> {
    let format = fields.required("format")?;
    if format.text != "\"eigenform\"" {
        return Err(Error::NotAScene { found: shown(format.text) });
    }
    let version = fields.required("version")?;
    match version.number()? {
        1.0 => Ok(()),
        number if number > 1.0 => Err(Error::NewerVersion { version: shown(version.text) }),
        _ => Err(version.wrong_type("1")),
    }
}

fn scene(fields: &Fields, standing: &mut Standing) -> Result<Scene, Error> {
    fields.only("recordings", &Only::NoEntries)?;
    Ok(Scene {
        title: fields.string("title")?,
        seed: fields.whole("seed", 0)?,
        stage: fields.get("stage").map_or(Ok(Stage::default()), stage)?,
        tempo: fields.get("tempo").map_or(Ok(Tempo::default()), tempo)?,
        frame_rate: fields.number("frameRate", DEFAULT_FRAME_RATE)?,
        minimum_distance: fields.number("minimumDistance", 0.0)?,
        join: fields.word("join", &[])?,
        tension: fields.number("tension", DEFAULT_TENSION)?,
        groups: Arc::new(groups(fields)?),
        adjacency: fields.get("adjacency").map_or(Ok(Arc::default()), |value| adjacency(value).map(Arc::new))?,
        tracks: vec![track(fields, standing)?],
        obstacles: Arc::new(fields.list("obstacles", limits::OBSTACLES, Counted::Obstacles, obstacle)?),
    })
}

fn stage(value: Value) -> Result<Stage, Error> {
    let (fields, default) = (value.object(STAGE)?, Stage::default());
    Ok(Stage {
        width: fields.number("width", default.width)?,
        depth: fields.number("depth", default.depth)?,
        height: fields.number("height", default.height)?,
        backdrop: fields.word("backdrop", &[])?,
        units: fields.word("units", &[])?,
    })
}

fn tempo(value: Value) -> Result<Tempo, Error> {
    let (fields, default) = (value.object(TEMPO)?, Tempo::default());
    Ok(Tempo {
        beats_per_minute: fields.number("beatsPerMinute", default.beats_per_minute)?,
        beats_per_bar: fields.whole("beatsPerBar", default.beats_per_bar)?,
        start: fields.number("start", default.start)?,
    })
}

fn groups(fields: &Fields) -> Result<Vec<Group>, Error> {
    let mut count = 0;
    let mut groups = fields.list("groups", limits::GROUPS, Counted::Groups, |value| group(value, 1, &mut count))?;
    normalize_groups(&mut groups);
    Ok(groups)
}

fn group(value: Value, depth: usize, count: &mut usize) -> Result<Group, Error> {
    *count += 1;
    if *count > limits::GROUPS {
        return Err(Error::TooMany { what: Counted::Groups, count: *count, limit: limits::GROUPS, place: "groups".to_owned() });
    }
    if depth > limits::GROUP_DEPTH {
        return Err(Error::GroupsTooDeep { limit: limits::GROUP_DEPTH, place: value.place.to_string() });
    }
    let fields = value.object(GROUP)?;
    Ok(Group {
        name: fields.string("name")?,
        color: fields.string("color")?,
        members: fields.list("members", limits::AGENTS, Counted::Members, |member| member.whole())?,
        tie_weight: fields.optional("tieWeight", |factor| factor.number())?,
        children: fields.list("children", limits::GROUPS, Counted::Groups, |child| group(child, depth + 1, count))?,
    })
}

fn adjacency(value: Value) -> Result<AdjacencySpec, Error> {
    let fields = value.object(ADJACENCY)?;
    let mut spec = AdjacencySpec {
        base: fields.word("base", &[])?,
        weights: fields.word("weights", &[])?,
        ties: fields.list("ties", limits::TIES_PER_KEYFRAME, Counted::Ties, tie)?,
        cuts: fields.list("cuts", limits::CUTS, Counted::Cuts, cut)?,
        obstacle_ties: fields.list("obstacleTies", limits::TIES_PER_KEYFRAME, Counted::Ties, obstacle_tie)?,
    };
    normalize_adjacency(&mut spec);
    Ok(spec)
}

fn tie(value: Value) -> Result<(u32, u32, f64), Error> {
    let [a, b, factor] = value.exactly("[a, b, factor], two agents and a number")?;
    Ok((entry(&value, a).whole()?, entry(&value, b).whole()?, entry(&value, factor).number()?))
}

fn obstacle_tie(value: Value) -> Result<(u32, u32, f64), Error> {
    let [agent, obstacle, factor] = value.exactly("[agent, obstacle, factor], two indices and a number")?;
    Ok((entry(&value, agent).whole()?, entry(&value, obstacle).whole()?, entry(&value, factor).number()?))
}

fn cut(value: Value) -> Result<(u32, u32), Error> {
    let [a, b] = value.exactly("[a, b], two agents")?;
    Ok((entry(&value, a).whole()?, entry(&value, b).whole()?))
}

fn track(fields: &Fields, standing: &mut Standing) -> Result<Track, Error> {
    fields.required("keyframes")?;
    let keyframes = fields.list("keyframes", limits::KEYFRAMES, Counted::Keyframes, |value| keyframe(value, standing))?;
    let agents = fields.list("agents", limits::AGENTS, Counted::Agents, agent)?;
    let segments = fields.list("segments", limits::KEYFRAMES, Counted::Segments, segment)?;
    let agent_count = keyframes.first().map_or(0, |first| first.positions.agent_count());
    Ok(Track {
        agents: Arc::new(if agents.is_empty() { vec![Agent::default(); agent_count] } else { agents }),
        segments: if segments.is_empty() { vec![Segment::default(); keyframes.len().saturating_sub(1)] } else { segments },
        keyframes,
    })
}

/// Where the agents of the next keyframe stand, and what those read so far have used of the limits over all of them.
#[derive(Default)]
struct Standing {
    /// Formations of the keyframes to come; none: each has its positions in the text.
    given: Option<std::vec::IntoIter<Arc<Formation>>>,
    positions: usize,
    ties: usize,
    dimensions: Option<usize>,
}

impl Standing {
    fn formation(&mut self, keyframe: &Fields) -> Result<Arc<Formation>, Error> {
        if let Some(given) = &mut self.given {
            // Too few are told from the counts of both.
            return Ok(given.next().unwrap_or_default());
        }
        keyframe.required("positions")?;
        formation(keyframe, &mut self.dimensions).map(Arc::new)
    }

    fn spend(&mut self, keyframe: &Keyframe, place: Place) -> Result<(), Error> {
        self.positions += keyframe.positions.agent_count();
        self.ties += keyframe.adjacency.as_ref().map_or(0, |own| own.ties.len() + own.obstacle_ties.len());
        let sums = [(self.positions, limits::POSITIONS, Counted::Positions), (self.ties, limits::TIES_IN_ALL, Counted::TiesInAll)];
        match sums.into_iter().find(|(count, limit, _)| count > limit) {
            Some((count, limit, what)) => Err(Error::TooMany { what, count, limit, place: place.to_string() }),
            None => Ok(()),
        }
    }
}

fn keyframe(value: Value, standing: &mut Standing) -> Result<Keyframe, Error> {
    let fields = value.object(if standing.given.is_some() { STANDING_KEYFRAME } else { KEYFRAME })?;
    let mut absent = fields.list("absent", limits::AGENTS, Counted::Agents, |value| value.whole())?;
    order::sort_by_key(&mut absent, |agent| u128::from(*agent));
    let keyframe = Keyframe {
        name: fields.string("name")?,
        time: fields.number("time", 0.0)?,
        hold: fields.number("hold", 0.0)?,
        corner: fields.flag("corner")?,
        between: fields.whole("between", 0)?,
        positions: standing.formation(&fields)?,
        absent,
        adjacency: fields.optional("adjacency", adjacency)?.map(Arc::new),
    };
    standing.spend(&keyframe, value.place)?;
    Ok(keyframe)
}

fn agent(value: Value) -> Result<Agent, Error> {
    let fields = value.object(AGENT)?;
    Ok(Agent {
        name: fields.string("name")?,
        color: fields.string("color")?,
        radius: fields.number("radius", Agent::default().radius)?,
        max_speed: fields.optional("maxSpeed", |speed| speed.number())?,
    })
}

fn segment(value: Value) -> Result<Segment, Error> {
    let fields = value.object(SEGMENT)?;
    fields.only("kind", &Only::Word("transition", KINDS))?;
    Ok(Segment::Transition(TransitionSpec {
        method: fields.word("method", &[])?,
        chosen: fields.optional("chosen", choice)?,
        order: fields.word("order", &[])?,
        alignment: fields.word("alignment", &[])?,
        sharing: fields.number("sharing", DEFAULT_SHARING)?,
        keep_size: fields.flag("keepSize")?,
        timing: fields.word("timing", &[])?,
        avoidance: fields.flag("avoidance")?,
        hierarchy: fields.flag("hierarchy")?,
        nodes: fields.list("nodes", limits::NODES, Counted::Nodes, node)?,
        path: fields.optional("path", path)?,
        crowd: fields.optional("crowd", crowd)?.unwrap_or_default(),
        assignment: fields.optional("assignment", assignment)?,
    }))
}

/// How an assignment is found.
pub fn read_assignment(text: &str) -> Result<AssignmentSpec, Error> {
    assignment(Value::document(text)?)
}

fn assignment(value: Value) -> Result<AssignmentSpec, Error> {
    let fields = value.object(ASSIGNMENT)?;
    Ok(AssignmentSpec {
        cost: fields.word("cost", &[])?,
        lambda: fields.number("lambda", DEFAULT_LAMBDA)?,
        locks: fields.list("locks", limits::AGENTS, Counted::Locks, lock)?,
        keep_groups: fields.flag("keepGroups")?,
    })
}

fn lock(value: Value) -> Result<(u32, u32), Error> {
    let [agent, slot] = value.exactly("[agent, slot], two indices")?;
    Ok((entry(&value, agent).whole()?, entry(&value, slot).whole()?))
}

fn node(value: Value) -> Result<NodeSpec, Error> {
    let fields = value.object(NODE)?;
    Ok(NodeSpec {
        group: fields.list("group", limits::GROUP_DEPTH, Counted::Levels, |index| index.whole())?,
        method: fields.required("method")?.word(&[])?,
        blend: fields.optional("blend", blend)?,
    })
}

fn blend(value: Value) -> Result<Blend, Error> {
    let fields = value.object(BLEND)?;
    Ok(Blend { method: fields.required("method")?.word(&[])?, amount: fields.required("amount")?.number()? })
}

fn choice(value: Value) -> Result<Choice, Error> {
    let fields = value.object(CHOICE)?;
    Ok(Choice {
        method: fields.required("method")?.word(&[])?,
        order: fields.word("order", &[])?,
        alignment: fields.word("alignment", &[])?,
        sharing: fields.number("sharing", DEFAULT_SHARING)?,
    })
}
