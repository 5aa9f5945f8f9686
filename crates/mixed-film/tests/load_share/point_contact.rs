//! Film and friction at a point against an independent program (`references/point_film.py`), closed forms and bounds.

use std::f64::consts::PI;
use std::num::NonZeroUsize;

use asperity_core::quantity::{
    Density, Force, KinematicViscosity, Length, PerKelvin, Pressure, PressureViscosity, Speed,
    Temperature, ThermalConductivity,
};
use asperity_mixed_film::PointContact;
use asperity_oil::{
    BaseOil, FilmRheology, Lubricant, LubricantInput, PressureLaw, ShearLawName, TractionConstants,
    ViscosityLaw,
};
use asperity_tribo_friction::{FilmFrictionSolution, FilmHeat, FilmSettings};
use proptest::prelude::*;
use serde_json::Value;

use crate::STEEL;

const MODULUS: f64 = 210e9 / 2.0 / 0.91;

fn lubricant(nu: [f64; 2], density: f64) -> Lubricant {
    LubricantInput {
        viscosity: Some(ViscosityLaw::AstmD341 {
            at_40: KinematicViscosity::from_si(nu[0] * 1e-6),
            at_100: KinematicViscosity::from_si(nu[1] * 1e-6),
        }),
        density: Some(Density::from_si(density)),
        thermal_expansion: Some(PerKelvin::from_si(0.63 / density)),
        pressure_viscosity: Some(PressureViscosity::from_si(1e-8)),
        ..LubricantInput::default()
    }
    .resolve(Temperature::from_celsius(90.0))
    .unwrap()
}

/// Oils of the reference values, with the constants that they have.
fn oil(name: &str) -> FilmRheology {
    let (nu, density, family, eyring) = match name {
        "M100" => ([96.0, 10.6], 882.0, BaseOil::Mineral, 5e6),
        "PAO100" => ([94.1, 14.0], 840.0, BaseOil::Pao, 4e6),
        _ => ([30.8, 5.9], 845.0, BaseOil::Pao, 4e6),
    };
    let mut constants = TractionConstants {
        eyring_stress: Pressure::from_si(eyring),
        ..TractionConstants::from_family(family).unwrap()
    };
    if family == BaseOil::Mineral {
        constants.conductivity = ThermalConductivity::from_si(0.137);
        (constants.conductivity_rise, constants.conductivity_bend) = (1.72, 0.54);
    }
    let rheology = FilmRheology::new(&lubricant(nu, density), family).unwrap();
    rheology.with_constants(constants).unwrap()
}

/// A ball of 19.05 mm on a disc.
fn ball(load: f64, entrainment: f64, slide_to_roll: f64, celsius: f64) -> PointContact {
    PointContact {
        load: Force::from_si(load),
        radii: [Length::from_si(9.525e-3); 2],
        modulus: Pressure::from_si(MODULUS),
        entrainment: Speed::from_si(entrainment),
        slide_to_roll,
        bodies: [STEEL, STEEL],
        temperature: Temperature::from_celsius(celsius),
        bulk_rise: 0.0,
    }
}

fn solved(
    oil: &FilmRheology,
    contact: &PointContact,
    film: Option<f64>,
    nodes: usize,
    heat: FilmHeat,
) -> FilmFrictionSolution {
    let hertz = contact.hertz().unwrap();
    let film = film.map(Length::from_si).unwrap_or_else(|| {
        let film = contact.film(oil, hertz.max_pressure).unwrap().value;
        film.thickness
    });
    let nodes = NonZeroUsize::new(nodes).unwrap();
    let settings = FilmSettings { nodes, heat };
    contact.friction(oil, &hertz, film, settings).unwrap().value
}

fn isothermal(oil: &FilmRheology, contact: &PointContact, film: f64) -> f64 {
    solved(oil, contact, Some(film), 96, FilmHeat::Isothermal).coefficient
}

#[test]
fn film_and_friction_of_fourteen_contacts_at_a_point() {
    let golden: Value = serde_json::from_str(include_str!("../golden/point_film.json")).unwrap();
    let conditions = golden["conditions"].as_array().unwrap();
    assert_eq!(conditions.len(), 14);
    for c in conditions {
        let of = |key: &str| c[key].as_f64().unwrap();
        let oil = oil(c["oil"].as_str().unwrap());
        let contact = PointContact {
            radii: [of("Rx_m"), of("Ry_m")].map(Length::from_si),
            ..ball(of("F_N"), of("Ve"), of("SRR"), of("T_C"))
        };
        let hertz = contact.hertz().unwrap();
        let film = contact.film(&oil, hertz.max_pressure).unwrap().value;
        let heated = solved(&oil, &contact, None, 96, FilmHeat::FilmAndSurfaces);
        let cold = solved(&oil, &contact, None, 96, FilmHeat::Isothermal);
        for (what, seen, expected) in [
            ("a", hertz.half_axes[0].si(), of("a_m")),
            ("b", hertz.half_axes[1].si(), of("b_m")),
            ("p0", hertz.max_pressure.si(), of("p0_Pa")),
            ("thermal reduction", film.thermal_reduction, of("phi_T")),
            ("film", film.thickness.si(), of("h_m")),
            ("mu", heated.coefficient, of("mu")),
            ("isothermal", cold.coefficient, of("mu_isothermal")),
            ("surface rise", heated.surface_rise, of("dT_surface")),
            ("film rise", heated.largest_film_rise, of("dT_film_max")),
        ] {
            let off = seen / expected - 1.0;
            // The program takes the temperature coefficient by a difference over 0.02 K, which misses the slope of a
            // cold oil by 1e-8.
            let tolerance = match what {
                "thermal reduction" | "film" | "film rise" => 3e-9,
                _ => 1e-9,
            };
            assert!(
                off.abs() < tolerance,
                "{} {what}: {seen:e}, {off:e}",
                c["case"]
            );
        }
        // Sixteen nodes: 2e-5.
        let coarse = solved(&oil, &contact, None, 16, FilmHeat::FilmAndSurfaces).coefficient;
        assert!(
            (coarse / of("mu") - 1.0).abs() < 2e-5,
            "{}: {coarse}",
            c["case"]
        );
    }
}

