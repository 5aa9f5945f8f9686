//! Friction, rolling and flash temperature against computed and published numbers.
//!
//! Expected numbers of the reference case come from an independent Python computation
//! (`references/table_2.py`) and are typed in to all printed digits; 1e-12 is what differently ordered double arithmetic leaves.

#![allow(
    clippy::unwrap_used,
    reason = "helpers of tests may unwrap as tests do"
)]

use crate::reference_case::{ALPHA, LOAD, MODULUS, OIL, POSITIONS, Position, STEEL, conditions};
use asperity_core::Treatment;
use asperity_core::line_contact::LineContact;
use asperity_core::material::Material;
use asperity_core::quantity::{
    Density, DynamicViscosity, Length, LineLoad, Pressure, PressureViscosity, SpecificHeat, Speed,
    ThermalConductivity,
};
use asperity_tribo_friction::eyring::EyringConditions;
use asperity_tribo_friction::flash::heat_share;
use asperity_tribo_friction::rolling::goksem_factor;
use asperity_tribo_friction::xu::XuConditions;
use asperity_tribo_friction::{
    FrictionLaw, FrictionSettings, RoughnessReading, XuLaw, doleschel, eyring, flash_temperature,
    matsumoto, mixed_friction, rolling_force,
};

const ROUNDING: f64 = 1e-12;

fn close(actual: f64, expected: f64, tolerance: f64) {
    let error = (actual - expected).abs();
    assert!(
        error <= tolerance * expected.abs(),
        "{actual} is not {expected}"
    );
}

fn value(law: FrictionLaw, position: &Position) -> f64 {
    let settings = FrictionSettings::default();
    let coefficient = law.coefficient(&settings, &conditions(position)).unwrap();
    // The oil of the reference case, 97.5 mPa s, is thicker than Xu's 75W90; nothing else is outside.
    let of_xu = |name| law == FrictionLaw::Xu && name == "viscosity";
    let expected = coefficient.outside.iter().all(|note| of_xu(note.name));
    assert!(expected, "{:?}", coefficient.outside);
    coefficient.value
}

#[test]
fn xu_of_the_reference_case() {
    for position in &POSITIONS {
        close(value(FrictionLaw::Xu, position), position.xu[0], ROUNDING);
        let smooth = asperity_tribo_friction::FrictionConditions {
            combined_roughness: Length::from_si(0.1e-6),
            ..conditions(position)
        };
        let coefficient = FrictionLaw::Xu.coefficient(&FrictionSettings::default(), &smooth);
        close(coefficient.unwrap().value, position.xu[1], ROUNDING);
    }
}

fn spot(slide_to_roll: f64, max_pressure: f64, roughness: f64) -> XuConditions {
    XuConditions {
        slide_to_roll,
        max_pressure: Pressure::from_si(max_pressure),
        viscosity: DynamicViscosity::from_si(0.010),
        entrainment: Speed::from_si(10.0),
        radius: Length::from_si(0.010),
        combined_roughness: Length::from_si(roughness),
    }
}

#[test]
fn xu_spot_values() {
    // Computed independently.
    let mu = |sr, p| {
        let coefficient = XuLaw::default().coefficient(&spot(sr, p, 0.1e-6));
        coefficient.unwrap().value
    };
    close(mu(0.2, 1e9), 0.012716825722695101, ROUNDING);
    close(mu(0.5, 1.5e9), 0.015524023448344361, ROUNDING);
}

