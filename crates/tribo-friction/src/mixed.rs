//! Friction force of a contact in which film and asperities share the load.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | F_s | sliding friction force per length of contact line | N/m |
//! | p_solid, p_fluid | pressure of the asperities and of the film at x | Pa |
//! | μ_m | coefficient of boundary friction | - |
//! | μ | coefficient of fluid friction | - |
//! | dx | spacing of the points | m |
//!
//! μ_m is 0.08 to 0.13 for steel in oil; 0.065 was measured on ground gears at the lowest speed
//! (Arana et al. 2019). The 2022 paper uses 0.3, a value of dry metal. The integral is the sum
//! over strips of constant pressure, as in the boundary-element solution: a uniform coefficient
//! gives exactly this coefficient times the load on the strips.

use asperity_core::quantity::{Length, LineLoad};
use asperity_core::{DomainError, cite};
use serde::Serialize;

use crate::error::FrictionError;

/// Friction per length of contact line, and its two parts.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct MixedFriction {
    /// F_s, the sum of both parts.
    pub total: LineLoad,
    /// Part of the asperities, ∫ μ_m p_solid dx.
    pub solid: LineLoad,
    /// Part of the film, ∫ μ p_fluid dx.
    pub fluid: LineLoad,
}

/// Friction force per length of a contact with film and asperities.
///
/// ```text
/// F_s = ∫ (μ_m p_solid + μ p_fluid) dx                                            [P21]
/// ```
///
/// `solid` and `fluid` are pressures in Pa at the same points, `spacing` apart.
///
/// # Errors
/// When the fields differ in length, a pressure is negative or not finite, the spacing is not
/// positive or a coefficient is negative or not finite.
///
/// ```
/// use asperity_core::quantity::Length;
/// use asperity_tribo_friction::mixed_friction;
/// let friction = mixed_friction(Length::from_si(1e-6), &[0.0, 2e9], &[5e8, 0.0], 0.1, 0.02)?;
/// assert!((friction.solid.si() - 200.0).abs() < 1e-9);
/// assert!((friction.total.si() - 210.0).abs() < 1e-9);
/// # Ok::<(), asperity_tribo_friction::FrictionError>(())
/// ```
pub fn mixed_friction(
    spacing: Length,
    solid: &[f64],
    fluid: &[f64],
    boundary_coefficient: f64,
    fluid_coefficient: f64,
) -> Result<MixedFriction, FrictionError> {
    cite!("P21");
    if solid.len() != fluid.len() {
        return Err(FrictionError::field_lengths(solid.len(), fluid.len()));
    }
    let dx = DomainError::positive("spacing", spacing)?;
    let mu_m = coefficient_in_domain("boundary coefficient", boundary_coefficient)?;
    let mu = coefficient_in_domain("fluid coefficient", fluid_coefficient)?;
    let solid = mu_m * sum("solid pressure", solid)? * dx;
    let fluid = mu * sum("fluid pressure", fluid)? * dx;
    Ok(MixedFriction {
        total: LineLoad::from_si(solid + fluid),
        solid: LineLoad::from_si(solid),
        fluid: LineLoad::from_si(fluid),
    })
}

fn sum(name: &'static str, pressures: &[f64]) -> Result<f64, DomainError> {
    let rule = "must be finite and not negative";
    pressures.iter().try_fold(0.0, |sum, &p| {
        DomainError::require(p.is_finite() && p >= 0.0, name, p, "Pa", rule).map(|p| sum + p)
    })
}

fn coefficient_in_domain(name: &'static str, value: f64) -> Result<f64, DomainError> {
    let rule = "must be finite and not negative";
    DomainError::require(value.is_finite() && value >= 0.0, name, value, "-", rule)
}

/// (1 − ξ) μ_fluid + ξ μ_boundary, the composition of the laws that share the load by ξ.
pub(crate) fn shared_coefficient(
    asperity_share: f64,
    fluid: f64,
    boundary: f64,
) -> Result<f64, FrictionError> {
    let fluid = coefficient_in_domain("fluid coefficient", fluid)?;
    let boundary = coefficient_in_domain("boundary coefficient", boundary)?;
    Ok((1.0 - asperity_share) * fluid + asperity_share * boundary)
}
