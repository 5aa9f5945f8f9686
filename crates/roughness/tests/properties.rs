//! Laws that hold for every profile.

#![allow(clippy::unwrap_used, clippy::panic)]

use asperity_core::Profile;
use asperity_core::quantity::Length;
use asperity_roughness::gaussian_filter::{Ends, mean_line};
use asperity_roughness::generate::SelfAffine;
use asperity_roughness::height_parameters::{Mode, in_sections};
use asperity_roughness::material_ratio::rk_parameters;
use asperity_roughness::preparation::{Preparation, prepare};
use asperity_roughness::summits::asperity_radius;
use proptest::prelude::*;

fn any_rough() -> impl Strategy<Value = Profile> {
    (any::<u64>(), 0.2..0.9f64, 20.0..200.0f64).prop_map(|(seed, hurst, roll_off)| {
        let recipe = SelfAffine {
            points: 4000,
            spacing: Length::from_si(0.5e-6),
            rq: Length::from_si(0.3e-6),
            hurst,
            roll_off: Length::from_si(roll_off * 1e-6),
            short_cut: Length::from_si(4e-6),
            seed,
        };
        recipe.generate().unwrap()
    })
}

fn map(profile: &Profile, f: impl Fn(f64) -> f64) -> Profile {
    Profile::new(
        profile.spacing(),
        profile.heights().iter().map(|z| f(*z)).collect(),
    )
    .unwrap()
}

/// Difference in height over the 40 % of the material ratio curve that start at `start` %.
fn fall(profile: &Profile, start: f64) -> f64 {
    let mut heights = profile.heights().to_vec();
    heights.sort_by(|a, b| b.total_cmp(a));
    let (n, first) = (heights.len() as f64, start / 100.0);
    heights[(first * n) as usize] - heights[((first + 0.4) * n) as usize]
}

fn close(a: f64, b: f64, relative: f64) -> bool {
    (a - b).abs() <= relative * a.abs().max(b.abs()).max(1e-30)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn heights_scale_and_shape_does_not(profile in any_rough(), factor in 0.01..100.0f64) {
        let scaled = map(&profile, |z| factor * z);
        for mode in [Mode::Iso4287, Mode::Iso21920] {
            let (a, b) = (in_sections(&profile, mode, 5).unwrap(), in_sections(&scaled, mode, 5).unwrap());
            for (a, b) in [(a.ra, b.ra), (a.rq, b.rq), (a.rp, b.rp), (a.rz, b.rz), (a.rt, b.rt)] {
                prop_assert!(close(a.si() * factor, b.si(), 1e-12));
            }
            prop_assert!(close(a.rku.unwrap(), b.rku.unwrap(), 1e-10));
            prop_assert!(close(a.rdq * factor, b.rdq, 1e-12));
            let order = a.ra <= a.rq && a.rq <= a.rt && a.rz <= a.rz1max && a.rz1max <= a.rt;
            prop_assert!(order || close(a.rz1max.si(), a.rt.si(), 1e-12));
        }
    }

    #[test]
    fn turning_a_profile_upside_down_swaps_peaks_and_pits(profile in any_rough()) {
        let turned = map(&profile, |z| -z);
        let (a, b) = (rk_parameters(profile.heights()).unwrap(), rk_parameters(turned.heights()).unwrap());
        // The window of 40 % of a curve turned over is the same one counted from its other end, unless two fall equally
        // within 1e-12 of the range, which is below ten Rk: then each curve has its own first one.
        if close(a.window_start + b.window_start, 60.0, 1e-12) {
            prop_assert!(close(a.rk.si(), b.rk.si(), 1e-10));
            prop_assert!(close(a.rpk.si(), b.rvk.si(), 1e-10));
            prop_assert!(close(a.mr1, 100.0 - b.mr2, 1e-10));
        } else {
            let falls = (fall(&profile, a.window_start), fall(&turned, b.window_start));
            prop_assert!((falls.0 - falls.1).abs() < 1e-11 * a.rk.si(), "{:?}", falls);
        }
        let (a, b) = (in_sections(&profile, Mode::Iso4287, 5).unwrap(), in_sections(&turned, Mode::Iso4287, 5).unwrap());
        prop_assert_eq!((a.rp, a.rv, a.ra), (b.rv, b.rp, b.ra));
        prop_assert!(close(a.rsk.unwrap(), -b.rsk.unwrap(), 1e-9));
    }

    #[test]
    fn running_a_profile_backwards_changes_no_height(profile in any_rough()) {
        let back = profile.mirrored();
        let recipe = Preparation { lambda_c: Some(Length::from_si(0.25e-3)), ..Preparation::default() };
        let (a, b) = (prepare(&profile, &recipe).unwrap(), prepare(&back, &recipe).unwrap());
        for (a, b) in a.profile.heights().iter().zip(b.profile.mirrored().heights()) {
            prop_assert!((a - b).abs() < 1e-18, "{} {}", a, b);
        }
        let radius = |p: &Profile| asperity_radius(p, Length::from_si(2.5e-6)).unwrap();
        prop_assert!(close(radius(&profile).radius.si(), radius(&back).radius.si(), 1e-9));
    }

    #[test]
    fn radius_falls_as_heights_grow(profile in any_rough(), factor in 0.1..10.0f64) {
        let lambda_s = Length::from_si(2.5e-6);
        let (a, b) = (
            asperity_radius(&profile, lambda_s).unwrap(),
            asperity_radius(&map(&profile, |z| factor * z), lambda_s).unwrap(),
        );
        prop_assert!(close(a.radius.si() / factor, b.radius.si(), 1e-9));
        prop_assert_eq!(a.count, b.count);
    }

    #[test]
    fn the_filter_is_linear_and_blind_to_an_offset(
        profile in any_rough(), factor in -3.0..3.0f64, offset in -0.1..0.1f64,
        ends in prop_oneof![Just(Ends::Cut), Just(Ends::Reg0), Just(Ends::Reg1), Just(Ends::Reflect)],
    ) {
        let cutoff = Length::from_si(80e-6);
        let line = mean_line(&profile, cutoff, ends).unwrap();
        let moved = mean_line(&map(&profile, |z| factor * z + offset), cutoff, ends).unwrap();
        for (w, moved) in line.iter().zip(&moved) {
            // Heights of 0.1 m are known to 1.4e-17.
            prop_assert!((factor * w + offset - moved).abs() < 1e-15);
        }
    }
}
