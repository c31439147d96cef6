//! Timings of the engine.
use criterion::{Criterion, criterion_group, criterion_main};
fn engine(_c: &mut Criterion) {}
criterion_group!(benches, engine);
criterion_main!(benches);
