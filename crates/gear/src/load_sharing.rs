//! Load sharing between the tooth pairs in simultaneous contact.
//!
//! Sources: ISO/TR 13989-1:2000 (trapezoid); Pedrero, Pleguezuelos, Artés and Antona 2010 (minimum elastic
//! potential).
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | ξ | profile coordinate in base pitches: 0 at A, ε_α at E | - |
//! | v(ξ) | weight of a pair at ξ | - |
//! | R(ξ) | share of the load that the pair at ξ carries | - |
//!
//! A law defines a weight; the share of a pair is its weight divided by the sum of the weights of all pairs in contact.

use asperity_core::DomainError;
use asperity_core::cite;
use asperity_core::numerics::interpolate;
use serde::{Deserialize, Serialize};

use crate::error::GearError;

/// Rounding error of a profile coordinate.
const ROUNDING: f64 = 1e-12;

/// Share at the ends of the path in the trapezoid (ISO/TR 13989-1:2000, unmodified profiles of good quality).
const TRAPEZOID_START: f64 = 1.0 / 3.0;

/// Contact ratios for which the trapezoid and the minimum-potential weight were derived: at most
/// two pairs in contact.
const TWO_PAIRS: (f64, f64) = (1.0, 2.0);

/// Law of load sharing between tooth pairs in contact.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub enum LoadSharing {
    /// Pairs in contact carry equal loads: 1/2, 1, 1/2 on a spur pair; a constant line load on a
    /// helical one.
    #[default]
    Uniform,
    /// 1/3 rising to 2/3, 1, 2/3 falling to 1/3. Spur pairs with 1 < ε_α ≤ 2.
    Trapezoid,
    /// Minimum elastic potential energy (Pedrero and Pleguezuelos). 1 < ε_α ≤ 2.
    MinPotential,
    /// Rows (position, weight): the position from 0 at A to 1 at E, the weight in any unit, with linear interpolation.
    Table(Vec<(f64, f64)>),
}

impl LoadSharing {
    /// Name in a case file.
    pub fn name(&self) -> &'static str {
        match self {
            Self::Uniform => "uniform",
            Self::Trapezoid => "trapezoid",
            Self::MinPotential => "min-potential",
            Self::Table(_) => "table",
        }
    }

    /// uniform: v = 1                                                           [Load-share-1]
    ///
    /// trapezoid: v = 1/3 + ξ/(3(ε_α − 1)) for ξ < ε_α − 1, the mirror image for ξ > 1, and
    /// 1 between                                                                [Load-share-2]
    ///
    /// min-potential: v = cos(b₀(ξ − ε_α/2)), b₀ = (½(1 + ε_α/2)² − 1)^(−1/2)   [Load-share-3]
    ///
    /// # Errors
    /// When ξ is not on the path, or the law does not hold for ε_α.
    ///
    /// ```
    /// use asperity_gear::LoadSharing;
    /// let middle = LoadSharing::MinPotential.weight(0.8, 1.6)?;
    /// assert!((middle - 1.0).abs() < 1e-15);
    /// # Ok::<(), asperity_gear::GearError>(())
    /// ```
    pub fn weight(&self, xi: f64, eps_alpha: f64) -> Result<f64, GearError> {
        let weights = Weights::new(self, eps_alpha)?;
        weights.require_contact(xi)?;
        Ok(weights.at(xi))
    }

    /// R(ξ) = v(ξ)/Σⱼ v(ξ + j), over all pairs in contact                       [Load-share-4]
    ///
    /// # Errors
    /// When ξ is not on the path, or the law does not hold for ε_α.
    ///
    /// ```
    /// use asperity_gear::LoadSharing;
    /// assert_eq!(LoadSharing::Uniform.share(0.2, 1.6)?, 0.5);
    /// assert_eq!(LoadSharing::Uniform.share(0.8, 1.6)?, 1.0);
    /// # Ok::<(), asperity_gear::GearError>(())
    /// ```
    pub fn share(&self, xi: f64, eps_alpha: f64) -> Result<f64, GearError> {
        let weights = Weights::new(self, eps_alpha)?;
        weights.require_contact(xi)?;
        Ok(weights.share(xi))
    }
}

/// A law that holds for a contact ratio.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Weights<'a> {
    law: &'a LoadSharing,
    eps_alpha: f64,
    /// b₀ of `[Load-share-3]`; unused by the other laws.
    b0: f64,
}

