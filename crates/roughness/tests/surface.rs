//! Correlation, spectra, summits, outliers and involutes against closed forms and slow sums.

#![allow(clippy::unwrap_used, clippy::panic)]

use std::f64::consts::{PI, TAU};

use asperity_core::Profile;
use asperity_core::quantity::Length;
use asperity_roughness::autocorrelation::{autocorrelation, lengths};
use asperity_roughness::generate::{
    Achieved, Amplitudes, Finish, Generated, PlateauHoned, Recipe, SelfAffine, Surface, Surrogate,
};
use asperity_roughness::hurst::hurst_fit;
use asperity_roughness::involute::{Involute, fitted_roll_length, form_left, heights, remove};
use asperity_roughness::outliers::{Outliers, replace};
use asperity_roughness::preparation::{Preparation, RoughnessFilter, profiles};
use asperity_roughness::spectral::moments;
use asperity_roughness::summits::summit_statistics;

fn length(metres: f64) -> Length {
    Length::from_si(metres)
}

fn recipe(points: usize, seed: u64) -> SelfAffine {
    SelfAffine {
        points,
        spacing: length(0.5e-6),
        rq: length(0.3e-6),
        hurst: 0.8,
        roll_off: length(100e-6),
        short_cut: length(5e-6),
        seed,
    }
}

#[test]
fn the_fast_autocorrelation_is_the_slow_sum() {
    let profile = recipe(500, 1).generate().unwrap();
    let z = profile.heights();
    let n = z.len();
    let mean = z.iter().sum::<f64>() / n as f64;
    let square = z.iter().map(|z| (z - mean).powi(2)).sum::<f64>() / n as f64;
    for (k, fast) in autocorrelation(z).unwrap().into_iter().enumerate() {
        let slow: f64 = (0..n - k)
            .map(|i| (z[i] - mean) * (z[i + k] - mean))
            .sum::<f64>()
            / (n - k) as f64
            / square;
        // Rounding of the transform grows as few products are left to average.
        assert!((fast - slow).abs() < 1e-10, "{k}: {fast} {slow}");
    }
}

#[test]
fn a_cosine_forgets_itself_after_its_arccosine() {
    let wavelength = 80e-6;
    let wave = |i: usize| 1e-6 * (TAU * i as f64 * 0.1e-6 / wavelength).cos();
    let profile = Profile::new(length(0.1e-6), (0..400_000).map(wave).collect()).unwrap();
    let found = lengths(&profile).unwrap();
    // arccos(0.2) and arccos(1/e) over 2π; 500 periods leave one part in a thousand of the ends.
    for (found, rho) in [
        (found.to_one_fifth, 0.2),
        (found.to_one_over_e, (-1.0_f64).exp()),
    ] {
        let expected = f64::acos(rho) / TAU * wavelength;
        assert!((found.unwrap().si() / expected - 1.0).abs() < 1e-3);
    }
}

#[test]
fn two_waves_have_their_bandwidth() {
    let (a, b) = (1e-6, 0.1e-6);
    let (p, q) = (TAU / 1000.0, TAU / 100.0);
    let wave = |i: usize| a * (p * i as f64).sin() + b * (q * i as f64).sin();
    let profile = Profile::new(length(1e-6), (0..100_000).map(wave).collect()).unwrap();
    let sums = |power: i32| 0.5 * (a * a * p.powi(power) + b * b * q.powi(power));
    let expected = sums(0) * sums(4) / sums(2).powi(2);
    let found = moments(&profile).unwrap().bandwidth().unwrap();
    // The 3-point curvature damps a wave of 100 points by 1 - (2π/100)²/12 = 0.03 %, twice in m4.
    assert!((found / expected - 1.0).abs() < 2e-3, "{found} {expected}");
}

