//! Published friction laws, for a comparison of complete laws.
//!
//! A law fitted to gears, rollers or mixed-EHL solutions includes asperity friction. A comparison prints its
//! coefficient times its loss factor, and whether the inputs are within its fitted range; the coefficient never
//! enters a formula that adds a boundary part.
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
use crate::friction_law::FrictionLaw;

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
    /// Nothing is known of the coefficient.
    Unknown,
}

/// A published friction law as a row of a comparison.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct PublishedLaw {
    /// The law.
    pub law: FrictionLaw,
    /// Whether its coefficient includes asperity friction.
    pub asperities: Asperities,
    /// Data it was fitted to.
    pub fitted_to: &'static str,
    /// Whether the law leaves the rolling resistance out, so that it is added.
    pub excludes_rolling: bool,
    #[serde(skip)]
    temperature: Option<FittedRange>,
    #[serde(skip)]
    pressure: Option<FittedRange>,
}

const fn celsius(low: f64, high: f64, correlation: &'static str) -> Option<FittedRange> {
    Some(FittedRange {
        name: "oil temperature",
        low,
        high,
        unit: "°C",
        correlation,
    })
}

const fn gigapascals(low: f64, high: f64, correlation: &'static str) -> Option<FittedRange> {
    Some(FittedRange {
        name: "maximum pressure",
        low,
        high,
        unit: "GPa",
        correlation,
    })
}

impl FrictionLaw {
    /// Properties of the law besides its formula.
    ///
    /// ```
    /// use asperity_tribo_friction::{FrictionLaw, published_law::Asperities};
    /// assert_eq!(FrictionLaw::Xu.published().asperities, Asperities::Included);
    /// assert_eq!(FrictionLaw::Eyring.published().asperities, Asperities::Excluded);
    /// ```
    #[must_use]
    pub const fn published(self) -> PublishedLaw {
        let (asperities, fitted_to, excludes_rolling, temperature) = match self {
            Self::Xu => (
                Asperities::Included,
                "mixed-EHL solutions of one 75W90",
                true,
                celsius(40.0, 120.0, "Xu (judgement)"),
            ),
            Self::BenedictKelley => (
                Asperities::Included,
                "roller tests with mineral oils",
                true,
                celsius(30.0, 120.0, "Benedict-Kelley (judgement)"),
            ),
            Self::Iso14179Part1 => (
                Asperities::Included,
                "gears with mineral oils",
                false,
                celsius(30.0, 110.0, "ISO/TR 14179-1 (judgement)"),
            ),
            Self::Iso14179Part2 => (
                Asperities::Included,
                "FZG gears; mineral, PAO and PAG by X_L",
                false,
                celsius(30.0, 120.0, "ISO/TR 14179-2 (judgement)"),
            ),
            Self::Matsumoto => (
                Asperities::Shared,
                "twin-disc tests; coefficients of the oils tested",
                true,
                celsius(40.0, 120.0, "Matsumoto (judgement)"),
            ),
            Self::Doleschel => (
                Asperities::Shared,
                "FZG gears and twin discs; coefficients of the oils tested",
                true,
                celsius(40.0, 120.0, "Doleschel (judgement)"),
            ),
            Self::Eyring => (
                Asperities::Excluded,
                "twin discs, base oils of ISO VG 100",
                true,
                celsius(40.0, 120.0, "Eyring (Arana) (judgement)"),
            ),
            Self::Constant => (Asperities::Unknown, "a given number", true, None),
        };
        // Xu's and Arana's laws check the pressure themselves; rollers and gears of the others ran at these
        // (judgement, the texts give none).
        let pressure = match self {
            Self::BenedictKelley => gigapascals(0.3, 2.0, "Benedict-Kelley (judgement)"),
            Self::Iso14179Part1 => gigapascals(0.3, 2.0, "ISO/TR 14179-1 (judgement)"),
            Self::Iso14179Part2 => gigapascals(0.3, 2.0, "ISO/TR 14179-2 (judgement)"),
            Self::Matsumoto => gigapascals(0.3, 2.0, "Matsumoto (judgement)"),
            Self::Doleschel => gigapascals(0.3, 2.0, "Doleschel (judgement)"),
            _ => None,
        };
        PublishedLaw {
            law: self,
            asperities,
            fitted_to,
            excludes_rolling,
            temperature,
            pressure,
        }
    }
}

impl PublishedLaw {
    /// Whether the coefficient includes asperity friction.
    #[must_use]
    pub const fn includes_asperities(&self) -> bool {
        matches!(self.asperities, Asperities::Included | Asperities::Shared)
    }

    /// The oil temperature, where it lies outside those that the law was fitted at. The texts of the
    /// sources give none, so the range is judgement; every other limit is in the law's own [`Checked`] value.
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
        let celsius = oil.celsius();
        let mut outside = Vec::new();
        if let Some(range) = &self.temperature {
            range.check(celsius, &mut outside);
        }
        Ok(outside)
    }

    /// The largest Hertz pressure, if it is outside the fitted range and the law does not check it itself.
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
        let mut outside = Vec::new();
        if let Some(range) = &self.pressure {
            range.check(giga, &mut outside);
        }
        Ok(outside)
    }
}