#[test]
fn xu_roughness_term_is_a_double_exponential() {
    // Relative to S = 0.42 um, evaluated from e^(b₉ (e^S − e^0.42)).
    let as_is = XuLaw {
        roughness: RoughnessReading::AsIs,
        ..XuLaw::default()
    };
    let mu = |law: &XuLaw, s| law.coefficient(&spot(0.2, 1e9, s)).unwrap();
    let base = mu(&as_is, 0.42e-6).value;
    close(mu(&as_is, 0.0).value / base, 0.723413, 1e-6);
    close(mu(&as_is, 1e-6).value / base, 2.100307, 1e-6);
    close(mu(&as_is, 2e-6).value / base, 38.06853, 1e-6);
    // The clamped reading stays at 0.6 um; both readings say that S is too large.
    let clamped = mu(&XuLaw::default(), 2e-6);
    close(clamped.value, mu(&as_is, 0.6e-6).value, ROUNDING);
    assert_eq!(clamped.outside.len(), 1);
    assert_eq!(clamped.outside[0].treatment, Treatment::Held);
    assert!(clamped.outside[0].correlation.contains("held at 0.6 um"));
    let printed = mu(&as_is, 2e-6).outside;
    assert_eq!(printed.len(), 1);
    assert_eq!(printed[0].treatment, Treatment::Extrapolated);
}

#[test]
fn xu_scales_with_the_lubricant_factor_of_the_paper() {
    // 0.84/0.9069, read as a ratio of lubricant factors.
    let scaled = XuLaw {
        friction_scale: 0.84 / 0.9069,
        ..XuLaw::default()
    };
    let position = spot(0.2, 1e9, 0.1e-6);
    let mu = scaled.coefficient(&position).unwrap().value;
    close(mu, 0.012716825722695101 * 0.9262322196493549, ROUNDING);
}

#[test]
fn benedict_kelley_of_the_reference_case() {
    for position in &POSITIONS {
        let mu = value(FrictionLaw::BenedictKelley, position);
        match position.benedict_kelley {
            Some(expected) => close(mu, expected, ROUNDING),
            None => assert_eq!(mu, 0.0),
        }
    }
}

#[test]
fn whole_mesh_laws_of_the_reference_case() {
    for position in &POSITIONS {
        // The same coefficient at every position.
        let part_1 = value(FrictionLaw::Iso14179Part1, position);
        close(part_1, 0.01255169103443137, ROUNDING);
        let part_2 = value(FrictionLaw::Iso14179Part2, position);
        close(part_2, 0.02947151259557021, ROUNDING);
    }
}

#[test]
fn asperity_shares_of_the_published_functions() {
    let um = |value: f64| Length::from_si(value * 1e-6);
    // Arana et al. 2019, table 1, evaluated by hand.
    let share = |film, ra| doleschel::asperity_share(um(film), um(ra)).unwrap();
    close(share(0.2, 0.25), 0.36, ROUNDING);
    assert_eq!(share(0.0, 0.25), 1.0);
    assert_eq!(share(0.5, 0.25), 0.0);
    let share = |film, rz| matsumoto::asperity_share(um(film), um(rz)).unwrap();
    close(share(0.5, 5.0), 0.5, ROUNDING);
    close(share(5.0, 5.0), 0.0, ROUNDING);
    close(share(0.05, 5.0), 1.0, ROUNDING);
}

#[test]
fn eyring_spot_values() {
    // Computed independently: shear thinning, nearly Newtonian, at the limiting stress.
    for (viscosity, sliding, expected) in [
        (1e3, 0.5, 0.03928146127967512),
        (10.0, 0.1, 0.003950806314819826),
        (1e6, -2.0, 0.047),
    ] {
        let position = EyringConditions {
            max_pressure: Pressure::from_si(1e9),
            contact_viscosity: DynamicViscosity::from_si(viscosity),
            pressure_viscosity: ALPHA,
            sliding: Speed::from_si(sliding),
            central_film: Length::from_si(300e-9),
            limiting_stress: eyring::MINERAL_OIL_LIMIT,
        };
        let mu = eyring::coefficient(&position).unwrap();
        close(mu.value, expected, ROUNDING);
    }
}

