//! Closed forms of parameters, spectra, summits, composites and generators.

#![allow(clippy::unwrap_used, clippy::panic)]

use std::f64::consts::{PI, SQRT_2, TAU};

use crate::common::{close, profile};
use asperity_core::Profile;
use asperity_core::quantity::Length;
use asperity_roughness::Parameters;
use asperity_roughness::autocorrelation::{autocorrelation, lengths};
use asperity_roughness::composite::{Pairing, combined_rq, compose};
use asperity_roughness::generate::{Ground, SelfAffine, lower_envelope, truncated};
use asperity_roughness::height_parameters::{Mode, height_parameters, in_sections};
use asperity_roughness::material_levels::MaterialLevels;
use asperity_roughness::material_ratio::{Line, abbott_curve, rk_parameters, rk_parameters_with};
use asperity_roughness::spectral::{moments, power_spectrum, slopes};
use asperity_roughness::summits::{ReferenceLevel, asperity_radius};

#[test]
fn a_sine_has_its_textbook_heights_in_both_modes() {
    let amplitude = 1.5e-6;
    // 50 whole waves, phase off the grid, 800 points a wave.
    let wave = profile(0.1e-6, 40_000, |x| {
        amplitude * (TAU * x / 80e-6 + 0.1).sin()
    });
    for mode in [Mode::Iso4287, Mode::Iso21920] {
        let found = height_parameters(&wave, mode, Length::from_si(0.8e-3)).unwrap();
        assert_eq!(found.sections, 5);
        // Sums over whole waves are exact but for |sin| at its zeros, (2π/800)²/12 of Ra.
        close(found.ra.si(), 2.0 * amplitude / PI, 1e-5);
        close(found.rq.si(), amplitude / SQRT_2, 1e-12);
        close(found.rku.unwrap(), 1.5, 1e-12);
        assert!(found.rsk.unwrap().abs() < 1e-12);
        // The crest lies up to half a point off the grid: (π/800)²/2.
        close(found.rz.si(), 2.0 * amplitude, 1e-5);
        close(found.rt.si(), 2.0 * amplitude, 1e-5);
        close(found.rsm.unwrap().si(), 80e-6, 1e-6);
        close(found.rc.unwrap().si(), 2.0 * amplitude, 1e-5);
        // Six points of 8000 are missing at the steepest places of each section.
        close(found.rdq, TAU / 80e-6 * amplitude / SQRT_2, 1e-3);
    }
}

#[test]
fn the_two_modes_differ_on_a_single_feature() {
    // One section of five holds a block; the mean of the sections' Rq is Rq/√5 of the whole.
    let z = |i: usize| if (100..150).contains(&i) { 1e-6 } else { 0.0 };
    let block = Profile::new(Length::from_si(1e-6), (0..1000).map(z).collect()).unwrap();
    let per_section = in_sections(&block, Mode::Iso4287, 5).unwrap();
    let whole = in_sections(&block, Mode::Iso21920, 5).unwrap();
    close(whole.rq.si(), 1e-6 * 0.05_f64.sqrt(), 1e-12);
    close(per_section.rq.si(), whole.rq.si() / 5f64.sqrt(), 1e-12);
    close(per_section.ra.si(), whole.ra.si(), 1e-12);
    assert_eq!(whole.rsm, None);
    assert_eq!(per_section.sections_without_element, 5);
}

#[test]
fn the_rk_family_of_a_sine_and_a_triangle_has_closed_forms() {
    // Curve of a sine of amplitude 1: cos(π Mr); line by least squares over the first 40 %... of its
    // flattest part. Values integrated to eight digits with arbitrary precision.
    let n = 200_000;
    let sine: Vec<f64> = (0..n)
        .map(|i| (PI * (f64::from(i) + 0.5) / f64::from(n)).cos())
        .collect();
    let found = rk_parameters(&sine).unwrap();
    // The curve has 200 000 steps: errors of some 1e-5 at its ends, where it is steepest.
    close(found.rk.si(), 1.774_702, 2e-5);
    close(found.rvk.si(), 0.443_918, 5e-5);
    close(found.mr2, 73.0689, 1e-5);
    assert_eq!((found.rpk.si(), found.mr1), (0.0, 0.0));

    let triangle: Vec<f64> = (0..n).map(|i| 2.0 * f64::from(i) / f64::from(n)).collect();
    for line in [Line::LeastSquares, Line::Secant] {
        let found = rk_parameters_with(&triangle, line).unwrap();
        close(found.rk.si(), 2.0, 1e-9);
        assert!(found.rpk.si() < 1e-9 && found.rvk.si() < 1e-9);
    }
}

