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
    assert_eq!(texture.std_degrees, 0.0);
    // Straight ridges at 18.4°: Std is 162.5° there, counted the other way from the row at the top.
    let straight = of(1.0).texture.unwrap();
    near(straight.sal.unwrap().si() * 1e6, 1.669_369_4, 0.01);
    assert_eq!(straight.str, None);
    assert!((straight.std_degrees - 17.5).abs() <= 0.5, "{straight:?}");
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
