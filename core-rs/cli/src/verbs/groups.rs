//! `eigenform groups`: who keeps together on the way to the next keyframe.

use eigenform::error::Error;
use eigenform::grouping::{AffinityJob, Metric, Preference};
use eigenform::scene::Opened;
use serde::Serialize;

use crate::arguments::Groups;
use crate::failure::Failure;
use crate::input::Words;
use crate::{input, output};

const METRICS: Words<Metric> = (&["euclidean", "manhattan"], &[Metric::Euclidean, Metric::Manhattan]);

#[derive(Serialize)]
struct Report {
    groups: Vec<Vec<u32>>,
    /// Square meters.
    preference: f64,
}

pub fn run(arguments: &Groups) -> Result<Vec<String>, Failure> {
    let Opened { scene, notes, .. } = input::read(&arguments.source)?;
    let metric = input::word(&arguments.metric, &METRICS, "--metric")?;
    let preference = arguments.preference.map_or(Preference::OfMedian(1.0), Preference::Of);
    if arguments.preference.is_some_and(|preference| !preference.is_finite()) {
        return Err(Error::NotFinite { place: "--preference".to_owned() }.into());
    }
    let [source, target] = scene.way_at(input::keyframe(&scene, arguments.keyframe, "--keyframe")?)?;
    let everybody: Vec<u32> = (0..source.agent_count() as u32).collect();
    let mut job = AffinityJob::new(source, target, &everybody, metric, preference);
    while job.step() < 1.0 {}
    let groups = job.groups().into_iter().map(|group| group.members).collect();
    let report = Report { groups, preference: job.preference() };
    let json = || serde_json::to_string(&report).expect("numbers are JSON");
    output::print(&if arguments.json { json() } else { lines(&report.groups) })?;
    Ok(notes)
}

fn lines(groups: &[Vec<u32>]) -> String {
    let line = |group: &Vec<u32>| group.iter().map(u32::to_string).collect::<Vec<_>>().join(" ") + "\n";
    groups.iter().map(line).collect()
}
