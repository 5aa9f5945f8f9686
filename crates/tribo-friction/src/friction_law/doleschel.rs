//! Mixed friction of Doleschel: load sharing by the film ratio.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | ξ | share of the load on the asperities | - |
//! | λ | φ h_c over the mean roughness (Ra₁ + Ra₂)/2 | - |
//! | μ_bdr, μ_ehd | coefficients of boundary and of fluid friction | - |
//!
//! Source: A. Doleschel, dissertation, TU München, 2002 (FVA 345); ξ, the definition of λ and
//! its domain 0 ≤ λ ≤ 2 confirmed in Arana et al. 2019, table 1. From λ = 2 on the film carries
//! the whole load. Doleschel's own fits of μ_ehd and μ_bdr belong to the oils of his tests and are not
//! included: the fluid part is an input, from [`eyring`](crate::eyring) or a measured value.

use asperity_core::quantity::Length;
use asperity_core::{DomainError, cite};

use crate::error::FrictionError;
use crate::mixed::shared_coefficient;

/// Doleschel 2002: film ratio from which the film carries the whole load.
const FULL_FILM: f64 = 2.0;

/// Share of the load on the asperities, by the film ratio.
///
/// ```text
/// ξ = (1 − λ/2)² for λ < 2, else 0;  λ = h_c/((Ra₁ + Ra₂)/2)          [Doleschel-share]
/// ```
///
/// The film is the central one with its thermal reduction.
///
/// # Errors
/// When film or roughness is negative or not finite, or both are 0.
///
/// ```
/// use asperity_tribo_friction::doleschel::asperity_share;
/// assert!((asperity_share("0.2 um".parse()?, "0.25 um".parse()?)? - 0.36).abs() < 1e-15);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn asperity_share(central_film: Length, mean_ra: Length) -> Result<f64, FrictionError> {
    cite!("Doleschel-share");
    let h = DomainError::non_negative("central film", central_film)?;
    let ra = DomainError::non_negative("mean Ra", mean_ra)?;
    let rule = "film and roughness must not both be zero";
    DomainError::require(h > 0.0 || ra > 0.0, "mean Ra", ra, "m", rule)?;
    let solid = (1.0 - h / ra / FULL_FILM).max(0.0);
    Ok(solid * solid)
}

/// Friction coefficient of Doleschel.
///
/// ```text
/// μ = (1 − ξ) μ_ehd + ξ μ_bdr                                              [Doleschel]
/// ```
///
/// # Errors
/// As [`asperity_share`], or when a coefficient is negative or not finite.
///
/// ```
/// use asperity_tribo_friction::doleschel::coefficient;
/// let mu = coefficient("0.25 um".parse()?, "0.25 um".parse()?, 0.02, 0.10)?;
/// assert!((mu - 0.04).abs() < 1e-15);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn coefficient(
    central_film: Length,
    mean_ra: Length,
    fluid: f64,
    boundary: f64,
) -> Result<f64, FrictionError> {
    cite!("Doleschel");
    shared_coefficient(asperity_share(central_film, mean_ra)?, fluid, boundary)
}