impl<'a> Weights<'a> {
    pub(crate) fn new(law: &'a LoadSharing, eps_alpha: f64) -> Result<Self, GearError> {
        DomainError::require(
            eps_alpha.is_finite() && eps_alpha > 0.0,
            "transverse contact ratio",
            eps_alpha,
            "-",
            "must be finite and greater than zero",
        )?;
        match law {
            LoadSharing::Uniform => cite!("Load-share-1"),
            LoadSharing::Trapezoid | LoadSharing::MinPotential => {
                if matches!(law, LoadSharing::Trapezoid) {
                    cite!("Load-share-2");
                } else {
                    cite!("Load-share-3");
                }
                let (low, high) = TWO_PAIRS;
                if !(eps_alpha > low && eps_alpha <= high) {
                    return Err(GearError::sharing_range(law.name(), eps_alpha, low, high));
                }
            }
            LoadSharing::Table(rows) => check_table(rows)?,
        }
        let b0 = (0.5 * (1.0 + 0.5 * eps_alpha).powi(2) - 1.0).powf(-0.5);
        Ok(Self { law, eps_alpha, b0 })
    }

    fn in_contact(&self, xi: f64) -> bool {
        xi >= -ROUNDING && xi <= self.eps_alpha + ROUNDING
    }

    fn require_contact(&self, xi: f64) -> Result<(), GearError> {
        if self.in_contact(xi) {
            return Ok(());
        }
        Err(GearError::coordinate_off_path(xi, self.eps_alpha))
    }

    /// v(ξ); 0 outside the path.
    pub(crate) fn at(&self, xi: f64) -> f64 {
        if !self.in_contact(xi) {
            return 0.0;
        }
        let eps = self.eps_alpha;
        match self.law {
            LoadSharing::Uniform => 1.0,
            LoadSharing::Trapezoid => {
                let from_end = xi.min(eps - xi);
                let double_contact = eps - 1.0;
                if from_end > double_contact {
                    1.0
                } else {
                    TRAPEZOID_START + (1.0 - 2.0 * TRAPEZOID_START) * from_end / double_contact
                }
            }
            LoadSharing::MinPotential => (self.b0 * (xi - 0.5 * eps)).cos(),
            LoadSharing::Table(rows) => interpolate(rows, xi / eps),
        }
    }

    /// R(ξ), for ξ on the path.
    pub(crate) fn share(&self, xi: f64) -> f64 {
        cite!("Load-share-4");
        let neighbours = self.eps_alpha.ceil() as i64;
        let all: f64 = (-neighbours..=neighbours)
            .map(|j| self.at(xi + j as f64))
            .sum();
        self.at(xi) / all
    }

    /// ∫ v dξ over the whole path.
    pub(crate) fn integral(&self) -> f64 {
        let eps = self.eps_alpha;
        match self.law {
            LoadSharing::Uniform => eps,
            // 2(ε_α − 1) base pitches of double contact at 1/2 on average, 2 − ε_α of single at 1.
            LoadSharing::Trapezoid => 1.0,
            LoadSharing::MinPotential => 2.0 * (0.5 * self.b0 * eps).sin() / self.b0,
            LoadSharing::Table(rows) => rows
                .windows(2)
                .map(|ends| 0.5 * eps * (ends[1].0 - ends[0].0) * (ends[0].1 + ends[1].1))
                .sum(),
        }
    }

    /// Coordinates of kinks of v within the path.
    pub(crate) fn knots(&self) -> Vec<f64> {
        match self.law {
            LoadSharing::Table(rows) => rows.iter().map(|row| row.0 * self.eps_alpha).collect(),
            _ => Vec::new(),
        }
    }
}

fn check_table(rows: &[(f64, f64)]) -> Result<(), GearError> {
    let error_at = |row: usize, rule: &'static str| {
        let (xi, share) = rows.get(row).copied().unwrap_or((f64::NAN, f64::NAN));
        Err(GearError::sharing_table(row, xi, share, rule))
    };
    let last = rows.len().saturating_sub(1);
    if rows.len() < 2 {
        return error_at(last, "a table needs at least two rows");
    }
    for (row, &(position, weight)) in rows.iter().enumerate() {
        if !(weight.is_finite() && weight >= 0.0) {
            return error_at(row, "the weight must be finite and not negative");
        }
        if weight == 0.0 && row != 0 && row != last {
            return error_at(row, "only the ends of the path may carry nothing");
        }
        if row == 0 && position != 0.0 {
            return error_at(row, "the first position must be 0, point A");
        }
        if position.is_nan() || row > 0 && position <= rows[row - 1].0 {
            return error_at(row, "places must increase");
        }
    }
    if rows[last].0 != 1.0 {
        return error_at(last, "the last position must be 1, point E");
    }
    if last == 1 && rows[0].1 == 0.0 && rows[1].1 == 0.0 {
        return error_at(last, "some weight must be positive");
    }
    Ok(())
}