#[test]
fn material_ratios_and_levels_of_a_sine_have_closed_forms() {
    // The curve of a sine of amplitude A is c = A cos(π Mr), so Mr = arccos(c/A)/π.
    let (amplitude, n) = (1.3e-6, 100_000);
    let sine: Vec<f64> = (0..n)
        .map(|i| amplitude * (TAU * (f64::from(i) + 0.3) / f64::from(n)).sin())
        .collect();
    let levels = MaterialLevels::from_heights(&sine).unwrap();
    for share in [-0.9, -0.5, 0.0, 0.3, 0.8] {
        let exact = 100.0 * f64::acos(share) / PI;
        let found = levels.ratio(Length::from_si(share * amplitude));
        // Within a point of the hundred thousand.
        assert!((found - exact).abs() < 1e-3, "{share}: {found} {exact}");
        let level = levels.level(exact).unwrap();
        assert!(
            (level.si() - share * amplitude).abs() < 1e-4 * amplitude,
            "{share}: {level}"
        );
    }
    let exact = amplitude * ((0.05 * PI).cos() - (0.75 * PI).cos());
    close(levels.difference(5.0, 75.0).unwrap().si(), exact, 1e-6);
    // A quarter of an amplitude below the level of 5 %.
    let exact = 100.0 * ((0.05 * PI).cos() - 0.25).acos() / PI;
    close(
        levels
            .ratio_below(5.0, Length::from_si(0.25 * amplitude))
            .unwrap(),
        exact,
        1e-4,
    );
    assert_eq!(levels.ratio(Length::from_si(2.0 * amplitude)), 0.0);
    assert_eq!(levels.ratio(Length::from_si(-2.0 * amplitude)), 100.0);
    assert!(levels.difference(75.0, 5.0).is_err() && levels.level(101.0).is_err());
    assert!(levels.level(f64::NAN).is_err());
}

#[test]
fn rk_of_quantised_heights_is_that_of_the_heights() {
    // A sum of waves with periods that have no common multiple, and the same rounded to a share of its Rq.
    let z = |i: u32| {
        let x = f64::from(i);
        1e-7 * ((0.11 * x).sin()
            + (0.0731 * x + 1.0).sin()
            + (0.231 * x + 2.0).sin()
            + (0.0519 * x).cos())
    };
    let heights: Vec<f64> = (0..20_000).map(z).collect();
    let exact = rk_parameters(&heights).unwrap();
    let rq = 1e-7 * SQRT_2;
    for share in [0.02, 0.1, 0.3, 0.5] {
        let step = share * rq;
        let rounded: Vec<f64> = heights.iter().map(|z| (z / step).round() * step).collect();
        let found = rk_parameters(&rounded).unwrap();
        // Straight pieces of the curve under a step stand for its own shape.
        let most = 0.002 + 0.06 * share;
        assert!(
            (found.rk / exact.rk - 1.0).abs() < most,
            "{share}: {} {}",
            found.rk,
            exact.rk
        );
        assert!(
            (found.mr1 - exact.mr1).abs() < 2.0 && (found.mr2 - exact.mr2).abs() < 2.0,
            "{share}"
        );
        let level = Length::from_si(0.7 * rq);
        let [a, b] =
            [&heights, &rounded].map(|z| MaterialLevels::from_heights(z).unwrap().ratio(level));
        assert!((a - b).abs() < 1.0, "{share}: {a} {b}");
    }
}

#[test]
fn areas_of_peaks_and_pits_are_those_of_their_triangles() {
    // A core of slope one with steep ends: straight pieces, so the reduced heights are exact.
    let piece = |mr: f64| match mr {
        m if m < 0.1 => 1.0 + 10.0 * (0.1 - m),
        m if m > 0.8 => 0.3 - 5.0 * (m - 0.8),
        m => 1.0 - (m - 0.1),
    };
    let n = 100_000;
    let heights: Vec<f64> = (0..n)
        .map(|k| piece((f64::from(k) + 0.5) / f64::from(n)))
        .collect();
    let found = rk_parameters(&heights).unwrap();
    close(found.rk.si(), 1.0, 1e-6);
    // c(0) = 1.1 cuts the peaks at 9 %, where 0.9 of height remains above.
    close(found.mr1, 9.0, 1e-4);
    close(found.rpk.si(), 0.9, 1e-3);
    // c(100) = 0.1 cuts the pits at 84 %; 0.8 of depth remains below.
    close(found.mr2, 84.0, 1e-4);
    close(found.rvk.si(), 0.8, 1e-3);
    close(found.a1.si(), 0.5 * 0.9 * 0.09, 1e-3);
    assert!(abbott_curve(&heights).unwrap().is_sorted_by(|a, b| a >= b));
}

