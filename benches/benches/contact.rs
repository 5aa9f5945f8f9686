//! Time of whole solutions, planning included; of warm starts with plans kept; of the transforms
//! that the solutions are made of; and of a stress field. `crates/contact/tests/common/peers.rs` defines the cases.

#[path = "../../crates/contact/tests/common/mod.rs"]
mod common;

use std::time::Duration;

use asperity_contact::subsurface::{graded_depths, subsurface_stress};
use asperity_contact::{ContactProblem, Control, Lead, Solver, SolverSettings, solve};
use asperity_core::numerics::{SymmetricToeplitz, good_fft_length};
use asperity_core::quantity::{Length, Pressure};
use common::peers::Peer;
use common::{CYLINDER, hertz_problem, rough_patch};
use criterion::{BenchmarkId, Criterion, criterion_group, criterion_main};

/// Cases and sizes; the largest fractal one takes a quarter of a minute and is left to the example
/// `measure`.
const CASES: [(&str, &[usize]); 5] = [
    ("a", &[1_000, 10_000, 100_000, 1_000_000]),
    ("d", &[1_000, 10_000, 100_000, 1_000_000]),
    ("e", &[1_000, 10_000, 100_000, 1_000_000]),
    ("c", &[4_096, 65_536, 1_048_576]),
    ("cf", &[4_096, 65_536]),
];

fn cold(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("cold");
    group
        .sample_size(10)
        .measurement_time(Duration::from_secs(2));
    let settings = SolverSettings::default();
    for (name, sizes) in CASES {
        for &points in sizes {
            let peer = Peer::new(name, points).unwrap();
            group.bench_function(BenchmarkId::new(name, points), |bencher| {
                bencher.iter(|| solve(&peer.problem(), &settings).unwrap());
            });
        }
    }
    group.finish();
}

/// Both convolutions of an iteration on the whole grid, products included.
fn transforms(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("transforms of an iteration");
    group
        .sample_size(10)
        .measurement_time(Duration::from_secs(1));
    for (ends, factor, sizes) in [("free", 2, CASES[1].1), ("periodic", 1, CASES[3].1)] {
        for &points in sizes {
            // A kernel of one value has a period of as many points as the matrix has rows.
            let mut both = [factor * points, points]
                .map(|length| SymmetricToeplitz::new(&[1.0], good_fft_length(length)));
            let signals = [factor * points, points].map(|n| vec![1.0; good_fft_length(n)]);
            let mut out = vec![0.0; good_fft_length(factor * points)];
            group.bench_function(BenchmarkId::new(ends, points), |bencher| {
                bencher.iter(|| {
                    for (filter, signal) in both.iter_mut().zip(&signals) {
                        filter.apply(signal, &mut out);
                    }
                });
            });
        }
    }
    group.finish();
}

fn warm(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("plans kept");
    group
        .sample_size(10)
        .measurement_time(Duration::from_secs(2));
    let settings = SolverSettings::default();
    for points in [1_000, 10_000, 100_000] {
        let peer = Peer::new("d", points).unwrap();
        let problem = peer.problem();
        let mut solver = Solver::new(points, problem.boundary).unwrap();
        let solution = solver.solve(&problem, &settings).unwrap();
        group.bench_function(BenchmarkId::new("no start", points), |bencher| {
            bencher.iter(|| solver.solve(&problem, &settings).unwrap());
        });
        let heavier = ContactProblem {
            control: Control::Load(CYLINDER.load * 1.05),
            start: Some(&solution.pressure),
            ..problem
        };
        group.bench_function(BenchmarkId::new("5 % more load", points), |bencher| {
            bencher.iter(|| solver.solve(&heavier, &settings).unwrap());
        });
        let lowered = ContactProblem {
            control: Control::Approach {
                approach: solution.approach + Length::from_si(80e-9),
                datum: solution.datum,
            },
            ..heavier
        };
        group.bench_function(BenchmarkId::new("80 nm lower", points), |bencher| {
            bencher.iter(|| solver.solve(&lowered, &settings).unwrap());
        });
    }
    group.finish();
}

/// The contact of a patch at one share of its load, from the pressure at the next.
fn patch(criterion: &mut Criterion) {
    let [columns, rows] = [768, 256];
    let (gap, spacing) = rough_patch([columns, rows]);
    let lead = Some(Lead { rows, spacing });
    let settings = SolverSettings::default();
    let problem = ContactProblem {
        lead,
        pressure_limit: Some(Pressure::from_si(8e9)),
        ..ContactProblem::new(&gap, spacing, CYLINDER.modulus, CYLINDER.load * 0.4)
    };
    let mut solver = Solver::from_problem(&problem).unwrap();
    let next = solver.solve(&problem, &settings).unwrap();
    let mut group = criterion.benchmark_group("patch");
    group.sample_size(10);
    group.bench_function("share 0.28 from share 0.4, 256 x 768", |bencher| {
        let problem = ContactProblem {
            control: Control::Load(CYLINDER.load * 0.28),
            start: Some(&next.pressure),
            ..problem
        };
        bencher.iter(|| solver.solve(&problem, &settings).unwrap());
    });
    group.finish();
}

fn subsurface(criterion: &mut Criterion) {
    let (gap, spacing) = CYLINDER.gap(2_000);
    let solution = solve(&hertz_problem(&gap, spacing), &SolverSettings::default()).unwrap();
    let depths = graded_depths(spacing, Length::from_si(100e-6), 200).unwrap();
    let traction: Vec<f64> = solution.pressure.iter().map(|p| 0.1 * p).collect();
    criterion.bench_function("stress field 2000 x 200 with traction", |bencher| {
        bencher.iter(|| {
            subsurface_stress(&solution.pressure, Some(&traction), spacing, &depths).unwrap()
        });
    });
}

criterion_group!(benches, cold, transforms, warm, patch, subsurface);
criterion_main!(benches);
