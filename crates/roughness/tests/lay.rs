//! Lay of made surfaces whose spectrum is known: filtered white noise and sums of waves.
#![allow(clippy::unwrap_used)]

use std::f64::consts::TAU;

use asperity_core::quantity::Length;
use asperity_roughness::form::Form;
use asperity_roughness::gaussian_filter::Ends;
use asperity_roughness::lay::{LayFinding, LayUnknown, lay_of_rows};
use asperity_roughness::preparation::{Preparation, RoughnessFilter};

use crate::common::Normal;

const COLUMNS: usize = 1000;
/// The spectrum of a filtered surface is no longer elliptical.
const UNFILTERED: Preparation = Preparation {
    form: Form::Mean,
    lambda_s: None,
    lambda_c: None,
    ends: Ends::Cut,
};

/// White noise of `columns` by `rows` points, smoothed with Gaussian weights of widths [a, b] in points along and across
/// the rows: its spectrum is elliptical, and the correlation lengths are in the ratio a/b = γ.
pub fn smoothed(columns: usize, rows: usize, widths: [f64; 2], seed: u64) -> Vec<f64> {
    let reach = widths.map(|width| (4.0 * width).ceil() as usize);
    let [wide, high] = [columns + 2 * reach[0], rows + 2 * reach[1]];
    let mut noise = Normal(seed);
    let white: Vec<f64> = (0..wide * high).map(|_| noise.next()).collect();
    let weights = [0, 1].map(|axis: usize| -> Vec<f64> {
        let r = reach[axis] as i64;
        (-r..=r)
            .map(|k| (-(k as f64 / widths[axis]).powi(2)).exp())
            .collect()
    });
    let along = |y: usize, x: usize| -> f64 {
        weights[0]
            .iter()
            .zip(&white[y * wide + x..])
            .map(|(w, z)| w * z)
            .sum()
    };
    let half: Vec<f64> = (0..high * columns)
        .map(|k| along(k / columns, k % columns))
        .collect();
    // Row by row, as they lie in memory.
    let mut smooth = vec![0.0; rows * columns];
    for (y, row) in smooth.chunks_mut(columns).enumerate() {
        for (w, above) in weights[1].iter().zip(half[y * columns..].chunks(columns)) {
            for (sum, z) in row.iter_mut().zip(above) {
                *sum += 1e-8 * w * z;
            }
        }
    }
    smooth
}

fn lay(z: &[f64], columns: usize, dy: f64) -> LayFinding {
    let spacings = [1e-6, dy].map(Length::from_si);
    lay_of_rows(z, columns, spacings, &UNFILTERED, RoughnessFilter::Gaussian).unwrap()
}

#[test]
fn the_lay_of_filtered_noise_is_the_ratio_of_its_widths() {
    for (widths, expected) in [([3.0, 30.0], 0.1), ([4.0, 16.0], 0.25)] {
        let (mut inside, mut sum) = (0, 0.0);
        for seed in 1..=8 {
            let found = lay(&smoothed(COLUMNS, 400, widths, seed), COLUMNS, 1e-6).unwrap();
            let [low, high] = found.range;
            assert!(!found.is_bound && high / low < 2.0, "{found:?}");
            inside += usize::from(low <= expected && expected <= high);
            sum += found.gamma.ln();
        }
        let mean = (sum / 8.0_f64).exp();
        println!("γ = {expected}: mean {mean:.4}, {inside} of 8 intervals hold it");
        assert!((mean / expected - 1.0).abs() < 0.06, "{mean} {expected}");
        // Of 95 % intervals, fewer than six of eight hold the value with a probability of 0.6 %; of intervals half as wide,
        // fewer than six with 52 %, in one of both surfaces with 77 %.
        assert!(inside >= 6, "{inside}");
    }
}

#[test]
fn filtering_along_the_rows_lowers_the_lay_a_little() {
    // λc removes waves that are long along the rows, whose ridges run along them.
    let z = smoothed(COLUMNS, 400, [3.0, 30.0], 3);
    let spacings = [Length::from_si(1e-6); 2];
    let (recipe, filter) = (Preparation::default(), RoughnessFilter::Gaussian);
    let filtered = lay_of_rows(&z, COLUMNS, spacings, &recipe, filter).unwrap();
    let filtered = filtered.unwrap();
    let ratio = filtered.gamma / lay(&z, COLUMNS, 1e-6).unwrap().gamma;
    assert!((0.85..1.0).contains(&ratio), "{ratio}");
    // The filter turns a parabola, the curvature of a flank of 10 mm radius, into a constant.
    let curved = |(i, z): (usize, &f64)| z - (1e-6 * (i % COLUMNS) as f64).powi(2) / (2.0 * 10e-3);
    let curved: Vec<f64> = z.iter().enumerate().map(curved).collect();
    let curved = lay_of_rows(&curved, COLUMNS, spacings, &recipe, filter)
        .unwrap()
        .unwrap();
    assert!(
        (curved.gamma / filtered.gamma - 1.0).abs() < 0.01 && !curved.is_bound,
        "{curved:?} {filtered:?}"
    );
}

