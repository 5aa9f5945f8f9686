//! Filters and preparation against closed forms and direct sums.

#![allow(clippy::unwrap_used, clippy::panic)]

use std::f64::consts::{PI, SQRT_2, TAU};

use crate::common::{close, profile};
use asperity_core::Profile;
use asperity_core::quantity::Length;
use asperity_roughness::form::Form;
use asperity_roughness::gaussian_filter::{
    Ends, alpha, mean_line, mean_line_gradient, transmission, weights,
};
use asperity_roughness::generate::{Pits, SelfAffine};
use asperity_roughness::height_parameters::Mode;
use asperity_roughness::material_ratio::rk_parameters;
use asperity_roughness::preparation::{Preparation, RoughnessFilter, prepare, prepare_with};
use asperity_roughness::resampling::{respaced, respaced_gradient};
use asperity_roughness::robust_filter::robust_mean_line;
use asperity_roughness::{Parameters, Warning};

/// Fractional noise without a random generator, for oracles.
fn rough(n: usize) -> Vec<f64> {
    (0..n)
        .map(|i| ((i * i * 7 + 13 * i) as f64 * 0.618_033_988_75).fract() - 0.4)
        .collect()
}

#[test]
fn the_filter_passes_half_the_amplitude_at_its_cutoff() {
    let cutoff = Length::from_si(0.25e-3);
    for ratio in [0.25, 0.5, 1.0, 2.0, 4.0] {
        let wavelength = 0.25e-3 * ratio;
        let wave = profile(0.5e-6, 6001, |x| (TAU * x / wavelength).cos());
        let line = mean_line(&wave, cutoff, Ends::Cut).unwrap();
        let expected = transmission(Length::from_si(wavelength), cutoff).unwrap();
        // The weights are cut off at ±λ_c, where they are e^−14.2 = 6e-7 of their middle.
        assert!(
            (line[3000] - expected * wave.heights()[3000]).abs() < 1e-6,
            "{ratio}"
        );
    }
    close(transmission(cutoff, cutoff).unwrap(), 0.5, 1e-15);
    close(alpha(), 0.469_718_639, 1e-9);
}

#[test]
fn regression_of_degree_one_keeps_a_line_to_its_ends() {
    let line = profile(1e-6, 3000, |x| 0.1 + 0.3 * x);
    let cutoff = Length::from_si(0.8e-3);
    let largest = |ends| {
        let filtered = mean_line(&line, cutoff, ends).unwrap();
        let pairs = filtered.iter().zip(line.heights());
        pairs.map(|(w, z)| (w - z).abs()).fold(0.0, f64::max)
    };
    // Heights of 0.1 m have an error of 1.4e-17; the transform adds a few.
    assert!(largest(Ends::Reg1) < 1e-15, "{:e}", largest(Ends::Reg1));
    assert!(largest(Ends::Reg0) > 1e-5);
    assert!(largest(Ends::Reflect) > 1e-5);
}

/// Weighted mean, weighted line or mirrored mean by direct sums.
fn direct(z: &[f64], w: &[f64], ends: Ends) -> Vec<f64> {
    let (n, m) = (z.len() as i64, w.len() as i64 - 1);
    let weight = |k: i64| w[k.unsigned_abs() as usize];
    (0..n)
        .map(|i| {
            let inside = (i - m).max(0)..=(i + m).min(n - 1);
            let sum =
                |f: &dyn Fn(i64) -> f64| inside.clone().map(|j| weight(j - i) * f(j)).sum::<f64>();
            let height = |j: i64| z[j as usize];
            match ends {
                Ends::Cut | Ends::Reg0 => sum(&height) / sum(&|_| 1.0),
                Ends::Reg1 => {
                    let lever = |j: i64| (j - i) as f64;
                    let (s0, s1, s2) = (sum(&|_| 1.0), sum(&lever), sum(&|j| lever(j).powi(2)));
                    let (t0, t1) = (sum(&height), sum(&|j| lever(j) * height(j)));
                    (s2 * t0 - s1 * t1) / (s0 * s2 - s1 * s1)
                }
                Ends::Reflect => {
                    let mirrored = |j: i64| match j {
                        j if j < 0 => -1 - j,
                        j if j >= n => 2 * n - 1 - j,
                        j => j,
                    };
                    (-m..=m).map(|k| weight(k) * height(mirrored(i + k))).sum()
                }
                other => panic!("no direct sum for {other:?}"),
            }
        })
        .collect()
}

