//! Limits of the friction laws, and inputs that have no answer.

#![allow(
    clippy::unwrap_used,
    reason = "helpers of tests may unwrap as tests do"
)]

use crate::reference_case::{ALPHA, LOAD, MODULUS, OIL, POSITIONS, STEEL, conditions};
use asperity_core::line_contact::LineContact;
use asperity_core::quantity::{
    DynamicViscosity, KinematicViscosity, Length, LineLoad, Pressure, Speed, Temperature,
};
use asperity_core::{Code, DomainError, Fault};
use asperity_tribo_friction::{
    FilmTraction, FrictionConditions, FrictionLaw, FrictionSettings, MeshConditions, XuCalibration,
    XuCoefficients, XuLaw, doleschel, flash_temperature, matsumoto, mixed_friction, rolling_force,
};

fn settings() -> FrictionSettings {
    FrictionSettings {
        constant: Some(0.05),
        fluid_coefficient: Some(0.02),
        ..FrictionSettings::default()
    }
}

fn at_start() -> FrictionConditions {
    conditions(&POSITIONS[0])
}

#[test]
fn shared_laws_run_from_boundary_to_fluid_friction() {
    let mu = |law: FrictionLaw, film: f64| {
        let position = FrictionConditions {
            central_film: Length::from_si(film),
            minimum_film: Length::from_si(film),
            ..at_start()
        };
        law.coefficient(&settings(), &position).unwrap().value
    };
    for law in [FrictionLaw::Matsumoto, FrictionLaw::Doleschel] {
        assert_eq!(mu(law, 0.0), 0.1, "boundary friction without a film");
        assert_eq!(mu(law, 1e-3), 0.02, "fluid friction of a thick film");
    }
}

#[test]
fn shared_laws_take_eyring_s_coefficient_when_none_is_given() {
    let thick = FrictionConditions {
        minimum_film: Length::from_si(1e-3),
        ..at_start()
    };
    let settings = FrictionSettings::default();
    let mu = |law: FrictionLaw| law.coefficient(&settings, &thick).unwrap().value;
    assert_eq!(mu(FrictionLaw::Matsumoto), mu(FrictionLaw::Eyring));
}

#[test]
fn eyring_is_newtonian_for_slow_sliding() {
    let slow = FrictionConditions {
        sliding: Speed::from_si(1e-4),
        ..at_start()
    };
    let mu = FrictionLaw::Eyring.coefficient(&settings(), &slow).unwrap();
    let mean_pressure = slow.max_pressure.si() * std::f64::consts::FRAC_PI_4;
    let newton =
        slow.contact_viscosity.si() * slow.sliding.si() / slow.central_film.si() / mean_pressure;
    // arsinh x = x − x³/6 with x = 7e-4.
    assert!((mu.value / newton - 1.0).abs() < 1e-7);
}

#[test]
fn local_laws_have_no_fluid_friction_without_sliding() {
    let pitch_point = conditions(&POSITIONS[2]);
    for law in [
        FrictionLaw::Xu,
        FrictionLaw::BenedictKelley,
        FrictionLaw::Eyring,
    ] {
        let mu = law.coefficient(&settings(), &pitch_point).unwrap();
        assert_eq!(mu.value, 0.0);
    }
}

#[test]
fn benedict_kelley_is_held_at_zero_with_a_note() {
    let light = FrictionConditions {
        load: LineLoad::from_si(10.0),
        ..at_start()
    };
    let law = FrictionLaw::BenedictKelley;
    let mu = law.coefficient(&settings(), &light).unwrap();
    assert_eq!(mu.value, 0.0);
    assert_eq!(mu.outside.len(), 1);
    let rough = FrictionConditions {
        mean_ra: Length::from_si(1.13e-6),
        ..at_start()
    };
    assert!(law.coefficient(&settings(), &rough).is_err());
}

