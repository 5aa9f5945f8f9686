//! Filters and parameters at the sizes labs send.

use std::hint::black_box;

use asperity_core::Profile;
use asperity_core::quantity::Length;
use asperity_roughness::Parameters;
use asperity_roughness::gaussian_filter::{Ends, mean_line};
use asperity_roughness::generate::SelfAffine;
use asperity_roughness::height_parameters::Mode;
use asperity_roughness::preparation::{Preparation, prepare};
use asperity_roughness::robust_filter::robust_mean_line;
use criterion::{BenchmarkId, Criterion, criterion_group, criterion_main};

fn recipe(points: usize) -> SelfAffine {
    SelfAffine {
        points,
        spacing: Length::from_si(0.5e-6),
        rq: Length::from_si(0.3e-6),
        hurst: 0.8,
        roll_off: Length::from_si(100e-6),
        short_cut: Length::from_si(2.5e-6),
        seed: 1,
    }
}

fn rough(points: usize) -> Profile {
    recipe(points).generate().expect("the recipe is valid")
}

fn info(c: &mut Criterion) {
    let flank = rough(1_000_000);
    let mut group = c.benchmark_group("info");
    group.sample_size(10);
    group.bench_function("prepare and evaluate 1e6 points in both modes", |b| {
        b.iter(|| {
            let prepared =
                prepare(black_box(&flank), &Preparation::default()).expect("long enough");
            let rough = &prepared.profile;
            let found = Parameters::from_profile(rough, Mode::Iso4287, Length::from_si(0.8e-3));
            let found = found.expect("long enough");
            found.in_mode(rough, Mode::Iso21920)
        });
    });
    group.finish();
}

fn parameters(c: &mut Criterion) {
    let prepared = prepare(&rough(1_000_000), &Preparation::default()).expect("long enough");
    let mut group = c.benchmark_group("parameters of 1e6 points");
    group.sample_size(20);
    for mode in [Mode::Iso4287, Mode::Iso21920] {
        group.bench_function(mode.to_string(), |b| {
            b.iter(|| {
                Parameters::from_profile(
                    black_box(&prepared.profile),
                    mode,
                    Length::from_si(0.8e-3),
                )
            });
        });
    }
    group.finish();
}

fn robust(c: &mut Criterion) {
    let mut group = c.benchmark_group("robust gaussian filter");
    group.sample_size(10);
    for points in [10_000, 100_000, 1_000_000] {
        let profile = rough(points);
        group.bench_with_input(
            BenchmarkId::from_parameter(points),
            &profile,
            |b, profile| {
                b.iter(|| robust_mean_line(black_box(profile), Length::from_si(0.8e-3)));
            },
        );
    }
    group.finish();
}

fn filtering(c: &mut Criterion) {
    let mut group = c.benchmark_group("gaussian filter");
    group.sample_size(20);
    for points in [10_000, 100_000, 1_000_000] {
        let profile = rough(points);
        for ends in [Ends::Cut, Ends::Reg1] {
            let id = BenchmarkId::new(format!("{ends:?}"), points);
            group.bench_with_input(id, &profile, |b, profile| {
                b.iter(|| mean_line(black_box(profile), Length::from_si(0.8e-3), ends));
            });
        }
    }
    group.finish();
}

fn generating(c: &mut Criterion) {
    let mut group = c.benchmark_group("generate");
    group.sample_size(10);
    group.bench_function("self-affine 1e6 points", |b| {
        b.iter(|| recipe(1_000_000).generate())
    });
    group.finish();
}

criterion_group!(benches, info, parameters, filtering, robust, generating);
criterion_main!(benches);
