//! The film law against independent programs (`references/film_friction.py`), its limits, and what must hold whatever the numbers.
//!
//! | what must hold | test |
//! |---|---|
//! | even in V_s, bodies change places, heat only lowers μ, falls with T₀ at a given film, at most Λ + 2 a τ_L0/w | `film_friction_keeps_its_bounds_and_symmetries` |
//! | μ V_s never falls, isothermally | `the_isothermal_loss_never_falls_with_sliding` |
//! | 0 at V_s = 0, Newton's slope there, residuals of stress and temperature at exit | `film_friction_solves_its_equations_and_is_newtons_at_rest` |
//! | units do not matter | `units_do_not_matter` |
//! | closed forms of slow and of fast sliding | `a_newtonian_isothermal_film_has_its_closed_form`, `at_high_slip_the_coefficient_is_the_limiting_shear` |
//! | fourteen conditions to 1e-8 | `film_friction_of_fourteen_conditions` |
//! | the parts of the powers add up | `three_parts_add_up` |

#![allow(
    clippy::unwrap_used,
    reason = "helpers of tests may unwrap as tests do"
)]

use asperity_core::line_contact::LineContact;
use asperity_core::material::Material;
use asperity_core::quantity::{
    Density, DynamicViscosity, KinematicViscosity, Length, LineLoad, PerKelvin, Pressure,
    PressureViscosity, SpecificHeat, Speed, Temperature, ThermalConductivity,
};
use asperity_oil::{
    BaseOil, CarreauConstants, FilmRheology, LubricantInput, PressureLaw, ShearLawName,
    TractionConstants, ViscosityLaw,
};
use asperity_tribo_friction::boundary::{SharedFriction, boundary_share};
use asperity_tribo_friction::film_friction::{LoadedFilm, solve};
use asperity_tribo_friction::{
    FilmFrictionSolution, FilmHeat, FilmLineContact, FilmRipple, FilmSettings,
};
use proptest::prelude::*;
use serde_json::Value;
use std::num::NonZeroUsize;

const STEEL: Material = Material {
    young: Pressure::from_si(210e9),
    poisson: 0.3,
    elastic_limit: Pressure::from_si(1.5e9),
    density: Density::from_si(7830.0),
    conductivity: ThermalConductivity::from_si(45.0),
    heat_capacity: SpecificHeat::from_si(465.0),
};
/// Reduced modulus of steel on steel.
const MODULUS: f64 = 210e9 / 2.0 / 0.91;

fn celsius(value: f64) -> Temperature {
    Temperature::from_si(value + 273.15)
}

/// Data sheet of an oil whose density falls by 0.63 kg/m³ per kelvin.
fn lubricant(nu: [f64; 2], density: f64) -> asperity_oil::Lubricant {
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
    .resolve(celsius(90.0))
    .unwrap()
}

/// An oil of the reference values, with the Eyring stress and the conductivity that they have.
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

fn settings(nodes: usize, heat: FilmHeat) -> FilmSettings {
    FilmSettings {
        nodes: NonZeroUsize::new(nodes).unwrap(),
        heat,
    }
}

fn friction(oil: &FilmRheology, contact: &FilmLineContact, nodes: usize) -> FilmFrictionSolution {
    solve(oil, contact, settings(nodes, FilmHeat::FilmAndSurfaces))
        .unwrap()
        .value
}

fn isothermal(oil: &FilmRheology, contact: &FilmLineContact, nodes: usize) -> f64 {
    solve(oil, contact, settings(nodes, FilmHeat::Isothermal))
        .unwrap()
        .value
        .coefficient
}

/// 144 N/mm on 4.5 mm radius at 6.5 m/s and 0.15 um film.
fn e_drive(slide_to_roll: f64) -> FilmLineContact {
    FilmLineContact {
        line: LineContact {
            load: LineLoad::from_si(144e3),
            radius: Length::from_si(4.5e-3),
            modulus: Pressure::from_si(MODULUS),
            speeds: speeds(6.5, slide_to_roll),
            bodies: [STEEL, STEEL],
        },
        film: Length::from_si(0.15e-6),
        temperature: celsius(90.0),
    }
}

fn speeds(entrainment: f64, slide_to_roll: f64) -> [Speed; 2] {
    [1.0, -1.0].map(|sign| Speed::from_si(entrainment * (1.0 + 0.5 * sign * slide_to_roll)))
}

fn golden() -> Vec<Value> {
    let file: Value = serde_json::from_str(include_str!("golden/film_friction.json")).unwrap();
    file["conditions"].as_array().unwrap().clone()
}

fn contact_of(of: &dyn Fn(&str) -> f64) -> FilmLineContact {
    FilmLineContact {
        line: LineContact {
            load: LineLoad::from_si(of("w_N_per_m")),
            radius: Length::from_si(of("R_m")),
            modulus: Pressure::from_si(MODULUS),
            speeds: speeds(of("Ve"), of("SRR")),
            bodies: [STEEL, STEEL],
        },
        film: Length::from_si(of("h_m")),
        temperature: celsius(of("T_C")),
    }
}

