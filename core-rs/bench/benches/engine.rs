//! How long the engine takes, natively. `npm run bench` prints these beside the browser's figures and other libraries'.

// Criterion's macro makes a function without documentation.
#![allow(missing_docs)]

use std::hint::black_box;
use std::sync::Arc;
use std::time::Instant;

use criterion::{BatchSize, Criterion, criterion_group, criterion_main};
use eigenform::adjacency::{self, AdjacencySpec};
use eigenform::assignment;
use eigenform::choice::MethodName;
use eigenform::formation::Formation;
use eigenform::perform::{Performer, Step};
use eigenform::scene::Scene;
use eigenform::spectral::Eigenbasis;
use eigenform_bench::{crossing_blocks, crowd, joined, move_first, show, strewn, thousand};

fn eigenbasis(criterion: &mut Criterion) {
    for agent_count in [300, 1260] {
        let graph = adjacency::build(&strewn(agent_count, 1), &AdjacencySpec::default(), &[]).expect("few ties");
        let laplacian = graph.laplacian();
        criterion.bench_function(&format!("eigenbasis {agent_count}"), |bencher| {
            bencher.iter(|| Eigenbasis::of(black_box(laplacian.as_ref())));
        });
    }
}

fn assign(criterion: &mut Criterion) {
    for agent_count in [1260, 1936] {
        let (source, target) = (strewn(agent_count, 1), strewn(agent_count, 2));
        criterion.bench_function(&format!("assignment {agent_count}"), |bencher| {
            bencher.iter(|| assignment::squared(black_box(&source), black_box(&target)));
        });
    }
}

/// From a moved agent at the middle keyframe to the new motions of both segments beside it.
fn moved_agent(criterion: &mut Criterion) {
    for (name, agent_count, method) in [
        ("moved agent 60", 60, MethodName::Spectral),
        ("moved agent 300", 300, MethodName::Spectral),
        ("moved agent 25 auto", 25, MethodName::Auto),
    ] {
        let scene = show(agent_count, 3, 10.0, method);
        criterion.bench_function(name, |bencher| {
            bencher.iter_batched(
                || {
                    let mut performer = Performer::default();
                    perform_all(&mut performer, &scene);
                    let mut moved = scene.clone();
                    moved.tracks[0].keyframes[1].positions = Arc::new(strewn(agent_count, 99));
                    (performer, moved)
                },
                |(mut performer, moved)| perform_all(&mut performer, &moved),
                BatchSize::PerIteration,
            );
        });
    }
}

/// From a group dragged at the second keyframe of 1,260 agents in three levels to the new motions of both segments beside it.
fn moved_group(criterion: &mut Criterion) {
    let scene = thousand();
    criterion.bench_function("moved group in 1260", |bencher| {
        bencher.iter_batched(
            || {
                let mut performer = Performer::default();
                perform_all(&mut performer, &scene);
                let mut dragged = scene.clone();
                let mut positions = scene.main_track().keyframes[1].positions.positions().to_vec();
                for place in &mut positions[36..72] {
                    place.x += 1.37;
                }
                dragged.tracks[0].keyframes[1].positions = Arc::new(Formation::new(positions));
                (performer, dragged)
            },
            |(mut performer, dragged)| perform_all(&mut performer, &dragged),
            BatchSize::PerIteration,
        );
    });
}

fn whole(criterion: &mut Criterion) {
    for (name, scene) in [
        ("blocks of 1936 kept apart", crossing_blocks()),
        ("one transition of 1260", show(1260, 2, 10.0, MethodName::Spectral)),
        ("show of 200 x 23 auto", show(200, 23, 10.0, MethodName::Auto)),
        ("smooth join of 300 x 6", joined(300, 6, 4.0, MethodName::Spectral)),
    ] {
        criterion.bench_function(name, |bencher| bencher.iter(|| perform_all(&mut Performer::default(), &scene)));
    }
}

/// What a crowd's walk takes beyond the straight guide that it follows, until it can be played: 300 steps with all forces and feedback.
fn crowds(criterion: &mut Criterion) {
    for agent_count in [110, 306, 783, 1190, 1936, 10_000] {
        let [walked, guide] = [MethodName::Crowd, MethodName::Linear].map(|method| crowd(agent_count, method));
        criterion.bench_function(&format!("crowd of {agent_count}, 300 steps"), |bencher| {
            bencher.iter_custom(|rounds| {
                let time = |scene: &Scene| {
                    let start = Instant::now();
                    move_first(&mut Performer::default(), scene);
                    start.elapsed()
                };
                (0..rounds).map(|_| time(&walked).saturating_sub(time(&guide))).sum()
            });
        });
    }
}

fn perform_all(performer: &mut Performer, scene: &Scene) {
    for segment in 0..scene.main_track().segments.len() {
        let mut job = performer.begin(scene, segment, &[]);
        while !matches!(job.step(performer).expect("the show can be performed"), Step::Done(_)) {}
    }
}

criterion_group! {
    name = benches;
    config = Criterion::default().sample_size(10).without_plots();
    targets = eigenbasis, assign, moved_agent, moved_group, whole, crowds
}
criterion_main!(benches);