#[test]
fn the_spacing_of_the_rows_counts() {
    // Every third row.
    let z = smoothed(COLUMNS, 900, [3.0, 30.0], 5);
    let third: Vec<f64> = z.chunks(COLUMNS).step_by(3).flatten().copied().collect();
    let all = lay(&z, COLUMNS, 1e-6).unwrap();
    let fewer = lay(&third, COLUMNS, 3e-6).unwrap();
    assert!(
        (fewer.gamma / all.gamma - 1.0).abs() < 0.03,
        "{fewer:?} {all:?}"
    );
}

#[test]
fn missing_points_and_rows_at_other_heights_do_not_change_the_lay() {
    let z = smoothed(COLUMNS, 400, [3.0, 30.0], 3);
    let whole = lay(&z, COLUMNS, 1e-6).unwrap();
    let mut other = Normal(8);
    let mut changed = z;
    for row in changed.chunks_mut(COLUMNS) {
        let offset = 1e-6 * other.next();
        for z in row {
            *z += offset;
            if other.uniform() < 0.05 {
                *z = f64::NAN;
            }
        }
    }
    changed[5 * COLUMNS..6 * COLUMNS].fill(f64::NAN);
    let found = lay(&changed, COLUMNS, 1e-6).unwrap();
    assert!(
        (found.gamma / whole.gamma - 1.0).abs() < 0.03,
        "{found:?} {whole:?}"
    );
}

/// Sum of waves whose wave vectors have normal components with the standard deviations 1/a across the ridges and 1/b along
/// them, the ridges turned by `degrees` from the normal of the rows.
pub fn waves(rows: usize, [a, b]: [f64; 2], degrees: f64, seed: u64) -> Vec<f64> {
    let mut noise = Normal(seed);
    let (sin, cos) = degrees.to_radians().sin_cos();
    let waves: Vec<[f64; 3]> = (0..300)
        .map(|_| {
            let (u, v) = (noise.next() / a, noise.next() / b);
            [u * cos - v * sin, u * sin + v * cos, TAU * noise.uniform()]
        })
        .collect();
    let mut z = vec![0.0; rows * COLUMNS];
    for [p, q, phase] in waves {
        let along: Vec<[f64; 2]> = (0..COLUMNS)
            .map(|x| <[f64; 2]>::from((p * x as f64).sin_cos()))
            .collect();
        for (y, row) in z.chunks_mut(COLUMNS).enumerate() {
            let (sin, cos) = (q * y as f64 + phase).sin_cos();
            for (z, [sin_x, cos_x]) in row.iter_mut().zip(&along) {
                *z += 1e-8 * (cos * cos_x - sin * sin_x);
            }
        }
    }
    z
}

/// γ by its definition, 1/⟨k_x²/k²⟩ − 1, of the elliptical spectrum of [`waves`].
fn defined([a, b]: [f64; 2], degrees: f64) -> f64 {
    let (sin, cos) = degrees.to_radians().sin_cos();
    let n = 20_000;
    let share = |k: usize| {
        let angle = TAU * (k as f64 + 0.5) / f64::from(n);
        let (u, v) = (angle.cos() / a, angle.sin() / b);
        (u * cos - v * sin).powi(2) / (u * u + v * v)
    };
    f64::from(n) / (0..n as usize).map(share).sum::<f64>() - 1.0
}

#[test]
fn turned_ridges_have_the_lay_of_their_spectrum() {
    for degrees in [0.0, 10.0, 25.0, -25.0] {
        let widths = [5.0, 40.0];
        let found = lay(&waves(250, widths, degrees, 4), COLUMNS, 1e-6).unwrap();
        let expected = defined(widths, degrees);
        println!("{degrees}°: {found:?}, defined {expected:.4}");
        assert!(
            (found.gamma / expected - 1.0).abs() < 0.15,
            "{degrees}: {found:?} {expected}"
        );
    }
    // Ridges along the rows.
    let found = lay(&waves(250, [5.0, 40.0], 90.0, 4), COLUMNS, 1e-6).unwrap();
    assert!(found.gamma > 4.0 && found.range[0] > 3.0, "{found:?}");
}

#[test]
fn a_surface_without_lay_is_isotropic() {
    for seed in 1..=5 {
        let found = lay(&smoothed(COLUMNS, 400, [4.0, 4.0], seed), COLUMNS, 1e-6).unwrap();
        println!("{found:?}");
        assert!((0.8..1.25).contains(&found.gamma), "{found:?}");
        assert!(found.range[0] > 0.6, "{found:?}");
    }
}

