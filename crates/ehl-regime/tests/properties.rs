//! Scaling and monotonicity of films, reductions and film parameters.

use asperity_core::quantity::{Length, Pressure};
use asperity_ehl_regime::film_elliptic::{hamrock_dowson_central, hamrock_dowson_minimum};
use asperity_ehl_regime::thermal_reduction::gupta;
use asperity_ehl_regime::{
    AsperityShape, FilmGroups, FilmLaw, LoadShareLaw, Orientation, RegimeError, film_line,
};
use proptest::prelude::*;

type Film = fn(&FilmGroups, Length) -> Result<Length, RegimeError>;

fn central_line(groups: &FilmGroups, radius: Length) -> Result<Length, RegimeError> {
    Ok(hamrock_dowson_central(groups, radius, f64::INFINITY)?.value)
}

fn minimum_line(groups: &FilmGroups, radius: Length) -> Result<Length, RegimeError> {
    Ok(hamrock_dowson_minimum(groups, radius, f64::INFINITY)?.value)
}

/// Film and its published exponents of U, G, W.
const POWER_LAWS: [(Film, [f64; 3]); 5] = [
    (film_line::dowson_higginson, [0.70, 0.54, -0.13]),
    (film_line::dowson_toyoda, [0.69, 0.56, -0.10]),
    (
        film_line::ertel_grubin,
        [8.0 / 11.0, 8.0 / 11.0, -1.0 / 11.0],
    ),
    (central_line, [0.67, 0.53, -0.067]),
    (minimum_line, [0.68, 0.49, -0.073]),
];

prop_compose! {
    fn gear_groups()(
        material in 1e3..8e3_f64,
        speed in -12.0..-9.5_f64,
        load in -5.5..-3.5_f64,
    ) -> FilmGroups {
        FilmGroups { material, speed: 10f64.powf(speed), load: 10f64.powf(load) }
    }
}

proptest! {
    #[test]
    fn films_are_the_published_powers_of_their_groups(groups in gear_groups(), c in 1.1..9.0_f64) {
        let radius = Length::from_si(0.01);
        let scaled = [
            FilmGroups { speed: c * groups.speed, ..groups },
            FilmGroups { material: c * groups.material, ..groups },
            FilmGroups { load: c * groups.load, ..groups },
        ];
        for (film, exponents) in POWER_LAWS {
            let base = film(&groups, radius).unwrap();
            for (groups, exponent) in scaled.iter().zip(exponents) {
                let ratio = film(groups, radius).unwrap() / base;
                prop_assert!((ratio / c.powf(exponent) - 1.0).abs() < 1e-12);
            }
            // At constant groups a film scales with the radius.
            let larger = film(&groups, radius * c).unwrap() / base;
            prop_assert!((larger / c - 1.0).abs() < 1e-12);
        }
    }

    #[test]
    fn hamrock_dowson_minimum_is_below_the_central_film(groups in gear_groups()) {
        let radius = Length::from_si(0.01);
        prop_assert!(minimum_line(&groups, radius).unwrap() < central_line(&groups, radius).unwrap());
    }

    #[test]
    fn moes_film_rises_with_speed_and_piezoviscosity(groups in gear_groups(), c in 1.01..4.0_f64) {
        let radius = Length::from_si(0.01);
        let base = film_line::moes(&groups, radius).unwrap();
        let faster = FilmGroups { speed: c * groups.speed, ..groups };
        let thicker = FilmGroups { material: c * groups.material, ..groups };
        prop_assert!(film_line::moes(&faster, radius).unwrap() > base);
        prop_assert!(film_line::moes(&thicker, radius).unwrap() > base);
    }

    #[test]
    fn reduction_lies_between_zero_and_one_and_falls_with_every_cause(
        p0 in 1e8..1.5e9_f64,
        loading in 1e-3..5.0_f64,
        srr in 0.0..1.5_f64,
        c in 1.01..2.0_f64,
    ) {
        let modulus = Pressure::from_si(115e9);
        let phi = |p0: f64, l: f64, srr: f64| {
            gupta(Pressure::from_si(p0), modulus, l, srr).unwrap().value
        };
        let base = phi(p0, loading, srr);
        prop_assert!(base > 0.0 && base < 1.0);
        prop_assert!(phi(p0, c * loading, srr) < base);
        prop_assert!(phi(c * p0, loading, srr) < base);
        prop_assert!(phi(p0, loading, srr + 0.01) < base);
        prop_assert_eq!(phi(p0, loading, -srr), base);
    }

    #[test]
    fn gupta_tends_to_one_as_the_loading_vanishes(p0 in 1e8..2e9_f64, srr in 0.0..2.0_f64) {
        let phi = gupta(Pressure::from_si(p0), Pressure::from_si(115e9), 1e-12, srr).unwrap();
        // 13.2 (p₀/E′) L^0.42 is at most 13.2 · 0.0087 · 9e-6.
        prop_assert!(1.0 - phi.value < 2e-6);
    }

    #[test]
    fn film_factor_is_a_power_of_the_radii_with_the_exponent_of_the_law(
        asperity in 5e-6..5e-4_f64,
        flank in 2e-3..0.1_f64,
        c in 1.1..5.0_f64,
    ) {
        for &law in FilmLaw::ALL {
            for (orientation, total) in [
                (Orientation::Isotropic, 1.134),
                (Orientation::Transverse, 1.134),
                (Orientation::Longitudinal, 1.146),
            ] {
                let x = law.speed_exponent();
                let f_q = |asperity: f64| {
                    AsperityShape::ridges(Length::from_si(asperity), Length::from_si(flank))
                        .film_factor(orientation, x)
                        .unwrap()
                };
                let ratio = f_q(c * asperity) / f_q(asperity);
                prop_assert!((ratio / c.powf(total - x) - 1.0).abs() < 1e-12);
            }
        }
    }

    #[test]
    fn asperities_of_the_flank_s_own_shape_have_film_factor_one(
        radius in 1e-3..0.1_f64,
        aspect in 0.2..50.0_f64,
    ) {
        let shape = AsperityShape {
            asperity_radius: Length::from_si(radius),
            asperity_aspect: aspect,
            flank_radius: Length::from_si(radius),
            flank_aspect: aspect,
        };
        for orientation in [Orientation::Isotropic, Orientation::Longitudinal] {
            let f_q = shape.film_factor(orientation, 0.69).unwrap();
            prop_assert!((f_q - 1.0).abs() < 1e-14);
        }
    }

    #[test]
    fn film_share_rises_with_the_film(film in 0.0..3.0_f64, more in 0.0..1.0_f64) {
        for law in [LoadShareLaw::LambdaStar, LoadShareLaw::ZhuHu] {
            let share = law.film_share(film, film).unwrap();
            let larger = law.film_share(film + more, film + more).unwrap();
            prop_assert!((0.0..=1.0).contains(&share));
            prop_assert!(larger >= share);
        }
    }
}
