//! Invariants of printed results: every number is finite, parts add up to their total, efficiencies lie within 0 and 1
//! and are one minus loss over power.

use asperity_core::number;
use asperity_core::{Code, Fault};

/// Largest difference between a total and its parts, relative to the total: rounding of sums of some thousand terms.
const TOLERANCE: f64 = 1e-9;

/// The error of an efficiency below 0 or above 1.
pub fn impossible_efficiency(of: &'static str, value: f64) -> Fault {
    let text = format!("{of} is {}, not within 0 and 1", number(value));
    Fault::new(Code::E308, text)
}

/// Σ parts = total, all finite; `of` and `unit` name them in the error.
///
/// # Errors
/// If a number is not finite, or the parts do not add up to the total.
///
/// ```
/// use asperity_case::balance::sum;
/// let loss = |total: f64| sum("loss", "W", total, &[560.0, 10.0]);
/// assert!(loss(570.0).is_ok());
/// assert_eq!(loss(580.0).unwrap_err().code(), "E501");
/// assert_eq!(loss(f64::NAN).unwrap_err().code(), "E308");
/// ```
pub fn sum(of: &'static str, unit: &'static str, total: f64, parts: &[f64]) -> Result<(), Fault> {
    for &value in parts.iter().chain([&total]) {
        finite(of, unit, value)?;
    }
    let parts: f64 = parts.iter().sum();
    if (parts - total).abs() <= TOLERANCE * total.abs() {
        Ok(())
    } else {
        Err(Fault::internal(format!(
            "{of} is {} {unit}, and its parts together are {} {unit}",
            number(total),
            number(parts)
        )))
    }
}

/// 0 ≤ η ≤ 1 and η = 1 − loss/input, with loss and input both powers or both energies.
///
/// # Errors
/// If the efficiency is outside 0 to 1, or does not follow from loss and input.
///
/// ```
/// use asperity_case::balance::efficiency;
/// let of = |value: f64| efficiency("efficiency", value, 1.0, 100.0);
/// assert!(of(0.99).is_ok());
/// assert_eq!(of(1.01).unwrap_err().code(), "E308");
/// assert_eq!(of(0.98).unwrap_err().code(), "E501");
/// ```
pub fn efficiency(of: &'static str, value: f64, loss: f64, input: f64) -> Result<(), Fault> {
    if (0.0..=1.0).contains(&value) {
        sum(of, "-", 1.0, &[value, loss / input])
    } else {
        Err(impossible_efficiency(of, value))
    }
}

/// A finite number.
///
/// # Errors
/// If the number is infinite or not a number.
pub fn finite(of: &'static str, unit: &'static str, value: f64) -> Result<(), Fault> {
    if value.is_finite() {
        Ok(())
    } else {
        Err(Fault::new(
            Code::E308,
            format!("{of} is {} {unit}, which is not a result", number(value)),
        ))
    }
}