#[test]
fn summits_of_a_gaussian_profile_are_as_dense_as_its_moments_say() {
    let recipe = SelfAffine {
        short_cut: length(20e-6),
        ..recipe(1 << 18, 5)
    };
    let profile = recipe.generate().unwrap();
    let found = summit_statistics(&profile, length(0.5e-6)).unwrap();
    // Some three thousand summits: two percent of counting noise.
    assert!(found.count > 2000);
    assert!(
        (found.density / found.spectral_density - 1.0).abs() < 0.06,
        "{found:?}"
    );
    // Nayak 1971: the mean curvature is √(π m₄/2).
    let expected = (0.5 * PI * moments(&profile).unwrap().m4).sqrt();
    assert!(
        (found.mean_curvature / expected - 1.0).abs() < 0.05,
        "{found:?}"
    );
    assert!(found.mean_height.si() > 0.0);
}

#[test]
fn the_hurst_fit_finds_the_exponent_of_its_recipe() {
    for hurst in [0.3, 0.5, 0.8] {
        let recipe = SelfAffine {
            hurst,
            roll_off: length(400e-6),
            short_cut: length(2e-6),
            ..recipe(1 << 17, 9)
        };
        let profile = recipe.generate_with(Amplitudes::Random).unwrap();
        let found = hurst_fit(&profile, length(200e-6), length(4e-6)).unwrap();
        // Bands hold from 60 lines up, so each mean is good to 13 % and the slope to some hundredths.
        assert!((found.hurst - hurst).abs() < 0.06, "{hurst} {found:?}");
        assert!(found.standard_error < 0.05);
    }
    assert!(
        hurst_fit(
            &recipe(4096, 1).generate().unwrap(),
            length(4e-6),
            length(200e-6)
        )
        .is_err()
    );
}

#[test]
fn spikes_are_replaced_and_pits_stay() {
    let profile = recipe(8000, 3).generate().unwrap();
    let mut z = profile.heights().to_vec();
    for (at, spike) in [(1000, 9e-6), (1001, 9e-6), (5000, -30e-6)] {
        z[at] += spike;
    }
    for (i, z) in z.iter_mut().enumerate().skip(3000).take(200) {
        *z -= 5e-6 * (PI * (i - 3000) as f64 / 200.0).sin();
    }
    let damaged = Profile::new(profile.spacing(), z).unwrap();
    let rule = Outliers {
        deviations: 8.0,
        half_window: 6,
    };
    let (cleaned, record) = replace(&damaged, rule).unwrap();
    assert_eq!((record.replaced, record.longest), (3, 2));
    assert!((record.farthest.si() - 30e-6).abs() < 1e-6);
    assert_eq!(cleaned.heights()[3100], damaged.heights()[3100]);
    let off = (cleaned.heights()[5000] - profile.heights()[5000]).abs();
    assert!(off < 0.05e-6, "{off}");
    let (same, none) = replace(&profile, rule).unwrap();
    assert_eq!((same, none.replaced), (profile, 0));
}

#[test]
fn a_trace_that_is_no_involute_is_warned_about_and_no_error() {
    let wave = |i: u32| 0.3e-6 * (0.06 * f64::from(i)).sin() - 2e-13 * f64::from(i).powi(2);
    let trace = Profile::new(Length::from_si(0.5e-6), (0..6001).map(wave).collect()).unwrap();
    let stated = Involute {
        base_radius: Length::from_si(20e-3),
        roll_length: Length::from_si(8e-3),
        towards_root: false,
    };
    // Its best roll lengths unroll more than half a turn of the base circle.
    assert!(fitted_roll_length(&trace, &stated).unwrap().si() > 0.1);
    assert!(form_left(&trace, &stated).unwrap().is_some());
}