#[test]
fn the_fast_filter_equals_direct_sums_with_every_treatment_of_the_ends() {
    let dx = Length::from_si(1e-6);
    // The trace is shorter than two supports, just longer, and much longer.
    for (n, reach) in [(60, 50), (110, 50), (400, 30), (40, 40)] {
        let z = rough(n);
        let cutoff = Length::from_si(f64::from(reach) * 1e-6);
        let trace = Profile::new(dx, z.clone()).unwrap();
        let w = weights(cutoff, dx).unwrap();
        if n < w.len() {
            assert!(mean_line(&trace, cutoff, Ends::Cut).is_err());
            continue;
        }
        for ends in [Ends::Cut, Ends::Reg0, Ends::Reg1, Ends::Reflect] {
            let fast = mean_line(&trace, cutoff, ends).unwrap();
            for (i, (fast, slow)) in fast.iter().zip(direct(&z, &w, ends)).enumerate() {
                // Sums of a hundred terms of size one; levers of 100 points in Reg1.
                assert!(
                    (fast - slow).abs() < 1e-12,
                    "{ends:?} {n} {i}: {fast} {slow}"
                );
            }
        }
    }
}

/// Σ a b, with the sum of the sizes of its terms.
fn product(a: &[f64], b: &[f64]) -> [f64; 2] {
    let terms = || a.iter().zip(b).map(|(a, b)| a * b);
    [terms().sum(), terms().map(f64::abs).sum()]
}

#[test]
fn gradients_over_raw_heights_are_transposes_of_filter_preparation_and_resampling() {
    let transposed = |[forward, backward]: [(&[f64], &[f64]); 2], what: &dyn std::fmt::Debug| {
        let [a, b] = [forward, backward].map(|(a, b)| product(a, b));
        let scale = a[1].max(b[1]);
        assert!((a[0] - b[0]).abs() < 1e-12 * scale, "{what:?}: {a:?} {b:?}");
    };
    let dx = Length::from_si(1e-6);
    let (few, many) = (rough(110), rough(30_000));
    for ends in [Ends::Cut, Ends::Reg0, Ends::Reg1, Ends::Reflect] {
        for (z, reach) in [(&few, 50.0), (&few, 70.0), (&few, 5.0), (&many, 700.0)] {
            let cutoff = Length::from_si(reach * 1e-6);
            let other: Vec<f64> = z.iter().map(|z| (9.0 * z).sin()).collect();
            let line = mean_line(&Profile::new(dx, z.clone()).unwrap(), cutoff, ends).unwrap();
            let back = mean_line_gradient(&other, dx, cutoff, ends).unwrap();
            transposed([(&line, &other), (z, &back)], &(ends, z.len(), reach));
            assert!(mean_line_gradient(&other[..reach as usize], dx, cutoff, ends).is_err());
        }
        for form in [
            Form::None,
            Form::Mean,
            Form::Level,
            Form::Poly2,
            Form::Circle,
        ] {
            for [lambda_s, lambda_c] in [
                [Some(2.5e-6), Some(80e-6)],
                [None, Some(8e-5)],
                [None, None],
            ] {
                let recipe = Preparation {
                    form,
                    ends,
                    lambda_s: lambda_s.map(Length::from_si),
                    lambda_c: lambda_c.map(Length::from_si),
                };
                let z: Vec<f64> = rough(500).iter().map(|z| 1e-6 * z).collect();
                let raw = Profile::new(dx, z).unwrap();
                let prepared = prepare(&raw, &recipe).unwrap();
                let over: Vec<f64> = prepared.profile.heights().iter().rev().copied().collect();
                let back = prepared.record.gradient(&over).unwrap();
                assert_eq!(back.is_none(), form == Form::Circle);
                let Some(back) = back else { continue };
                let forward = (prepared.profile.heights(), &over[..]);
                transposed([forward, (raw.heights(), &back)], &recipe);
                assert!(prepared.record.gradient(&over[1..]).is_err());
            }
        }
    }
    let raw = Profile::new(dx, few).unwrap();
    for to in [0.37e-6, 1e-6, 2.3e-6] {
        let to = Length::from_si(to);
        let other = respaced(&raw, to).unwrap();
        let over: Vec<f64> = other.heights().iter().rev().copied().collect();
        let back = respaced_gradient(&over, raw.len(), dx, to);
        transposed([(other.heights(), &over), (raw.heights(), &back)], &to);
    }
    let recipe = Preparation::default();
    let raw = profile(0.5e-6, 4000, |x| 1e-7 * (x / 20e-6).sin());
    let robust = prepare_with(&raw, &recipe, RoughnessFilter::RobustGaussian).unwrap();
    let heights = robust.profile.heights();
    assert_eq!(robust.record.gradient(heights).unwrap(), None);
}