#[test]
fn film_friction_of_fourteen_conditions() {
    let close = |case: &str, what: &str, seen: f64, expected: f64, tolerance: f64| {
        assert!(
            (seen / expected - 1.0).abs() < tolerance,
            "{case} {what}: {seen:e} instead of {expected:e}"
        );
    };
    let golden = golden();
    assert_eq!(golden.len(), 14);
    for c in golden {
        let of = |key: &str| c[key].as_f64().unwrap();
        let case = c["case"].as_str().unwrap();
        let rheology = oil(c["oil"].as_str().unwrap());
        let state = rheology.state(celsius(of("T_C"))).unwrap();
        // Printed with eleven digits; the table of viscosities keeps 1e-10.
        close(case, "eta0", state.viscosity.si(), of("eta0"), 1e-9);
        close(
            case,
            "alpha",
            state.pressure_viscosity.si(),
            of("alpha"),
            1e-9,
        );
        let contact = contact_of(&of);
        let heated = friction(&rheology, &contact, 32);
        close(case, "mu", heated.coefficient, of("mu"), 1e-8);
        close(
            case,
            "surface rise",
            heated.surface_rise,
            of("dT_surface"),
            1e-8,
        );
        close(
            case,
            "film rise",
            heated.largest_film_rise,
            of("dT_film_max"),
            1e-8,
        );
        let fine = friction(&rheology, &contact, 96).coefficient;
        close(case, "mu, 96 nodes", fine, of("mu_n96"), 1e-8);
        let cold = isothermal(&rheology, &contact, 32);
        close(case, "isothermal", cold, of("mu_isothermal"), 1e-8);
        // Sixteen nodes: 1.3e-5 in case m2, 4e-6 in e2, below 1e-6 else.
        let coarse = friction(&rheology, &contact, 16).coefficient;
        close(case, "mu, 16 nodes", coarse, of("mu_n96"), 2e-5);
    }
}

#[test]
fn a_newtonian_isothermal_film_has_its_closed_form() {
    // mu = eta0 V_s/h (2a/w) (pi/2) [I1(x) + L_-1(x)], x = alpha p0, by the series of I1 and L_-1.
    let (mut first, mut struve) = (0.0, 0.0);
    let limits = TractionConstants {
        limiting_shear: 1e9,
        ..TractionConstants::from_family(BaseOil::Pao).unwrap()
    };
    let rheology = oil("e-fluid")
        .with_constants(limits)
        .unwrap()
        .with_laws(ShearLawName::Newton, PressureLaw::Barus);
    let contact = e_drive(1e-6);
    let state = rheology.state(contact.temperature).unwrap();
    let solution = solve(&rheology, &contact, settings(96, FilmHeat::Isothermal))
        .unwrap()
        .value;
    let x = state.pressure_viscosity.si() * solution.max_pressure.si();
    let half = 0.5 * x;
    // Terms (x/2)^(2k+1)/(k! (k+1)!) and (x/2)^(2k)/(Γ(k+1/2) Γ(k+3/2)).
    let root_pi = std::f64::consts::PI.sqrt();
    let (mut one, mut two) = (half, 1.0 / (root_pi * 0.5 * root_pi));
    for k in 0..80 {
        first += one;
        struve += two;
        let k = f64::from(k);
        one *= half * half / ((k + 1.0) * (k + 2.0));
        two *= half * half / ((k + 0.5) * (k + 1.5));
    }
    let sliding = (contact.line.speeds[0].si() - contact.line.speeds[1].si()).abs();
    let expected =
        state.viscosity.si() * sliding / contact.film.si() * 2.0 * solution.half_width.si()
            / contact.line.load.si()
            * 0.5
            * std::f64::consts::PI
            * (first + struve);
    // tau_L = 1e9 p leaves 1e-36 of the fourth power; the quadrature is spectral.
    assert!(
        (solution.coefficient / expected - 1.0).abs() < 1e-9,
        "{} {expected}",
        solution.coefficient
    );
    // Slow sliding of Eyring's law is Newton's.
    let eyring = oil("e-fluid").with_constants(limits).unwrap();
    let slow = isothermal(&eyring, &e_drive(1e-7), 96);
    assert!((slow / (0.1 * expected) - 1.0).abs() < 1e-5);
}

#[test]
fn at_high_slip_the_coefficient_is_the_limiting_shear() {
    let constants = TractionConstants {
        ambient_limit: Pressure::from_si(0.0),
        ..TractionConstants::from_family(BaseOil::Mineral).unwrap()
    };
    let rheology = oil("M100")
        .with_constants(constants)
        .unwrap()
        .with_laws(ShearLawName::Newton, PressureLaw::Roelands);
    let mut contact = e_drive(1.9);
    contact.film = Length::from_si(1e-9);
    contact.temperature = celsius(-40.0);
    let mu = isothermal(&rheology, &contact, 32);
    // Newton's stress is 1e12 limits and more; at the rim of the contact, where p is 0.02 p0, still 1e3.
    assert!((mu / 0.047 - 1.0).abs() < 1e-10, "{mu}");
}

