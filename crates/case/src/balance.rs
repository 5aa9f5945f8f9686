//! Invariants of printed results: every number is finite, parts add up to their total, efficiencies lie within 0 and 1
//! and are one minus loss over power.

use asperity_core::number;
use asperity_core::{Code, Fault};

/// Largest difference between a total and its parts, relative to the total: rounding of sums of some thousand terms.
const TOLERANCE: f64 = 1e-9;

/// Numbers of a result that cannot be, or cannot be together.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum Unbalanced {
    /// A number that is not finite.
    #[error("{of} is {value} {unit}, which is not a result", value = number(*value))]
    NotFinite {
        /// Name of the number.
        of: &'static str,
        /// The number.
        value: f64,
        /// Its unit.
        unit: &'static str,
    },
    /// An efficiency below 0 or above 1.
    #[error("{of} is {value}, not within 0 and 1", value = number(*value))]
    Efficiency {
        /// Name of the efficiency.
        of: &'static str,
        /// The efficiency.
        value: f64,
    },
    /// A total that is not the sum of its parts.
    #[error("{of} is {total} {unit}, and its parts together are {parts} {unit}", total = number(*total), parts = number(*parts))]
    Sum {
        /// Name of the total.
        of: &'static str,
        /// The total.
        total: f64,
        /// Sum of the parts.
        parts: f64,
        /// Unit of both.
        unit: &'static str,
    },
}

impl Unbalanced {
    /// Stable code of the message: a state beyond physical sense, or a fault of the program.
    #[must_use]
    pub const fn code(&self) -> Code {
        match self {
            Self::NotFinite { .. } | Self::Efficiency { .. } => Code::E308,
            Self::Sum { .. } => Code::E501,
        }
    }
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
pub fn sum(
    of: &'static str,
    unit: &'static str,
    total: f64,
    parts: &[f64],
) -> Result<(), Unbalanced> {
    for &value in parts.iter().chain([&total]) {
        finite(of, unit, value)?;
    }
    let parts: f64 = parts.iter().sum();
    match (parts - total).abs() <= TOLERANCE * total.abs() {
        true => Ok(()),
        false => Err(Unbalanced::Sum {
            of,
            total,
            parts,
            unit,
        }),
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
pub fn efficiency(of: &'static str, value: f64, loss: f64, input: f64) -> Result<(), Unbalanced> {
    match (0.0..=1.0).contains(&value) {
        true => sum(of, "-", 1.0, &[value, loss / input]),
        false => Err(Unbalanced::Efficiency { of, value }),
    }
}

/// A finite number.
///
/// # Errors
/// If the number is infinite or not a number.
pub fn finite(of: &'static str, unit: &'static str, value: f64) -> Result<(), Unbalanced> {
    match value.is_finite() {
        true => Ok(()),
        false => Err(Unbalanced::NotFinite { of, value, unit }),
    }
}

impl From<Unbalanced> for Fault {
    fn from(error: Unbalanced) -> Self {
        Self::of(error.code(), error)
    }
}
