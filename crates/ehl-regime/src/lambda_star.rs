//! The film parameter Λ* of Hansen, Björling and Larsson.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | h_m, h_c | minimum and central smooth film | m |
//! | h* | smooth film plus the film between asperity and flank | m |
//! | f_q | h_c with the asperity's radii over h_c with the flank's | - |
//! | S_pk | reduced peak height of the *composite* surface z₁ + z₂ | m |
//! | R_xa, R_ya | asperity radius along and across the motion | m |
//! | R_xb, R_yb | flank radius along and across the motion | m |
//! | X | exponent of the speed group in the film law in use | - |
//!
//! Source: J. Hansen, M. Björling and R. Larsson, "A new film parameter for rough surface EHL
//! contacts with anisotropic and isotropic structures", Tribol. Lett. 69 (2021) 37. The
//! constants of f_q come from film formulas: 1.134 = 1 + 2·0.067 and the bracket 0.61, 0.75 =
//! 0.73·1.03, 2/π from Hamrock–Dowson's central film (P14); 1.146 = 1 + 2·0.073 and 1, 1.23, 2/3
//! from Chittenden's. S_pk is never a sum of the two surfaces' own values. The change between
//! full film and mixed friction is at Λ* = 1; no range of radii was published.

use asperity_core::quantity::{Length, Quantity};
use asperity_core::{DomainError, cite};
use serde::{Deserialize, Serialize};

use crate::error::RegimeError;
use crate::film_law::FilmThickness;

/// Direction of the roughness relative to the motion.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub enum Orientation {
    /// No direction.
    Isotropic,
    /// Ridges across the motion, as flanks ground or hobbed along the face width have.
    #[default]
    Transverse,
    /// Ridges along the motion.
    Longitudinal,
}

/// Constants of f_q: α + X, and γ₁, γ₂, γ₃ of the ellipticity bracket.
struct Constants {
    exponent: f64,
    bracket: [f64; 3],
}

/// From Hamrock and Dowson's central film.
const ISOTROPIC_OR_TRANSVERSE: Constants = Constants {
    exponent: 1.134,
    bracket: [0.61, 0.75, 2.0 / std::f64::consts::PI],
};

/// From Chittenden's central film.
const LONGITUDINAL: Constants = Constants {
    exponent: 1.146,
    bracket: [1.0, 1.23, 2.0 / 3.0],
};

impl Orientation {
    fn constants(self) -> &'static Constants {
        match self {
            Self::Isotropic | Self::Transverse => &ISOTROPIC_OR_TRANSVERSE,
            Self::Longitudinal => &LONGITUDINAL,
        }
    }
}

/// Radii of an asperity and of the flank it stands on.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct AsperityShape {
    /// Mean radius of asperity tips along the motion R_xa.
    pub asperity_radius: Length,
    /// R_ya/R_xa; infinite for ridges, which a profile represents.
    pub asperity_aspect: f64,
    /// Relative radius of the flanks along the motion R_xb.
    pub flank_radius: Length,
    /// R_yb/R_xb; infinite for a line contact.
    pub flank_aspect: f64,
}

impl AsperityShape {
    /// Ridges of a two-dimensional profile on a line contact: both aspects are infinite.
    pub const fn ridges(asperity_radius: Length, flank_radius: Length) -> Self {
        Self {
            asperity_radius,
            asperity_aspect: f64::INFINITY,
            flank_radius,
            flank_aspect: f64::INFINITY,
        }
    }

