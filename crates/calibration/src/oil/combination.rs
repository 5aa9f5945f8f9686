//! Constants that the points determine only in combination.

use asperity_core::numerics::Z_95;
use asperity_core::{Estimate, EstimateKeys, estimate_keys};
use serde::{Deserialize, Serialize};

use super::fit::LawFit;
use super::problem::{FALL, LIMIT, STATED_CONSTANTS};
use crate::block::digits;
use crate::information::correlations;

/// Correlation above which two constants are reported as their combination.
const COMBINED: f64 = 0.95;
/// Temperature of the limiting shear stress of an oil \[°C\].
const REFERENCE_C: f64 = 90.0;

estimate_keys! { pub(super) Ranged: "value" "range"; }

/// Combination of two constants that is known better than either of them.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct Combination {
    /// Keys of the constants.
    pub keys: [String; 2],
    /// Their correlation.
    pub correlation: f64,
    /// The combination in words.
    pub text: String,
    /// Its value with 5 % and 95 % quantile.
    #[serde(flatten, with = "Ranged")]
    pub fitted: Estimate,
}

impl Combination {
    /// The combination with its value and the reason for it.
    #[must_use]
    pub fn sentence(&self) -> String {
        format!(
            "{} = {} ({} to {}, 5 to 95 %); the points do not separate the constants (correlation {:+.2})",
            self.text,
            digits(self.fitted.value),
            digits(self.fitted.low),
            digits(self.fitted.high),
            self.correlation
        )
    }
}

/// The combinations of the stated constants of a fit with `values`, whose linearised bands are widened by `factor`.
///
/// Of two correlated variables a and b, a − (cov_ab/var_b) b is not correlated with b and has the least variance.
pub(super) fn combinations(fit: &LawFit<'_>, values: &[f64], factor: f64) -> Vec<Combination> {
    let all = correlations(&fit.covariance);
    let mut found = Vec::new();
    for i in 0..values.len() {
        for j in i + 1..values.len() {
            let correlation = all[(i, j)];
            if correlation.abs() <= COMBINED {
                continue;
            }
            // The coefficient of the temperature stands second: a constant has its value at another temperature.
            let (first, second) = if i == FALL { (j, i) } else { (i, j) };
            let deviation = |k: usize| factor * fit.constant_deviation(k);
            let weight = -correlation * deviation(first) / deviation(second);
            let left = deviation(first) * (1.0 - correlation * correlation).sqrt();
            let name = |k: usize| STATED_CONSTANTS[k].1;
            let unit = match STATED_CONSTANTS[first].2 {
                "" => String::new(),
                unit => format!(" [{unit}]"),
            };
            let of = format!("{}{unit}", name(first));
            let (text, logarithm) = match (first, second) {
                (LIMIT, FALL) => (
                    format!("{of} at {:.0} °C", REFERENCE_C - weight),
                    weight * values[second],
                ),
                (_, FALL) => (
                    format!(
                        "{of} times the exponential of {weight:.0} K times the {}",
                        name(second)
                    ),
                    weight * values[second],
                ),
                _ => (
                    format!("{of} times {} to the power of {weight:.2}", name(second)),
                    weight * values[second].ln(),
                ),
            };
            let value = values[first] * logarithm.exp();
            found.push(Combination {
                keys: [first, second].map(|k| STATED_CONSTANTS[k].0.to_owned()),
                correlation,
                text,
                fitted: Estimate::new(value, [-Z_95, Z_95].map(|z| value * (z * left).exp())),
            });
        }
    }
    found
}