/// The line contact of a position.
fn line_contact(position: &Position) -> LineContact {
    LineContact {
        load: LOAD,
        radius: Length::from_si(position.radius_mm * 1e-3),
        modulus: MODULUS,
        speeds: [0.5, -0.5]
            .map(|part| Speed::from_si(position.entrainment + part * position.sliding)),
        bodies: [STEEL; 2],
    }
}

#[test]
fn rolling_resistance_of_the_reference_case() {
    for position in &POSITIONS {
        let contact = line_contact(position);
        let force = |phi| rolling_force(&contact, OIL, ALPHA, phi).unwrap().si();
        close(force(1.0), position.rolling[0], ROUNDING);
        close(force(position.gupta), position.rolling[1], ROUNDING);
    }
}

/// F₁ = ½ ∫ (h − h₀) dp over the isothermal Grubin inlet of a Barus oil, own derivation and
/// quadrature (200 000 points). The power law was fitted to solutions of that kind within 5 %.
#[test]
fn rolling_resistance_agrees_with_a_numerical_inlet() {
    // η₀, α, V_e, w, R, F₁ on one surface [N/m].
    let cases = [
        (0.0975, 2e-8, 4.568, 113409.0, 0.0116269, 218.84101828117622),
        (0.01, 1.5e-8, 10.0, 3e5, 0.01, 83.02785754284167),
        (0.05, 2e-8, 2.0, 1e6, 0.02, 92.08214471928676),
        (0.02, 2.2e-8, 20.0, 2e5, 0.008, 175.10771366068604),
        (0.1, 2e-8, 0.5, 5e5, 0.01, 46.04107235963668),
    ];
    for (viscosity, alpha, speed, load, radius, expected) in cases {
        let contact = LineContact {
            load: LineLoad::from_si(load),
            radius: Length::from_si(radius),
            modulus: Pressure::from_si(115.3846e9),
            speeds: [Speed::from_si(speed); 2],
            bodies: [STEEL; 2],
        };
        let force = rolling_force(
            &contact,
            DynamicViscosity::from_si(viscosity),
            PressureViscosity::from_si(alpha),
            1.0,
        );
        close(force.unwrap().si(), expected, 0.05);
    }
}

/// Expected value of the unit tests of an open ball-bearing dynamics code.
#[test]
fn goksem_factor_of_a_published_test_case() {
    let gu = 4863.08548968228 * 8.929170740443306e-13;
    let factor = goksem_factor(gu, 2.934858572384527e-5, 8.743070312928715e-6).unwrap();
    // The code's D has π to nine digits: 2e-7 between its printed D and ours.
    close(factor, 0.403451221364356, 1e-6);
}

#[test]
fn longer_goksem_form_of_the_reference_case() {
    for position in &POSITIONS {
        let modulus = 2.0 * MODULUS.si();
        let radius = position.radius_mm * 1e-3;
        let gu = ALPHA.si() * OIL.si() * position.entrainment / radius;
        let w = LOAD.si() / (modulus * radius);
        let factor = |loading| goksem_factor(gu, w, loading).unwrap();
        let thermal = factor(position.thermal_loading) / factor(0.0);
        close(thermal, position.goksem, ROUNDING);
        // Both forms of the isothermal fit, 0.4 % apart.
        close(
            factor(0.0) * w * radius / ALPHA.si(),
            position.rolling[0],
            5e-3,
        );
    }
}

#[test]
fn flash_temperature_of_the_reference_case() {
    for position in &POSITIONS {
        let contact = line_contact(position);
        let half_width = Length::from_si(position.half_width_um * 1e-6);
        let rise = flash_temperature(&contact, half_width, position.xu[0]).unwrap();
        match position.flash {
            // The surface speeds are reconstructed from V_e and V_s: a few digits lost in
            // their difference.
            Some(expected) => close(rise, expected, 1e-11),
            None => assert_eq!(rise, 0.0),
        }
    }
}