/// Constants without a limit that matters.
fn unlimited(name: &str) -> FilmRheology {
    let oil = oil(name);
    let constants = TractionConstants {
        limiting_shear: 1e9,
        ..*oil.constants()
    };
    oil.with_constants(constants).unwrap()
}

#[test]
fn a_newtonian_isothermal_film_at_a_point_has_its_closed_form() {
    // mu = (3/p0) eta0 (Vs/h) [(x - 1) e^x + 1]/x^2, x = alpha p0.
    let film = 100e-9;
    let newton = unlimited("M100").with_laws(ShearLawName::Newton, PressureLaw::Barus);
    let expected = |contact: &PointContact| {
        let state = newton.state(contact.temperature).unwrap();
        let p0 = contact.hertz().unwrap().max_pressure.si();
        let x = state.pressure_viscosity.si() * p0;
        let integral = ((x - 1.0) * x.exp() + 1.0) / (x * x);
        let rate = 2.0 * contact.slide_to_roll / film;
        3.0 / p0 * state.viscosity.si() * rate * integral
    };
    for load in [3.0, 30.0] {
        let contact = ball(load, 2.0, 0.25, 90.0);
        let off = isothermal(&newton, &contact, film) / expected(&contact) - 1.0;
        // Logarithms of the viscosity and the rate, about 20, are rounded before the exponential.
        assert!(off.abs() < 1e-13, "{load}: {off:e}");
    }
    // At rest Eyring's law has the slope of Newton's; it differs by the square of the rate, here 1e-12.
    let slow = ball(3.0, 2.0, 1e-7, 90.0);
    let off = isothermal(&unlimited("M100"), &slow, film) / expected(&slow) - 1.0;
    assert!(off.abs() < 1e-8, "{off:e}");
    let rest = isothermal(&oil("M100"), &ball(30.0, 2.0, 0.0, 90.0), film);
    assert_eq!(rest, 0.0);
}

#[test]
fn friction_at_a_point_is_a_line_over_the_logarithm_of_the_sliding_speed() {
    // mu = alpha tau0 + (tau0/p_mean) ln(2 eta0 Vs/(tau0 h)), p_mean = 2 p0/3, where the whole area is far above tau0.
    let film = 1e-9;
    let oil = unlimited("M100");
    let contact = ball(300.0, 2.0, 1.0, 60.0);
    let state = oil.state(contact.temperature).unwrap();
    let mean = 2.0 / 3.0 * contact.hertz().unwrap().max_pressure.si();
    let stress = 5e6;
    let rate = 2.0 * state.viscosity.si() * 2.0 / (stress * film);
    let expected = state.pressure_viscosity.si() * stress + stress / mean * rate.ln();
    let mu = isothermal(&oil, &contact, film);
    // ln(2 x) differs from arsinh x by 1/(4 x²); x at the rim is 26.
    assert!((mu / expected - 1.0).abs() < 1e-5, "{mu} {expected}");
}

#[test]
fn at_high_slip_friction_at_a_point_is_the_limiting_stress_over_the_mean_pressure() {
    let of = oil("M100");
    for fall in [0.0, 0.004, -0.004] {
        let constants = TractionConstants {
            limiting_shear_fall: PerKelvin::from_si(fall),
            ..*of.constants()
        };
        let oil = of.clone().with_constants(constants).unwrap();
        let oil = oil.with_laws(ShearLawName::Newton, PressureLaw::Barus);
        let contact = ball(30.0, 2.0, 1.9, -20.0);
        let mean = 2.0 / 3.0 * contact.hertz().unwrap().max_pressure.si();
        let expected = 0.047 * (-fall * (253.15_f64 - 363.15)).exp() + 2e6 / mean;
        let mu = isothermal(&oil, &contact, 1e-10);
        assert!(
            (mu / expected - 1.0).abs() < 1e-12,
            "{fall}: {mu} {expected}"
        );
    }
}

