//! Invariants of printed results: every number is finite, parts add up to their total, efficiencies lie within 0 and 1
//! and are one minus loss over power.

/// Largest difference between a total and its parts, relative to the total: rounding of sums of some thousand terms.
const TOLERANCE: f64 = 1e-9;

/// Numbers of a result that cannot be, or cannot be together.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum Unbalanced {
    /// A number that is not finite.
    #[error("{of} is {value} {unit}, which is not a result")]
    NotFinite {
        /// Name of the number.
        of: &'static str,
        /// The number.
        value: f64,
        /// Its unit.
        unit: &'static str,
    },
    /// An efficiency below 0 or above 1.
    #[error("{of} is {value}, not within 0 and 1")]
    Efficiency {
        /// Name of the efficiency.
        of: &'static str,
        /// The efficiency.
        value: f64,
    },
    /// A total that is not the sum of its parts.
    #[error("{of} is {total} {unit}, and its parts together are {parts} {unit}")]
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
    pub const fn code(&self) -> &'static str {
        match self {
            Self::NotFinite { .. } | Self::Efficiency { .. } => "E308",
            Self::Sum { .. } => "E501",
        }
    }
}

/// A total and its parts.
#[derive(Debug, Clone, Copy)]
pub struct Balance<'a> {
    /// Name of the total.
    pub of: &'static str,
    /// Unit of total and parts.
    pub unit: &'static str,
    /// The total.
    pub total: f64,
    /// The parts.
    pub parts: &'a [f64],
}

impl Balance<'_> {
    /// Σ parts = total, all finite.
    ///
    /// # Errors
    /// When a number is not finite, or the parts are not those of the total.
    ///
    /// ```
    /// use asperity::balance::Balance;
    /// let of = |total: f64| Balance { of: "loss", unit: "W", total, parts: &[560.0, 10.0] };
    /// assert!(of(570.0).check().is_ok());
    /// assert_eq!(of(580.0).check().unwrap_err().code(), "E501");
    /// assert_eq!(of(f64::NAN).check().unwrap_err().code(), "E308");
    /// ```
    pub fn check(self) -> Result<(), Unbalanced> {
        let Self {
            of, unit, total, ..
        } = self;
        for &value in std::iter::once(&self.total).chain(self.parts) {
            if !value.is_finite() {
                return Err(Unbalanced::NotFinite { of, value, unit });
            }
        }
        let parts: f64 = self.parts.iter().sum();
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
}

/// An efficiency with the loss and the power that it is of.
#[derive(Debug, Clone, Copy)]
pub struct Efficiency {
    /// Name of the efficiency.
    pub of: &'static str,
    /// The efficiency.
    pub value: f64,
    /// Loss, or energy lost.
    pub loss: f64,
    /// Power, or energy, that goes in.
    pub input: f64,
}

impl Efficiency {
    /// 0 ≤ η ≤ 1 and η = 1 − loss/input.
    ///
    /// # Errors
    /// When the efficiency is outside 0 to 1, or of another loss.
    ///
    /// ```
    /// use asperity::balance::Efficiency;
    /// let of = |value: f64| Efficiency { of: "efficiency", value, loss: 1.0, input: 100.0 };
    /// assert!(of(0.99).check().is_ok());
    /// assert_eq!(of(1.01).check().unwrap_err().code(), "E308");
    /// assert_eq!(of(0.98).check().unwrap_err().code(), "E501");
    /// ```
    pub fn check(self) -> Result<(), Unbalanced> {
        let Self {
            of,
            value,
            loss,
            input,
        } = self;
        if !(0.0..=1.0).contains(&value) {
            return Err(Unbalanced::Efficiency { of, value });
        }
        Balance {
            of,
            unit: "-",
            total: 1.0,
            parts: &[value, loss / input],
        }
        .check()
    }
}
