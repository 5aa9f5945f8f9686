//! Limits of the film laws, and inputs that have no answer.

#![allow(
    clippy::unwrap_used,
    reason = "helpers of tests may unwrap as tests do"
)]

use asperity_core::quantity::{Length, LineLoad, Pressure};
use asperity_core::{Code, DomainError, Fault};
use asperity_ehl_regime::film_elliptic::{
    ellipticity, hamrock_dowson_central, hamrock_dowson_minimum,
};
use asperity_ehl_regime::regime::film_share_of_film_ratio;
use asperity_ehl_regime::thermal_reduction::gupta;
use asperity_ehl_regime::{
    AsperityShape, FilmConditions, FilmGroups, FilmLaw, FilmThickness, LoadShareLaw, Orientation,
    Regime, ThermalLaw, film_line, film_ratio, lambda_star,
};

fn position() -> FilmConditions {
    FilmConditions {
        entrainment: "4.568 m/s".parse().unwrap(),
        radius: "11.627 mm".parse().unwrap(),
        load: "113.4 N/mm".parse().unwrap(),
        modulus: "115.3846 GPa".parse().unwrap(),
        viscosity: "97.5 mPa s".parse().unwrap(),
        pressure_viscosity: "20 1/GPa".parse().unwrap(),
        contact_length: None,
    }
}

/// Groups with given Moes numbers M and L.
fn groups_of(m: f64, l: f64) -> FilmGroups {
    let speed: f64 = 1e-11;
    FilmGroups {
        material: l / (2.0 * speed).powf(0.25),
        speed,
        load: m * (2.0 * speed).sqrt(),
    }
}

#[test]
fn moes_tends_to_each_of_its_asymptotes() {
    // Deep in each regime the other three terms leave less than 2 %.
    let number = |m: f64, l: f64| {
        let radius = Length::from_si(0.01);
        let film = film_line::moes(&groups_of(m, l), radius).unwrap();
        film.si() / radius.si() / (2e-11_f64).sqrt()
    };
    let near = |actual: f64, expected: f64| {
        assert!(
            (actual / expected - 1.0).abs() < 0.02,
            "{actual} is not near {expected}"
        );
    };
    near(number(1e-3, 1e-3), 3.0 / 1e-3);
    near(number(1e4, 1e-3), 2.621 * 1e4_f64.powf(-0.2));
    near(number(1.0, 1e6), 1.287 * 1e6_f64.powf(2.0 / 3.0));
    near(
        number(1e4, 100.0),
        1.311 * 1e4_f64.powf(-0.125) * 100_f64.powf(0.75),
    );
}

#[test]
fn speed_exponents_are_those_of_the_central_films() {
    // Deep in the elastic piezoviscous regime (M = 10⁴, L = 100), where the slope of Moes'
    // form has come within a hundredth of its asymptote's; the others are power laws everywhere.
    let groups = groups_of(1e4, 100.0);
    // The factor of the steady solutions on Dowson and Toyoda's film has no power.
    for &law in FilmLaw::ALL.iter().filter(|law| **law != FilmLaw::Steady) {
        let central = |speed: f64| {
            let at = FilmGroups { speed, ..groups };
            let radius = Length::from_si(0.01);
            let film = match law {
                FilmLaw::DowsonToyoda => film_line::dowson_toyoda(&at, radius),
                FilmLaw::Moes => film_line::moes(&at, radius),
                FilmLaw::ErtelGrubin => film_line::ertel_grubin(&at, radius),
                _ => hamrock_dowson_central(&at, radius, f64::INFINITY).map(|film| film.value),
            };
            film.unwrap().si()
        };
        let slope = (central(1.01 * groups.speed) / central(groups.speed)).ln() / 1.01_f64.ln();
        assert!(
            (slope - law.speed_exponent()).abs() < 1e-2,
            "{law:?}: {slope}"
        );
    }
}

#[test]
fn an_infinite_ellipticity_is_the_limit_of_a_large_one() {
    let groups = groups_of(5.0, 10.0);
    let radius = Length::from_si(0.01);
    for film in [hamrock_dowson_central, hamrock_dowson_minimum] {
        let line = film(&groups, radius, f64::INFINITY).unwrap().value.si();
        let long = film(&groups, radius, 60.0).unwrap().value.si();
        assert!(line.is_finite());
        // e^(−0.68·60) is below the last bit.
        assert!((line / long - 1.0).abs() < 1e-15);
    }
}

