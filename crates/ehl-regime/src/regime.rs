//! Full film or mixed friction, and the share of the load that the film carries.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | Λ* | film parameter of [`lambda_star`](crate::lambda_star()) | - |
//! | λ | classical film ratio φ h/Sq | - |
//! | c_f | share of the load carried by the film | - |
//! | h | film thickness (central or minimum, as the comparison asks) | m |
//! | Sq | combined root-mean-square roughness √(Rq₁² + Rq₂²) | m |
//!
//! A contact is in full film if asperities carry less than 2 % of its load, by whatever law of the load share: their
//! friction is then within the error of the film friction. Otherwise it is mixed, or boundary if the boundary layer makes
//! more than half of the friction. The 2022 paper decides by Λ*: full film from Λ* = 1 on (Hansen et al. 2021).
//!
//! The share by Λ* is this model's: a parabola that is 1 with a flat top at Λ* = 1, so that
//! regimes join without a step, and 75 % at Λ* = 0.5 where the 2022 paper quotes 60 to 80 %.
//! The share by λ is D. Zhu and Y.-Z. Hu's fit (Tribol. Trans. 44 (2001) 383, as used for gears
//! by Castro and Seabra): it passes 1 at λ ≈ 2 and would fall again beyond its maximum at
//! λ = 2.26; both are read as a full film.

use asperity_core::quantity::Length;
use asperity_core::{DomainError, cite};
use serde::{Deserialize, Serialize};

use crate::error::RegimeError;

/// Zhu and Hu 2001: factor and exponent of the numerator.
const ZHU_HU_RISE: (f64, f64) = (1.21, 0.64);
/// Zhu and Hu 2001: factor and exponent of the denominator.
const ZHU_HU_FALL: (f64, f64) = (0.37, 1.26);

/// Share of the load on asperities below which a film is called full and its friction taken as that of smooth flanks.
pub const FULL_FILM: f64 = 0.02;

/// Lubrication regime: separation of the flanks, and the origin of their friction.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub enum Regime {
    /// Asperities carry less than [`FULL_FILM`] of the load; in the 2022 paper Λ* ≥ 1.
    #[default]
    FullFilm,
    /// Film and asperities share the load.
    Mixed,
    /// As mixed, and the boundary layer of touching asperities makes more than half of the friction.
    Boundary,
}

impl Regime {
    /// Regime of the 2022 paper: full film from Λ* = 1 on.
    ///
    /// # Errors
    /// When Λ* is negative or NaN.
    ///
    /// ```
    /// use asperity_ehl_regime::Regime;
    /// assert_eq!(Regime::from_lambda_star(1.0)?, Regime::FullFilm);
    /// assert_eq!(Regime::from_lambda_star(0.99)?, Regime::Mixed);
    /// # Ok::<(), asperity_ehl_regime::RegimeError>(())
    /// ```
    pub fn from_lambda_star(lambda_star: f64) -> Result<Self, RegimeError> {
        Ok(if not_negative("Lambda*", lambda_star)? >= 1.0 {
            Self::FullFilm
        } else {
            Self::Mixed
        })
    }

    /// Mixed where the film carries at most 98 % of the load.
    ///
    /// ```
    /// use asperity_ehl_regime::Regime;
    /// assert_eq!(Regime::of_film_share(0.981), Regime::FullFilm);
    /// assert_eq!(Regime::of_film_share(0.52), Regime::Mixed);
    /// ```
    #[must_use]
    pub fn of_film_share(film_share: f64) -> Self {
        if 1.0 - film_share < FULL_FILM {
            Self::FullFilm
        } else {
            Self::Mixed
        }
    }

    /// Regime of a contact, or of a path of contact, with this share of it in mixed lubrication, its friction and the part
    /// of that in the boundary layer: boundary from half of the friction, and full film only if no part of it is mixed.
    ///
    /// ```
    /// use asperity_ehl_regime::Regime;
    /// assert_eq!(Regime::of_friction(0.9, 51.0, 100.0), Regime::Boundary);
    /// assert_eq!(Regime::of_friction(0.1, 50.0, 100.0), Regime::Mixed);
    /// assert_eq!(Regime::of_friction(0.0, 2.0, 100.0), Regime::FullFilm);
    /// ```
    #[must_use]
    pub fn of_friction(mixed_share: f64, boundary: f64, friction: f64) -> Self {
        match mixed_share > 0.0 {
            false => Self::FullFilm,
            true if boundary > 0.5 * friction => Self::Boundary,
            true => Self::Mixed,
        }
    }

    /// Words for a reader, with the share of the load on asperities. Boundary friction may dominate where the film carries most
    /// of the load: this is mixed lubrication in the usual sense of the word.
    ///
    /// ```
    /// use asperity_ehl_regime::Regime;
    /// assert_eq!(Regime::Boundary.words(0.33), "mixed, mostly boundary friction");
    /// assert_eq!(Regime::Boundary.words(0.84), "boundary");
    /// ```
    #[must_use]
    pub fn words(self, asperity_share: f64) -> &'static str {
        match self {
            Self::Boundary if asperity_share <= 0.5 => "mixed, mostly boundary friction",
            other => other.name(),
        }
    }

    /// Name in tables.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::FullFilm => "full film",
            Self::Mixed => "mixed",
            Self::Boundary => "boundary",
        }
    }
}

