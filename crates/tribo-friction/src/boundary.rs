//! Boundary friction, and the share of the asperity load that it acts on.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | μ_b | coefficient of boundary friction | - |
//! | h_b | height of the boundary layer | m |
//! | h_k | film of a touching spot | m |
//! | β | share of the asperity load on the boundary layer | - |
//! | φ | share of the load on the asperities | - |
//! | μ_f, μ_a | coefficients of the film and of lubricated asperities | - |
//!
//! Touching asperities are lubricated (micro-EHL): they shear the oil at asperity pressure, near its limiting
//! stress; μ_b acts only where they are closer than the boundary layer. With exponentially distributed films of
//! mean h_k, the mean of e^(−h/h_b) is 1/(1 + h_k/h_b). An asperity contact that forms inside the contact, where sliding holds the oil at the
//! stress at which no film flows, has at least the share β_i ([`INNER_BOUNDARY`]).
//!
//! Evidence for μ_b: 0.065 to 0.07 on ground FZG gears with mineral oil and EP additives, 0.08, 0.12 and
//! 0.12 to 0.135 elsewhere; a tribofilm raised a rig's raw value from 0.086 to 0.120 in 10 000 s. The
//! boundary layer, that is tribofilm and roughness below the short-wave cut-off, was compared with
//! mixed-EHL solutions and belongs to the cut-off λ_s = 2.5 um.

use asperity_core::quantity::Length;
use asperity_core::{DomainError, cite};

use crate::error::FrictionError;

/// Default coefficient of boundary friction.
pub const BOUNDARY_FRICTION: f64 = 0.09;
/// 5 % and 95 % quantiles of the coefficient of boundary friction.
pub const BOUNDARY_FRICTION_BAND: [f64; 2] = [0.066, 0.123];
/// Default height of the boundary layer, at a short-wave cut-off of 2.5 um.
pub const BOUNDARY_LAYER: Length = Length::from_si(10e-9);
/// 5 % and 95 % quantiles of the height of the boundary layer.
pub const BOUNDARY_LAYER_BAND: [Length; 2] = [Length::from_si(5e-9), Length::from_si(20e-9)];

/// Default of the least boundary share β_i of an asperity contact that formed inside the contact, where no oil flows: the share that
/// its roughness leaves on the layer. No theory yields it. It was chosen on 93 reference solutions, which therefore do not test it:
/// mean error of ln μ -0.025, +0.005 and +0.042 with 0.6, 0.75 and 0.9 (`docs/decisions/friction.md`).
pub const INNER_BOUNDARY: f64 = 0.75;
/// Range of β_i that these solutions admit.
pub const INNER_BOUNDARY_RANGE: [f64; 2] = [0.6, 0.9];

/// Share of a touching spot's load on the boundary layer.
///
/// ```text
/// β_k = 1/(1 + h_k/h_b)                                                  [Boundary-share]
/// ```
///
/// 1 without a film, 0 without a boundary layer.
///
/// # Errors
/// When the film or the layer is negative or not finite, or both are 0.
///
/// ```
/// use asperity_core::quantity::Length;
/// use asperity_tribo_friction::boundary::{BOUNDARY_LAYER, boundary_share};
/// assert_eq!(boundary_share(Length::from_si(10e-9), BOUNDARY_LAYER)?, 0.5);
/// # Ok::<(), asperity_tribo_friction::FrictionError>(())
/// ```
pub fn boundary_share(film: Length, boundary_layer: Length) -> Result<f64, FrictionError> {
    cite!("Boundary-share");
    let h = DomainError::non_negative("film of the asperity contact", film)?;
    let h_b = DomainError::non_negative("boundary layer", boundary_layer)?;
    let rule = "film and boundary layer must not both be zero";
    DomainError::require(h + h_b > 0.0, "boundary layer", h_b, "m", rule)?;
    Ok(share_on_layer(h, h_b))
}

/// [`boundary_share`] of a film and a layer \[m\] for a loop over many films, around which the equation is cited and the numbers are
/// checked.
#[inline(always)]
#[must_use]
pub fn share_on_layer(film: f64, layer: f64) -> f64 {
    layer / (layer + film)
}

/// The three parts of the friction of a rough lubricated contact.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize)]
pub struct FrictionParts {
    /// (1 − φ) μ_f: the film.
    pub film: f64,
    /// φ (1 − β) μ_a: lubricated asperities.
    pub lubricated_asperities: f64,
    /// φ β μ_b: the boundary layer.
    pub boundary: f64,
}

impl FrictionParts {
    /// The friction coefficient of the contact.
    #[must_use]
    pub fn total(&self) -> f64 {
        self.film + self.lubricated_asperities + self.boundary
    }
}

/// Shares of the load, each with its friction coefficient.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize)]
pub struct SharedFriction {
    /// Share φ of the load on the asperities.
    pub asperity_share: f64,
    /// Share β of the asperity load on the boundary layer.
    pub boundary_share: f64,
    /// Film friction μ_f.
    pub film: f64,
    /// Friction μ_a of lubricated asperities.
    pub asperities: f64,
    /// Boundary friction μ_b.
    pub boundary: f64,
}

impl SharedFriction {
    /// Friction coefficient of film, lubricated asperities and boundary layer, by parts.
    ///
    /// ```text
    /// μ = (1 − φ) μ_f + φ [(1 − β) μ_a + β μ_b]                            [Three-parts]
    /// ```
    ///
    /// # Errors
    /// When a share is not within 0..1, or a coefficient is negative or not finite.
    ///
    /// ```
    /// use asperity_tribo_friction::boundary::SharedFriction;
    /// let parts = SharedFriction {
    ///     asperity_share: 0.5, boundary_share: 0.2, film: 0.02, asperities: 0.03, boundary: 0.08,
    /// }.parts()?;
    /// assert!((parts.total() - 0.03).abs() < 1e-15 && (parts.boundary - 0.008).abs() < 1e-15);
    /// # Ok::<(), asperity_tribo_friction::FrictionError>(())
    /// ```
    pub fn parts(&self) -> Result<FrictionParts, FrictionError> {
        cite!("Three-parts");
        let rule = "must lie between 0 and 1";
        for (name, share) in [
            ("asperity share", self.asperity_share),
            ("boundary share", self.boundary_share),
        ] {
            DomainError::require((0.0..=1.0).contains(&share), name, share, "-", rule)?;
        }
        let rule = "must be finite and not negative";
        for (name, mu) in [
            ("film friction", self.film),
            ("friction of lubricated asperities", self.asperities),
            ("boundary friction", self.boundary),
        ] {
            DomainError::require(mu.is_finite() && mu >= 0.0, name, mu, "-", rule)?;
        }
        let (phi, beta) = (self.asperity_share, self.boundary_share);
        Ok(FrictionParts {
            film: (1.0 - phi) * self.film,
            lubricated_asperities: phi * (1.0 - beta) * self.asperities,
            boundary: phi * beta * self.boundary,
        })
    }
}