#[test]
fn an_involute_traced_from_its_definition_is_removed() {
    let (rb, roll) = (40e-3, 12e-3);
    let start: f64 = roll / rb;
    // The involute r_b (cos ξ + ξ sin ξ, sin ξ − ξ cos ξ), turned into the frame of its middle.
    let point = |xi: f64| {
        (
            rb * (xi.cos() + xi * xi.sin()),
            rb * (xi.sin() - xi * xi.cos()),
        )
    };
    let (x0, y0) = point(start);
    let flank = Involute {
        base_radius: length(rb),
        roll_length: length(roll),
        towards_root: false,
    };
    for step in -50..=50 {
        let (x, y) = point(start + f64::from(step) * 1e-3);
        let (dx, dy) = (x - x0, y - y0);
        let along = dx * start.cos() + dy * start.sin();
        let up = dx * start.sin() - dy * start.cos();
        let found = heights(&flank, &[along]).unwrap()[0];
        assert!((found - up).abs() < 1e-15, "{step}: {found} {up}");
    }
    let wave = |i: usize| 1e-7 * (i as f64 / 20.0).sin();
    let x: Vec<f64> = (0..3001).map(|i| 1e-6 * (1500.0 - f64::from(i))).collect();
    let form = heights(&flank, &x).unwrap();
    let traced = form
        .iter()
        .enumerate()
        .map(|(i, z)| z + wave(i) + 1e-8 * i as f64);
    let traced = Profile::new(length(1e-6), traced.collect()).unwrap();
    let from_tip = Involute {
        towards_root: true,
        ..flank
    };
    let left = remove(&traced, &from_tip).unwrap();
    let off = left
        .heights()
        .iter()
        .enumerate()
        .map(|(i, z)| (z - wave(i)).abs());
    // What the straight line takes of 24 waves.
    assert!(off.fold(0.0, f64::max) < 1e-8);
    let below = Involute {
        roll_length: length(0.5e-3),
        ..flank
    };
    assert!(remove(&traced, &below).is_err());
}

#[test]
fn plateau_honed_profiles_have_the_heights_of_both_processes() {
    let fine = SelfAffine {
        rq: length(0.05e-6),
        roll_off: length(20e-6),
        ..recipe(8192, 1)
    };
    let coarse = SelfAffine {
        rq: length(1e-6),
        ..recipe(8192, 2)
    };
    let honed = PlateauHoned {
        coarse,
        fine,
        depth: length(0.5e-6),
    };
    let found = Recipe::from_surface(Surface::PlateauHoned(honed))
        .generate()
        .unwrap();
    let (a, b) = (coarse.generate().unwrap(), fine.generate().unwrap());
    let pairs = a.heights().iter().zip(b.heights());
    let least: Vec<f64> = pairs.map(|(a, b)| a.min(b - 0.5e-6)).collect();
    let mean = least.iter().sum::<f64>() / least.len() as f64;
    for (z, least) in found.profile.heights().iter().zip(&least) {
        assert!((z - (least - mean)).abs() < 1e-18);
    }
    assert!(found.achieved.rsk.unwrap() < -1.0, "{:?}", found.achieved);
    let other = SelfAffine {
        points: 4096,
        ..fine
    };
    assert!(
        PlateauHoned {
            fine: other,
            ..honed
        }
        .generate()
        .is_err()
    );
}

#[test]
fn waviness_and_roughness_add_up_to_the_primary_profile() {
    let trace = recipe(12_000, 4).generate().unwrap();
    let found = profiles(&trace, &Preparation::default(), RoughnessFilter::Gaussian).unwrap();
    let (waviness, first) = (found.waviness.unwrap(), found.roughness.first_index);
    assert_eq!(waviness.len(), found.roughness.profile.len());
    for (i, (w, r)) in waviness
        .heights()
        .iter()
        .zip(found.roughness.profile.heights())
        .enumerate()
    {
        let p = found.primary.heights()[first + i];
        assert!((w + r - p).abs() < 1e-20);
    }
}

