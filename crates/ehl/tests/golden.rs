//! The solver gives the numbers to which stored records refer.

#![allow(
    clippy::unwrap_used,
    clippy::disallowed_methods,
    reason = "a record that cannot be solved fails its test"
)]

use crate::common::{contact, gear_oil, waves};
use asperity_core::quantity::{DynamicViscosity, Length, Pressure, PressureViscosity};
use asperity_ehl::{
    FrictionLaw, GOLDEN_RECORD, MovingProfile, Oil, RecordSettings, RoughContact, transient,
};
use asperity_oil::ShearLaw;

/// Largest deviation of a number: transforms round differently with and without AVX2.
const TOLERANCE: f64 = 1e-7;

/// Numbers of a short record of two wavy surfaces with thin films, in order.
fn numbers() -> Vec<(&'static str, f64)> {
    let rough = RoughContact {
        contact: contact(1.2e9, 1.0, 0.2),
        oil: Oil {
            shear_law: ShearLaw::Eyring {
                stress: Pressure::from_si(5e6),
            },
            ..gear_oil()
        },
        surface_1: MovingProfile::periodic(&waves(1, 0.3e-6)),
        surface_2: MovingProfile::periodic(&waves(2, 0.3e-6)),
    };
    let settings = RecordSettings {
        cells: 128,
        start: 1.0,
        length: 3.0,
        friction: Some(FrictionLaw {
            viscosity: DynamicViscosity::from_si(0.01),
            pressure_viscosity: PressureViscosity::from_si(1.8e-8),
            eyring_stress: Pressure::from_si(5e6),
            limiting_stress: Pressure::from_si(2e6),
            limiting_slope: 0.035,
            boundary_friction: 0.08,
            boundary_layer: Length::from_si(10e-9),
        }),
        ..RecordSettings::default()
    };
    let record = transient::record(&rough, &settings).unwrap().value;
    let friction = record.friction.as_ref().unwrap();
    let mut found = vec![
        ("solid share", record.solid_share.mean),
        ("mean film [m]", record.mean_film.mean),
        ("smooth film [m]", record.smooth_film.si()),
        ("largest pressure [Pa]", record.max_pressure.si()),
        ("mean largest pressure [Pa]", record.mean_max_pressure.mean),
        ("friction, shifted", friction.shifted.mean),
        ("friction, graded", friction.graded.mean),
        ("friction, stepped", friction.stepped.mean),
        ("friction, film alone", friction.film.mean),
        ("boundary share", friction.boundary_share.mean),
    ];
    let below = record.load_below.iter();
    found.extend(below.map(|below| ("load below a film", below.share.mean)));
    found
}

#[test]
fn a_short_record_has_the_numbers_to_which_stored_records_refer() {
    let found = numbers();
    if std::env::var_os("ASPERITY_WRITE").is_some() {
        let line = |(name, value): &(&str, f64)| format!("{name}: {value:.9e}\n");
        let text: String = found.iter().map(line).collect();
        let file = concat!(env!("CARGO_MANIFEST_DIR"), "/src/golden_record.txt");
        std::fs::write(file, text).unwrap();
        return;
    }
    let golden: Vec<(&str, f64)> = GOLDEN_RECORD
        .lines()
        .map(|line| line.rsplit_once(": ").unwrap())
        .map(|(name, value)| (name, value.parse().unwrap()))
        .collect();
    assert_eq!(golden.len(), found.len());
    for ((name, golden), (own, value)) in golden.into_iter().zip(found) {
        assert_eq!(name, own);
        let largest = golden.abs().max(1e-12);
        assert!(
            (value - golden).abs() <= TOLERANCE * largest,
            "{name}: {value:e}, not {golden:e}: if the solver is meant to give other numbers, write them anew \
             (ASPERITY_WRITE=1), which makes stored records invalid"
        );
    }
}
