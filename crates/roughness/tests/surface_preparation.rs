//! Preparation of surfaces against traces and closed forms.
#![allow(clippy::unwrap_used)]

use std::f64::consts::TAU;

use asperity_core::Profile;
use asperity_core::quantity::Length;
use asperity_roughness::form::Form;
use asperity_roughness::gaussian_filter::Ends;
use asperity_roughness::preparation::{Preparation, prepare};
use asperity_roughness::surface_preparation::{PreparedSurface, prepare_surface};

const COLUMNS: usize = 700;
const ROWS: usize = 300;
const DX: f64 = 1e-6;
const DY: f64 = 2e-6;

fn made(height: impl Fn(f64, f64) -> f64) -> Vec<f64> {
    let at = |k: usize| height((k % COLUMNS) as f64 * DX, (k / COLUMNS) as f64 * DY);
    (0..COLUMNS * ROWS).map(at).collect()
}

fn prepared(z: &[f64], recipe: &Preparation) -> PreparedSurface {
    prepare_surface(z, COLUMNS, [DX, DY].map(Length::from_si), recipe).unwrap()
}

fn largest(heights: &[f64]) -> f64 {
    heights.iter().fold(0.0, |m: f64, z| m.max(z.abs()))
}

#[test]
fn a_surface_without_change_across_is_prepared_as_its_rows_are() {
    let profile = |x: f64| 1e-7 * (x / 9e-6).sin() + 2e-7 * (x / 41e-6).cos() + 3e-3 * x;
    let z = made(|x, _| profile(x));
    for form in [Form::Level, Form::Poly2, Form::Circle] {
        let recipe = Preparation {
            form,
            ..Preparation::default()
        };
        let trace = Profile::new(Length::from_si(DX), z[..COLUMNS].to_vec()).unwrap();
        let trace = prepare(&trace, &recipe).unwrap().profile;
        let surface = prepared(&z, &recipe);
        assert_eq!((surface.columns, surface.rows()), (trace.len(), ROWS));
        for k in [0, 1, 150, ROWS - 1] {
            let row = surface.row(k).iter().zip(trace.heights());
            let off = row.fold(0.0_f64, |m, (a, b)| m.max((a - b).abs()));
            assert!(off < 1e-16, "{form:?}, row {k}: {off:e}");
        }
    }
}

#[test]
fn a_wave_across_the_rows_is_filtered_by_its_length() {
    let lambda_c = 100e-6;
    let recipe = Preparation {
        lambda_s: None,
        lambda_c: Some(Length::from_si(lambda_c)),
        ends: Ends::Reg1,
        ..Preparation::default()
    };
    // Half of the amplitude at the cut-off, 1 − exp(−π α²) = 1 − 1/2; of a wave in both directions 1 − 2^(−(λc/λ)²).
    for (along, across) in [(0.0, 1.0), (1.0, 1.0), (1.0, 0.0), (0.5, 2.0)] {
        let wave = |x: f64, y: f64| (TAU * (along * x + across * y) / lambda_c).cos();
        let surface = prepared(&made(|x, y| 1e-7 * wave(x, y)), &recipe);
        let square: f64 = along * along + across * across;
        let left = 1.0 - 0.5_f64.powf(square);
        let middle = (100..200).flat_map(|k| &surface.row(k)[200..500]);
        let expected =
            (100..200).flat_map(|k| (200..500).map(move |i| (i as f64 * DX, k as f64 * DY)));
        let (mut both, mut own) = (0.0, 0.0);
        for (z, (x, y)) in middle.zip(expected) {
            both += z * wave(x, y);
            own += 1e-7 * wave(x, y).powi(2);
        }
        assert!(
            (both / own - left).abs() < 4e-3,
            "{along} {across}: {} {left}",
            both / own
        );
    }
}

#[test]
fn the_form_is_removed_in_both_directions_and_missing_points_are_bridged() {
    let recipe = Preparation {
        form: Form::Poly2,
        lambda_s: None,
        lambda_c: None,
        ..Preparation::default()
    };
    let flank = |x: f64, y: f64| 1e-3 * x - 2e-3 * y + 3.0 * x * x + 0.7 * x * y - 5.0 * y * y;
    let z = made(flank);
    assert!(largest(&prepared(&z, &recipe).heights) < 1e-15);
    let mut pitted = z;
    for (k, z) in pitted.iter_mut().enumerate() {
        if k % 11 == 0 || k / COLUMNS == 40 {
            *z = f64::NAN;
        }
    }
    let surface = prepared(&pitted, &recipe);
    assert!((surface.record.bridged - 19_727.0 / 210_000.0).abs() < 1e-15);
    // Level bridges at the ends of rows, where neighbours differ by 2 nm.
    let largest = largest(&surface.heights);
    assert!(largest < 3e-9, "{largest:e}");
    let inside = (0..ROWS).flat_map(|k| &surface.row(k)[10..COLUMNS - 10]);
    let inside = inside.fold(0.0_f64, |m, z| m.max(z.abs()));
    assert!(inside < 5e-11, "{inside:e}");
}

#[test]
fn surfaces_that_cannot_be_prepared_are_refused() {
    let refused = |z: &[f64], columns: usize| {
        let spacings = [DX, DY].map(Length::from_si);
        prepare_surface(z, columns, spacings, &Preparation::default())
            .unwrap_err()
            .to_string()
    };
    let z = made(|x, _| x);
    assert!(refused(&z[..3 * COLUMNS], COLUMNS).contains("rows"));
    assert!(refused(&z[..300 * 400], 400).contains("one cut-off"));
    let few: Vec<f64> = (0..z.len())
        .map(|k| if k % 3 == 0 { f64::NAN } else { z[k] })
        .collect();
    assert!(refused(&few, COLUMNS).contains("share of missing points"));
}
