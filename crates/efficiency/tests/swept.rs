//! Energies of a contact that sweeps the flank; `references/swept.py` computes those of the three gears.

#![allow(
    clippy::unwrap_used,
    reason = "helpers of tests may unwrap as tests do"
)]

use std::collections::BTreeMap;

use asperity_core::quantity::{Length, LineEnergy, LineLoad, Speed};
use asperity_efficiency::swept::{HYSTERESIS, SweptPosition, run_in_energy, swept_deformation};
use proptest::prelude::*;
use serde::Deserialize;

#[derive(Deserialize)]
struct Golden {
    cases: BTreeMap<String, Case>,
}

#[derive(Deserialize)]
struct Case {
    places: Vec<[f64; 6]>,
    elastic_cycled_w: f64,
    plastic_first_pass_w: f64,
    max_area_density_j_per_m2: f64,
}

fn place(row: &[f64; 6]) -> SweptPosition {
    SweptPosition {
        weight: Length::from_si(row[0]),
        load: LineLoad::from_si(row[1]),
        radius: Length::from_si(row[2]),
        half_width: Length::from_si(row[3]),
        entrainment: Speed::from_si(row[4]),
        plastic_work: LineEnergy::from_si(row[5]),
    }
}

#[test]
fn swept_powers_of_three_gears() {
    let golden: Golden = serde_json::from_str(include_str!("golden/swept.json")).unwrap();
    assert_eq!(golden.cases.len(), 3);
    for (name, case) in golden.cases {
        let places: Vec<SweptPosition> = case.places.iter().map(place).collect();
        let power = swept_deformation(&places, HYSTERESIS).unwrap();
        // The places are typed with nine digits.
        let close = |seen: f64, expected: f64| (seen / expected - 1.0).abs() < 1e-7;
        assert!(
            close(power.elastic_cycling.si(), case.elastic_cycled_w),
            "{name}"
        );
        assert!(
            close(power.hysteresis.si(), 0.005 * case.elastic_cycled_w),
            "{name}"
        );
        assert!(
            close(power.plastic.si(), case.plastic_first_pass_w),
            "{name}"
        );
        let densest = places
            .iter()
            .map(|p| run_in_energy(p.plastic_work, p.half_width).unwrap())
            .fold(0.0, f64::max);
        assert!(close(densest, case.max_area_density_j_per_m2), "{name}");
    }
}

#[test]
fn cycled_energy_is_the_work_of_the_front_half_of_the_pressure() {
    let (f, r, a) = (144e3, 5.6e-3, 94e-6);
    let p0 = 2.0 * f / (std::f64::consts::PI * a);
    let n = 20_000;
    // Midpoint rule; the square root at the end costs 1e-6.
    let work: f64 = (0..n)
        .map(|i| (f64::from(i) + 0.5) / f64::from(n))
        .map(|t| p0 * (1.0 - t * t).sqrt() * t * a / r * a / f64::from(n))
        .sum();
    let power = swept_deformation(&[place(&[0.05, f, r, a, 7.3, 0.0])], HYSTERESIS).unwrap();
    assert!((power.elastic_cycling.si() / (work * 7.3 * 0.05) - 1.0).abs() < 1e-5);
    assert_eq!(power.plastic.si(), 0.0);
}

#[test]
fn impossible_places_are_refused() {
    let good = [0.05, 144e3, 5.6e-3, 94e-6, 7.3, 1e-3];
    assert!(swept_deformation(&[], HYSTERESIS).is_err());
    assert!(swept_deformation(&[place(&good)], 1.5).is_err());
    for k in 0..6 {
        let mut bad = good;
        bad[k] = -1.0;
        assert!(
            swept_deformation(&[place(&bad)], HYSTERESIS).is_err(),
            "{k}"
        );
    }
}

proptest! {
    #[test]
    fn powers_add_up_over_places_and_go_with_speed(
        weight in 1e-3..0.1_f64, speed in 0.1..30.0_f64, factor in 0.1..10.0_f64, alpha in 0.0..0.1_f64,
    ) {
        let at = |weight, speed| swept_deformation(&[place(&[weight, 1e5, 8e-3, 9e-5, speed, 2e-3])], alpha).unwrap();
        let (one, faster) = (at(weight, speed), at(weight, factor * speed));
        prop_assert!((faster.elastic_cycling / one.elastic_cycling / factor - 1.0).abs() < 1e-12);
        prop_assert!((faster.plastic / one.plastic / factor - 1.0).abs() < 1e-12);
        prop_assert!((one.hysteresis.si() - alpha * one.elastic_cycling.si()).abs() <= 1e-12 * one.elastic_cycling.si());
        let row = [0.5 * weight, 1e5, 8e-3, 9e-5, speed, 2e-3];
        let halves = swept_deformation(&[place(&row), place(&row)], alpha).unwrap();
        prop_assert!((halves.elastic_cycling / one.elastic_cycling - 1.0).abs() < 1e-12);
    }
}