/// Half of the heat would make the faster flank the colder one: the rise of a flank that takes its share alone,
/// from the other through an insulator, is that of the pair.
#[test]
fn two_flanks_share_the_heat_that_makes_them_equally_hot() {
    let bronze = Material {
        conductivity: ThermalConductivity::from_si(60.0),
        density: Density::from_si(8800.0),
        heat_capacity: SpecificHeat::from_si(377.0),
        ..STEEL
    };
    let speeds = [5.0, 3.2].map(Speed::from_si);
    let pair = LineContact {
        load: LOAD,
        radius: Length::from_si(0.01),
        modulus: MODULUS,
        speeds,
        bodies: [STEEL, bronze],
    };
    let together = flash_temperature(&pair, Length::from_si(1e-4), 0.05).unwrap();
    let share = heat_share([&STEEL, &bronze], speeds).unwrap();
    let heat = 0.05 * LOAD.si() * (5.0 - 3.2);
    for (steel, speed, part) in [(STEEL, 5.0, share), (bronze, 3.2, 1.0 - share)] {
        let effusivity =
            (steel.conductivity.si() * steel.density.si() * steel.heat_capacity.si()).sqrt();
        let alone = 1.11 * part * heat / (effusivity * (speed * 2e-4_f64).sqrt());
        close(alone, together, 1e-12);
    }
    assert_eq!(
        heat_share([&STEEL, &bronze], [speeds[0], Speed::from_si(0.0)]).unwrap(),
        1.0
    );
    assert!(heat_share([&STEEL, &bronze], [Speed::from_si(0.0); 2]).is_err());
}

/// Blok's constant from its integral: the flash temperature of a semi-elliptic source is
/// max over x of ∫₋₁ˣ √(1 − s²)/√(x − s) ds, times (2/π) √2/√π.
#[test]
fn blok_s_constant_is_that_of_a_semi_elliptic_source() {
    let integral = |x: f64| {
        // s = x − t² takes the end point's root out.
        let n = 2000;
        let step = (1.0 + x).sqrt() / f64::from(n);
        (0..n)
            .map(|i| {
                let t = (f64::from(i) + 0.5) * step;
                let s = x - t * t;
                2.0 * (1.0 - s * s).max(0.0).sqrt() * step
            })
            .sum::<f64>()
    };
    let largest = (0..1000)
        .map(|i| integral(f64::from(i) * 1e-3))
        .fold(0.0, f64::max);
    let constant = largest * std::f64::consts::FRAC_2_PI * (2.0 / std::f64::consts::PI).sqrt();
    // Printed as 1.11; the integral gives 1.1115.
    close(constant, 1.1115, 1e-4);
}

#[test]
fn mixed_friction_of_a_hertz_contact_is_the_coefficient_times_the_load() {
    // Semi-elliptic pressures sampled at strip centres; the film carries 75 %.
    let (p0, a, n) = (6e8, 120e-6, 4000);
    let dx = 2.0 * a / f64::from(n);
    let hertz: Vec<f64> = (0..n)
        .map(|i| {
            let x = -1.0 + (f64::from(i) + 0.5) * 2.0 / f64::from(n);
            p0 * (1.0 - x * x).sqrt()
        })
        .collect();
    let solid: Vec<f64> = hertz.iter().map(|p| 0.25 * p).collect();
    let fluid: Vec<f64> = hertz.iter().map(|p| 0.75 * p).collect();
    let friction = mixed_friction(Length::from_si(dx), &solid, &fluid, 0.1, 0.02).unwrap();
    let load = std::f64::consts::FRAC_PI_2 * p0 * a;
    // The midpoint rule is off by about n^−1.5 at the root-like ends.
    close(friction.total.si(), (0.25 * 0.1 + 0.75 * 0.02) * load, 1e-5);
    close(friction.solid.si(), 0.025 * load, 1e-5);
    close(
        friction.solid.si() + friction.fluid.si(),
        friction.total.si(),
        ROUNDING,
    );
}
