//! Helpers shared by the tests.

/// Relative agreement.
#[track_caller]
pub fn close(got: f64, expected: f64, tolerance: f64) {
    assert!(
        (got / expected - 1.0).abs() < tolerance,
        "{got} instead of {expected}"
    );
}
