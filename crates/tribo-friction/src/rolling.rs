//! Rolling resistance of the inlet.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | F_r | rolling resistance per length of contact line, **on one surface** | N/m |
//! | G, U, W | α E′, η₀ V_e/(E′ R), w/(E′ R) with E′ = 2 E* | - |
//! | R | relative radius of curvature | m |
//! | α | pressure-viscosity coefficient | 1/Pa |
//! | φ | thermal reduction | - |
//! | D | (3/4) (2π)^(3/2) G U/W^(3/2) | - |
//! | L | thermal loading η₀ β_T V_e²/k_oil | - |
//!
//! Source: P. G. Goksem and R. A. Hargreaves, ASME J. Lubr. Technol. 100 (1978) 346, whose
//! inlet solution the power law fits. It lies within 5 % of an independent numerical Grubin
//! inlet solution (`references/table_2.py`), F = ½ ∫ (h − h₀) dp, in five cases with G U from 10⁻⁷ to 1.1·10⁻⁶. A force
//! on one surface: the pair loses F_r (u₁ + u₂) = 2 F_r V_e. [`goksem_factor`] is the longer form
//! of the same fit, with its own thermal factor, as an open bearing dynamics code has it.

use asperity_core::line_contact::LineContact;
use asperity_core::quantity::{DynamicViscosity, LineLoad, PressureViscosity};
use asperity_core::{DomainError, cite};

use crate::error::FrictionError;

/// Goksem and Hargreaves 1978: factor, power of G U, power of W.
const FACTOR: f64 = 4.318;
const GU_POWER: f64 = 0.658;
const W_POWER: f64 = 0.0126;

/// The longer form: ln F_r α/(W R) = 0.658228 ln D − 0.162625 when isothermal.
const LONG_FORM: (f64, f64) = (0.658228, -0.162625);
/// The longer form's thermal factor: e^(0.0106383 L^0.3174603 ln D)/(1 + 0.411483 L^0.707071).
const LONG_FORM_RISE: (f64, f64) = (0.0106383, 0.3174603);
const LONG_FORM_FALL: (f64, f64) = (0.411483, 0.707071);

/// Rolling resistance on one surface by Goksem and Hargreaves.
///
/// ```text
/// F_r = 4.318 φ (G U)^0.658 W^0.0126 R/α                                           [P9]
/// ```
///
/// The oil's viscosity η₀ and pressure-viscosity coefficient α hold at the inlet temperature; the thermal reduction φ
/// is 1 for an isothermal inlet.
///
/// # Errors
/// When an input is not finite and positive (φ may be 0).
///
/// ```
/// use asperity_core::{line_contact::LineContact, material::Material};
/// use asperity_tribo_friction::rolling_force;
/// let steel = Material {
///     young: "210 GPa".parse()?, poisson: 0.3, elastic_limit: "235 MPa".parse()?,
///     density: "7830 kg/m3".parse()?, conductivity: "45 W/(m K)".parse()?, heat_capacity: "465 J/(kg K)".parse()?,
/// };
/// let pitch_point = LineContact {
///     load: "113.409 N/mm".parse()?, radius: "11.6269 mm".parse()?, modulus: "115.3846 GPa".parse()?,
///     speeds: ["4.568 m/s".parse()?; 2], bodies: [steel; 2],
/// };
/// let force = rolling_force(&pitch_point, "97.5 mPa s".parse()?, "20 1/GPa".parse()?, 1.0)?;
/// assert!((force.si() - 209.16).abs() < 0.01);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn rolling_force(
    contact: &LineContact,
    viscosity: DynamicViscosity,
    pressure_viscosity: PressureViscosity,
    thermal_factor: f64,
) -> Result<LineLoad, FrictionError> {
    cite!("P9");
    let v_e = DomainError::positive("entrainment speed", contact.entrainment())?;
    let r = DomainError::positive("radius", contact.radius)?;
    let load = DomainError::positive("line load", contact.load)?;
    let e = 2.0 * DomainError::positive("reduced modulus", contact.modulus)?;
    let eta = DomainError::positive("viscosity", viscosity)?;
    let alpha = DomainError::positive("pressure-viscosity", pressure_viscosity)?;
    let phi = DomainError::require(
        thermal_factor.is_finite() && thermal_factor >= 0.0,
        "thermal factor",
        thermal_factor,
        "-",
        "must be finite and not negative",
    )?;
    let gu = alpha * e * (eta * v_e / (e * r));
    let w = load / (e * r);
    Ok(LineLoad::from_si(
        FACTOR * phi * gu.powf(GU_POWER) * w.powf(W_POWER) * r / alpha,
    ))
}

/// Rolling resistance over W R/α by the longer form of the fit.
///
/// ```text
/// F_r α/(W R) = e^(0.658228 ln D − 0.162625) e^(0.0106383 L^0.3174603 ln D)/(1 + 0.411483 L^0.707071),
/// D = (3/4) (2π)^(3/2) G U/W^(3/2)                                          [Goksem-long]
/// ```
///
/// The groups are plain numbers, so that the resistance is this factor times W R/α. L = 0 is
/// the isothermal contact.
///
/// # Errors
/// When G U or W is not finite and positive or L is negative or not finite.
///
/// ```
/// use asperity_tribo_friction::rolling::goksem_factor;
/// let factor = goksem_factor(4863.0855 * 8.9291707e-13, 2.9348586e-5, 8.74307e-6)?;
/// assert!((factor - 0.403451).abs() < 1e-6);
/// # Ok::<(), asperity_tribo_friction::FrictionError>(())
/// ```
pub fn goksem_factor(gu: f64, w: f64, loading: f64) -> Result<f64, FrictionError> {
    cite!("Goksem-long");
    let rule = "must be finite and greater than zero";
    let positive = |name, value: f64| {
        DomainError::require(value.is_finite() && value > 0.0, name, value, "-", rule)
    };
    let (gu, w) = (positive("G U", gu)?, positive("load group W", w)?);
    let l = DomainError::require(
        loading.is_finite() && loading >= 0.0,
        "thermal loading L",
        loading,
        "-",
        "must be finite and not negative",
    )?;
    let d = 0.75 * std::f64::consts::TAU.powf(1.5) * gu / w.powf(1.5);
    let rise = LONG_FORM_RISE.0 * l.powf(LONG_FORM_RISE.1) * d.ln();
    let fall = 1.0 + LONG_FORM_FALL.0 * l.powf(LONG_FORM_FALL.1);
    Ok((LONG_FORM.0 * d.ln() + LONG_FORM.1 + rise).exp() / fall)
}
