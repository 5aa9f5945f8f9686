//! Bulk temperature of the gears from the loss of their mesh.

#![allow(
    clippy::unwrap_used,
    reason = "helpers of tests may unwrap as tests do"
)]

use asperity_core::quantity::{Length, Power, Temperature, ThermalConductance};
use asperity_core::{Code, Fault};
use asperity_efficiency::EfficiencyError;
use asperity_efficiency::bulk_temperature::{HotterStart, Network, fixed_point, iso_rise};

fn celsius(value: f64) -> Temperature {
    Temperature::from_celsius(value)
}

fn rise(loss: f64, a: f64, b: f64, x_s: f64) -> f64 {
    let [a, b] = [a, b].map(|mm| Length::from_si(mm * 1e-3));
    iso_rise(Power::from_si(loss), a, b, x_s).unwrap()
}

#[test]
fn rises_are_those_of_an_independent_computation() {
    for (loss, a, b, x_s, expected) in [
        (400.0, 91.5, 14.0, 1.0, 18.4543),
        (400.0, 91.5, 14.0, 1.2, 22.1452),
        (400.0, 91.5, 14.0, 0.2, 3.69087),
        (1132.0, 89.2453, 32.0, 1.2, 26.2949),
        (100.0, 91.5, 14.0, 1.0, 6.80166),
    ] {
        // Printed to six digits.
        assert!(
            (rise(loss, a, b, x_s) / expected - 1.0).abs() < 5e-6,
            "{loss} {x_s}"
        );
    }
}

#[test]
fn two_gears_in_oil_have_their_temperatures() {
    let g = ThermalConductance::from_si;
    let network = Network {
        to_oil: [g(12.0), g(18.0)],
        between: g(3.0),
    };
    let [pinion, wheel] = network.rises(Power::from_si(400.0), 0.5).unwrap();
    assert!((pinion - 15.68627).abs() < 5e-6 && (wheel - 11.76471).abs() < 5e-6);
    // All heat leaves by the oil.
    assert!((12.0 * pinion + 18.0 * wheel - 400.0).abs() < 1e-10);
}

#[test]
fn the_fixed_point_of_a_loss_that_falls_with_temperature_is_met() {
    let made = |at: Temperature| -> Result<Temperature, EfficiencyError> {
        let loss = 400.0 / (1.0 + 0.01 * (at - celsius(90.0)).si()).sqrt();
        Ok(celsius(90.0 + rise(loss, 91.5, 14.0, 1.0)))
    };
    let found = fixed_point(celsius(90.0), made).unwrap();
    // 107.41783 °C by an independent computation.
    assert!((found.temperature - celsius(107.41783)).si().abs() < 0.01);
    assert!(found.residual < 0.01 && found.steps == 12 && found.hotter == HotterStart::Same);
}

#[test]
fn a_loss_that_rises_with_temperature_has_two_bulk_temperatures() {
    // Cold below a step at 120 °C, hot above it.
    let made = |at: Temperature| -> Result<Temperature, EfficiencyError> {
        Ok(celsius(if at < celsius(120.0) { 100.0 } else { 140.0 }))
    };
    let found = fixed_point(celsius(90.0), made).unwrap();
    assert!((found.temperature - celsius(100.0)).si().abs() < 0.01);
    let HotterStart::Elsewhere(hotter) = found.hotter else {
        panic!("{found:?}");
    };
    assert!((hotter - celsius(140.0)).si().abs() < 0.01);
}

#[test]
fn a_temperature_that_does_not_settle_is_an_error() {
    let made = |at: Temperature| -> Result<Temperature, EfficiencyError> {
        Ok(Temperature::from_si(at.si() + 1.0))
    };
    let error = fixed_point(celsius(90.0), made).unwrap_err();
    let error = Fault::from(error);
    assert_eq!(error.code(), Code::E311);
    let start = "the bulk temperature did not settle in 50 steps (last ";
    assert!(error.message().starts_with(start), "{error}");
}

#[test]
fn a_state_refused_on_the_way_is_told_with_the_last_temperature_that_was_not() {
    let made = |at: Temperature| -> Result<Temperature, EfficiencyError> {
        if at > celsius(100.0) {
            Err(EfficiencyError::from(
                asperity_core::DomainError::positive("made", Temperature::from_si(-1.0))
                    .unwrap_err(),
            ))
        } else {
            Ok(Temperature::from_si(at.si() + 8.0))
        }
    };
    // 90, 94 and 98 °C are met, 102 °C is not.
    let error = fixed_point(celsius(90.0), made).unwrap_err();
    let expected =
        "the bulk temperature did not settle in 3 steps (last 98 °C, still moving by 8.00 K)";
    assert_eq!(error.to_string(), expected);
}