#[test]
fn benedict_kelley_is_noted_where_roughness_more_than_trebles_it() {
    let noted = |um: f64| {
        let position = FrictionConditions {
            mean_ra: Length::from_si(um * 1e-6),
            ..at_start()
        };
        let mu = FrictionLaw::BenedictKelley.coefficient(&settings(), &position);
        mu.unwrap()
            .outside
            .iter()
            .any(|note| note.name == "mean Ra")
    };
    // 1.13/(1.13 - Ra) is 3 at 0.7533 um.
    assert!(!noted(0.753) && noted(0.754));
}

#[test]
fn rollers_and_gears_of_the_published_laws_bore_less_than_2_gpa() {
    for &law in FrictionLaw::ALL {
        let outside = |giga: f64| {
            let row = law.published();
            let found = row.outside_pressure(Pressure::from_si(giga * 1e9)).unwrap();
            !found.is_empty()
        };
        assert!(!outside(1.0), "{law:?}");
        let own = matches!(
            law,
            FrictionLaw::Xu | FrictionLaw::Eyring | FrictionLaw::Constant
        );
        assert_eq!(outside(4.0), !own, "{law:?}");
    }
}

#[test]
fn constant_needs_its_value() {
    let law = FrictionLaw::Constant;
    let none = law.coefficient(&FrictionSettings::default(), &at_start());
    let refused = Fault::from(none.unwrap_err());
    assert_eq!(refused.code(), Code::E205);
    let expected = "the friction law constant needs the setting constant";
    assert_eq!(refused.message(), expected);
    let mu = law.coefficient(&settings(), &at_start()).unwrap();
    assert_eq!(mu.value, 0.05);
}

#[test]
fn values_outside_the_range_carry_notes() {
    let names = |law: FrictionLaw, position: FrictionConditions| -> Vec<&'static str> {
        let mu = law.coefficient(&settings(), &position).unwrap();
        mu.outside.iter().map(|note| note.name).collect()
    };
    let slow = MeshConditions {
        pitch_line_speed: Speed::from_si(0.5),
        base_line_load: LineLoad::from_si(1e5),
        ..at_start().mesh
    };
    let slow = FrictionConditions {
        mesh: slow,
        ..at_start()
    };
    assert_eq!(
        names(FrictionLaw::Iso14179Part1, slow),
        ["pitch line speed"]
    );
    assert_eq!(
        names(FrictionLaw::Iso14179Part2, slow),
        ["base line load Fbt/b", "pitch line speed"]
    );
    let heavy = FrictionConditions {
        max_pressure: Pressure::from_si(3e9),
        entrainment: Speed::from_si(0.5),
        sliding: Speed::from_si(0.9),
        ..at_start()
    };
    assert_eq!(
        names(FrictionLaw::Xu, heavy),
        [
            "slide-to-roll ratio",
            "maximum pressure",
            "entrainment speed",
            // The oil of the reference case is no 75W90.
            "viscosity"
        ]
    );
    assert_eq!(names(FrictionLaw::Eyring, heavy), ["maximum pressure"]);
    let cold = FrictionConditions {
        viscosity: DynamicViscosity::from_si(5.0),
        kinematic_viscosity: KinematicViscosity::from_si(5e-3),
        ..at_start()
    };
    for (law, name) in [
        (FrictionLaw::Xu, "viscosity"),
        (FrictionLaw::BenedictKelley, "viscosity"),
        (FrictionLaw::Iso14179Part1, "kinematic viscosity"),
        (FrictionLaw::Iso14179Part2, "viscosity"),
    ] {
        assert!(names(law, cold).contains(&name), "{law:?}");
    }
    let fast = FrictionConditions {
        sliding: Speed::from_si(20.0),
        entrainment: Speed::from_si(30.0),
        ..at_start()
    };
    assert_eq!(names(FrictionLaw::Eyring, fast), ["sliding speed"]);
    assert!(names(FrictionLaw::BenedictKelley, fast).contains(&"sum of the surface speeds"));
}