#[test]
fn the_limiting_stress_falls_with_temperature_from_90_c() {
    let constants = TractionConstants {
        ambient_limit: Pressure::from_si(0.0),
        limiting_shear_fall: PerKelvin::from_si(0.005),
        ..TractionConstants::from_family(BaseOil::Mineral).unwrap()
    };
    let rheology = oil("M100")
        .with_constants(constants)
        .unwrap()
        .with_laws(ShearLawName::Newton, PressureLaw::Roelands);
    let mut contact = e_drive(1.9);
    contact.film = Length::from_si(1e-10);
    for t in [40.0, 90.0] {
        contact.temperature = celsius(t);
        let mu = isothermal(&rheology, &contact, 32);
        let expected = 0.047 * (-0.005 * (t - 90.0_f64)).exp();
        assert!((mu / expected - 1.0).abs() < 1e-6, "{t}: {mu} {expected}");
    }
}

#[test]
fn a_slow_film_is_newtonian_whatever_its_eyring_stress() {
    let contact = e_drive(1e-7);
    let of = |stress: f64| {
        let constants = TractionConstants {
            eyring_stress: Pressure::from_si(stress),
            ..TractionConstants::from_family(BaseOil::Pao).unwrap()
        };
        isothermal(
            &oil("e-fluid").with_constants(constants).unwrap(),
            &contact,
            16,
        )
    };
    assert!((of(2e6) / of(20e6) - 1.0).abs() < 1e-4);
}

#[test]
fn what_a_solution_says_of_its_stress_and_heat_agrees() {
    for (slip, limited) in [(1e-6, 0.0), (1.9, 1.0)] {
        let mut contact = e_drive(slip);
        if limited > 0.0 {
            contact.film = Length::from_si(1e-9);
            contact.temperature = celsius(0.0);
        }
        let found = friction(&oil("M100"), &contact, 16);
        assert_eq!(found.limited_share, limited, "{found:?}");
    }
    let found = friction(&oil("M100"), &e_drive(0.4), 16);
    assert!((0.0..=1.0).contains(&found.limited_share));
    assert!(found.mean_film_rise > 0.0 && found.mean_film_rise <= found.largest_film_rise);
    let force = found.mean_stress.si() * 2.0 * found.half_width.si();
    assert!((force / (found.coefficient * 144e3) - 1.0).abs() < 1e-12);
}

#[test]
fn constants_that_no_oil_has_are_refused_by_name() {
    let good = TractionConstants::from_family(BaseOil::Mineral).unwrap();
    let mut all = [good; 7];
    all[0].limiting_shear = 0.0;
    all[1].limiting_shear_fall = PerKelvin::from_si(-0.03);
    all[2].ambient_limit = Pressure::from_si(-1.0);
    all[3].eyring_stress = Pressure::from_si(0.0);
    all[4].gold_exponent = f64::NAN;
    all[5].conductivity_rise = -1.0;
    all[6].pressure_viscosity_factor = 0.0;
    let names = [
        "limiting shear stress over pressure",
        "fall of the limiting shear",
        "limiting shear stress at p = 0",
        "Eyring stress",
        "Gold exponent t",
        "conductivity rise c1",
        "pressure-viscosity factor",
    ];
    for (constants, name) in all.into_iter().zip(names) {
        let error = oil("M100").with_constants(constants).unwrap_err();
        assert!(error.to_string().contains(name), "{error}");
    }
}

#[test]
fn without_sliding_there_is_no_friction() {
    let solution = friction(&oil("e-fluid"), &e_drive(0.0), 16);
    assert_eq!((solution.coefficient, solution.surface_rise), (0.0, 0.0));
}

/// The law of a film at the temperature to which the shear stress `tau` \[Pa\] heats it between walls at `wall`.
fn law_at(
    rheology: &FilmRheology,
    pressure: Pressure,
    wall: Temperature,
    contact: &FilmLineContact,
    tau: f64,
) -> f64 {
    let [u1, u2] = contact.line.speeds.map(Speed::si);
    let point = rheology.film_point(pressure.si(), (u1 - u2).abs(), contact.film.si());
    let at = wall.si() + point.heating() * tau;
    let (law, _) = rheology
        .heated_stress(&point.isothermal(), at, None)
        .unwrap();
    law.value
}