#[test]
fn a_lay_that_is_not_resolved_is_refused_with_its_reason() {
    let z = smoothed(COLUMNS, 400, [3.0, 12.0], 2);
    let far: Vec<f64> = z.chunks(COLUMNS).step_by(40).flatten().copied().collect();
    let found = lay(&far, COLUMNS, 40e-6).unwrap_err();
    assert!(
        matches!(found, LayUnknown::TooFarApart { lines: "rows", .. }),
        "{found}"
    );
    assert_eq!(
        lay(&z[..3 * COLUMNS], COLUMNS, 1e-6),
        Err(LayUnknown::TooFewRows { rows: 3 })
    );
    // Ten rows over 10 um of ridges 40 um long bound the lay, and the bound is of no use.
    let short = lay(&z[..10 * COLUMNS], COLUMNS, 1e-6).unwrap();
    assert!(
        short.is_bound && short.gamma > 0.4 && short.range[0] < 0.1,
        "{short:?}"
    );
    let flat = lay(&vec![0.0; 100 * COLUMNS], COLUMNS, 1e-6);
    assert_eq!(flat, Err(LayUnknown::Flat));
    // Waves as long as the parts of the rows.
    let found = lay(&smoothed(600, 100, [25.0, 60.0], 2), 600, 1e-6).unwrap_err();
    assert!(matches!(found, LayUnknown::TooShort { .. }), "{found}");
    // Unevenness from point to point: noise.
    let found = lay(&smoothed(COLUMNS, 100, [0.2, 0.2], 2), COLUMNS, 1e-6).unwrap_err();
    assert!(matches!(found, LayUnknown::TooFarApart { .. }), "{found}");
}

#[test]
fn the_bound_of_short_surfaces_holds_the_lay() {
    for rows in [16, 30, 60, 100] {
        for seed in 1..=4 {
            let z = smoothed(COLUMNS, rows, [3.0, 30.0], 100 + seed);
            let found = lay(&z, COLUMNS, 1e-6).unwrap();
            let [low, high] = found.range;

            assert!(low < 0.11 && high > 0.085, "{rows} rows: {found:?}");
        }
    }
}

/// Lay of [`smoothed`] noise after the default filters along the rows: the distances at which the autocorrelation of the
/// filtered spectrum is 0.2, in closed form across the rows and by summing the spectrum along them.
fn filtered_lay([a, b]: [f64; 2], [dx, dy]: [f64; 2]) -> f64 {
    let recipe = Preparation::default();
    let [lambda_s, lambda_c] = [recipe.lambda_s, recipe.lambda_c].map(|l| l.unwrap().si());
    // ISO 16610-21: half of an amplitude at the cut-off.
    let passed = |wavelength: f64, cutoff: f64| 0.5_f64.powf((cutoff / wavelength).powi(2));
    let lines: Vec<[f64; 2]> = (1..20_000)
        .map(|k| {
            let k = f64::from(k) * 50.0;
            let wavelength = TAU / k;
            let filter = passed(wavelength, lambda_s) * (1.0 - passed(wavelength, lambda_c));
            [k, (-0.5 * (k * a * dx).powi(2)).exp() * filter * filter]
        })
        .collect();
    let sum = |x: f64| {
        lines
            .iter()
            .map(|[k, power]| power * (k * x).cos())
            .sum::<f64>()
    };
    let step = 1e-2 * a * dx;
    let level = 0.2 * sum(0.0);
    let first = (1..1000)
        .find(|i| sum(f64::from(*i) * step) < level)
        .unwrap();
    let (mut low, mut high) = (f64::from(first - 1) * step, f64::from(first) * step);
    for _ in 0..40 {
        let middle = 0.5 * (low + high);
        if sum(middle) > level {
            low = middle
        } else {
            high = middle
        }
    }
    low / (b * dy * (2.0 * 5.0_f64.ln()).sqrt())
}

#[test]
fn the_interval_holds_the_lay_of_the_filtered_surface() {
    const SEEDS: u64 = 12;
    for (widths, columns, rows) in [
        ([3.0, 12.0], 1000, 300),
        ([8.0, 8.0], 1200, 200),
        ([10.0, 30.0], 1600, 250),
    ] {
        let expected = filtered_lay(widths, [1e-6, 1e-6]);
        let unfiltered = widths[0] / widths[1];
        assert!(expected < 0.95 * unfiltered, "{expected}");
        let spacings = [Length::from_si(1e-6); 2];
        let found = (1..=SEEDS).map(|seed| {
            let z = smoothed(columns, rows, widths, seed);
            let filter = RoughnessFilter::Gaussian;
            lay_of_rows(&z, columns, spacings, &Preparation::default(), filter)
                .unwrap()
                .unwrap()
        });
        let found: Vec<_> = found.collect();
        let holds = |value: f64| {
            let inside = found
                .iter()
                .filter(|lay| (lay.range[0]..=lay.range[1]).contains(&value));
            inside.count()
        };
        println!(
            "{widths:?}: {expected:.3}, {} of {SEEDS} intervals hold it, {} the unfiltered {unfiltered:.3}",
            holds(expected),
            holds(unfiltered)
        );
        // Of 95 % intervals fewer than nine of twelve hold the value with a probability of 0.2 %; 183 of 191 did in a trial of
        // eight surfaces of ratios from 0.1 to 1.
        assert!(holds(expected) >= 9, "{widths:?}: {}", holds(expected));
    }
}
