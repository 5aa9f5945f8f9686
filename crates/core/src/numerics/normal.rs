//! The standard normal distribution.

/// 95 % quantile: from 5 % to 95 % a normal distribution reaches this number of standard deviations to either side.
///
/// ```
/// use asperity_core::numerics::{Z_95, standard_normal_below};
/// assert!((standard_normal_below(Z_95) - 0.95).abs() < 1e-15);
/// ```
pub const Z_95: f64 = 1.644_853_626_951_472_7;

/// 75 % quantile: half of all values lie within this number of standard deviations of the mean.
///
/// ```
/// use asperity_core::numerics::{Z_75, standard_normal_below};
/// assert!((standard_normal_below(Z_75) - 0.75).abs() < 1e-15);
/// ```
pub const Z_75: f64 = 0.674_489_750_196_081_7;

/// 97.5 % quantile: the ends of a band of 95 % of a normal distribution.
///
/// ```
/// use asperity_core::numerics::{Z_975, standard_normal_below};
/// assert!((standard_normal_below(Z_975) - 0.975).abs() < 1e-15);
/// ```
pub const Z_975: f64 = 1.959_963_984_540_054;

/// Φ(z) = erfc(−z/√2)/2
///
/// ```
/// use asperity_core::numerics::standard_normal_below;
/// assert_eq!(standard_normal_below(0.0), 0.5);
/// ```
#[must_use]
pub fn standard_normal_below(z: f64) -> f64 {
    0.5 * libm::erfc(-z / std::f64::consts::SQRT_2)
}

/// z with Φ(z) = p, Φ(z) = erfc(−z/√2)/2; p is held off 0 and 1.
///
/// A start within 4.5e-4 (Abramowitz and Stegun 26.2.23) and two steps of Halley's iteration, whose error is of third order:
///
/// ```text
/// z' = z − u/(1 + z u/2),  u = (Φ(z) − p) √(2π) exp(z²/2)
/// ```
///
/// ```
/// use asperity_core::numerics::{Z_975, standard_normal_quantile};
/// assert!((standard_normal_quantile(0.975) - Z_975).abs() < 1e-15);
/// assert!((standard_normal_quantile(1e-10) + 6.361_340_902_404_056).abs() < 1e-13);
/// assert_eq!(standard_normal_quantile(0.5), 0.0);
/// ```
#[must_use]
pub fn standard_normal_quantile(p: f64) -> f64 {
    /// Φ(−8): above 1 less this no number below 1 is left.
    const LEAST: f64 = 6.220_960_574_271_785e-16;
    if p == 0.5 {
        return 0.0;
    }
    // In the lower tail Φ keeps its digits.
    let tail = p.min(1.0 - p).max(LEAST);
    let t = (-2.0 * tail.ln()).sqrt();
    let above = 2.515_517 + t * (0.802_853 + t * 0.010_328);
    let below = 1.0 + t * (1.432_788 + t * (0.189_269 + t * 0.001_308));
    let mut z = above / below - t;
    for _ in 0..2 {
        let density = (-0.5 * z * z).exp() / std::f64::consts::TAU.sqrt();
        let step = (standard_normal_below(z) - tail) / density;
        z -= step / (1.0 + 0.5 * z * step);
    }
    if p < 0.5 { z } else { -z }
}