#[test]
fn the_roots_of_stress_and_temperature_leave_no_residual() {
    for c in golden() {
        let rheology = oil(c["oil"].as_str().unwrap());
        let contact = contact_of(&|key| c[key].as_f64().unwrap());
        let solution = friction(&rheology, &contact, 16);
        let mut film = LoadedFilm::new(&rheology, &contact, FilmSettings::default()).unwrap();
        let rise = film.surface_rise(solution.coefficient);
        assert_eq!(rise, solution.surface_rise);
        let [again, _] = film.friction_at(rise).unwrap();
        // The last Newton steps, 1e-9 of the friction and 1e-6 of the stresses, leave their squares.
        assert!(
            (again / solution.coefficient - 1.0).abs() < 1e-13,
            "{}",
            c["case"]
        );
        assert!(
            solution.evidence.iterations <= 8,
            "{}: {:?}",
            c["case"],
            solution.evidence
        );
        let wall = Temperature::from_si(contact.temperature.si() + rise);
        let sliding = Speed::from_si(contact.line.speeds[0].si() - contact.line.speeds[1].si());
        let tau = rheology
            .shear_stress(solution.max_pressure, wall, sliding, contact.film)
            .unwrap();
        let law = law_at(&rheology, solution.max_pressure, wall, &contact, tau.value);
        assert!(
            (law / tau.value - 1.0).abs() < 1e-11 && tau.iterations <= 6,
            "{tau:?}, {law}"
        );
    }
}

#[test]
fn the_slope_over_surface_temperature_is_that_of_the_friction() {
    for (shear, pressure) in [
        (ShearLawName::Eyring, PressureLaw::Barus),
        (ShearLawName::Eyring, PressureLaw::Roelands),
        (ShearLawName::Carreau, PressureLaw::Roelands),
        (ShearLawName::Newton, PressureLaw::Barus),
    ] {
        // A limiting stress that falls with temperature adds its own slope.
        let constants = TractionConstants {
            limiting_shear_fall: PerKelvin::from_si(0.004),
            ..TractionConstants::from_family(BaseOil::Mineral).unwrap()
        };
        let rheology = oil("M100").with_constants(constants).unwrap();
        let rheology = rheology.with_laws(shear, pressure);
        let contact = e_drive(0.3);
        let mut film = LoadedFilm::new(&rheology, &contact, FilmSettings::default()).unwrap();
        let [_, slope] = film.friction_at(10.0).unwrap();
        let [high, _] = film.friction_at(10.05).unwrap();
        let [low, _] = film.friction_at(9.95).unwrap();
        // Central difference over 0.1 K: 1e-6 of the slope.
        let numeric = (high - low) / 0.1;
        assert!(
            (slope / numeric - 1.0).abs() < 1e-5,
            "{shear:?} {pressure:?}: {slope} {numeric}"
        );
    }
}

#[test]
fn a_film_with_a_share_of_the_load_is_a_hertz_contact_of_that_share_and_half_width() {
    let (rheology, contact) = (oil("M100"), e_drive(0.3));
    let loaded = |line, share: f64| {
        let contact = FilmLineContact { line, ..contact };
        let mut film = LoadedFilm::new(&rheology, &contact, FilmSettings::default()).unwrap();
        film.carry(share).unwrap();
        film
    };
    let mut whole = LoadedFilm::new(&rheology, &contact, FilmSettings::default()).unwrap();
    let rise = 7.0;
    let all = whole.friction_at(rise).unwrap();
    assert_eq!(loaded(contact.line, 1.0).friction_at(rise).unwrap(), all);
    assert_eq!(
        loaded(contact.line, 1.0).surface_rise(0.05),
        whole.surface_rise(0.05)
    );
    for share in [0.9, 0.4, 0.01] {
        let lighter = LineContact {
            load: contact.line.load * share,
            radius: contact.line.radius / share,
            ..contact.line
        };
        let [found, slope] = loaded(contact.line, share).friction_at(rise).unwrap();
        let [expected, expected_slope] = loaded(lighter, 1.0).friction_at(rise).unwrap();
        assert!((found / expected - 1.0).abs() < 1e-12, "{share}");
        assert!((slope / expected_slope - 1.0).abs() < 1e-9, "{share}");
        // The surfaces are heated by the friction of the whole load.
        assert_eq!(
            loaded(contact.line, share).surface_rise(0.05),
            whole.surface_rise(0.05)
        );
    }
    for share in [0.0, 1.1, f64::NAN] {
        assert!(whole.carry(share).is_err(), "{share}");
        assert!(whole.carry_rippled(share, &[]).is_err(), "{share}");
    }
    assert!(whole.carry_rippled(0.5, &[]).is_err());
}