#[test]
fn a_wave_keeps_its_heights_on_other_points() {
    // Of the heights inside; at an end the image of the trace is another wave.
    const INSIDE: usize = 40;
    for points in [2.7, 3.0, 3.3, 5.0, 17.0, 120.0] {
        let wave = |x: f64| (TAU * x / points + 0.3).sin();
        let z: Vec<f64> = (0..600).map(|i| wave(f64::from(i))).collect();
        let trace = Profile::new(Length::from_si(0.3e-6), z).unwrap();
        for to in [0.13e-6, 0.299e-6, 0.31e-6, 0.5e-6, 0.6e-6, 0.9e-6] {
            let other = respaced(&trace, Length::from_si(to)).unwrap();
            assert!(trace.length().si() - other.length().si() < to);
            let n = other.len();
            let inside = other.heights().iter().enumerate().skip(INSIDE);
            for (i, found) in inside.take(n.saturating_sub(2 * INSIDE)) {
                let expected = wave(i as f64 * to / 0.3e-6);
                assert!(
                    (found - expected).abs() < 2e-4,
                    "{points} {to} {i}: {found}"
                );
            }
        }
    }
    // Points of a multiple are points of the trace, a line stays one to its ends within a thousandth of its steps, and
    // an equal spacing changes nothing.
    let z = rough(500);
    let trace = Profile::new(Length::from_si(0.25e-6), z.clone()).unwrap();
    let every_second: Vec<f64> = z.iter().step_by(2).copied().collect();
    let half = respaced(&trace, Length::from_si(0.5e-6)).unwrap();
    assert_eq!(half.heights(), every_second);
    let same = respaced(&trace, Length::from_si(0.250_001e-6)).unwrap();
    assert_eq!(same.heights(), z);
    let line = Profile::new(Length::from_si(1.0), (0..90).map(f64::from).collect()).unwrap();
    let other = respaced(&line, Length::from_si(0.7)).unwrap();
    for (i, found) in other.heights().iter().enumerate() {
        assert!((found - 0.7 * i as f64).abs() < 1e-3, "{i}: {found}");
    }
}

#[test]
fn a_long_trace_is_filtered_in_blocks_as_a_short_one_is_whole() {
    let dx = Length::from_si(1e-6);
    // 70 weights a side and 30 000 points make four blocks; 20 weights are summed directly.
    for reach in [20, 70, 700] {
        let cutoff = Length::from_si(f64::from(reach) * 1e-6);
        let w = weights(cutoff, dx).unwrap();
        let z = rough(30_000);
        let line = mean_line(&Profile::new(dx, z.clone()).unwrap(), cutoff, Ends::Reg0).unwrap();
        let m = w.len() - 1;
        for i in (0..z.len()).step_by(97) {
            let inside = i.saturating_sub(m)..(i + m + 1).min(z.len());
            let (mut sum, mut total) = (0.0, 0.0);
            for j in inside {
                sum += w[j.abs_diff(i)] * z[j];
                total += w[j.abs_diff(i)];
            }
            // Heights of size one.
            assert!((line[i] - sum / total).abs() < 1e-13, "{reach} {i}");
        }
    }
}

#[test]
fn preparing_drops_half_a_cutoff_and_says_what_was_done() {
    let wave = profile(0.5e-6, 11_200, |x| {
        1e-6 * (TAU * x / 50e-6).sin() + 0.02 * x + 0.1
    });
    let recipe = Preparation {
        lambda_c: Some(Length::from_si(0.8e-3)),
        ..Preparation::default()
    };
    let prepared = prepare(&wave, &recipe).unwrap();
    assert_eq!((prepared.first_index, prepared.profile.len()), (800, 9600));
    assert_eq!(prepared.record.dropped_each_end, 800);
    assert_eq!(prepared.warnings, []);
    let found = Parameters::from_profile(&prepared.profile, Mode::Iso4287, Length::from_si(0.8e-3))
        .unwrap();
    assert_eq!(found.heights.sections, 6);
    // λ_c leaves 1 − a(50 um) = 1 of the wave, λ_s = 2.5 um takes 1 − a = 0.17 %.
    let passed = transmission(Length::from_si(50e-6), Length::from_si(2.5e-6)).unwrap();
    close(found.heights.rq.si(), passed * 1e-6 / SQRT_2, 2e-4);
}

