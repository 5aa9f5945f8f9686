//! Plausibility of an efficiency.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | η | efficiency of the mesh | - |
//! | H_V | local loss factor of the gear pair | - |
//! | μ_eq | constant friction coefficient with the same loss | - |

use asperity_core::{Checked, DomainError, FittedRange};

use crate::error::EfficiencyError;

/// Usual range of the mean friction coefficient of a lubricated steel gear mesh, from full films on
/// superfinished flanks to boundary lubrication on ground flanks. A plausibility range, not a fit.
pub const LUBRICATED_STEEL: FittedRange =
    FittedRange::new("mu_eq", 0.01, 0.12, "-", "lubricated steel gears");

/// μ_eq = (1 − η)/H_V                                                          `[Plausible-1]`
///
/// # Errors
/// When η is not within 0 ≤ η ≤ 1 or H_V is not positive.
///
/// ```
/// use asperity_efficiency::equivalent_friction;
/// let friction = equivalent_friction(0.99508, 0.073283)?;
/// assert!((friction.value - 0.0671).abs() < 1e-4 && friction.outside.is_empty());
/// // The 98.8 % of the 2022 paper would take more friction than oil on steel has.
/// assert_eq!(equivalent_friction(0.988, 0.060808)?.outside.len(), 1);
/// # Ok::<(), asperity_efficiency::EfficiencyError>(())
/// ```
pub fn equivalent_friction(
    efficiency: f64,
    loss_factor: f64,
) -> Result<Checked<f64>, EfficiencyError> {
    asperity_core::cite!("Plausible-1");
    DomainError::require(
        (0.0..=1.0).contains(&efficiency),
        "efficiency",
        efficiency,
        "-",
        "must lie between 0 and 1",
    )?;
    DomainError::require(
        loss_factor.is_finite() && loss_factor > 0.0,
        "loss factor",
        loss_factor,
        "-",
        "must be finite and greater than zero",
    )?;
    let value = (1.0 - efficiency) / loss_factor;
    let mut outside = Vec::new();
    LUBRICATED_STEEL.check(value, &mut outside);
    Ok(Checked { value, outside })
}
