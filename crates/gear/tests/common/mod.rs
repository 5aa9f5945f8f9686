//! Helpers shared by the tests.

use asperity_core::quantity::{Angle, Length};

pub fn mm(value: f64) -> Length {
    Length::from_si(value * 1e-3)
}

pub fn degrees(value: f64) -> Angle {
    Angle::from_si(value.to_radians())
}

/// Both evaluations round in the sixteenth digit; lengths along the path are differences of larger
/// ones and lose up to three.
pub const ROUNDING: f64 = 1e-12;

#[track_caller]
pub fn assert_close(value: f64, expected: f64, relative: f64) {
    assert!(
        (value / expected - 1.0).abs() < relative,
        "{value} is not {expected} to {relative:e}"
    );
}