#[test]
fn oil_temperatures_outside_the_fitted_range_are_named_for_every_published_law() {
    for &law in FrictionLaw::ALL {
        let row = law.published();
        assert_eq!(row.name, law.name());
        let cold = row.outside(Temperature::from_si(243.15)).unwrap();
        let expected = usize::from(law != FrictionLaw::Constant);
        assert_eq!(cold.len(), expected, "{law:?}");
        assert!(
            row.outside(Temperature::from_si(363.15))
                .unwrap()
                .is_empty()
        );
        assert!(row.outside(Temperature::from_si(-1.0)).is_err());
    }
    assert!(FrictionLaw::Iso14179Part2.published().includes_asperities());
    assert!(!FrictionLaw::Eyring.published().includes_asperities());
}

#[test]
fn laws_of_the_standards_are_proportional_to_their_lubricant_factor() {
    let mu = |factor: f64| {
        let mesh = MeshConditions {
            lubricant_factor: factor,
            ..at_start().mesh
        };
        let position = FrictionConditions { mesh, ..at_start() };
        let law = FrictionLaw::Iso14179Part2;
        law.coefficient(&settings(), &position).unwrap().value
    };
    assert!((mu(0.8) / mu(1.0) - 0.8).abs() < 1e-12);
}

#[test]
fn a_traction_carries_the_rises_it_is_given() {
    let plain = FilmTraction::from_coefficient(0.03);
    assert_eq!((plain.surface_rise, plain.film_rise), (None, None));
    let hot = plain.with_rises(12.0, 30.0);
    assert_eq!((hot.surface_rise, hot.film_rise), (Some(12.0), Some(30.0)));
    assert_eq!(hot.coefficient, 0.03);
}

#[test]
fn impossible_inputs_are_refused_by_name() {
    let refused = |law: FrictionLaw, position: FrictionConditions, name: &str| {
        let refused = Fault::from(law.coefficient(&settings(), &position).unwrap_err());
        assert_eq!(refused.cause::<DomainError>().unwrap().name, name);
    };
    let thin = FrictionConditions {
        viscosity: DynamicViscosity::from_si(1e-3),
        ..at_start()
    };
    refused(FrictionLaw::Xu, thin, "viscosity");
    let nowhere = FrictionConditions {
        sliding: Speed::from_si(f64::NAN),
        ..at_start()
    };
    for law in [
        FrictionLaw::Xu,
        FrictionLaw::BenedictKelley,
        FrictionLaw::Eyring,
    ] {
        refused(law, nowhere, "sliding speed");
    }
    let smooth_and_dry = FrictionConditions {
        central_film: Length::from_si(0.0),
        minimum_film: Length::from_si(0.0),
        mean_ra: Length::from_si(0.0),
        sum_rz: Length::from_si(0.0),
        ..at_start()
    };
    refused(FrictionLaw::Matsumoto, smooth_and_dry, "sum of Rz");
    refused(FrictionLaw::Doleschel, smooth_and_dry, "mean Ra");
    // As is, e^(b₉ e^S) overflows at 8 um: no infinite coefficient leaves the law.
    let as_is = FrictionSettings {
        xu: XuLaw {
            roughness: asperity_tribo_friction::RoughnessReading::AsIs,
            ..XuLaw::default()
        },
        ..settings()
    };
    let very_rough = FrictionConditions {
        combined_roughness: Length::from_si(8e-6),
        ..at_start()
    };
    assert!(FrictionLaw::Xu.coefficient(&as_is, &very_rough).is_err());
    for friction_scale in [-1.0, 0.0, f64::INFINITY, f64::NAN] {
        let scaled = FrictionSettings {
            xu: XuLaw {
                friction_scale,
                ..XuLaw::default()
            },
            ..settings()
        };
        let error = FrictionLaw::Xu.coefficient(&scaled, &at_start());
        let error = error.unwrap_err().to_string();
        assert!(error.contains("friction scale"), "{error}");
    }
}

