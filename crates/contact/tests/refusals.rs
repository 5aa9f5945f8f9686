//! Refusals: a problem that is none, or is not solved, is an error that says what to change.
#![allow(clippy::unwrap_used, reason = "a test that cannot set up has failed")]

use crate::common::{CYLINDER, hertz_problem, rough_gap};
use asperity_contact::dense_reference::{MAX_POINTS, solve_dense};
use asperity_contact::flat_punch;
use asperity_contact::half_plane::HalfPlane;
use asperity_contact::two_flanks::TwoFlanks;
use asperity_contact::westergaard::Wave;
use asperity_contact::{
    Boundary, ContactError, ContactProblem, ContactSolution, Control, PeriodicKernel, Solver,
    SolverSettings, solve,
};
use asperity_core::Profile;
use asperity_core::quantity::{Length, LineLoad, Pressure};

fn approach(metres: f64) -> Control {
    Control::Approach {
        approach: Length::from_si(metres),
        datum: CYLINDER.window * 2.0,
    }
}

fn solved(problem: &ContactProblem) -> Result<ContactSolution, ContactError> {
    solve(problem, &SolverSettings::default())
}

#[test]
fn too_few_iterations_are_an_error_with_evidence() {
    let (gap, spacing) = rough_gap(1_000);
    let settings = SolverSettings {
        max_iterations: 3,
        ..SolverSettings::default()
    };
    let error = solve(&hertz_problem(&gap, spacing), &settings).unwrap_err();
    let ContactError::NotConverged {
        iterations,
        certificate,
        tolerance,
    } = &error
    else {
        panic!("{error:?}");
    };
    assert_eq!((*iterations, *tolerance), (3, 1e-8));
    assert!(certificate.duality_gap > 1e-8 && certificate.duality_gap < 1.0);
    assert!(certificate.penetration > 1e-8 && certificate.penetration < 1.0);
    assert!(certificate.load_error < 1e-12 && certificate.reference_gap.si() > 1e-7);
    assert!(error.to_string().contains("after 3 iterations"));
}

#[test]
fn a_tolerance_below_round_off_is_an_error_and_not_endless() {
    let (gap, spacing) = rough_gap(1_000);
    let settings = SolverSettings {
        tolerance: 1e-18,
        ..SolverSettings::default()
    };
    let error = solve(&hertz_problem(&gap, spacing), &settings).unwrap_err();
    assert!(matches!(error, ContactError::NotConverged { iterations, .. } if iterations < 5_000));
}

#[test]
fn a_tolerance_at_which_anything_passes_is_refused() {
    let (gap, spacing) = rough_gap(1_000);
    for (tolerance, accepted) in [
        (1e-4, true),
        (1.001e-4, false),
        (1e-2, false),
        (f64::INFINITY, false),
    ] {
        let settings = SolverSettings {
            tolerance,
            ..SolverSettings::default()
        };
        let found = solve(&hertz_problem(&gap, spacing), &settings);
        match found {
            Ok(_) => assert!(accepted),
            Err(error) => assert!(!accepted && error.code() == "E211", "{error}"),
        }
    }
}

#[test]
fn nonsense_is_refused_by_name() {
    let (gap, spacing) = CYLINDER.gap(100);
    let good = hertz_problem(&gap, spacing);
    let mut bad_gap = gap.clone();
    bad_gap[7] = f64::NAN;
    let load = |newtons: f64| Control::Load(LineLoad::from_si(newtons));
    let near = Control::Approach {
        approach: Length::from_si(1e-6),
        datum: CYLINDER.window * 0.25,
    };
    let cases = [
        (ContactProblem { gap: &[], ..good }, "too few"),
        (
            ContactProblem {
                gap: &gap[..1],
                ..good
            },
            "too few",
        ),
        (
            ContactProblem {
                gap: &bad_gap,
                ..good
            },
            "gap[7] = NaN m: must be finite",
        ),
        (
            ContactProblem {
                spacing: Length::from_si(0.0),
                ..good
            },
            "spacing",
        ),
        (
            ContactProblem {
                modulus: Pressure::from_si(-1.0),
                ..good
            },
            "reduced modulus",
        ),
        (
            ContactProblem {
                modulus: Pressure::from_si(f64::NAN),
                ..good
            },
            "reduced modulus",
        ),
        (
            ContactProblem {
                control: load(0.0),
                ..good
            },
            "load = 0",
        ),
        (
            ContactProblem {
                control: load(-5.0),
                ..good
            },
            "load = -5",
        ),
        (
            ContactProblem {
                control: load(f64::INFINITY),
                ..good
            },
            "load = inf",
        ),
        (
            ContactProblem {
                control: approach(f64::NAN),
                ..good
            },
            "approach = NaN",
        ),
        (
            ContactProblem {
                control: near,
                ..good
            },
            "must lie farther than 150 um",
        ),
        (
            ContactProblem {
                prescribed_pressure: Some(&[1.0]),
                ..good
            },
            "prescribed pressure has 1 values where 100",
        ),
        (
            ContactProblem {
                prescribed_pressure: Some(&bad_gap),
                ..good
            },
            "prescribed pressure[7]",
        ),
        (
            ContactProblem {
                start: Some(&[-1.0; 100]),
                ..good
            },
            "start[0] = -1 Pa",
        ),
        (
            ContactProblem {
                start: Some(&[]),
                ..good
            },
            "start has 0 values",
        ),
        (
            ContactProblem {
                pressure_limit: Some(Pressure::from_si(0.0)),
                ..good
            },
            "pressure limit",
        ),
        (
            ContactProblem {
                pressure_limit: Some(Pressure::from_si(5e8)),
                ..good
            },
            "raise the limit",
        ),
        (
            ContactProblem {
                boundary: Boundary::Periodic(PeriodicKernel::Strip),
                control: approach(1.0),
                ..good
            },
            "control the load",
        ),
    ];
    for (problem, expected) in cases {
        for error in [
            solved(&problem).unwrap_err(),
            solve_dense(&problem).unwrap_err(),
        ] {
            let text = error.to_string();
            assert!(text.contains(expected), "{text} does not say {expected}");
        }
    }
    for tolerance in [0.0, -1.0, f64::NAN] {
        let settings = SolverSettings {
            tolerance,
            ..SolverSettings::default()
        };
        assert!(
            solve(&good, &settings)
                .unwrap_err()
                .to_string()
                .contains("tolerance")
        );
    }
    let mut other = Solver::new(99, Boundary::FreeEnds).unwrap();
    let error = other.solve(&good, &SolverSettings::default()).unwrap_err();
    assert!(
        error
            .to_string()
            .contains("made for 99 points with free ends")
    );
}

