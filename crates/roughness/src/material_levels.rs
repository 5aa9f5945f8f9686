//! Material ratio at a level, level at a material ratio, and height difference between two ratios.
//!
//! Source: ISO 4287:1997, 4.5 (Rmr(c), Rδc, relative Rmr) and ISO 21920-2:2021 (Rmr(c), Rmc(p), Rdc(p, q)), over
//! the evaluation length. Levels are heights above the mean line.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | c | level, height above the mean line | m |
//! | Rmr(c) | material ratio: fraction of the evaluation length in the material at c | % |
//! | Rmc(p) | level at which the material ratio is p | m |
//! | Rdc(p, q) | Rmc(p) − Rmc(q), p < q | m |

use asperity_core::cite;
use asperity_core::quantity::Length;

use crate::error::RoughnessError;
use crate::material_ratio::{curve, cut};

/// Material ratio curve of a profile for computing levels and ratios.
///
/// ```
/// use asperity_core::quantity::Length;
/// use asperity_roughness::material_levels::MaterialLevels;
/// // A triangular profile from −1 um to 1 um has a straight curve.
/// let heights: Vec<f64> = (0..2000).map(|i| (f64::from(i) - 999.5) * 1e-9).collect();
/// let levels = MaterialLevels::from_heights(&heights)?;
/// assert!((levels.ratio(Length::from_si(0.5e-6)) - 25.0).abs() < 1e-9);
/// assert!((levels.difference(5.0, 75.0)?.si() - 1.4e-6).abs() < 1e-15);
/// # Ok::<(), asperity_roughness::RoughnessError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct MaterialLevels {
    /// Heights in descending order; the height of point k is the level at (k + ½)/N.
    curve: Vec<f64>,
}

impl MaterialLevels {
    /// The curve of `heights` \[m\] of a filtered profile over its evaluation length.
    ///
    /// # Errors
    /// When there are fewer than ten heights, or one is not finite.
    pub fn from_heights(heights: &[f64]) -> Result<Self, RoughnessError> {
        Ok(Self {
            curve: curve(heights)?,
        })
    }

    /// Material ratio at a level `[%]`, 0 above the highest point and 100 below the lowest.
    ///
    /// ```text
    /// Rmr(c) = Ml(c)/l_e                                                           [Rmr-1]
    /// ```
    pub fn ratio(&self, level: Length) -> f64 {
        cite!("Rmr-1");
        let count = self.curve.len() as f64;
        cut(&self.curve, level.si(), |k| {
            (k as f64 + 0.5) / count * 100.0
        })
    }

    /// Level at which the material ratio is `ratio` `[%]`; beyond the ends of the curve, the highest or lowest point.
    ///
    /// ```text
    /// Rmr(Rmc(p)) = p                                                              [Rmr-2]
    /// ```
    ///
    /// # Errors
    /// When the ratio is not within 0 and 100 %.
    pub fn level(&self, ratio: f64) -> Result<Length, RoughnessError> {
        cite!("Rmr-2");
        if !(0.0..=100.0).contains(&ratio) {
            return Err(RoughnessError::Domain(asperity_core::DomainError {
                name: "material ratio",
                value: ratio,
                unit: "%",
                rule: "from 0 to 100",
            }));
        }
        let last = self.curve.len() - 1;
        let at = (ratio / 100.0 * self.curve.len() as f64 - 0.5).clamp(0.0, last as f64);
        let below = (at.floor() as usize).min(last);
        let (high, low) = (self.curve[below], self.curve[(below + 1).min(last)]);
        Ok(Length::from_si(high + (low - high) * (at - below as f64)))
    }

    /// Rdc(p, q) = Rmc(p) − Rmc(q), called Rδc in ISO 4287                            [Rmr-3]
    ///
    /// # Errors
    /// When a ratio is not within 0 and 100 %, or p is not below q.
    pub fn difference(&self, p: f64, q: f64) -> Result<Length, RoughnessError> {
        cite!("Rmr-3");
        let (upper, lower) = (self.level(p)?, self.level(q)?);
        if p >= q {
            return Err(RoughnessError::Domain(asperity_core::DomainError {
                name: "first material ratio",
                value: p,
                unit: "%",
                rule: "below the second",
            }));
        }
        Ok(upper - lower)
    }

    /// Rmr of ISO 4287 `[%]` at the depth `depth` below the level of the ratio `reference` `[%]`.
    ///
    /// ```text
    /// Rmr = Rmr(c₁), c₁ = Rmc(Rmr0) − Rδc                                          [Rmr-4]
    /// ```
    ///
    /// # Errors
    /// When the reference is not within 0 and 100 %.
    pub fn ratio_below(&self, reference: f64, depth: Length) -> Result<f64, RoughnessError> {
        cite!("Rmr-4");
        Ok(self.ratio(self.level(reference)? - depth))
    }
}
