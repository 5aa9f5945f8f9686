//! Time of whole solutions, planning included, and of solutions with plans kept.
#![allow(
    missing_docs,
    reason = "criterion's macros make undocumented functions"
)]
#![allow(
    clippy::unwrap_used,
    reason = "a problem that cannot be solved has no time"
)]

#[path = "../tests/common/mod.rs"]
mod common;

use asperity_contact::{Boundary, ContactProblem, Control, Solver, SolverSettings, solve};
use asperity_core::quantity::{Length, Pressure};
use common::{CYLINDER, hertz_problem, rough_gap};
use criterion::{Criterion, criterion_group, criterion_main};

fn cold(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("cold");
    group.sample_size(20);
    let settings = SolverSettings::default();
    let limited = Some(Pressure::from_si(4e9));
    for (name, (gap, spacing), limit) in [
        ("hertz 10 000", CYLINDER.gap(10_000), None),
        ("rough 10 000", rough_gap(10_000), None),
        ("rough 100 000", rough_gap(100_000), None),
        ("rough plastic 10 000", rough_gap(10_000), limited),
        ("rough plastic 100 000", rough_gap(100_000), limited),
    ] {
        let problem = ContactProblem {
            pressure_limit: limit,
            ..hertz_problem(&gap, spacing)
        };
        group.bench_function(name, |bencher| {
            bencher.iter(|| solve(&problem, &settings).unwrap());
        });
    }
    group.finish();
}

fn kept(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("kept plans");
    group.sample_size(20);
    let settings = SolverSettings::default();
    for points in [1_000, 10_000] {
        let (gap, spacing) = rough_gap(points);
        let mut solver = Solver::new(points, Boundary::FreeEnds).unwrap();
        let problem = hertz_problem(&gap, spacing);
        let solution = solver.solve(&problem, &settings).unwrap();
        group.bench_function(format!("load, {points}"), |bencher| {
            bencher.iter(|| solver.solve(&problem, &settings).unwrap());
        });
        let step = Control::Approach {
            approach: solution.approach + Length::from_si(80e-9),
            datum: solution.datum,
        };
        let lowered = ContactProblem {
            control: step,
            start: Some(&solution.pressure),
            ..problem
        };
        group.bench_function(format!("approach step, {points}"), |bencher| {
            bencher.iter(|| solver.solve(&lowered, &settings).unwrap());
        });
    }
    group.finish();
}

criterion_group!(benches, cold, kept);
criterion_main!(benches);
