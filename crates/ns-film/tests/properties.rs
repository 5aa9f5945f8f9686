//! Properties of the film that hold for every input.
#![allow(clippy::unwrap_used)] // Helpers outside test functions.

use asperity_core::quantity::{DynamicViscosity, Speed};
use asperity_ns_film::film_pressure::{FilmPressure, Rupture, film_pressure};
use proptest::prelude::*;

/// A wavy wedge or cylinder: 200 points, waves of any phase and of up to most of the gap.
fn gap(curvature: f64, tilt: f64, waves: &[(f64, f64)]) -> (Vec<f64>, Vec<f64>) {
    let x: Vec<f64> = (0..=200).map(|i| (f64::from(i) - 100.0) * 2e-6).collect();
    let h = x
        .iter()
        .map(|x| {
            let t = x / 2e-4;
            let rough: f64 = waves
                .iter()
                .enumerate()
                .map(|(k, (size, phase))| size * (7.0 * (k + 1) as f64 * t + phase).sin())
                .sum();
            1e-6 * (1.0 + curvature * t * t + tilt * (1.0 - t) + rough / waves.len() as f64)
        })
        .collect();
    (x, h)
}

fn reynolds(x: &[f64], h: &[f64], u: f64, eta: f64) -> FilmPressure {
    let (u, eta) = (Speed::from_si(u), DynamicViscosity::from_si(eta));
    film_pressure(x, h, u, eta, Rupture::Reynolds).unwrap()
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(200) })]

    #[test]
    fn a_ruptured_film_never_pulls_and_never_gains_oil(
        curvature in 0.0..20.0f64,
        tilt in 0.0..2.0f64,
        waves in prop::collection::vec((0.0..0.9f64, 0.0..6.3f64), 1..6),
        eta in 1e-3..1.0f64,
    ) {
        let (x, h) = gap(curvature, tilt, &waves);
        let film = reynolds(&x, &h, 3.0, eta);
        prop_assert!(film.pressure.iter().all(|p| *p >= 0.0));
        prop_assert!(film.residual < 1e-9, "{}", film.residual);
        // Flow through the middle of each interval: equal in the film, and never more after a
        // rupture than before it.
        let flow: Vec<f64> = (0..200)
            .map(|i| {
                let middle = 0.5 * (h[i] + h[i + 1]);
                let slope = (film.pressure[i + 1] - film.pressure[i]) / (x[i + 1] - x[i]);
                1.5 * middle - middle.powi(3) / (12.0 * eta) * slope
            })
            .collect();
        for i in 1..200 {
            let change = flow[i] - flow[i - 1];
            if film.pressure[i] > 0.0 {
                prop_assert!(change.abs() < 1e-8 * flow[i].abs());
            } else {
                // Where it has ruptured the gap drags away at least what comes.
                prop_assert!(change > -1e-8 * flow[i].abs());
            }
        }
    }

    #[test]
    fn pressure_is_proportional_to_speed_and_viscosity(
        curvature in 0.1..20.0f64,
        wave in (0.0..0.9f64, 0.0..6.3f64),
        factor in 0.1..10.0f64,
    ) {
        let (x, h) = gap(curvature, 0.0, &[wave]);
        let load = |u, eta| reynolds(&x, &h, u, eta).load.si();
        prop_assert!((load(factor, 0.05) / load(1.0, 0.05) / factor - 1.0).abs() < 1e-9);
        prop_assert!((load(1.0, 0.05 * factor) / load(factor, 0.05) - 1.0).abs() < 1e-9);
    }

    #[test]
    fn rupture_never_carries_less_than_a_film_that_pulls(curvature in 0.5..20.0f64, tilt in 0.0..1.0f64) {
        let (x, h) = gap(curvature, tilt, &[(0.0, 0.0)]);
        let (u, eta) = (Speed::from_si(1.0), DynamicViscosity::from_si(0.05));
        let full = film_pressure(&x, &h, u, eta, Rupture::FullSommerfeld).unwrap().load.si();
        let ruptured = reynolds(&x, &h, 1.0, 0.05).load.si();
        prop_assert!(ruptured >= full * (1.0 - 1e-12));
    }
}