#[test]
fn a_limit_that_rises_with_the_temperature_leaves_one_solution() {
    let oil = oil("M100");
    let constants = TractionConstants {
        limiting_shear_fall: PerKelvin::from_si(-0.01),
        ..*oil.constants()
    };
    let rising = oil.clone().with_constants(constants).unwrap();
    let contact = ball(60.0, 2.0, 0.3, 20.0);
    let plain = solved(&oil, &contact, None, 32, FilmHeat::FilmAndSurfaces);
    let found = solved(&rising, &contact, None, 32, FilmHeat::FilmAndSurfaces);
    assert!(
        found.surface_rise > 0.0 && found.evidence.iterations < 20,
        "{found:?} {plain:?}"
    );
    // Below 90 °C the limit of the rising law is lower.
    assert!(found.coefficient < plain.coefficient);
}

#[test]
fn the_factor_of_friction_leaves_the_film_and_multiplies_alpha() {
    let oil = oil("e-fluid");
    let constants = TractionConstants {
        pressure_viscosity_factor: 0.9,
        ..*oil.constants()
    };
    let contact = ball(30.0, 2.0, 0.5, 90.0);
    let p0 = contact.hertz().unwrap().max_pressure;
    for law in [PressureLaw::Barus, PressureLaw::Roelands] {
        let own = oil.clone().with_laws(ShearLawName::Eyring, law);
        let less = own.clone().with_constants(constants).unwrap();
        let film = contact.film(&own, p0).unwrap().value.thickness;
        assert_eq!(contact.film(&less, p0).unwrap().value.thickness, film);
        let factored = isothermal(&less, &contact, film.si());
        let whole = isothermal(&own.with_alpha_factor(0.9), &contact, film.si());
        assert!((factored / whole - 1.0).abs() < 1e-14);
    }
}

#[test]
fn a_flat_ellipse_rubs_like_the_lines_that_it_consists_of() {
    // tau ~ p: strips of an ellipse and of a line have the same friction coefficient.
    let oil = unlimited("M100").with_laws(ShearLawName::Newton, PressureLaw::Barus);
    let contact = PointContact {
        radii: [Length::from_si(0.01), Length::from_si(1.0)],
        ..ball(400.0, 2.0, 0.1, 90.0)
    };
    let hertz = contact.hertz().unwrap();
    let [a, b] = hertz.half_axes.map(Length::si);
    let solution = solved(&oil, &contact, Some(1e-7), 32, FilmHeat::FilmAndSurfaces);
    let force = solution.mean_stress.si() * PI * a * b;
    assert!((force / (solution.coefficient * 400.0) - 1.0).abs() < 1e-12);
    assert_eq!(solution.half_width, hertz.half_axes[0]);
}

#[test]
fn both_laws_of_pressure_on_200_points_take_less_than_a_second() {
    let begin = std::time::Instant::now();
    for law in [PressureLaw::Barus, PressureLaw::Roelands] {
        let oil = oil("M100").with_laws(ShearLawName::Eyring, law);
        for k in 0..200 {
            let contact = ball(20.0 + f64::from(k), 2.0, 0.005 * f64::from(k + 1), 90.0);
            let mu = solved(&oil, &contact, None, 16, FilmHeat::FilmAndSurfaces).coefficient;
            assert!(mu > 0.0);
        }
    }
    assert!(begin.elapsed().as_secs_f64() < 1.0);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn friction_at_a_point_keeps_its_bounds_and_symmetries(
        load in 5.0..200.0,
        speed in 0.2..5.0,
        slide in 0.005..1.9,
        celsius in 0.0..130.0,
        ratio in 0.2..5.0,
        family in 0..2,
    ) {
        let oil = oil(["M100", "e-fluid"][family as usize]);
        let contact = PointContact {
            radii: [9.525e-3, 9.525e-3 * ratio].map(Length::from_si),
            ..ball(load, speed, slide, celsius)
        };
        let hertz = contact.hertz().unwrap();
        let film = contact.film(&oil, hertz.max_pressure).unwrap().value.thickness.si();
        let of = |contact: &PointContact, heat| solved(&oil, contact, Some(film), 16, heat);
        let heated = of(&contact, FilmHeat::FilmAndSurfaces);
        let mean = 2.0 / 3.0 * hertz.max_pressure.si();
        let most = oil.constants().limiting_shear + 2e6 / mean;
        prop_assert!(heated.coefficient > 0.0 && heated.coefficient < most);
        prop_assert!(heated.surface_rise > 0.0);
        let mirrored = PointContact { slide_to_roll: -slide, ..contact };
        let other = of(&mirrored, FilmHeat::FilmAndSurfaces);
        prop_assert!((other.coefficient / heated.coefficient - 1.0).abs() < 1e-12);
        prop_assert!(of(&contact, FilmHeat::Isothermal).coefficient > heated.coefficient);
        let warmer = PointContact { bulk_rise: 0.5, ..contact };
        prop_assert!(of(&warmer, FilmHeat::FilmAndSurfaces).coefficient < heated.coefficient);
        let hotter = PointContact { temperature: Temperature::from_celsius(celsius + 5.0), ..contact };
        prop_assert!(of(&hotter, FilmHeat::FilmAndSurfaces).coefficient < heated.coefficient);
    }
}
