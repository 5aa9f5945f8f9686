//! Surfaces generated like measured ones, against surfaces of the same kind that were left out of the fit.
#![allow(clippy::unwrap_used)]

use asperity_core::Profile;
use asperity_core::quantity::Length;
use asperity_roughness::Parameters;
use asperity_roughness::areal::parameters;
use asperity_roughness::autocorrelation::{autocorrelation, lengths};
use asperity_roughness::generate::{
    FittedSurface, LikeSurface, SelfAffine, SurfacePieces, surface_like,
};
use asperity_roughness::height_parameters::Mode;
use asperity_roughness::lay::lay_of_rows;
use asperity_roughness::preparation::{Preparation, RoughnessFilter, prepare};

use crate::common::compared::rank_sum;
use crate::lay::smoothed;

const COLUMNS: usize = 512;
const ROWS: usize = 128;
const SPACINGS: [Length; 2] = [Length::from_si(1e-6), Length::from_si(1e-6)];
const LAMBDA_C: Length = Length::from_si(0.08e-3);
const NAMES: [&str; 20] = [
    "Sa",
    "Sq",
    "Sp",
    "Sv",
    "Sz",
    "Ssk",
    "Sku",
    "Sdq",
    "Sdr",
    "Sal",
    "lay",
    "Ra",
    "Rz",
    "Rsk",
    "Rku",
    "RSm",
    "Rdq",
    "Rk",
    "Rpk",
    "length of the autocorrelation",
];

/// Areal parameters, the lay, and the means of the parameters of rows.
fn of(z: &[f64]) -> [f64; 20] {
    let recipe = Preparation {
        lambda_c: Some(LAMBDA_C),
        lambda_s: None,
        ..Preparation::default()
    };
    let areal = parameters(z, COLUMNS, SPACINGS).unwrap();
    let lay = lay_of_rows(z, COLUMNS, SPACINGS, &recipe, RoughnessFilter::Gaussian).unwrap();
    let rows: Vec<[f64; 9]> = z
        .chunks(COLUMNS)
        .step_by(16)
        .map(|row| {
            let profile = Profile::new(SPACINGS[0], row.to_vec()).unwrap();
            let rough = prepare(&profile, &recipe).unwrap().profile;
            let found = Parameters::from_profile(&rough, Mode::Iso4287, LAMBDA_C).unwrap();
            let (h, m) = (&found.heights, &found.material);
            [
                h.ra.si(),
                h.rz.si(),
                h.rsk.unwrap(),
                h.rku.unwrap(),
                h.rsm.unwrap().si(),
                h.rdq,
                m.rk.si(),
                m.rpk.si(),
                lengths(&rough).unwrap().to_one_fifth.unwrap().si(),
            ]
        })
        .collect();
    let mean = |k: usize| rows.iter().map(|row| row[k]).sum::<f64>() / rows.len() as f64;
    let own = [
        areal.sa.si(),
        areal.sq.si(),
        areal.sp.si(),
        areal.sv.si(),
        areal.sz.si(),
        areal.ssk.unwrap(),
        areal.sku.unwrap(),
        areal.sdq,
        areal.sdr,
        areal.texture.unwrap().sal.unwrap().si(),
        lay.unwrap().gamma,
    ];
    std::array::from_fn(|k| {
        if k < own.len() {
            own[k]
        } else {
            mean(k - own.len())
        }
    })
}

/// Twelve parts of a ground-like surface: ridges 18 um wide along the face on a finer background, peaks cut, valleys deep.
fn parts() -> Vec<Vec<f64>> {
    let part = |seed: u64| -> Vec<f64> {
        let ridges = smoothed(COLUMNS, ROWS, [3.0, 18.0], seed);
        let fine = smoothed(COLUMNS, ROWS, [1.5, 3.0], 100 + seed);
        let both = ridges
            .iter()
            .zip(&fine)
            .map(|(a, b)| 1e7 * a / 8.0 + 1e7 * b / 4.0);
        // Heights in um, squeezed above the mean.
        both.map(|z| 1e-6 * (1.0 - (-z).exp()) * 0.2).collect()
    };
    (1..=12).map(part).collect()
}

#[test]
fn eighteen_of_twenty_parameters_are_those_of_surfaces_left_out() {
    let parts = parts();
    let (fitted, left_out): (Vec<_>, Vec<_>) =
        parts.into_iter().enumerate().partition(|(k, _)| k % 2 == 0);
    let only = |list: Vec<(usize, Vec<f64>)>| list.into_iter().map(|(_, z)| z).collect::<Vec<_>>();
    let [fitted, left_out] = [fitted, left_out].map(only);
    let fit = FittedSurface::to(&fitted, COLUMNS, SPACINGS).unwrap();
    let made: Vec<_> = (1..=10).map(|seed| fit.generate(seed)).collect();
    let off = different(&made, &left_out);
    assert!(off.len() <= 2, "{off:?}");
}

/// The parameters that differ between two groups of surfaces; ten and six that do not overlap differ with p 0.001.
fn different(made: &[Vec<f64>], left_out: &[Vec<f64>]) -> Vec<String> {
    let [made, kept] = [made, left_out].map(|all| all.iter().map(|z| of(z)).collect::<Vec<_>>());
    let column = |rows: &[[f64; 20]], k: usize| rows.iter().map(|row| row[k]).collect::<Vec<_>>();
    let mean = |rows: &[[f64; 20]], k| column(rows, k).iter().sum::<f64>() / rows.len() as f64;
    let mut off = Vec::new();
    for (k, name) in NAMES.iter().enumerate() {
        let p = rank_sum(&column(&made, k), &column(&kept, k));
        let ratio = mean(&made, k) / mean(&kept, k);
        if p <= 0.01 {
            off.push(format!("{name}: p {p:.4}, ratio of the means {ratio:.3}"));
        }
    }
    off
}

