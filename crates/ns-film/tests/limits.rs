//! Limits of the film: thick and thin, and inputs without an answer.
#![allow(clippy::unwrap_used)] // Helpers outside test functions.

use asperity_core::quantity::{Angle, Density, DynamicViscosity, Length, Speed};
use asperity_ns_film::film_pressure::{Rupture, film_pressure};
use asperity_ns_film::{
    FilmConditions, FluidModel, pressure_difference_across, pressure_difference_over_thickness,
};

fn rolling() -> FilmConditions {
    let u = Speed::from_si(4.5);
    FilmConditions {
        wall_1: u,
        wall_2: u,
        radius_1: Length::from_si(6e-3),
        radius_2: Length::from_si(6e-3),
        film_thickness: Length::from_si(1e-7),
        angle: Angle::from_si(0.0),
        base_radius: Length::from_si(6e-3),
        middle_speed: None,
        viscosity: DynamicViscosity::from_si(0.0975),
        density: Density::from_si(998.0),
    }
}

#[test]
fn a_thick_film_varies_as_the_logarithm_of_its_thickness_over_the_radius() {
    // 1 mm on 6 mm: ln(1 + 1/6) = 0.154 151, the 1/r law that the paper's 16 % belongs to.
    let dynamic = 998.0 * 4.5 * 4.5;
    let thick = &[1e-3];
    let paper = pressure_difference_over_thickness(FluidModel::Paper, &rolling(), thick).unwrap();
    assert!((paper[0] / dynamic - 0.154_150_679_827_258_3).abs() < 1e-12);
    let section = FilmConditions {
        film_thickness: Length::from_si(1e-3),
        ..rolling()
    }
    .section()
    .unwrap();
    let exact = section.centrifugal_difference_thick().unwrap().si();
    assert!((exact / dynamic - 0.154_150_679_827_258_3).abs() < 1e-12);
    // The form for thin films is the first term, h/R.
    let first = section.cross_film().unwrap().difference.si();
    assert!((first / dynamic - 1.0 / 6.0).abs() < 1e-12);
}

#[test]
fn both_models_agree_on_a_thin_rolling_film() {
    let thin = [1e-9, 1e-8, 1e-7, 1e-6];
    let sweep = |model| pressure_difference_over_thickness(model, &rolling(), &thin).unwrap();
    let (consistent, paper) = (sweep(FluidModel::ReynoldsCross), sweep(FluidModel::Paper));
    for (i, h) in thin.iter().enumerate() {
        // They part at the next term of the logarithm, h/2R.
        assert!((paper[i] / consistent[i] - 1.0).abs() < h / 6e-3);
        assert!((consistent[i] / consistent[0] - h / thin[0]).abs() < 1e-9 * h / thin[0]);
    }
}

#[test]
fn sliding_breaks_the_papers_film_but_not_the_consistent_one() {
    let sliding = FilmConditions {
        wall_1: Speed::from_si(5.2),
        wall_2: Speed::from_si(3.8),
        base_radius: Length::from_si(20e-3),
        ..rolling()
    };
    let at = |model| pressure_difference_across(model, &sliding).unwrap().si();
    assert!(at(FluidModel::ReynoldsCross).abs() < 1.0);
    assert!(at(FluidModel::Paper).abs() > 100.0);
}

#[test]
fn impossible_films_are_errors() {
    for bad in [
        FilmConditions {
            film_thickness: Length::from_si(0.0),
            ..rolling()
        },
        FilmConditions {
            radius_2: Length::from_si(-1.0),
            ..rolling()
        },
        FilmConditions {
            angle: Angle::from_si(f64::NAN),
            ..rolling()
        },
        FilmConditions {
            wall_1: Speed::from_si(f64::INFINITY),
            ..rolling()
        },
        FilmConditions {
            viscosity: DynamicViscosity::from_si(0.0),
            ..rolling()
        },
        FilmConditions {
            density: Density::from_si(f64::NAN),
            ..rolling()
        },
    ] {
        for model in [FluidModel::ReynoldsCross, FluidModel::Paper] {
            assert!(pressure_difference_across(model, &bad).is_err(), "{bad:?}");
        }
    }
}

#[test]
fn impossible_gaps_are_named() {
    let film = |x: &[f64], h: &[f64], u: f64| {
        film_pressure(
            x,
            h,
            Speed::from_si(u),
            DynamicViscosity::from_si(0.01),
            Rupture::Reynolds,
        )
    };
    let (x, h) = ([0.0, 1.0, 2.0], [1e-6, 1e-6, 1e-6]);
    for (refused, expected) in [
        (
            film(&x[..2], &h[..2], 1.0),
            "2 points are too few for a film: give at least 3",
        ),
        (
            film(&x, &h[..2], 1.0),
            "gap has 2 values where 3 are needed",
        ),
        (
            film(&x, &[1e-6, 0.0, 1e-6], 1.0),
            "gap[1] = 0 m: must be finite and greater than zero",
        ),
        (
            film(&[0.0, 2.0, 2.0], &h, 1.0),
            "position[2] = 2 m: must rise",
        ),
    ] {
        assert_eq!(refused.unwrap_err().to_string(), expected);
    }
    assert!(film(&[0.0, f64::NAN, 2.0], &h, 1.0).is_err());
    assert!(film(&x, &h, 0.0).is_err());
    // Parallel walls carry nothing.
    assert_eq!(film(&x, &h, 1.0).unwrap().load.si(), 0.0);
}
