//! Time of the load map of a pair, compliance included, and of what follows from it.

#[path = "../../crates/gear/tests/common/reference.rs"]
mod reference;

use std::time::Duration;

use asperity_core::quantity::Length;
use asperity_gear::{LoadLaw, LoadMap, LoadMapSettings, MicroGeometry, ReliefShape};
use criterion::{BenchmarkId, Criterion, criterion_group, criterion_main};
use reference::{golden, steel};

fn maps(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("load map");
    group
        .sample_size(20)
        .measurement_time(Duration::from_secs(2));
    let relieved = |length: f64| {
        let length = Length::from_si(length);
        MicroGeometry::tip_relief(Length::from_si(1e-5), length, ReliefShape::Linear)
    };
    for case in golden().cases() {
        let pair = case.pair();
        let double = (pair.path().eps_alpha - 1.0) * pair.path().base_pitch.si();
        for (name, micro) in [
            ("plain", MicroGeometry::default()),
            ("relief", relieved(double.max(1e-4))),
        ] {
            group.bench_function(BenchmarkId::new(name, &case.name), |bencher| {
                bencher.iter(|| {
                    LoadMap::new(
                        &pair,
                        case.torque(),
                        &LoadLaw::Elastic,
                        &micro,
                        &[steel(); 2],
                        &LoadMapSettings::default(),
                    )
                    .unwrap()
                });
            });
        }
    }
    group.finish();
}

criterion_group!(benches, maps);
criterion_main!(benches);