#[test]
fn hamrock_dowson_notes_what_left_its_range_but_not_the_line_limit() {
    let groups = FilmGroups {
        material: 4615.0,
        speed: 1.66e-10,
        load: 1e-6,
    };
    let film = hamrock_dowson_central(&groups, Length::from_si(0.01), f64::INFINITY).unwrap();
    let names: Vec<_> = film.outside.iter().map(|note| note.name).collect();
    assert_eq!(names, ["speed group U"]);
}

#[test]
fn hamrock_dowson_without_a_contact_length_asks_for_it() {
    let refused = Fault::from(FilmLaw::HamrockDowson.film(&position()).unwrap_err());
    assert_eq!(refused.code(), Code::E205);
    let expected = "the film law hamrock-dowson needs contact_length";
    assert_eq!(refused.message(), expected);
    // With R as the contact length both readings of the load are the same.
    let square = FilmConditions {
        contact_length: Some(position().radius),
        ..position()
    };
    let paper = FilmLaw::HamrockDowson.film(&square).unwrap().value;
    let line = FilmLaw::HamrockDowsonLine.film(&square).unwrap().value;
    assert!((paper.central / line.central - 1.0).abs() < 1e-14);
}

#[test]
fn every_film_law_reads_its_own_name() {
    for &law in FilmLaw::ALL {
        let read = FilmLaw::deserialize_name(law.name());
        assert_eq!(read, Ok(law));
        assert!(FilmLaw::deserialize_name("dowson").is_err());
    }
}

/// Reads a law as a case file does.
trait ByName: Sized {
    fn deserialize_name(name: &str) -> Result<Self, serde::de::value::Error>;
}

impl ByName for FilmLaw {
    fn deserialize_name(name: &str) -> Result<Self, serde::de::value::Error> {
        use serde::de::IntoDeserializer;
        serde::Deserialize::deserialize(name.into_deserializer())
    }
}

#[test]
fn impossible_positions_are_refused_by_name() {
    let refused = |bad: FilmConditions, name: &str| {
        for &law in FilmLaw::ALL {
            let bad = FilmConditions {
                contact_length: Some(Length::from_si(0.05)),
                ..bad
            };
            let refused = Fault::from(law.film(&bad).unwrap_err());
            assert_eq!(refused.cause::<DomainError>().unwrap().name, name);
        }
    };
    let load = |si| FilmConditions {
        load: LineLoad::from_si(si),
        ..position()
    };
    refused(load(0.0), "line load");
    refused(load(f64::NAN), "line load");
    refused(
        FilmConditions {
            radius: Length::from_si(f64::INFINITY),
            ..position()
        },
        "radius",
    );
    refused(
        FilmConditions {
            modulus: Pressure::from_si(-1.0),
            ..position()
        },
        "reduced modulus",
    );
    assert!(ellipticity(0.0).is_err());
    assert!(ellipticity(f64::NAN).is_err());
}

#[test]
fn no_thermal_loading_is_no_reduction() {
    let (p0, modulus) = (Pressure::from_si(1e9), Pressure::from_si(115e9));
    for law in [ThermalLaw::Gupta, ThermalLaw::None] {
        assert_eq!(law.reduction(p0, modulus, 0.0, 0.0).unwrap().value, 1.0);
    }
}