#[test]
fn smooth_flanks_have_no_asperity_friction() {
    let (film, flat) = (Length::from_si(1e-7), Length::from_si(0.0));
    assert_eq!(matsumoto::asperity_share(film, flat), Ok(0.0));
    assert_eq!(doleschel::asperity_share(film, flat), Ok(0.0));
    assert!(matsumoto::coefficient(film, flat, -0.1, 0.1).is_err());
}

#[test]
fn mixed_friction_refuses_fields_that_do_not_belong_together() {
    let dx = Length::from_si(1e-6);
    let refused = mixed_friction(dx, &[1.0, 2.0], &[1.0], 0.1, 0.02).unwrap_err();
    assert_eq!(
        refused.to_string(),
        "2 solid and 1 fluid pressures; both must be given at the same points"
    );
    assert!(mixed_friction(dx, &[-1.0], &[1.0], 0.1, 0.02).is_err());
    assert!(mixed_friction(dx, &[1.0], &[f64::NAN], 0.1, 0.02).is_err());
    assert!(mixed_friction(dx, &[1.0], &[1.0], f64::NAN, 0.02).is_err());
    let nothing = mixed_friction(dx, &[], &[], 0.1, 0.02).unwrap();
    assert_eq!(nothing.total.si(), 0.0);
}

#[test]
fn rolling_refuses_what_does_not_roll() {
    let contact = |speed: f64| LineContact {
        load: LOAD,
        radius: Length::from_si(0.01),
        modulus: MODULUS,
        speeds: [Speed::from_si(speed); 2],
        bodies: [STEEL; 2],
    };
    assert!(rolling_force(&contact(0.0), OIL, ALPHA, 1.0).is_err());
    assert!(rolling_force(&contact(1.0), OIL, ALPHA, -0.1).is_err());
    assert!(rolling_force(&contact(1.0), OIL, ALPHA, 0.0).is_ok());
}

#[test]
fn equal_surface_speeds_make_no_flash() {
    let rolling = LineContact {
        load: LOAD,
        radius: Length::from_si(0.01),
        modulus: MODULUS,
        speeds: [Speed::from_si(4.0); 2],
        bodies: [STEEL; 2],
    };
    let half_width = Length::from_si(1e-4);
    assert_eq!(flash_temperature(&rolling, half_width, 0.1), Ok(0.0));
    let still = LineContact {
        speeds: [Speed::from_si(0.0); 2],
        ..rolling
    };
    assert!(flash_temperature(&still, half_width, 0.1).is_err());
}

#[test]
fn coefficient_files_read_and_say_where_they_do_not() {
    let calibration = XuCalibration {
        source: "own tests".to_owned(),
        oil: "75W90".to_owned(),
        coefficients: XuCoefficients::XU_2005,
    };
    let text = serde_json::to_string_pretty(&calibration).unwrap();
    assert_eq!(XuCalibration::from_json(&text), Ok(calibration));
    let misspelt = text.replace("b9", "b_9");
    let refused = XuCalibration::from_json(&misspelt).unwrap_err().to_string();
    assert!(refused.contains(" at line 13 column "), "{refused}");
}

#[test]
fn every_law_reads_its_own_name() {
    for &law in FrictionLaw::ALL {
        let text = serde_json::to_string(&law).unwrap();
        assert_eq!(text, format!("\"{}\"", law.name()));
        assert_eq!(serde_json::from_str::<FrictionLaw>(&text).unwrap(), law);
    }
    // A case file may set one choice and leave the others.
    let settings: FrictionSettings =
        serde_json::from_str(r#"{"xu": {"roughness": "as-is", "friction_scale": 0.92623}}"#)
            .unwrap();
    assert_eq!(settings.xu.coefficients, XuCoefficients::XU_2005);
    assert!(serde_json::from_str::<FrictionSettings>(r#"{"scale": 1}"#).is_err());
}