#[test]
fn moments_of_a_sine_are_those_of_its_derivatives() {
    let k = TAU / 50e-6;
    let wave = profile(0.5e-6, 10_000, |x| 1e-6 * (k * x).sin());
    let found = moments(&wave).unwrap();
    close(found.m0, 0.5e-12, 1e-12);
    // Six points of 10 000 are missing at the steepest places; they count double.
    close(found.m2, 0.5e-12 * k * k, 1.2e-3);
    // 3-point: (k dx)²/12 of the curvature.
    close(found.m4, 0.5e-12 * k.powi(4), 1e-3);
    assert_eq!(slopes(&[0.0; 6], 1.0), [0.0; 0]);
}

#[test]
fn correlation_lengths_are_where_the_whole_function_falls() {
    let recipe = |roll_off: f64| SelfAffine {
        points: 40_000,
        spacing: Length::from_si(0.5e-6),
        rq: Length::from_si(0.3e-6),
        hurst: 0.8,
        roll_off: Length::from_si(roll_off),
        short_cut: Length::from_si(2.5e-6),
        seed: 8,
    };
    // Found among the first 4096 shifts, by blocks; and only among more of them.
    for roll_off in [100e-6, 12e-3] {
        let rough = recipe(roll_off).generate().unwrap();
        let rho = autocorrelation(rough.heights()).unwrap();
        let after = rho.iter().position(|rho| *rho <= 0.2).unwrap();
        assert_eq!(after > 4096, roll_off > 1e-3, "{after}");
        let part = (rho[after - 1] - 0.2) / (rho[after - 1] - rho[after]);
        let found = lengths(&rough).unwrap().to_one_fifth.unwrap();
        close(found.si(), 0.5e-6 * (after as f64 - 1.0 + part), 1e-9);
    }
}

#[test]
fn parameters_in_another_mode_are_those_worked_anew() {
    let rough = profile(0.5e-6, 9000, |x| {
        1e-6 * (TAU * x / 70e-6).sin() + 3e-7 * (TAU * x / 9e-6).sin()
    });
    let of = |mode| Parameters::from_profile(&rough, mode, Length::from_si(0.8e-3)).unwrap();
    let found = of(Mode::Iso4287).in_mode(&rough, Mode::Iso21920).unwrap();
    assert_eq!(found, of(Mode::Iso21920));
    assert_ne!(found, of(Mode::Iso4287));
}

#[test]
fn the_spectrum_holds_the_power_of_the_profile_at_its_wavelength() {
    let wave = profile(0.5e-6, 4096, |x| 1e-6 * (TAU * x / (64.0 * 0.5e-6)).sin());
    let found = power_spectrum(&wave).unwrap();
    let power: f64 = found.density.iter().sum::<f64>() * found.frequency_step;
    close(power, 0.5e-12, 1e-4);
    let highest =
        (0..found.density.len()).max_by(|a, b| found.density[*a].total_cmp(&found.density[*b]));
    assert_eq!(highest, Some(64));
}

#[test]
fn the_summits_of_parabolic_ridges_have_their_radius() {
    let ridge = |x: f64| {
        let from_crest = (x / 40e-6).fract() * 40e-6 - 20e-6;
        -from_crest * from_crest / (2.0 * 80e-6)
    };
    let ridges = profile(0.5e-6, 8000, ridge);
    let found = asperity_radius(&ridges, Length::from_si(2.5e-6)).unwrap();
    close(found.radius.si(), 80e-6, 1e-6);
    assert_eq!(found.window_points, 5);
    // Four summits are too few for the peak zone.
    let few = asperity_radius(&ridges.slice(0..320).unwrap(), Length::from_si(2.5e-6)).unwrap();
    assert_eq!((few.count, few.level), (4, ReferenceLevel::MeanLine));
}

