//! How avoidance does on shows: `cargo run --release --bin avoid -- [--distance 0.5] [--method auto] [--verbose] FILE…`
//!
//! Every segment of each keyframe CSV or scene, under straight guides or another method; without files, the symmetric suite.

use std::time::Instant;

use eigenform::choice::MethodName;
use eigenform::edits::{Avoidance, AvoidanceJob, AvoidanceStep, Edited};
use eigenform::motion::{Motion, clashes};
use eigenform::perform::perform;
use eigenform::scene::{self, Segment};
use eigenform_bench::crowds;
use glam::DVec2;

struct Options {
    distance: f64,
    method: MethodName,
    is_verbose: bool,
    files: Vec<String>,
}

#[derive(Default)]
struct Tally {
    still: usize,
    breached: usize,
    free: usize,
    solved: Vec<f64>,
    /// How many each rung solved.
    rungs: [usize; 22],
    failed: usize,
    jerks: Vec<f64>,
    means: Vec<f64>,
    greatest: Vec<f64>,
    speeds: Vec<f64>,
}

fn main() {
    let options = options();
    let mut tally = Tally::default();
    if options.files.is_empty() {
        for (name, guide) in crowds::suite() {
            judge(name, &guide, &options, &mut tally);
        }
    }
    for file in &options.files {
        let bytes = std::fs::read(file).expect("the file can be read");
        let mut scene = scene::open_bytes(&bytes).expect("the file is a scene").scene;
        scene.minimum_distance = options.distance;
        for Segment::Transition(transition) in &mut scene.tracks[0].segments {
            transition.method = options.method;
        }
        let performance = perform(&scene).expect("the scene can be performed");
        let name = file.rsplit('/').next().unwrap_or(file);
        for (k, segment) in performance.segments().iter().enumerate() {
            judge(&format!("{name} {k} {:?}", segment.choice.method), &segment.motion, &options, &mut tally);
        }
    }
    report(&mut tally);
}

fn options() -> Options {
    let mut options = Options { distance: 0.5, method: MethodName::Linear, is_verbose: false, files: Vec::new() };
    let mut arguments = std::env::args().skip(1);
    while let Some(argument) = arguments.next() {
        let mut value = || arguments.next().expect("an option has a value");
        match argument.as_str() {
            "--distance" => options.distance = value().parse().expect("a distance is a number"),
            "--method" => options.method = serde_json::from_value(value().into()).expect("a method is auto, linear, …"),
            "--verbose" => options.is_verbose = true,
            _ => options.files.push(argument),
        }
    }
    options
}

fn judge(name: &str, guide: &Motion, options: &Options, tally: &mut Tally) {
    let avoidance = Avoidance {
        minimum_distance: options.distance,
        is_clamped: [false; 2],
        seed: 0,
        obstacles: Vec::new(),
        holds: Vec::new(),
        groups: Vec::new(),
    };
    let is_still = guide.times().len() < 2 || guide.sample(0) == guide.sample(guide.times().len() - 1);
    if is_still {
        tally.still += 1;
        return;
    }
    let start = Instant::now();
    let mut job = AvoidanceJob::new(avoidance, guide.clone());
    let edited = loop {
        if let AvoidanceStep::Done(edited) = job.step() {
            break edited;
        }
    };
    let seconds = start.elapsed().as_secs_f64();
    let report = &edited.report;
    let before = clashes(guide, options.distance - 1e-6).len();
    let agent_count = guide.agent_count();
    if !report.breaches.is_empty() {
        tally.breached += 1;
    } else if report.rung == 0 && report.is_solved() {
        tally.free += 1;
        return;
    } else if report.is_solved() {
        tally.rungs[report.rung] += 1;
        tally.solved.push(1e3 * seconds);
        tally.jerks.push(jerk(&edited, guide));
        tally.means.push(report.deviation[0]);
        tally.greatest.push(report.deviation[1]);
        tally.speeds.push(top_speed(&edited.motion) / top_speed(guide));
    } else {
        tally.failed += 1;
    }
    if options.is_verbose && !report.is_solved() {
        for clash in report.unsolved.iter().take(60) {
            println!("    {:.3} m at {:.2} s, {:?}", clash.distance, clash.time, clash.agents);
        }
    }
    if options.is_verbose || !report.is_solved() || options.files.is_empty() {
        println!(
            "{name}: {agent_count} agents, {before} clashes -> {} ({} breaches), rung {}, {:.1} ms, deviation {:.3} {:.2} m, jerk {:.2}, speed x{:.2}",
            report.unsolved.len(),
            report.breaches.len(),
            report.rung,
            1e3 * seconds,
            report.deviation[0],
            report.deviation[1],
            jerk(&edited, guide),
            top_speed(&edited.motion) / top_speed(guide),
        );
    }
}

/// The root mean square of what the deviation adds to jerk, the median over those moved, m/s³.
fn jerk(edited: &Edited, guide: &Motion) -> f64 {
    let count = guide.times().len();
    let agent_count = guide.agent_count();
    let at = |k: usize, agent: usize| edited.motion.sample(k)[agent] - guide.sample(k)[agent];
    let mut jerks = Vec::new();
    for agent in 0..agent_count {
        let mut sum = 0.0;
        let third = |k: usize| -> DVec2 { at(k + 3, agent) - 3.0 * at(k + 2, agent) + 3.0 * at(k + 1, agent) - at(k, agent) };
        for k in 1..count.saturating_sub(4) {
            let frame = guide.times()[k + 1] - guide.times()[k];
            sum += third(k).length_squared() / frame.powi(6);
        }
        if sum > 1e-12 {
            jerks.push((sum / count as f64).sqrt());
        }
    }
    median(&mut jerks)
}

fn top_speed(motion: &Motion) -> f64 {
    let mut top: f64 = 0.0;
    for k in 1..motion.times().len() {
        let seconds = motion.times()[k] - motion.times()[k - 1];
        let steps = motion.sample(k - 1).iter().zip(motion.sample(k));
        top = steps.map(|(from, to)| from.distance(*to) / seconds).fold(top, f64::max);
    }
    top
}

fn median(values: &mut [f64]) -> f64 {
    values.sort_unstable_by(f64::total_cmp);
    values.get(values.len() / 2).copied().unwrap_or(0.0)
}

fn report(tally: &mut Tally) {
    let clashing = tally.solved.len() + tally.failed;
    println!(
        "\n{} still, {} with keyframes too near, {} without a clash, {clashing} clashing: {} solved, {} not; by rung {:?}",
        tally.still,
        tally.breached,
        tally.free,
        tally.solved.len(),
        tally.failed,
        &tally.rungs[1..],
    );
    println!(
        "medians: {:.1} ms, jerk {:.2} m/s3, mean deviation {:.4} m, greatest {:.3} m, speed x{:.3}",
        median(&mut tally.solved),
        median(&mut tally.jerks),
        median(&mut tally.means),
        median(&mut tally.greatest),
        median(&mut tally.speeds),
    );
}
