//! Scope of the published friction laws, for a comparison that applies each as a whole.
//!
//! The coefficient of a law fitted to gears, rollers or mixed-EHL solutions includes asperity friction. A comparison
//! applies such a law as a whole, reports whether its inputs are within its data, and adds no boundary part.
//!
//! | law | asperities inside | fitted to |
//! |---|---|---|
//! | `xu` | yes (mixed-EHL solutions) | one 75W90 |
//! | `benedict-kelley` | yes (roller tests) | mineral oils |
//! | `iso-14179-1` | yes (gears) | mineral oils |
//! | `iso-14179-2` | yes (FZG gears) | mineral, PAO and PAG by X_L |
//! | `matsumoto`, `doleschel` | explicit, with the coefficients of their own test rigs | one pair of coefficients an oil |
//! | `eyring` | no | three base oils of ISO VG 100 |
//! | `constant` | as the number | - |

use asperity_core::quantity::{Pressure, Temperature};
use asperity_core::{DomainError, FittedRange, OutOfRange};
use serde::Serialize;

use crate::error::FrictionError;

/// Whether the coefficient of a friction law includes asperity friction.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Asperities {
    /// The coefficient holds for rough flanks in mixed friction.
    Included,
    /// The law shares the load between film and boundary itself.
    Shared,
    /// The coefficient holds for a full film.
    Excluded,
    /// Unknown.
    Unknown,
}

/// Scope of a published friction law.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[non_exhaustive]
pub struct PublishedLaw {
    /// Name in a case file.
    pub name: &'static str,
    /// Whether its coefficient includes asperity friction.
    pub asperities: Asperities,
    /// Data it was fitted to.
    pub fitted_to: &'static str,
    /// Whether the law leaves the rolling resistance out, so that it is added.
    pub excludes_rolling: bool,
    /// Whether the law has its own constants, so that a comparison can apply it as a whole.
    pub is_whole: bool,
    /// Name of the law in notes on the ranges below.
    #[serde(skip)]
    pub(crate) judged: &'static str,
    /// Oil temperatures \[°C\] of the data.
    #[serde(skip)]
    pub(crate) celsius: Option<[f64; 2]>,
    /// Largest Hertz pressures \[GPa\] of the data, unless the law checks them itself.
    #[serde(skip)]
    pub(crate) gigapascals: Option<[f64; 2]>,
}

impl PublishedLaw {
    /// Whether the coefficient includes asperity friction.
    #[must_use]
    pub const fn includes_asperities(&self) -> bool {
        matches!(self.asperities, Asperities::Included | Asperities::Shared)
    }

    /// Note on an oil temperature outside the data of the law. The sources state no range, so it is assumed; every
    /// other limit is in the law's own [`Checked`] value.
    ///
    /// [`Checked`]: asperity_core::Checked
    ///
    /// # Errors
    /// When the temperature is not positive.
    ///
    /// ```
    /// use asperity_tribo_friction::FrictionLaw;
    /// let cold = FrictionLaw::Xu.published().outside("-20 °C".parse()?)?;
    /// assert_eq!(cold.len(), 1);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn outside(&self, oil: Temperature) -> Result<Vec<OutOfRange>, FrictionError> {
        DomainError::positive("oil temperature", oil)?;
        Ok(self.notes("oil temperature", oil.celsius(), "°C", self.celsius))
    }

    /// Note on a largest Hertz pressure outside the data of the law, unless the law checks it itself.
    ///
    /// # Errors
    /// When the pressure is negative.
    ///
    /// ```
    /// use asperity_tribo_friction::FrictionLaw;
    /// let hard = FrictionLaw::BenedictKelley.published().outside_pressure("2.4 GPa".parse()?)?;
    /// assert_eq!(hard.len(), 1);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn outside_pressure(&self, hertz: Pressure) -> Result<Vec<OutOfRange>, FrictionError> {
        let giga = DomainError::non_negative("maximum pressure", hertz)? * 1e-9;
        Ok(self.notes("maximum pressure", giga, "GPa", self.gigapascals))
    }

    fn notes(
        &self,
        name: &'static str,
        value: f64,
        unit: &'static str,
        range: Option<[f64; 2]>,
    ) -> Vec<OutOfRange> {
        let mut outside = Vec::new();
        if let Some([low, high]) = range {
            let correlation = self.judged;
            let range = FittedRange::new(name, low, high, unit, correlation);
            range.check(value, &mut outside);
        }
        outside
    }
}
