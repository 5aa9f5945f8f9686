//! Stiffness of a pair of teeth according to ISO 6336-1, for unknown root forms.
//!
//! Source: ISO 6336-1:2019, method B (polynomial of the theoretical single stiffness).
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | c′_th | theoretical single stiffness per metre of face width | N/m² |
//! | c(ξ) | stiffness of the pair at ξ | N/m² |
//! | C_M | ratio of measured to theoretical stiffness, 0.8 | - |
//! | c_γ | mean mesh stiffness per metre of face width | N/m² |
//!
//! The factors of gear blank and basic rack of the standard, C_R and C_B, are 1 here. Range: not
//! for ε_α < 1.2 or |x| > 1, where the polynomial was not fitted.

use asperity_core::DomainError;
use asperity_core::cite;

use crate::error::GearError;
use crate::pair::GearPair;

/// Relative decrease of the stiffness from the middle of the path to its ends: a fit to the tooth compliance of eight
/// pairs with ε_α 1.45 to 1.85 gives 0.30 to 0.35.
const DECREASE_TO_THE_ENDS: f64 = 0.33;

/// Minimum transverse contact ratio of the polynomial.
const LEAST_CONTACT_RATIO: f64 = 1.2;

/// Maximum profile shift coefficient of the polynomial.
const LARGEST_SHIFT: f64 = 1.0;

impl GearPair {
    /// 1/c′_th = 0.04723 + 0.15551/z_n1 + 0.25791/z_n2 − 0.00635 x₁ − 0.11654 x₁/z_n1
    /// − 0.00193 x₂ − 0.24188 x₂/z_n2 + 0.00529 x₁² + 0.00182 x₂²  mm µm/N        [Stiffness-1]
    ///
    /// Result in N/m². `shift` holds x₁ and x₂; for a ring z_n2 = ∞ and x₂ = 0.
    ///
    /// # Errors
    /// Outside the range of the polynomial.
    ///
    /// ```
    /// use asperity_gear::{GearPair, GearPairInput};
    /// let pair = GearPair::new(&GearPairInput::standard(
    ///     [50, 120], "1.3 mm".parse()?, "30 deg".parse()?, "50 mm".parse()?,
    /// ))?;
    /// // 19.69 N/(mm µm).
    /// assert!((pair.iso_single_stiffness([0.0, 0.0])? / 1e9 - 19.69).abs() < 0.01);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn iso_single_stiffness(&self, shift: [f64; 2]) -> Result<f64, GearError> {
        cite!("Stiffness-1");
        let eps_alpha = self.path.eps_alpha;
        DomainError::require(
            eps_alpha >= LEAST_CONTACT_RATIO,
            "transverse contact ratio",
            eps_alpha,
            "-",
            "must be at least 1.2 for the stiffness of ISO 6336-1",
        )?;
        for x in shift {
            DomainError::require(
                x.abs() <= LARGEST_SHIFT,
                "profile shift",
                x,
                "-",
                "must lie between -1 and 1 for the stiffness of ISO 6336-1",
            )?;
        }
        let virtual_teeth = self.base_helix.si().cos().powi(2) * self.helix.si().cos();
        let [over_1, mut over_2] = self.teeth.map(|z| virtual_teeth / f64::from(z));
        let [x1, mut x2] = shift;
        if self.internal {
            (over_2, x2) = (0.0, 0.0);
        }
        let q = 0.04723 + 0.15551 * over_1 + 0.25791 * over_2
            - 0.00635 * x1
            - 0.11654 * x1 * over_1
            - 0.00193 * x2
            - 0.24188 * x2 * over_2
            + 0.00529 * x1 * x1
            + 0.00182 * x2 * x2;
        // 1 N/(mm µm) is 1e9 N/m².
        Ok(1e9 / q)
    }

    /// c_γ = C_M c′_th cos β (0.75 ε_α + 0.25)                                   [Stiffness-2]
    ///
    /// Mean mesh stiffness per metre of face width, in N/m².
    ///
    /// # Errors
    /// As [`GearPair::iso_single_stiffness`].
    pub fn iso_mesh_stiffness(
        &self,
        shift: [f64; 2],
        stiffness_factor: f64,
    ) -> Result<f64, GearError> {
        cite!("Stiffness-2");
        let single = self.iso_single_stiffness(shift)?;
        Ok(stiffness_factor * single * self.helix.si().cos() * (0.75 * self.path.eps_alpha + 0.25))
    }

    /// c(ξ)/C_M = c′_th (1 − 0.33 ((ξ − ε_α/2)/(ε_α/2))²)                         [Stiffness-3]
    pub(crate) fn iso_stiffness_at(&self, single: f64, xi: f64) -> f64 {
        cite!("Stiffness-3");
        let from_middle = 2.0 * xi / self.path.eps_alpha - 1.0;
        single * (1.0 - DECREASE_TO_THE_ENDS * from_middle * from_middle)
    }
}
