//! Draws of calibrated parameters.

use asperity::case::{CalibratedName, CalibrationInput, CorrelationInput, LoadedCase, cholesky};
use asperity::uncertainty::{UncertainParameter, range};
use asperity_core::Estimate;
use asperity_core::numerics::{Z_95, Z_975};

fn case(change: impl Fn(&mut CalibrationInput)) -> Result<LoadedCase, asperity::Error> {
    let file = std::path::Path::new("../../fixtures/cases/e-drive.toml");
    let mut given = CalibrationInput {
        boundary_friction: Some(Estimate {
            value: 0.09,
            low: 0.08,
            high: 0.11,
        }),
        ..CalibrationInput::default()
    };
    change(&mut given);
    asperity::case::load_with(file, &|input| input.calibration = Some(given.clone()))
}

#[test]
fn calibrated_values_take_the_place_of_defaults_and_their_bands_of_the_ranges() {
    let found = case(|given| {
        given.eyring_stress = Some(Estimate {
            value: "4.4 MPa".parse().unwrap(),
            low: "4.1 MPa".parse().unwrap(),
            high: "4.8 MPa".parse().unwrap(),
        });
    })
    .unwrap();
    assert_eq!(found.case.model.boundary_friction, 0.09);
    let at_stated = found.at_stated().unwrap();
    // 5 and 95 % quantiles of lognormal constants with these of 2.5 and 97.5 %.
    for (name, value, ends) in [
        (UncertainParameter::BoundaryFriction, 0.09, [0.08, 0.11]),
        (UncertainParameter::EyringStress, 4.4e6, [4.1e6, 4.8e6]),
    ] {
        let range = range(name, &at_stated).unwrap().unwrap();
        assert_eq!(range.value, value);
        for (end, band) in range.ends().into_iter().zip(ends) {
            let expected = value * f64::powf(band / value, Z_95 / Z_975);
            assert!((end / expected - 1.0).abs() < 1e-12, "{end} {expected}");
        }
    }
    // What is not calibrated keeps its range.
    assert_eq!(
        range(UncertainParameter::BoundaryLayer, &at_stated).unwrap(),
        Some(Estimate::new(10e-9, [5e-9, 20e-9]))
    );
    let key = "model.boundary_friction";
    assert!(found.case.defaults.iter().all(|default| default.key != key));
}

#[test]
fn a_band_without_its_value_and_values_given_twice_are_refused() {
    let refused = |found: Result<LoadedCase, asperity::Error>, part: &str| {
        let error = found.err().unwrap();
        assert_eq!(error.code(), "E205");
        assert!(error.to_string().contains(part), "{error}");
    };
    refused(
        case(|given| given.boundary_friction.as_mut().unwrap().low = 0.095),
        "0 < low < high",
    );
    let pair = |value| CorrelationInput {
        between: [
            CalibratedName::BoundaryFriction,
            CalibratedName::BoundaryLayer,
        ],
        value,
    };
    refused(
        case(|given| given.correlations = Some(vec![pair(1.0)])),
        "contradict each other",
    );
    let twice = case(|_| {})
        .unwrap()
        .with_key("model.boundary_friction", "0.1");
    refused(twice, "leave one of the two out");
}

fn with(pairs: &[(CalibratedName, CalibratedName, f64)]) -> CalibrationInput {
    let pairs = pairs.iter().map(|&(a, b, value)| CorrelationInput {
        between: [a, b],
        value,
    });
    CalibrationInput {
        correlations: Some(pairs.collect()),
        ..CalibrationInput::default()
    }
}

fn triangle(given: &CalibrationInput) -> Option<Vec<Vec<f64>>> {
    let all = CalibratedName::ALL;
    cholesky(all.len(), |i, j| given.correlation(all[i], all[j]))
}

#[test]
fn the_triangle_gives_the_correlations_back() {
    let [a, b, c, _] = CalibratedName::ALL;
    let given = with(&[(a, b, -0.9), (c, b, 0.3)]);
    let lower = triangle(&given).unwrap();
    for i in 0..4 {
        for j in 0..4 {
            let product: f64 = lower[i].iter().zip(&lower[j]).map(|(a, b)| a * b).sum();
            let [first, other] = [i, j].map(|k| CalibratedName::ALL[k]);
            assert!((product - given.correlation(first, other)).abs() < 1e-15);
        }
    }
}

#[test]
fn correlations_of_no_distribution_have_no_triangle() {
    let [a, b, c, _] = CalibratedName::ALL;
    let pairs = [(a, b, 0.9), (b, c, 0.9), (a, c, -0.9)];
    assert!(triangle(&with(&pairs)).is_none());
    assert!(triangle(&with(&[(a, b, 1.0)])).is_none());
}