#[test]
fn a_rippled_film_shears_as_its_parts_do() {
    let contact = e_drive(0.3);
    let film = contact.film.si();
    let ripple = |parts: &[[f64; 2]], size: f64| -> Vec<FilmRipple> {
        let area = 1.0 / parts.len() as f64;
        let part = |[pressure, thinner]: &[f64; 2]| FilmRipple {
            area,
            pressure: size * pressure,
            film: film * (1.0 - size * 1e-9 * thinner),
        };
        parts.iter().map(part).collect()
    };
    // Peaks, whose film is thinner, and long shallow valleys.
    let parts: Vec<[f64; 2]> = (0..24)
        .map(|k| {
            let x = (f64::from(k) + 0.5) / 24.0;
            [-(1.0 - x).ln() - 1.0, 0.3 * (x - 0.5)]
        })
        .collect();
    for (name, load) in [("e-fluid", 1.0), ("e-fluid", 0.15), ("M100", 1.0)] {
        let rheology = oil(name);
        let line = LineContact {
            load: contact.line.load * load,
            ..contact.line
        };
        let contact = FilmLineContact { line, ..contact };
        let settings = FilmSettings {
            heat: FilmHeat::Isothermal,
            ..FilmSettings::default()
        };
        let p0 = 2.0 * line.load.si() / std::f64::consts::PI / {
            let product = 4.0 * line.load.si() * line.radius.si();
            (product / (std::f64::consts::PI * line.modulus.si())).sqrt()
        };
        let friction = |share: f64, parts: &[FilmRipple]| {
            let mut film = LoadedFilm::new(&rheology, &contact, settings).unwrap();
            film.carry_rippled(share, parts).unwrap();
            film.friction_at(0.0).unwrap()[0]
        };
        let sliding = (line.speeds[0].si() - line.speeds[1].si()).abs();
        for share in [1.0, 0.7] {
            let mut even = LoadedFilm::new(&rheology, &contact, settings).unwrap();
            even.carry(share).unwrap();
            let [even, _] = even.friction_at(0.0).unwrap();
            // Six places differ from the sixteen of an even film by 8.5e-4 at most in these contacts.
            let flat = friction(share, &ripple(&parts, 0.0)) / even;
            assert!((flat - 1.0).abs() < 1e-3, "{name} {share}: {flat}");
            for size in [0.03e9, 0.2e9, 0.5e9] {
                let parts = ripple(&parts, size);
                // Every part at 200 places, with the pressure that holds the load of each place.
                let (mut stress, mut weight) = (0.0, 0.0);
                for place in 0..200 {
                    let x = (f64::from(place) + 0.5) / 200.0;
                    let mean = share * p0 * (1.0 - x * x).sqrt();
                    let load = |offset: f64| -> f64 {
                        let of = |part: &FilmRipple| {
                            (mean + share * share * part.pressure + offset).max(0.0)
                        };
                        parts.iter().map(|part| part.area * of(part)).sum()
                    };
                    let [mut low, mut high] = [-10e9, 10e9];
                    for _ in 0..80 {
                        let middle = 0.5 * (low + high);
                        if load(middle) < mean {
                            low = middle
                        } else {
                            high = middle
                        }
                    }
                    for part in &parts {
                        let pressure = (mean + share * share * part.pressure + low).max(0.0);
                        let point = rheology
                            .film_point(pressure, sliding, part.film)
                            .isothermal();
                        let wall = contact.temperature.si();
                        let (found, _) = rheology.heated_stress(&point, wall, None).unwrap();
                        stress += part.area * found.value;
                    }
                    weight += mean;
                }
                let found = friction(share, &parts) / (stress / weight);
                assert!(
                    (found - 1.0).abs() < 0.01,
                    "{name} {load} {share} {size}: {found}"
                );
            }
        }
    }
}

#[test]
fn viscosity_rises_with_pressure_by_the_law_asked_for() {
    let (pressure, alpha, sliding, film) = (0.4e9_f64, 1e-8, 1e-6, 1e-6);
    let constants = TractionConstants::from_family(BaseOil::Mineral).unwrap();
    let stress = |law, pressure| {
        let rheology = FilmRheology::with_alpha(
            &lubricant([96.0, 10.6], 882.0),
            constants,
            PressureViscosity::from_si(alpha),
            celsius(90.0),
        );
        let rheology = rheology.unwrap().with_laws(ShearLawName::Newton, law);
        let found = rheology.shear_stress(
            Pressure::from_si(pressure),
            celsius(90.0),
            Speed::from_si(sliding),
            Length::from_si(film),
        );
        found.unwrap().value
    };
    let log_0 = stress(PressureLaw::Barus, 1.0).ln();
    let rise = |law| stress(law, pressure).ln() - log_0;
    assert!((rise(PressureLaw::Barus) / (alpha * pressure) - 1.0).abs() < 1e-6);
    // Roelands in closed form, with ln eta_0 + 9.67 = ln(eta_0/6.315e-5 Pa s).
    let growth = log_0 + 9.67;
    let z = alpha / (5.1e-9 * growth);
    let expected = growth * ((1.0 + 5.1e-9 * pressure).powf(z) - 1.0);
    let found = rise(PressureLaw::Roelands);
    assert!((found / expected - 1.0).abs() < 1e-4, "{found} {expected}");
    // Where Barus' exponent is held, the stress is still the limiting one.
    let held = stress(PressureLaw::Barus, 6e9);
    let limit = constants.ambient_limit.si() + constants.limiting_shear * 6e9;
    assert!(held > 0.9 * limit && held <= limit, "{held} {limit}");
}

#[test]
fn roelands_gives_less_friction_than_barus_for_thin_oils() {
    // A third of it in the Petry-Johnson conditions, the reason why Barus is the default.
    let contact = e_drive(0.3);
    let barus = friction(&oil("e-fluid"), &contact, 16).coefficient;
    let other = oil("e-fluid").with_laws(ShearLawName::Eyring, PressureLaw::Roelands);
    let roelands = friction(&other, &contact, 16).coefficient;
    assert!(roelands < 0.6 * barus, "{roelands} {barus}");
}

