//! Cold steady solutions and time steps of rough contacts on the gear case: 512 cells took 1.4 ms cold, and a step 1.0 to
//! 3.4 ms (22 November 2026).

#[path = "../../crates/ehl/tests/common/mod.rs"]
mod common;

use std::time::Duration;

use asperity_core::quantity::Pressure;
use asperity_ehl::{
    MovingProfile, Oil, RecordSettings, RoughContact, SteadySettings, Window, steady, transient,
};
use asperity_oil::ShearLaw;
use common::{contact, gear_oil, waves};
use criterion::{BenchmarkId, Criterion, criterion_group, criterion_main};

fn cold(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("cold_steady");
    group
        .sample_size(10)
        .measurement_time(Duration::from_secs(2));
    for cells in [256, 512, 1024] {
        let settings = SteadySettings {
            cells,
            window: Some(Window::ROUGH),
        };
        let (pair, oil) = (contact(1.2e9, 5.0, 0.0), gear_oil());
        group.bench_function(BenchmarkId::from_parameter(cells), |bencher| {
            bencher.iter(|| steady::solve(&pair, &oil, &settings).unwrap());
        });
    }
}

/// Records of two half-widths, 256 steps at 512 cells: gentle (Rq 0.05 µm at 5 m/s) and heavy
/// (0.3 µm at 1 m/s).
fn record(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("record_of_256_steps");
    group
        .sample_size(10)
        .measurement_time(Duration::from_secs(5));
    for (name, u_m, rq) in [("gentle", 5.0, 0.05e-6), ("heavy", 1.0, 0.3e-6)] {
        let rough = RoughContact {
            contact: contact(1.2e9, u_m, 0.2),
            oil: Oil {
                shear_law: ShearLaw::Eyring {
                    stress: Pressure::from_si(5e6),
                },
                ..gear_oil()
            },
            surface_1: MovingProfile::periodic(&waves(1, rq)),
            surface_2: MovingProfile::periodic(&waves(2, rq)),
        };
        let settings = RecordSettings {
            start: 0.0,
            length: 2.0,
            ..RecordSettings::default()
        };
        group.bench_function(name, |bencher| {
            bencher.iter(|| transient::record(&rough, &settings).unwrap());
        });
    }
}

criterion_group!(benches, cold, record);
criterion_main!(benches);