#[test]
fn the_steepness_of_guptas_factor_is_held_with_a_note() {
    let modulus = Pressure::from_si(115e9);
    for (p0, srr) in [(0.3e9, 0.0), (1.2e9, 0.5), (4e9, 1.9)] {
        let at = |l: f64| gupta(Pressure::from_si(p0), modulus, l, srr).unwrap();
        let form = |l: f64| {
            let loading = 0.213 * (1.0 + 2.23 * srr.powf(0.83)) * l.powf(0.64);
            (1.0 - 13.2 * p0 / 230e9 * l.powf(0.42)) / (1.0 + loading)
        };
        let fall = |l: f64| {
            let log = |step: f64| at(l * (1.0 + step)).value.ln();
            (log(-1e-5) - log(1e-5)) / 2e-5
        };
        let mut before = 0.0;
        let mut counts = [0, 0];
        for k in -60..60 {
            let l = 10_f64.powf(0.1 * f64::from(k));
            let (found, steepness) = (at(l), fall(l));
            let is_held = found.outside.len() == 1;
            counts[usize::from(is_held)] += 1;
            assert!(
                steepness > before - 1e-9 && steepness < 0.345 + 1e-8,
                "{l} {steepness}"
            );
            before = steepness;
            if is_held {
                assert!((steepness - 0.345).abs() < 1e-8, "{l} {steepness}")
            } else {
                // To the bit.
                assert!((found.value / form(l) - 1.0).abs() < 1e-15, "{l}")
            }
        }
        assert!(counts.iter().all(|count| *count > 20), "{counts:?}");
    }
    // However cold: there is a film.
    assert!(
        gupta(Pressure::from_si(4e9), modulus, 1e12, 1.9)
            .unwrap()
            .value
            > 0.0
    );
}

#[test]
fn thermal_reduction_refuses_what_is_not_a_number() {
    let (p0, modulus) = (Pressure::from_si(1e9), Pressure::from_si(115e9));
    assert!(gupta(p0, modulus, f64::NAN, 0.0).is_err());
    assert!(gupta(p0, modulus, 1.0, f64::INFINITY).is_err());
    assert!(gupta(Pressure::from_si(-1.0), modulus, 1.0, 0.0).is_err());
}

#[test]
fn lambda_star_refuses_a_surface_without_peaks() {
    let film = FilmThickness {
        central: Length::from_si(1e-6),
        minimum: Length::from_si(1e-6),
    };
    assert!(lambda_star(&film, 0.1, Length::from_si(0.0)).is_err());
    assert!(lambda_star(&film, f64::NAN, Length::from_si(1e-6)).is_err());
    assert!(film_ratio(film.central, 1.0, Length::from_si(0.0)).is_err());
    let shape = AsperityShape::ridges(Length::from_si(0.0), Length::from_si(0.01));
    assert!(shape.film_factor(Orientation::Isotropic, 0.67).is_err());
}

#[test]
fn without_a_film_the_asperities_carry_the_load() {
    assert_eq!(LoadShareLaw::LambdaStar.film_share(0.0, 0.0), Ok(0.0));
    assert_eq!(LoadShareLaw::ZhuHu.film_share(0.0, 0.0), Ok(0.0));
    assert!(LoadShareLaw::LambdaStar.film_share(f64::NAN, 1.0).is_err());
    assert!(LoadShareLaw::ZhuHu.film_share(1.0, -1.0).is_err());
    assert!(Regime::from_lambda_star(f64::NAN).is_err());
}

#[test]
fn film_share_is_one_from_lambda_star_one_on_and_rises_to_it() {
    let share = |value: f64| LoadShareLaw::LambdaStar.film_share(value, 0.0).unwrap();
    assert_eq!(share(1.0), 1.0);
    assert_eq!(share(7.0), 1.0);
    // The parabola has a flat top: one part in 10⁸ below at 1 − 10⁻⁴.
    assert!((1.0 - share(1.0 - 1e-4) - 1e-8).abs() < 1e-14);
}

#[test]
fn zhu_hu_share_rises_to_one_and_stays() {
    let share = |value: f64| film_share_of_film_ratio(value).unwrap();
    let shares: Vec<f64> = (0..=1000).map(|i| share(f64::from(i) * 5e-3)).collect();
    assert!(shares.windows(2).all(|pair| pair[1] >= pair[0]));
    // No step where the formula's maximum (2.257) is passed, and nearly one at λ = 2.
    assert!(shares.windows(2).all(|pair| pair[1] - pair[0] < 0.05));
    assert!((share(2.0) - 1.0).abs() < 5e-4);
    assert_eq!(share(3.0), 1.0);
}

#[test]
fn a_film_factor_is_finite_and_not_negative() {
    let film = FilmThickness {
        central: Length::from_si(0.3e-6),
        minimum: Length::from_si(0.2e-6),
    };
    let of = |factor: f64| lambda_star(&film, factor, Length::from_si(0.5e-6));
    assert!(of(0.0).is_ok());
    for factor in [-0.1, f64::INFINITY, f64::NAN] {
        assert!(of(factor).is_err(), "{factor}");
    }
}
