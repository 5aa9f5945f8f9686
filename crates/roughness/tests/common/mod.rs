//! Helpers of several test files.

#![allow(
    clippy::unwrap_used,
    reason = "helpers of tests may unwrap as tests do"
)]

use asperity_core::Profile;
use asperity_core::quantity::Length;

/// `n` heights z(x), `dx` apart.
pub fn profile(dx: f64, n: usize, z: impl Fn(f64) -> f64) -> Profile {
    Profile::new(
        Length::from_si(dx),
        (0..n).map(|i| z(i as f64 * dx)).collect(),
    )
    .unwrap()
}

/// Equal to `relative`.
pub fn close(found: f64, expected: f64, relative: f64) {
    assert!(
        (found - expected).abs() <= relative * expected.abs(),
        "{found} is not {expected}"
    );
}
