//! `eigenform spread`: keyframes that let those who are stuck spread out.

use eigenform::perform::{Performer, Salvage, SalvageStep};
use eigenform::scene::{Opened, Scene, write_json};

use crate::arguments::Spread;
use crate::failure::Failure;
use crate::{input, output};

pub fn run(arguments: &Spread) -> Result<Vec<String>, Failure> {
    let Opened { mut scene, mut notes, .. } = input::read(&arguments.source)?;
    let count = scene.main_track().segments.len();
    let asked = match arguments.segment {
        None => 0..count,
        Some(_) if count == 0 => return Err(Failure::usage("the scene has one keyframe, so there is no transition", "--segment")),
        Some(segment) => {
            let index = input::whole_within(segment, &(0..=count - 1), "--segment")?;
            index..index + 1
        }
    };
    let mut performer = Performer::default();
    // The last first: the numbers of those before stay.
    for index in asked.rev() {
        let Some(salvage) = salvage(&mut performer, &scene, index)? else { continue };
        let is_taken = !salvage.keyframes.is_empty() && (arguments.wild || !salvage.report.is_wild);
        notes.push(format!("transition {index}: {}", words(&salvage, is_taken)));
        if is_taken {
            scene = salvage.apply(&scene, index);
        }
    }
    output::print(&write_json(&scene))?;
    Ok(notes)
}

fn salvage(performer: &mut Performer, scene: &Scene, index: usize) -> Result<Option<Box<Salvage>>, Failure> {
    let mut job = performer.salvage(scene, index);
    loop {
        if let SalvageStep::Done(found) = job.step(performer)? {
            return Ok(found);
        }
    }
}

fn words(salvage: &Salvage, is_taken: bool) -> String {
    let report = &salvage.report;
    let count = salvage.keyframes.len();
    if count == 0 {
        return "spreading out does not keep them apart".to_owned();
    }
    let taken = if is_taken { "" } else { ", left out without --wild" };
    let (aside, ratio) = (report.deviation.max, report.top_speed / report.guide_top_speed);
    format!("{count} keyframes, {aside:.2} m aside at most, {ratio:.2} times as fast{taken}")
}
