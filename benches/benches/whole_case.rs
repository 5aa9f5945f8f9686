//! Cost of the shipped e-drive case: a whole run, and another temperature with its contacts kept.
use std::hint::black_box;
use std::path::Path;

use asperity::Run;
use asperity::case::load;
use asperity::core::task::on_threads;
use asperity_benches::WORKSPACE;
use criterion::{Criterion, criterion_group, criterion_main};

/// The shipped e-drive case on one thread, so that its time is one of the processor.
fn whole_case(criterion: &mut Criterion) {
    let path = Path::new(WORKSPACE).join("fixtures/cases/e-drive.toml");
    let case = load(&path, None).expect("a shipped case");
    let tables = Run::new(&case).contacts().expect("solved contacts");
    let warmer = case
        .with_key("operation.bulk_temperature", "60 °C")
        .expect("a temperature");
    criterion.bench_function("e-drive, another temperature by kept contacts", |bencher| {
        bencher.iter(|| {
            on_threads(1, || {
                Run::new(black_box(&warmer))
                    .known(&tables)
                    .losses()
                    .expect("losses")
            })
        });
    });
    let mut slow = criterion.benchmark_group("e-drive");
    slow.sample_size(10);
    slow.bench_function("whole run", |bencher| {
        bencher.iter(|| on_threads(1, || Run::new(black_box(&case)).execute().expect("a run")));
    });
}

criterion_group!(whole, whole_case);
criterion_main!(whole);