/// Law of the load sharing between film and asperities.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub enum LoadShareLaw {
    /// c_f = 1 − (1 − min(Λ*, 1))².
    #[default]
    LambdaStar,
    /// Zhu and Hu's function of the classical film ratio.
    ZhuHu,
}

impl LoadShareLaw {
    /// The share c_f of the load that the film carries, from both film parameters (each law
    /// uses its own).
    ///
    /// # Errors
    /// When the parameter is negative or NaN.
    ///
    /// ```
    /// use asperity_ehl_regime::LoadShareLaw;
    /// assert_eq!(LoadShareLaw::LambdaStar.film_share(0.5, 1.0)?, 0.75);
    /// assert!((LoadShareLaw::ZhuHu.film_share(0.5, 1.0)? - 0.883212).abs() < 1e-6);
    /// # Ok::<(), asperity_ehl_regime::RegimeError>(())
    /// ```
    pub fn film_share(self, lambda_star: f64, film_ratio: f64) -> Result<f64, RegimeError> {
        match self {
            Self::LambdaStar => film_share_of_lambda_star(lambda_star),
            Self::ZhuHu => film_share_of_film_ratio(film_ratio),
        }
    }
}

fn not_negative(name: &'static str, value: f64) -> Result<f64, DomainError> {
    DomainError::require(value >= 0.0, name, value, "-", "must not be negative")
}

/// Share of the load that the film carries, by Λ*.
///
/// ```text
/// c_f = 1 − (1 − min(Λ*, 1))²                                             [Film-share]
/// ```
///
/// # Errors
/// When Λ* is negative or NaN.
///
/// ```
/// use asperity_ehl_regime::regime::film_share_of_lambda_star;
/// assert_eq!(film_share_of_lambda_star(3.0)?, 1.0);
/// # Ok::<(), asperity_ehl_regime::RegimeError>(())
/// ```
pub fn film_share_of_lambda_star(lambda_star: f64) -> Result<f64, RegimeError> {
    cite!("Film-share");
    let gap = 1.0 - not_negative("Lambda*", lambda_star)?.min(1.0);
    Ok(1.0 - gap * gap)
}

/// Share of the load that the film carries, by the classical film ratio.
///
/// ```text
/// c_f = min(1, 1.21 λ^0.64/(1 + 0.37 λ^1.26)), and 1 beyond its maximum       [Zhu-Hu]
/// ```
///
/// # Errors
/// When λ is negative or NaN.
///
/// ```
/// use asperity_ehl_regime::regime::film_share_of_film_ratio;
/// assert_eq!(film_share_of_film_ratio(0.0)?, 0.0);
/// assert_eq!(film_share_of_film_ratio(f64::INFINITY)?, 1.0);
/// # Ok::<(), asperity_ehl_regime::RegimeError>(())
/// ```
pub fn film_share_of_film_ratio(film_ratio: f64) -> Result<f64, RegimeError> {
    cite!("Zhu-Hu");
    let lambda = not_negative("film ratio", film_ratio)?;
    let ((a, m), (b, n)) = (ZHU_HU_RISE, ZHU_HU_FALL);
    // Zero of the derivative of a λ^m/(1 + b λ^n).
    let maximum = (m / (b * (n - m))).powf(1.0 / n);
    if lambda >= maximum {
        return Ok(1.0);
    }
    Ok((a * lambda.powf(m) / (1.0 + b * lambda.powf(n))).min(1.0))
}

/// Classical film ratio.
///
/// ```text
/// λ = φ h/Sq                                                               [Film-ratio]
/// ```
///
/// # Errors
/// When the roughness is not positive, or the film or φ negative or not finite.
///
/// ```
/// use asperity_core::quantity::Length;
/// use asperity_ehl_regime::film_ratio;
/// let ratio = film_ratio(Length::from_si(1e-6), 0.8, Length::from_si(0.4e-6))?;
/// assert!((ratio - 2.0).abs() < 1e-12);
/// # Ok::<(), asperity_ehl_regime::RegimeError>(())
/// ```
pub fn film_ratio(
    film: Length,
    thermal_factor: f64,
    combined_roughness: Length,
) -> Result<f64, RegimeError> {
    cite!("Film-ratio");
    let h = DomainError::non_negative("film", film)?;
    let phi = DomainError::require(
        thermal_factor.is_finite() && thermal_factor >= 0.0,
        "thermal factor",
        thermal_factor,
        "-",
        "must be finite and not negative",
    )?;
    let sq = DomainError::positive("combined roughness", combined_roughness)?;
    Ok(phi * h / sq)
}