#[test]
fn a_carreau_film_without_thinning_is_newtonian() {
    let constants = TractionConstants {
        carreau: CarreauConstants {
            exponent: 1.0,
            ..CarreauConstants::default()
        },
        ..TractionConstants::from_family(BaseOil::Pao).unwrap()
    };
    let of = |law| {
        let rheology = oil("e-fluid")
            .with_constants(constants)
            .unwrap()
            .with_laws(law, PressureLaw::Barus);
        friction(&rheology, &e_drive(0.2), 16).coefficient
    };
    assert!((of(ShearLawName::Carreau) / of(ShearLawName::Newton) - 1.0).abs() < 1e-13);
}

#[test]
fn cold_oil_leaves_the_range_with_a_note_and_impossible_input_is_refused() {
    let rheology = oil("e-fluid");
    let mut contact = e_drive(0.3);
    contact.temperature = celsius(-35.0);
    let cold = solve(&rheology, &contact, FilmSettings::default()).unwrap();
    assert!(
        cold.outside
            .iter()
            .any(|note| note.name == "bulk temperature")
    );
    assert!(
        cold.outside
            .iter()
            .all(|note| note.correlation == "film friction")
    );
    let refused = |change: fn(&mut FilmLineContact)| {
        let mut contact = e_drive(0.3);
        change(&mut contact);
        solve(&rheology, &contact, FilmSettings::default()).is_err()
    };
    assert!(refused(|c| c.film = Length::from_si(0.0)));
    assert!(refused(|c| c.line.load = LineLoad::from_si(-1.0)));
    assert!(refused(
        |c| c.line.speeds = [Speed::from_si(f64::NAN), Speed::from_si(1.0)]
    ));
    assert!(refused(
        |c| c.line.speeds = [Speed::from_si(-1.0), Speed::from_si(0.5)]
    ));
    assert!(refused(|c| c.temperature = celsius(700.0)));
    assert!(refused(
        |c| c.line.bodies[1].conductivity = ThermalConductivity::from_si(0.0)
    ));
}

#[test]
fn unlike_bodies_share_the_heat_by_their_own_constants() {
    // A second body without conduction leaves all heat to the first: B1 sqrt(u1) alone.
    let rheology = oil("e-fluid");
    let mut contact = e_drive(0.5);
    contact.line.bodies[1].heat_capacity = SpecificHeat::from_si(1e-9);
    let alone = LoadedFilm::new(&rheology, &contact, FilmSettings::default()).unwrap();
    let a = (4.0 * 144e3 * 4.5e-3 / (std::f64::consts::PI * MODULUS)).sqrt();
    let b = (45.0_f64 * 7830.0 * 465.0).sqrt();
    let slow = (2.0_f64 * 45.0 / (7830.0 * 1e-9) / a).sqrt() * (45.0_f64 * 7830.0 * 1e-9).sqrt();
    let expected =
        0.798_507_829_726 * 144e3 * 3.25 / ((b * 8.125_f64.sqrt() + slow) * (2.0 * a).sqrt());
    assert!((alone.surface_rise(1.0) / expected - 1.0).abs() < 1e-12);
}

#[test]
fn boundary_share_runs_from_layer_to_film() {
    let nm = |x: f64| Length::from_si(x * 1e-9);
    assert_eq!(boundary_share(nm(0.0), nm(10.0)).unwrap(), 1.0);
    assert_eq!(boundary_share(nm(30.0), nm(10.0)).unwrap(), 0.25);
    assert_eq!(boundary_share(nm(30.0), nm(0.0)).unwrap(), 0.0);
    assert!(
        boundary_share(nm(0.0), nm(0.0)).is_err() && boundary_share(nm(-1.0), nm(1.0)).is_err()
    );
}