#[test]
fn seeds_differ_and_repeat_and_ridges_keep_their_direction() {
    let z = crate::lay::waves(100, [3.0, 30.0], 20.0, 9);
    let columns = 500;
    let left = |row: &[f64]| row[..columns].to_vec();
    let z: Vec<f64> = z.chunks(2 * columns).flat_map(left).collect();
    let fit = FittedSurface::to(std::slice::from_ref(&z), columns, SPACINGS).unwrap();
    let made = fit.generate(3);
    assert_eq!(made, fit.generate(3));
    assert_ne!(made, fit.generate(4));
    let std = |z: &[f64]| {
        parameters(z, columns, SPACINGS)
            .unwrap()
            .texture
            .unwrap()
            .std_degrees
    };
    assert!(
        (std(&made) - std(&z)).abs() < 8.0,
        "{} {}",
        std(&made),
        std(&z)
    );
    let mut holed = z;
    holed[7] = f64::NAN;
    assert!(FittedSurface::to(&[holed], columns, SPACINGS).is_err());
}

/// Surfaces with dimples 40 um wide on a fine texture.
fn dimpled(rows: usize, seed: u64) -> Vec<f64> {
    let texture = smoothed(COLUMNS, rows, [3.0, 3.0], seed);
    let rms = (texture.iter().map(|z| z * z).sum::<f64>() / texture.len() as f64).sqrt();
    let mut z: Vec<f64> = texture.iter().map(|z| 0.1e-6 * z / rms).collect();
    let mut state = seed.wrapping_mul(0x9E37_79B9_7F4A_7C15) | 1;
    let mut uniform = || {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        (state >> 11) as f64 / (1_u64 << 53) as f64
    };
    for _ in 0..COLUMNS * rows / 4000 {
        let [x, y] = [uniform() * COLUMNS as f64, uniform() * rows as f64];
        let depth = 1e-6 * (0.5 + uniform());
        for (k, z) in z.iter_mut().enumerate() {
            let r = ((k % COLUMNS) as f64 - x).hypot((k / COLUMNS) as f64 - y) / 20.0;
            *z -= depth * (1.0 - r * r).max(0.0);
        }
    }
    z
}

/// Spectrum and heights alone leave six or more of the parameters different, skewness and the spacing of features among them.
#[test]
fn surfaces_of_pieces_keep_their_dimples() {
    let all: Vec<_> = (1..=12).map(|seed| dimpled(320, seed)).collect();
    let (given, left_out) = all.split_at(6);
    let like = LikeSurface::to(given, COLUMNS, SPACINGS, None).unwrap();
    let made: Vec<_> = (1..=10).map(|seed| like.generate(seed)).collect();
    let repeated = like.generate(1);
    assert_eq!(repeated, made[0]);
    // Places of pieces: none has a quarter of another while others are left.
    for (k, one) in repeated.pieces.iter().enumerate() {
        for other in &repeated.pieces[..k] {
            let common =
                |d: usize| one.size[d].saturating_sub(one.first[d].abs_diff(other.first[d]));
            let is_new = one.surface != other.surface || 4 * common(0) * common(1) < 225 * 225;
            assert!(is_new, "{one:?} {other:?}");
        }
    }
    let rows_apart = [Length::from_si(1e-6), Length::from_si(160e-6)];
    assert!(SurfacePieces::to(given, COLUMNS, rows_apart).is_err());
    let heights: Vec<_> = made.into_iter().map(|made| made.heights).collect();
    let off = different(&heights, left_out);
    assert!(off.len() <= 2, "{off:?}");
}

#[test]
fn a_surface_made_from_a_trace_has_its_heights_and_the_stated_lay() {
    let um = |x: f64| Length::from_si(1e-6 * x);
    let recipe = SelfAffine {
        points: 4000,
        spacing: um(1.0),
        rq: um(0.3),
        hurst: 0.8,
        roll_off: um(40.0),
        short_cut: um(5.0),
        seed: 7,
    };
    let trace = recipe.generate().unwrap();
    let wanted = autocorrelation(trace.heights()).unwrap();
    for lay in [1.0, 0.4] {
        const ROWS: usize = 64;
        let made = surface_like(&trace, ROWS, um(2.0), lay, 3).unwrap();
        let row = |k: usize| &made[k % ROWS * 4000..][..4000];
        let product = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
        let square: f64 = (0..ROWS).map(|k| product(row(k), row(k))).sum();
        let along = |lag: usize| {
            let rows = (0..ROWS).map(|k| product(&row(k)[lag..], row(k)));
            rows.sum::<f64>() / square
        };
        let across = |lag: usize| {
            let rows = (0..ROWS).map(|k| product(row(k), row(k + lag)));
            rows.sum::<f64>() / square
        };
        // The heights imposed by rank, and negative parts left out, move the correlation a little.
        for lag in [4, 8, 16] {
            let found = along(lag);
            assert!(
                (found - wanted[lag]).abs() < 0.06,
                "{lay} {lag}: {found} {}",
                wanted[lag]
            );
            let same = wanted[(2.0 * lay * lag as f64).round() as usize];
            let found = across(lag);
            assert!(
                (found - same).abs() < 0.06,
                "{lay} {lag} across: {found} {same}"
            );
        }
    }
}