#[test]
fn numbers_too_large_to_add_are_an_error_and_not_endless() {
    let gap = [1e308, -1e308, 1e308, 0.0];
    assert!(solved(&hertz_problem(&gap, Length::from_si(1e-6))).is_err());
}

#[test]
fn flanks_that_do_not_match_are_refused() {
    let profile = |points: usize, spacing: f64| {
        Profile::new(Length::from_si(spacing), vec![0.0; points]).unwrap()
    };
    let first = profile(100, 1e-6);
    let flanks = TwoFlanks {
        first: &first,
        second: &first,
        radius: CYLINDER.radius,
        load: CYLINDER.load,
        modulus: CYLINDER.modulus,
        pressure_limit: None,
    };
    assert!(flanks.gap().is_ok());
    for (second, expected) in [
        (profile(99, 1e-6), "second flank has 99 values where 100"),
        (profile(100, 2e-6), "resample"),
    ] {
        let error = TwoFlanks {
            second: &second,
            ..flanks
        }
        .gap()
        .unwrap_err();
        assert!(error.to_string().contains(expected), "{error}");
    }
    let flat = TwoFlanks {
        radius: Length::from_si(0.0),
        ..flanks
    };
    assert!(flat.press(&SolverSettings::default()).is_err());
}

#[test]
fn closed_forms_refuse_what_they_do_not_hold_for() {
    let wave = Wave {
        amplitude: Length::from_si(1e-6),
        wavelength: Length::from_si(1e-3),
        modulus: CYLINDER.modulus,
    };
    let closing = wave.closing_pressure().unwrap();
    assert!(wave.half_width(closing).is_err());
    assert!(wave.mean_gap(-closing).is_err());
    assert!(
        wave.pressure(closing * 0.5, Length::from_si(f64::NAN))
            .is_err()
    );
    assert!(
        Wave {
            amplitude: Length::from_si(0.0),
            ..wave
        }
        .closing_pressure()
        .is_err()
    );
    // Little load leaves the mean gap, and touches at the peaks only.
    let little = wave.mean_gap(closing * 1e-9).unwrap();
    assert!((little / wave.amplitude - 1.0).abs() < 1e-7);
    let edge = flat_punch::pressure(CYLINDER.load, wave.amplitude, wave.amplitude);
    assert!(edge.is_err());
    let datum = Length::from_si(0.0);
    assert!(flat_punch::approach(CYLINDER.load, wave.amplitude, CYLINDER.modulus, datum).is_err());
}

#[test]
fn a_half_plane_refuses_arrays_of_another_length() {
    let spacing = Length::from_si(1e-6);
    let mut plane = HalfPlane::new(4, spacing, CYLINDER.modulus, Boundary::FreeEnds).unwrap();
    assert!(plane.displacement(&[0.0; 3], &mut [0.0; 4]).is_err());
    assert!(plane.displacement(&[0.0; 4], &mut [0.0; 5]).is_err());
    assert!(HalfPlane::new(1, spacing, CYLINDER.modulus, Boundary::FreeEnds).is_err());
    assert!(HalfPlane::new(4, spacing, Pressure::from_si(0.0), Boundary::FreeEnds).is_err());
}

#[test]
fn the_dense_matrix_refuses_what_is_too_large_for_it() {
    let (gap, spacing) = CYLINDER.gap(MAX_POINTS + 1);
    let error = solve_dense(&hertz_problem(&gap, spacing)).unwrap_err();
    assert!(error.to_string().contains("use the solver with transforms"));
}