#[test]
fn the_robust_line_of_a_damaged_flank_is_that_of_the_sound_one() {
    let recipe = SelfAffine {
        points: 8000,
        spacing: Length::from_si(0.5e-6),
        rq: Length::from_si(0.4e-6),
        hurst: 0.8,
        roll_off: Length::from_si(60e-6),
        short_cut: Length::from_si(4e-6),
        seed: 12,
    };
    let sound = recipe.generate().unwrap();
    let pit = Pits {
        count: 1,
        width: Length::from_si(80e-6),
        depth: Length::from_si(12e-6),
        seed: 5,
    };
    let damaged = pit.add_to(&sound).unwrap();
    let recipe = Preparation::default();
    let rpk = |profile: &Profile, filter| {
        let prepared = prepare_with(profile, &recipe, filter).unwrap();
        rk_parameters(prepared.profile.heights()).unwrap().rpk.si()
    };
    let (plain, robust) = (RoughnessFilter::Gaussian, RoughnessFilter::RobustGaussian);
    // The pit raises false shoulders under the plain filter only.
    assert!((rpk(&damaged, robust) / rpk(&sound, robust) - 1.0).abs() < 0.03);
    assert!(rpk(&damaged, plain) > 1.2 * rpk(&sound, plain));

    // Regression of degree two keeps a parabola, to the ends, in the least number of passes.
    // Also on a trace hardly longer than the cut-off, shorter than the reach of the weights.
    for points in [3000, 900] {
        let parabola = profile(1e-6, points, |x| 0.1 + 0.2 * x - 30.0 * x * x);
        let kept = robust_mean_line(&parabola, Length::from_si(0.8e-3)).unwrap();
        for (w, z) in kept.heights.iter().zip(parabola.heights()) {
            assert!((w - z).abs() < 1e-12, "{points}");
        }
    }
}

#[test]
fn the_robust_line_is_that_of_direct_sums_by_the_definition() {
    let i = |i: usize| i as f64;
    let waves = |k: usize| {
        3e-7 * (TAU * i(k) / 61.0).sin()
            + 2e-7 * (TAU * i(k) / 397.0 + 0.7).sin()
            + 5e-8 * (0.9 * i(k) + 1e-3 * i(k * k % 97)).cos()
    };
    let pit = |k: usize| {
        let x = (i(k) - 1500.0) / 120.0;
        if x.abs() < 1.0 {
            8e-6 * (0.5 * PI * x).cos().powi(2)
        } else {
            0.0
        }
    };
    let heights = (0..2400).map(|k| waves(k) - pit(k)).collect();
    let trace = Profile::new(Length::from_si(0.5e-6), heights).unwrap();
    let found = robust_mean_line(&trace, Length::from_si(0.25e-3)).unwrap();
    // Recomputed in Python without transforms: numpy's least squares at each point over ±779 points,
    // ⌈500 γ/α⌉, repeated until the outlier distance stands to 10⁻⁸.
    assert_eq!(found.evidence.iterations, 19);
    // Each pass multiplies rounding by less than one; 10⁻⁹ of the distance is far above it.
    close(
        found.evidence.outlier_distance.si(),
        9.042_468_217_560_211e-7,
        1e-9,
    );
    let lines = [
        (0, 3.435_544_494_406_612e-7),
        (400, 2.681_349_382_257e-8),
        (1200, 3.495_785_324_719e-8),
        (1500, 6.439_996_799_705e-8),
        (1999, 4.059_610_831_039e-8),
        (2399, 1.999_695_954_990_944e-7),
    ];
    for (k, expected) in lines {
        // A millionth of a nanometre.
        assert!((found.heights[k] - expected).abs() < 1e-15, "{k}");
    }
}

#[test]
fn a_sine_at_the_cutoff_passes_half_of_the_robust_filter_too() {
    let cutoff = 0.25e-3;
    let wave = profile(0.5e-6, 6001, |x| (TAU * x / cutoff).cos());
    let line = robust_mean_line(&wave, Length::from_si(cutoff)).unwrap();
    // Tukey's weights on a sine move the share a little from the ½ of equal weights.
    assert!(
        (line.heights[3000] / wave.heights()[3000] - 0.5).abs() < 0.1,
        "{}",
        line.heights[3000]
    );
}

#[test]
fn form_that_was_not_removed_is_reported() {
    let crowned = profile(0.5e-6, 6001, |x| {
        1e-7 * (TAU * x / 40e-6).sin() - 25.0 * (x - 1.5e-3).powi(2)
    });
    let recipe = Preparation {
        lambda_c: None,
        ..Preparation::default()
    };
    let prepared = prepare(&crowned, &recipe).unwrap();
    let sag = match prepared.warnings.as_slice() {
        [Warning::FormNotRemoved { sag, .. }] => sag.si(),
        other => panic!("{other:?}"),
    };
    let message = prepared.warnings[0].to_string();
    assert!(
        message.starts_with("form not removed (parabola of 56."),
        "{message}"
    );
    assert!(message.ends_with("um is not roughness"), "{message}");
    // 25/m · (1.5 mm)² = 56 um.
    close(sag, 56.2e-6, 2e-3);
    let removed = prepare(
        &crowned,
        &Preparation {
            form: Form::Poly2,
            ..recipe
        },
    )
    .unwrap();
    assert_eq!(removed.warnings, []);
}