proptest! {
    #[test]
    fn three_parts_add_up(phi in 0.0..1.0_f64, beta in 0.0..1.0_f64, film in 0.0..0.06_f64, asperities in 0.0..0.06_f64, boundary in 0.05..0.15_f64) {
        let shared = SharedFriction { asperity_share: phi, boundary_share: beta, film, asperities, boundary };
        let parts = shared.parts().unwrap();
        let direct = (1.0 - phi) * film + phi * ((1.0 - beta) * asperities + beta * boundary);
        prop_assert!((parts.total() - direct).abs() < 1e-16);
        let without = SharedFriction { asperity_share: 0.0, ..shared }.parts().unwrap();
        prop_assert_eq!(without.total(), film);
        let bad = SharedFriction { boundary_share: 1.1, ..shared };
        prop_assert!(bad.parts().is_err());
    }

    #[test]
    fn film_friction_keeps_its_bounds_and_symmetries(
        load in 4e4..4e5_f64,
        radius in 3e-3..2e-2_f64,
        entrainment in 0.5..25.0_f64,
        slide_to_roll in 1e-3..1.5_f64,
        film in 5e-8..1.5e-6_f64,
        temperature in -20.0..130.0_f64,
        which in 0..3_usize,
    ) {
        let rheology = oil(["e-fluid", "M100", "PAO100"][which]);
        let contact = FilmLineContact {
            line: LineContact {
                load: LineLoad::from_si(load),
                radius: Length::from_si(radius),
                speeds: speeds(entrainment, slide_to_roll),
                ..e_drive(0.0).line
            },
            film: Length::from_si(film),
            temperature: celsius(temperature),
        };
        let heated = friction(&rheology, &contact, 16);
        let mu = heated.coefficient;
        prop_assert!(mu > 0.0);
        // Even in the sliding speed: the bodies change places.
        let [u1, u2] = contact.line.speeds;
        let line = LineContact { speeds: [u2, u1], ..contact.line };
        let mirrored = friction(&rheology, &FilmLineContact { line, ..contact }, 16);
        prop_assert!((mirrored.coefficient / mu - 1.0).abs() < 1e-13);
        // Heat only lowers it.
        let cold = isothermal(&rheology, &contact, 16);
        prop_assert!(mu <= cold * (1.0 + 1e-13));
        // Never above the limit: the mean of tau_L0 and Lambda p.
        let constants = rheology.constants();
        let a = heated.half_width.si();
        let limit = constants.limiting_shear + 2.0 * a * constants.ambient_limit.si() / load;
        prop_assert!(cold <= limit * (1.0 + 1e-6), "{cold} {limit}");
        // Falls with temperature at a given film.
        let warmer = FilmLineContact { temperature: celsius(temperature + 5.0), ..contact };
        prop_assert!(friction(&rheology, &warmer, 16).coefficient < mu);
        prop_assert!(heated.limited_share >= 0.0 && heated.limited_share <= 1.0 + 1e-12);
    }

    #[test]
    fn film_friction_solves_its_equations_and_is_newtons_at_rest(
        load in 4e4..4e5_f64,
        entrainment in 0.5..25.0_f64,
        slide_to_roll in 1e-3..1.5_f64,
        film in 5e-8..1.5e-6_f64,
        temperature in -20.0..130.0_f64,
        which in 0..3_usize,
    ) {
        let rheology = oil(["e-fluid", "M100", "PAO100"][which]);
        let at = |slide_to_roll: f64| FilmLineContact {
            line: LineContact {
                load: LineLoad::from_si(load),
                speeds: speeds(entrainment, slide_to_roll),
                ..e_drive(0.0).line
            },
            film: Length::from_si(film),
            temperature: celsius(temperature),
        };
        let contact = at(slide_to_roll);
        let found = friction(&rheology, &contact, 16);
        // F3 at exit.
        let mut again = LoadedFilm::new(&rheology, &contact, FilmSettings::default()).unwrap();
        let [mu, _] = again.friction_at(again.surface_rise(found.coefficient)).unwrap();
        prop_assert!((mu / found.coefficient - 1.0).abs() < 1e-12);
        // F1 at exit, in the middle of the contact.
        let wall = Temperature::from_si(contact.temperature.si() + found.surface_rise);
        let [u1, u2] = contact.line.speeds.map(Speed::si);
        let tau = rheology.shear_stress(found.max_pressure, wall, Speed::from_si(u1 - u2), contact.film).unwrap();
        let law = law_at(&rheology, found.max_pressure, wall, &contact, tau.value);
        prop_assert!((law / tau.value - 1.0).abs() < 1e-11, "{tau:?}, {law}");
        // Without sliding nothing rubs, and a little sliding rubs in proportion.
        prop_assert_eq!(friction(&rheology, &at(0.0), 16).coefficient, 0.0);
        let newton = rheology.clone().with_laws(ShearLawName::Newton, PressureLaw::Barus);
        let slow = at(1e-12);
        // The limiting stress enters with the fourth power of its share.
        let (eyring, newton) = (isothermal(&rheology, &slow, 32), isothermal(&newton, &slow, 32));
        prop_assert!((eyring / newton - 1.0).abs() < 1e-3 || newton > 1e-6, "{eyring} {newton}");
    }

    #[test]
    fn units_do_not_matter(
        slide_to_roll in 1e-3..1.5_f64,
        film in 5e-8..1.5e-6_f64,
        temperature in 0.0..130.0_f64,
        length in 0.5..2.0_f64,
        time in 0.5..2.0_f64,
        mass in 0.5..2.0_f64,
    ) {
        let of = |length: f64, time: f64, mass: f64| {
            let pressure = mass / (length * time * time);
            let conductivity = mass * length / time.powi(3);
            let density = mass / length.powi(3);
            let lubricant = LubricantInput {
                viscosity: Some(ViscosityLaw::Given {
                    dynamic_viscosity: DynamicViscosity::from_si(0.012 * pressure * time),
                    temperature: Some(celsius(90.0)),
                }),
                temperature_coefficient: Some(PerKelvin::from_si(0.03)),
                density: Some(Density::from_si(850.0 * density)),
                thermal_expansion: Some(PerKelvin::from_si(7e-4)),
                pressure_viscosity: Some(PressureViscosity::from_si(1e-8)),
                ..LubricantInput::default()
            };
            let lubricant = lubricant.resolve(celsius(90.0)).unwrap();
            let family = TractionConstants::from_family(BaseOil::Mineral).unwrap();
            let constants = TractionConstants {
                ambient_limit: family.ambient_limit * pressure,
                eyring_stress: family.eyring_stress * pressure,
                conductivity: family.conductivity * conductivity,
                conductivity_rise: family.conductivity_rise / pressure,
                conductivity_bend: family.conductivity_bend / pressure,
                ..family
            };
            let alpha = PressureViscosity::from_si(1.4e-8 / pressure);
            let rheology = FilmRheology::with_alpha(&lubricant, constants, alpha, celsius(90.0)).unwrap();
            let steel = Material {
                young: STEEL.young * pressure,
                conductivity: STEEL.conductivity * conductivity,
                density: STEEL.density * density,
                heat_capacity: STEEL.heat_capacity * (length / time).powi(2),
                ..STEEL
            };
            let line = e_drive(slide_to_roll).line;
            friction(&rheology, &FilmLineContact {
                line: LineContact {
                    load: line.load * (pressure * length),
                    radius: line.radius * length,
                    modulus: line.modulus * pressure,
                    speeds: line.speeds.map(|u| u * (length / time)),
                    bodies: [steel, steel],
                },
                film: Length::from_si(film * length),
                temperature: celsius(temperature),
            }, 16)
        };
        let (one, other) = (of(1.0, 1.0, 1.0), of(length, time, mass));
        prop_assert!((other.coefficient / one.coefficient - 1.0).abs() < 1e-9);
        prop_assert!((other.surface_rise - one.surface_rise).abs() < 1e-9 * one.surface_rise);
    }

    #[test]
    fn the_isothermal_loss_never_falls_with_sliding(slide_to_roll in 1e-4..1.5_f64, more in 1.0..1.5_f64) {
        let rheology = oil("M100");
        let loss = |s: f64| s * isothermal(&rheology, &e_drive(s), 16);
        prop_assert!(loss(more * slide_to_roll) >= loss(slide_to_roll) * (1.0 - 1e-12));
    }
}

