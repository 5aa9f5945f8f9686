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

/// Ridges of several wavelengths at an angle, bent along their length, with a tilt and a fixed noise.
fn ridges(k: usize, bend: f64) -> f64 {
    let (x, y) = ((k % COLUMNS) as f64 * 0.5, (k / COLUMNS) as f64 * 0.8);
    let across = 0.9 * x + 0.3 * y;
    let along = 0.9 * y - 0.3 * x;
    let mut z = 0.01 * x - 0.02 * y;
    for (i, wavelength) in [31.0, 13.7, 9.1, 5.3, 3.7].into_iter().enumerate() {
        let i = i as f64;
        z += 0.1
            * (TAU * across / wavelength
                + 1.7 * i
                + bend * (TAU * along / (90.0 + 17.0 * i)).sin())
            .sin();
    }
    let hash = (k as u64).wrapping_mul(0x9E37_79B9_7F4A_7C15) >> 40;
    1e-6 * (z + 0.05 * (hash as f64 / (1_u64 << 24) as f64 - 0.5))
}

#[test]
fn parameters_are_those_of_a_public_program() {
    let of = |bend: f64| {
        let z: Vec<f64> = (0..COLUMNS * ROWS).map(|k| ridges(k, bend)).collect();
        parameters(&z, COLUMNS, spacings()).unwrap()
    };
    let near = |found: f64, expected: f64, tolerance: f64| {
        assert!(
            (found / expected - 1.0).abs() < tolerance,
            "{found} {expected}"
        );
    };
    let bent = of(8.0);
    for (found, expected) in [
        (bent.sa.si() * 1e6, 0.126_273_629_170_621_27),
        (bent.sq.si() * 1e6, 0.158_503_220_786_841_9),
        (bent.sp.si() * 1e6, 0.511_216_202_212_208_6),
        (bent.sv.si() * 1e6, 0.515_403_189_894_409_1),
        (bent.sz.si() * 1e6, 1.026_619_392_106_617_8),
        (bent.ssk.unwrap(), -0.054_652_105_857_533_59),
        (bent.sku.unwrap(), 2.867_180_034_530_757),
        (bent.sdq, 0.164_619_226_196_614_9),
        (100.0 * bent.sdr, 1.334_745_480_628_663),
    ] {
        near(found, expected, 1e-10);
    }
    // The program takes the values of the autocorrelation between points from a cubic spline and directions from whole points.
    let texture = bent.texture.unwrap();
    near(texture.sal.unwrap().si() * 1e6, 1.672_772_8, 0.01);
    near(texture.str.unwrap(), 0.333_632_758, 0.01);
    let straight = of(1.0).texture.unwrap();
    near(straight.sal.unwrap().si() * 1e6, 1.669_369_4, 0.01);
    assert_eq!(straight.str, None);
    // Ridges at 18.43°. The program finds 162.5°, counted the other way from the row at the top: the sector of half a degree with the
    // largest sum of amplitudes, which also depends on how many lines of the spectrum a sector has.
    let turned = (0.3_f64).atan2(0.9).to_degrees();
    let found = of(0.0).texture.unwrap().std_degrees;
    assert!((found - turned).abs() < 0.1, "{found} {turned}");
    assert!((straight.std_degrees - turned).abs() < 1.5, "{straight:?}");
}

/// Angle from `found` to `expected` \[°\] between directions that repeat after 180°.
fn apart(found: f64, expected: f64) -> f64 {
    ((found - expected + 90.0).rem_euclid(180.0) - 90.0).abs()
}

#[test]
fn the_direction_of_a_wave_is_exact_at_any_angle_spacing_and_length() {
    for (columns, rows, dx, dy) in [
        (200, 200, 1.0, 1.0),
        (240, 160, 0.5, 0.8),
        (400, 64, 0.5, 2.0),
    ] {
        for wavelength in [8.0, 20.0, 37.0] {
            for degrees in [
                0.0, 7.0, 23.0, 40.0, 45.0, 58.0, 90.0, 101.0, 135.0, 163.0, 179.0_f64,
            ] {
                let (sin, cos) = degrees.to_radians().sin_cos();
                let wave = |k: usize| {
                    let (x, y) = ((k % columns) as f64 * dx, (k / columns) as f64 * dy);
                    1e-6 * (TAU * (x * cos + y * sin) / wavelength + 0.3).sin()
                };
                let z: Vec<f64> = (0..columns * rows).map(wave).collect();
                let spacings = [dx, dy].map(|d| Length::from_si(1e-6 * d));
                let found = parameters(&z, columns, spacings).unwrap().texture.unwrap();
                let off = apart(found.std_degrees, degrees);
                assert!(
                    off < 0.1,
                    "{columns} x {rows}, {wavelength}: {degrees}° is {}",
                    found.std_degrees
                );
            }
        }
    }
}

#[test]
fn of_crossed_textures_the_stronger_one_is_the_direction() {
    let wave = |k: usize, degrees: f64, wavelength: f64| {
        let (sin, cos) = degrees.to_radians().sin_cos();
        let (x, y) = ((k % COLUMNS) as f64 * 0.5, (k / COLUMNS) as f64 * 0.8);
        (TAU * (x * cos + y * sin) / wavelength + 0.1).sin()
    };
    for [strong, weak] in [[30.0, 150.0], [150.0, 30.0], [75.0, 20.0]] {
        let hatch = |k: usize| 1e-7 * (wave(k, strong, 9.0) + 0.8 * wave(k, weak, 7.0));
        let z: Vec<f64> = (0..COLUMNS * ROWS).map(hatch).collect();
        let found = parameters(&z, COLUMNS, spacings())
            .unwrap()
            .texture
            .unwrap();
        assert!(apart(found.std_degrees, strong) < 0.5, "{found:?}");
    }
}

#[test]
fn a_plane_and_missing_points_are_left_out() {
    let tilted = |k: usize| 1e-6 * ((k % COLUMNS) as f64 + 3.0 * (k / COLUMNS) as f64);
    let flat: Vec<f64> = (0..COLUMNS * ROWS).map(tilted).collect();
    let found = parameters(&flat, COLUMNS, spacings()).unwrap();
    assert!(found.sz.si() < 1e-15, "{found:?}");
    let mut z: Vec<f64> = (0..COLUMNS * ROWS).map(|k| ridges(k, 1.0)).collect();
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