#[test]
fn a_recipe_reads_from_text_and_returns_what_it_achieved() {
    let text = r#"{"surface": {"self-affine": {"points": 4096, "spacing": "0.5 um", "rq": "0.3 um",
        "hurst": 0.8, "roll-off": "100 um", "short-cut": "5 um", "seed": 1}}, "amplitudes": "random",
        "pits": {"count": 3, "width": "40 um", "depth": "5 um", "seed": 2}, "mirrored": true}"#;
    let recipe: Recipe = serde_json::from_str(text).unwrap();
    let Generated {
        profile, achieved, ..
    } = recipe.generate().unwrap();
    assert_eq!(achieved, Achieved::from_profile(&profile));
    assert!(achieved.rt.si() > 3e-6 && achieved.rsk.unwrap() < -1.0);
    assert_eq!(recipe.generate().unwrap().profile, profile);
}

fn surrogate(finish: Finish, number: usize, body: usize) -> Surrogate {
    Surrogate {
        finish,
        number: [number, 12],
        body,
        length: length(3e-3),
        spacing: length(0.5e-6),
        lambda_s: Some(length(2.5e-6)),
        lambda_c: Some(length(0.25e-3)),
    }
}

#[test]
fn ground_surrogates_are_superfinished_ones_with_grooves() {
    for number in [0, 7] {
        let of = |finish| surrogate(finish, number, 0).generate().unwrap().0;
        let (ground, fine) = (of(Finish::Ground), of(Finish::Superfinished));
        let grooves = ground.heights().iter().zip(fine.heights());
        let grooves = grooves.map(|(z, background)| z - background).collect();
        let grooves = Achieved::from_profile(&Profile::new(ground.spacing(), grooves).unwrap());
        let ratio = grooves.rq / Achieved::from_profile(&fine).rq;
        // The filter takes its part of both.
        assert!(ratio > 0.4 && ratio < 4.0, "{ratio}");
        // Cusps stand up between the grooves.
        assert!(grooves.rsk.unwrap() > 0.5, "{grooves:?}");
    }
}

#[test]
fn shapes_of_surrogates_fill_their_ranges() {
    let free = |number| Surrogate {
        lambda_s: None,
        ..surrogate(Finish::Ground, number, 0)
    };
    let third = |k: usize| {
        let place = (free(k).lambda_s() / length(2.5e-6)).log10();
        assert!((0.0..1.0).contains(&place), "{place}");
        (3.0 * place) as usize
    };
    let thirds: Vec<usize> = (0..12).map(third).collect();
    for part in 0..3 {
        assert_eq!(thirds.iter().filter(|third| **third == part).count(), 4);
    }
    // The first is in the middle of the range.
    assert_eq!(thirds[0], 1);
    let ratios: Vec<f64> = (0..12)
        .map(|k| {
            let (_, found) = surrogate(Finish::Ground, k, 0).generate().unwrap();
            found.material.rpk / found.heights.ra
        })
        .collect();
    let (low, high) = asperity_core::numerics::extremes(&ratios);
    assert!(high > 1.3 * low, "{ratios:?}");
}

#[test]
fn a_surrogate_is_always_the_same_and_the_flanks_of_a_pair_differ() {
    let pinion = surrogate(Finish::Ground, 3, 0).generate().unwrap();
    assert_eq!(pinion, surrogate(Finish::Ground, 3, 0).generate().unwrap());
    let wheel = surrogate(Finish::Ground, 3, 1).generate().unwrap().0;
    let product = |a: &Profile, b: &Profile| -> f64 {
        let pairs = a.heights().iter().zip(b.heights());
        pairs.map(|(a, b)| a * b).sum()
    };
    let correlation = product(&pinion.0, &wheel)
        / (product(&pinion.0, &pinion.0) * product(&wheel, &wheel)).sqrt();
    assert!(correlation.abs() < 0.2, "{correlation}");
}

#[test]
fn an_impossible_surrogate_is_refused() {
    let none = Surrogate {
        spacing: length(0.0),
        ..surrogate(Finish::Ground, 0, 0)
    };
    assert!(none.generate().is_err());
    assert!(surrogate(Finish::Ground, 12, 0).generate().is_err());
}