#[test]
fn a_film_at_light_load_shears_at_its_pressures_and_before_the_contact() {
    let (rheology, contact) = (oil("M100"), e_drive(0.3));
    let film = |excess: &[f64], inlet: f64| {
        let mut film = LoadedFilm::new(&rheology, &contact, FilmSettings::default()).unwrap();
        film.reach_beyond(excess, inlet).unwrap();
        film
    };
    let rise = 3.0;
    let mut hertz = LoadedFilm::new(&rheology, &contact, FilmSettings::default()).unwrap();
    let [whole, _] = hertz.friction_at(rise).unwrap();
    // Without excess only the floor of the pressure acts.
    let [even, _] = film(&[0.0; 4], 0.0).friction_at(rise).unwrap();
    assert!((even / whole - 1.0).abs() < 3e-4, "{even} {whole}");
    // c₀ (1 - sin²t) + c₁ sin²t with both the same is a pressure that is higher everywhere: so is the sum of its powers.
    let [raised, _] = film(&[0.1, 0.0, 0.0, 0.0], 0.0).friction_at(rise).unwrap();
    let [lowered, _] = film(&[-0.1, 0.1, 0.0, 0.0], 0.0).friction_at(rise).unwrap();
    assert!(
        raised > 1.01 * whole && lowered < 0.99 * whole,
        "{raised} {lowered}"
    );
    // Before the contact the film shears at ambient pressure: (2a/w) I τ(0).
    let inlet = 1.7;
    let [more, _] = film(&[0.0; 4], inlet).friction_at(rise).unwrap();
    let line = contact.line;
    let [w, r] = [line.load.si(), line.radius.si()];
    let half_width = (4.0 * w * r / (std::f64::consts::PI * line.modulus.si())).sqrt();
    let sliding = (line.speeds[0].si() - line.speeds[1].si()).abs();
    let point = rheology.film_point(0.0, sliding, contact.film.si());
    let wall = contact.temperature.si() + rise;
    let (stress, _) = rheology.heated_stress(&point, wall, None).unwrap();
    let expected = 2.0 * half_width / w * inlet * stress.value;
    assert!(
        ((more - even) / expected - 1.0).abs() < 1e-9,
        "{more} {even} {expected}"
    );
    // A film that carries a part of the load has less pressure, and the same inlet.
    let mut part = film(&[0.0; 4], inlet);
    part.carry(0.5).unwrap();
    let mut without = film(&[0.0; 4], 0.0);
    without.carry(0.5).unwrap();
    let [part, without] = [part, without].map(|mut film| film.friction_at(rise).unwrap()[0]);
    assert!((0.5 * (part - without) / expected - 1.0).abs() < 1e-9);
    assert!(hertz.reach_beyond(&[0.0; 4], -1.0).is_err());
    assert!(hertz.reach_beyond(&[0.0; 4], f64::NAN).is_err());
}
