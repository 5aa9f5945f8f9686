//! The standard normal distribution.

/// 95 % quantile: from 5 % to 95 % a normal distribution reaches this number of standard deviations to either side.
///
/// ```
/// use asperity_core::numerics::{Z_95, standard_normal_below};
/// assert!((standard_normal_below(Z_95) - 0.95).abs() < 1e-15);
/// ```
pub const Z_95: f64 = 1.644_853_626_951_472_7;

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

/// z with Φ(z) = p, Φ(z) = erfc(−z/√2)/2, by bisection; p is held off 0 and 1.
///
/// ```
/// use asperity_core::numerics::{Z_975, standard_normal_quantile};
/// assert!((standard_normal_quantile(0.975) - Z_975).abs() < 1e-12);
/// assert_eq!(standard_normal_quantile(0.5), 0.0);
/// ```
#[must_use]
pub fn standard_normal_quantile(p: f64) -> f64 {
    /// Beyond it no number between 0 and 1 is left.
    const END: f64 = 8.0;
    /// Halvings of the bracket down to the last digit.
    const HALVINGS: usize = 60;
    if p == 0.5 {
        return 0.0;
    }
    let below = |z: f64| standard_normal_below(z) < p;
    let (mut low, mut high) = (-END, END);
    for _ in 0..HALVINGS {
        let middle = 0.5 * (low + high);
        if below(middle) {
            low = middle;
        } else {
            high = middle;
        }
    }
    0.5 * (low + high)
}
