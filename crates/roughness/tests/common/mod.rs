//! Helpers of several test files.

#![allow(
    clippy::unwrap_used,
    reason = "helpers of tests may unwrap as tests do"
)]

pub mod compared;
pub mod finishes;

use std::f64::consts::TAU;

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

/// Deviates of the standard normal distribution by Box and Muller from a multiplicative congruential sequence.
pub struct Normal(pub u64);

impl Normal {
    /// Uniform between 0 and 1.
    pub fn uniform(&mut self) -> f64 {
        self.0 = self
            .0
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        ((self.0 >> 11) as f64 + 0.5) / (1_u64 << 53) as f64
    }

    /// The next deviate.
    pub fn next(&mut self) -> f64 {
        (-2.0 * self.uniform().ln()).sqrt() * (TAU * self.uniform()).cos()
    }
}
