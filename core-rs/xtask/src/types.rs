//! Writes the page's types from the engine's.

use eigenform::text::json;
use eigenform::{adjacency, assignment, choice, obstacle, scene};
use ts_rs::TS;

/// The TypeScript of every type that crosses the seam, in one file.
pub fn typescript() -> String {
    let declarations = [
        scene::Scene::decl(),
        scene::Track::decl(),
        scene::Stage::decl(),
        scene::Backdrop::decl(),
        scene::Units::decl(),
        scene::Tempo::decl(),
        scene::Agent::decl(),
        scene::Group::decl(),
        adjacency::AdjacencySpec::decl(),
        adjacency::Base::decl(),
        adjacency::Weights::decl(),
        assignment::AssignmentSpec::decl(),
        assignment::Cost::decl(),
        scene::Keyframe::decl(),
        scene::Segment::decl(),
        scene::TransitionSpec::decl(),
        scene::CrowdSpec::decl(),
        scene::NodeSpec::decl(),
        scene::Obstacle::decl(),
        obstacle::ObstacleShape::decl(),
        choice::Choice::decl(),
        choice::Blend::decl(),
        choice::MethodName::decl(),
        choice::Join::decl(),
        choice::Order::decl(),
        choice::Alignment::decl(),
        choice::Timing::decl(),
    ];
    let mut text = String::from(
        "// Generated from the engine's types by `cargo xtask types`. Do not edit.\n\nimport type { Formation } from \"./formation\";\n",
    );
    for declaration in declarations {
        text.push_str("\nexport ");
        text.push_str(&declaration);
        text.push('\n');
    }
    let crowd = json(&scene::CrowdSpec::default());
    text.push_str("\n/** What a crowd is told where nothing is said. */\nexport const CROWD_DEFAULTS: CrowdSpec = ");
    text.push_str(&crowd);
    text.push_str(";\n");
    text
}
