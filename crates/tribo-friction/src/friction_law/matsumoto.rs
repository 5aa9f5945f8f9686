//! Mixed friction of Matsumoto and Morikawa: load sharing by maximum heights.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | ξ | share of the load on the asperities | - |
//! | h_m | minimum film thickness | m |
//! | Rz₁ + Rz₂ | sum of the maximum heights | m |
//! | μ_bdr, μ_ehd | coefficients of boundary and of fluid friction | - |
//!
//! Source: S. Matsumoto and K. Morikawa, JSME MPT 2013 and International Gear Conference 2014;
//! ξ and its domain 0.01 ≤ h_m/(Rz₁ + Rz₂) ≤ 1 confirmed in Arana et al. 2019, table 1. The ends
//! of the domain are ξ = 1 and ξ = 0; beyond them ξ is constant. Tested on discs.
//! The fluid part is an input: compose with [`eyring`](crate::eyring) or a measured value.

use asperity_core::quantity::Length;
use asperity_core::{DomainError, cite};

use crate::error::FrictionError;
use crate::mixed::shared_coefficient;

/// Matsumoto and Morikawa: the share per decade of h_m/(Rz₁ + Rz₂).
const SHARE_PER_DECADE: f64 = 0.5;

/// Share of the load on the asperities, by maximum heights.
///
/// ```text
/// ξ = ½ log₁₀( (Rz₁ + Rz₂)/h_m ), between 0 and 1                     [Matsumoto-share]
/// ```
///
/// # Errors
/// When film or heights are negative or not finite, or both are 0.
///
/// ```
/// use asperity_tribo_friction::matsumoto::asperity_share;
/// assert!((asperity_share("0.5 um".parse()?, "5 um".parse()?)? - 0.5).abs() < 1e-15);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn asperity_share(minimum_film: Length, sum_rz: Length) -> Result<f64, FrictionError> {
    cite!("Matsumoto-share");
    let h = DomainError::non_negative("minimum film", minimum_film)?;
    let rz = DomainError::non_negative("sum of Rz", sum_rz)?;
    let rule = "film and maximum heights must not both be zero";
    DomainError::require(h > 0.0 || rz > 0.0, "sum of Rz", rz, "m", rule)?;
    Ok((SHARE_PER_DECADE * (rz / h).log10()).clamp(0.0, 1.0))
}

/// Friction coefficient of Matsumoto and Morikawa.
///
/// ```text
/// μ = (1 − ξ) μ_ehd + ξ μ_bdr                                              [Matsumoto]
/// ```
///
/// # Errors
/// As [`asperity_share`], or when a coefficient is negative or not finite.
///
/// ```
/// use asperity_tribo_friction::matsumoto::coefficient;
/// let mu = coefficient("0.5 um".parse()?, "5 um".parse()?, 0.03, 0.09)?;
/// assert!((mu - 0.06).abs() < 1e-15);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn coefficient(
    minimum_film: Length,
    sum_rz: Length,
    fluid: f64,
    boundary: f64,
) -> Result<f64, FrictionError> {
    cite!("Matsumoto");
    shared_coefficient(asperity_share(minimum_film, sum_rz)?, fluid, boundary)
}