    /// Film between asperity and flank over the smooth film, f_q.
    ///
    /// ```text
    /// f_q = (R_xa/R_xb)^α [1 − γ₁ exp(−γ₂ (R_ya/R_xa)^γ₃)] / [1 − γ₁ exp(−γ₂ (R_yb/R_xb)^γ₃)],
    /// α = 1.134 − X, γ = (0.61, 0.75, 2/π) for isotropic and transverse roughness,
    /// α = 1.146 − X, γ = (1, 1.23, 2/3) for longitudinal roughness                   [P15]
    /// ```
    ///
    /// # Errors
    /// When a radius or an aspect is not positive or X is not finite.
    ///
    /// ```
    /// use asperity_core::quantity::Length;
    /// use asperity_ehl_regime::{AsperityShape, Orientation};
    /// let shape = AsperityShape::ridges(Length::from_si(100e-6), Length::from_si(10e-3));
    /// let f_q = shape.film_factor(Orientation::Transverse, 0.67)?;
    /// assert!((f_q - 0.118032).abs() < 1e-6);
    /// # Ok::<(), asperity_ehl_regime::RegimeError>(())
    /// ```
    pub fn film_factor(
        &self,
        orientation: Orientation,
        speed_exponent: f64,
    ) -> Result<f64, RegimeError> {
        cite!("P15");
        let r_a = DomainError::positive("asperity radius", self.asperity_radius)?;
        let r_b = DomainError::positive("flank radius", self.flank_radius)?;
        let x = DomainError::require(
            speed_exponent.is_finite(),
            "speed exponent",
            speed_exponent,
            "-",
            "must be finite",
        )?;
        let Constants { exponent, bracket } = orientation.constants();
        let power = (r_a / r_b).powf(exponent - x);
        Ok(
            power * side_flow("asperity aspect", self.asperity_aspect, bracket)?
                / side_flow("flank aspect", self.flank_aspect, bracket)?,
        )
    }
}

/// 1 − γ₁ exp(−γ₂ q^γ₃); 1 for q = ∞.
fn side_flow(name: &'static str, aspect: f64, gamma: &[f64; 3]) -> Result<f64, DomainError> {
    let rule = "must be greater than zero; infinite for ridges or a line contact";
    let q = DomainError::require(aspect > 0.0, name, aspect, "-", rule)?;
    let [g1, g2, g3] = gamma;
    Ok(1.0 - g1 * (-g2 * q.powf(*g3)).exp())
}

/// Λ* and its parts.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct LambdaStar {
    /// Λ* = h*/S_pk.
    pub value: f64,
    /// h* = h_m + f_q h_c.
    pub effective_film: Length,
    /// f_q.
    pub film_factor: f64,
    /// Minimum smooth film h_m.
    pub minimum: Length,
    /// Central smooth film h_c.
    pub central: Length,
    /// Reduced peak height S_pk of the composite surface.
    pub reduced_peak_height: Length,
}

/// The film parameter Λ*.
///
/// ```text
/// Λ* = h*/S_pk                                                                    [P11]
/// h* = h_m + f_q h_c                                                              [P12]
/// ```
///
/// # Errors
/// When S_pk is not positive, or a film or f_q is negative or not finite.
///
/// ```
/// use asperity_core::quantity::Length;
/// use asperity_ehl_regime::{FilmThickness, lambda_star};
/// let film = FilmThickness { central: Length::from_si(1.0e-6), minimum: Length::from_si(0.8e-6) };
/// let parameter = lambda_star(&film, 0.1, Length::from_si(0.3e-6))?;
/// assert!((parameter.value - 3.0).abs() < 1e-12);
/// # Ok::<(), asperity_ehl_regime::RegimeError>(())
/// ```
pub fn lambda_star(
    film: &FilmThickness,
    film_factor: f64,
    reduced_peak_height: Length,
) -> Result<LambdaStar, RegimeError> {
    cite!("P11");
    cite!("P12");
    let h_m = DomainError::non_negative("minimum film", film.minimum)?;
    let h_c = DomainError::non_negative("central film", film.central)?;
    let f_q = DomainError::require(
        film_factor.is_finite() && film_factor >= 0.0,
        "film factor f_q",
        film_factor,
        "-",
        "must be finite and not negative",
    )?;
    let s_pk = DomainError::positive("reduced peak height", reduced_peak_height)?;
    let effective = h_m + f_q * h_c;
    Ok(LambdaStar {
        value: effective / s_pk,
        effective_film: Quantity::from_si(effective),
        film_factor,
        minimum: film.minimum,
        central: film.central,
        reduced_peak_height,
    })
}
