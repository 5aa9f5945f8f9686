//! Schlenk's mean friction coefficient, as in ISO/TR 14179-2.
//!
//! | symbol | meaning | unit in the formula |
//! |---|---|---|
//! | μ_mz | coefficient of friction of the whole mesh | - |
//! | F_bt/b | transverse base force over face width | N/mm |
//! | v_ΣC | sum of the surface speeds at the pitch point | m/s |
//! | ρ_redC | relative radius of curvature at the pitch point | mm |
//! | η | dynamic viscosity at the oil temperature | mPa s |
//! | Ra | mean arithmetic roughness (Ra₁ + Ra₂)/2 | um |
//! | X_L | lubricant factor | - |
//!
//! Source: L. Schlenk, dissertation, TU München, 1994; ISO/TR 14179-2:2001. Formula and units
//! are confirmed in three independent public copies. X_L is 1.0 for mineral oils; values of 0.8
//! for polyalphaolefins and esters and 0.75 (6/v_ΣC)^0.2 for polyglycols are usual. The usual
//! range (textbook knowledge) is F_bt/b ≥ 150 N/mm and pitch line speeds of 1 to 50 m/s.

use asperity_core::quantity::{DynamicViscosity, Length};
use asperity_core::{Checked, DomainError, FittedRange, cite};

use crate::conditions::MeshConditions;
use crate::error::FrictionError;

/// Schlenk 1994: factor, and powers of the load group, the viscosity and the roughness.
const FACTOR: f64 = 0.048;
const LOAD_POWER: f64 = 0.2;
const VISCOSITY_POWER: f64 = -0.05;
const ROUGHNESS_POWER: f64 = 0.25;

const NAME: &str = "ISO/TR 14179-2 (Schlenk)";

/// Usual lower limit of the line load; there is no upper one.
const LOAD_RANGE: FittedRange =
    FittedRange::new("base line load Fbt/b", 150.0, f64::INFINITY, "N/mm", NAME);

/// Usual range of the pitch line speed.
const SPEED_RANGE: FittedRange = FittedRange::new("pitch line speed", 1.0, 50.0, "m/s", NAME);

/// Gear oils at the temperature of the FZG tests (assumed).
const VISCOSITY_RANGE: FittedRange = FittedRange::new("viscosity", 3.0, 500.0, "mPa s", NAME);

/// Schlenk's mean friction coefficient.
///
/// ```text
/// μ_mz = 0.048 ( (F_bt/b)/(v_ΣC ρ_redC) )^0.2 η^−0.05 Ra^0.25 X_L              [Schlenk]
/// ```
///
/// # Errors
/// When an input is not finite and positive (Ra may be 0).
///
/// ```
/// use asperity_tribo_friction::{MeshConditions, iso_14179_2::coefficient};
/// let mesh = MeshConditions {
///     base_line_load: "164.7565 N/mm".parse()?, sum_speed: "9.135818 m/s".parse()?,
///     reduced_radius: "11.62688 mm".parse()?, lubricant_factor: 1.0,
///     load_intensity: "3.11 MPa".parse()?, pitch_line_speed: "11.79 m/s".parse()?,
/// };
/// let mu = coefficient(&mesh, "97.5 mPa s".parse()?, "0.25 um".parse()?)?;
/// assert!((mu.value - 0.0294715).abs() < 1e-7);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn coefficient(
    mesh: &MeshConditions,
    viscosity: DynamicViscosity,
    mean_ra: Length,
) -> Result<Checked<f64>, FrictionError> {
    cite!("Schlenk");
    let load = DomainError::positive("base line load Fbt/b", mesh.base_line_load)? * 1e-3;
    let v = DomainError::positive("sum of the surface speeds", mesh.sum_speed)?;
    let rho = DomainError::positive("reduced radius", mesh.reduced_radius)? * 1e3;
    let eta = DomainError::positive("viscosity", viscosity)? * 1e3;
    let ra = DomainError::non_negative("mean Ra", mean_ra)? * 1e6;
    let x_l = DomainError::require(
        mesh.lubricant_factor.is_finite() && mesh.lubricant_factor > 0.0,
        "lubricant factor X_L",
        mesh.lubricant_factor,
        "-",
        "must be finite and greater than zero",
    )?;
    let v_t = DomainError::positive("pitch line speed", mesh.pitch_line_speed)?;
    let mut outside = Vec::new();
    LOAD_RANGE.check(load, &mut outside);
    SPEED_RANGE.check(v_t, &mut outside);
    VISCOSITY_RANGE.check(eta, &mut outside);
    let load_group = (load / (v * rho)).powf(LOAD_POWER);
    Ok(Checked {
        value: FACTOR * load_group * eta.powf(VISCOSITY_POWER) * ra.powf(ROUGHNESS_POWER) * x_l,
        outside,
    })
}