#[test]
fn all_summits_of_a_gaussian_profile_have_nayaks_mean_curvature() {
    let recipe = SelfAffine {
        points: 1 << 18,
        spacing: Length::from_si(0.2e-6),
        rq: Length::from_si(0.2e-6),
        hurst: 0.8,
        roll_off: Length::from_si(40e-6),
        short_cut: Length::from_si(8e-6),
        seed: 4,
    };
    let gaussian = recipe.generate().unwrap();
    let z = gaussian.heights();
    let dx = recipe.spacing.si();
    let at_summits: Vec<f64> = z
        .windows(3)
        .filter(|z| z[1] > z[0] && z[1] >= z[2])
        .map(|z| (2.0 * z[1] - z[0] - z[2]) / (dx * dx))
        .collect();
    let mean = at_summits.iter().sum::<f64>() / at_summits.len() as f64;
    let m4 = moments(&gaussian).unwrap().m4;
    let nayak = asperity_roughness::spectral::gaussian_summit_curvature(m4).unwrap();
    // Some 10⁴ summits: statistical error of one percent.
    close(mean, nayak, 0.02);
    // Those in the peak zone are sharper than the mean of all.
    let found = asperity_radius(&gaussian, Length::from_si(0.2e-6)).unwrap();
    close(found.spectral_radius.si(), 1.0 / nayak, 1e-12);
    assert!(found.radius < found.spectral_radius && found.radius > found.spectral_radius * 0.4);
}

#[test]
fn heights_of_uncorrelated_flanks_add_in_squares() {
    let flank = |seed| {
        let recipe = SelfAffine {
            points: 1 << 16,
            spacing: Length::from_si(0.5e-6),
            rq: Length::from_si(0.3e-6),
            hurst: 0.7,
            roll_off: Length::from_si(30e-6),
            short_cut: Length::from_si(3e-6),
            seed,
        };
        recipe.generate().unwrap()
    };
    let (first, second) = (flank(1), flank(2));
    let rq = |p: &Profile| (p.heights().iter().map(|z| z * z).sum::<f64>() / p.len() as f64).sqrt();
    let together = compose(&first, &second, Pairing::default()).unwrap();
    let expected = combined_rq(Length::from_si(0.3e-6), Length::from_si(0.3e-6)).unwrap();
    // About 2000 independent correlation lengths.
    close(rq(&together.profile), expected.si(), 0.03);
    // Against itself the same flank doubles: the rule of squares does not hold.
    let doubled = compose(&first, &first, Pairing::default()).unwrap();
    close(rq(&doubled.profile), 0.6e-6, 1e-12);
}

#[test]
fn composing_resamples_only_when_asked() {
    let ramp = |dx: f64, n: usize| profile(dx, n, |x| 2.0 * x);
    let (fine, coarse) = (ramp(0.5e-6, 201), ramp(0.8e-6, 101));
    assert!(compose(&fine, &coarse, Pairing::default()).is_err());
    let pairing = Pairing {
        resample: true,
        ..Pairing::default()
    };
    let both = compose(&coarse, &fine, pairing).unwrap();
    assert_eq!(both.resampled_from, Some(Length::from_si(0.8e-6)));
    assert_eq!(both.profile.len(), 161);
    for (i, z) in both.profile.heights().iter().enumerate() {
        assert!((z - 4.0 * 0.5e-6 * i as f64).abs() < 1e-16);
    }
}

#[test]
fn generated_profiles_have_the_asked_height_and_repeat_with_their_seed() {
    let recipe = Ground {
        points: 20_000,
        spacing: Length::from_si(0.5e-6),
        rq: Length::from_si(0.4e-6),
        grit_spacing: Length::from_si(12e-6),
        grit_radius: Length::from_si(60e-6),
        grit_protrusion: Length::from_si(1e-6),
        seed: 9,
    };
    let ground = recipe.generate().unwrap();
    let found = in_sections(&ground, Mode::Iso21920, 5).unwrap();
    close(found.rq.si(), 0.4e-6, 1e-12);
    // Cusps point up: ground surfaces under this model lean to positive skewness.
    assert!(found.rsk.unwrap() > 0.1, "{:?}", found.rsk);
    assert_eq!(ground, recipe.generate().unwrap());
    assert_ne!(ground, Ground { seed: 10, ..recipe }.generate().unwrap());
    let (plateau, removed) = truncated(&ground, 0.3).unwrap();
    assert!(removed.si() > 0.0);
    let after = rk_parameters(plateau.heights()).unwrap();
    assert!(after.rpk < rk_parameters(ground.heights()).unwrap().rpk * 0.1);
    assert_eq!(lower_envelope(&ground, &plateau).unwrap(), plateau);
}
