//! Fluid friction of a full film by Eyring's law with a limiting shear stress.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | τ₀ | Eyring stress 2 Λ/α | Pa |
//! | Λ | limiting shear stress over pressure | - |
//! | α | pressure-viscosity coefficient | 1/Pa |
//! | p̄ | mean Hertz pressure π p₀/4 of a line contact | Pa |
//! | η | viscosity in the film, at its temperature and p̄ | Pa s |
//! | h | central film thickness with its thermal reduction | m |
//! | V_s | sliding speed | m/s |
//!
//! Source: A. Arana, J. Larrañaga, I. Ulacia, Proc. IMechE J 233 (2019) 303, eq. 13, with
//! τ₀ = 2 Λ/α after Bair and Winer. Couette flow across the film. Λ is 0.053, 0.047, 0.035 for
//! a naphthenic, a paraffinic mineral and a polyalphaolefin base oil of ISO VG 100 (their table
//! 2). Compared by them with twin-disc tests at 1 GPa, 2 to 16 m/s and slip ratios up to 0.4, and
//! with gears up to 1.4 GPa. Without sliding there is no friction; for slow sliding the law is
//! Newton's, μ → η V_s/(h p̄). [`film_friction`](crate::film_friction) takes the stress over the pressures of the contact, with the
//! heat of the film.

use asperity_core::quantity::{DynamicViscosity, Length, Pressure, PressureViscosity, Speed};
use asperity_core::{Checked, DomainError, FittedRange, cite};

use crate::error::FrictionError;

/// Limiting shear stress over pressure of a paraffinic mineral oil, ISO VG 100 (Arana et al.
/// 2019, table 2, after Höglund).
pub const MINERAL_OIL_LIMIT: f64 = 0.047;

/// Arana et al. 2019: pressures up to the gears they compare with.
const PRESSURE: FittedRange =
    FittedRange::new("maximum pressure", 0.0, 1.4, "GPa", "Eyring (Arana)");

/// Arana et al. 2019: viscosity in the film that Barus' law can mean at their pressures and oils; beyond
/// it the limit rules (assumed).
const VISCOSITY: FittedRange =
    FittedRange::new("viscosity in the film", 0.1, 1e9, "Pa s", "Eyring (Arana)");

/// Arana et al. 2019: sliding speeds of their twin-disc tests and gears.
const SLIDING: FittedRange = FittedRange::new("sliding speed", 0.0, 16.0, "m/s", "Eyring (Arana)");

/// Inputs of Eyring's law at a mesh position.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EyringConditions {
    /// Maximum Hertz pressure p₀.
    pub max_pressure: Pressure,
    /// Viscosity in the film, at its temperature and the mean Hertz pressure.
    pub contact_viscosity: DynamicViscosity,
    /// Pressure-viscosity coefficient α.
    pub pressure_viscosity: PressureViscosity,
    /// Sliding speed V_s, of either sign.
    pub sliding: Speed,
    /// Central film thickness with its thermal reduction.
    pub central_film: Length,
    /// Limiting shear stress over pressure Λ.
    pub limiting_stress: f64,
}

/// Fluid friction coefficient of a full film.
///
/// ```text
/// μ = min( (τ₀/p̄) arsinh( η |V_s|/(τ₀ h) ), Λ ),  τ₀ = 2 Λ/α,  p̄ = π p₀/4      [Eyring]
/// ```
///
/// # Errors
/// When an input other than the sliding speed is not finite and positive.
///
/// ```
/// use asperity_tribo_friction::eyring::{EyringConditions, coefficient};
/// let position = EyringConditions {
///     max_pressure: "1 GPa".parse()?, contact_viscosity: "1000 Pa s".parse()?,
///     pressure_viscosity: "20 1/GPa".parse()?, sliding: "0.5 m/s".parse()?,
///     central_film: "300 nm".parse()?, limiting_stress: 0.047,
/// };
/// assert!((coefficient(&position)?.value - 0.0392815).abs() < 1e-7);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn coefficient(position: &EyringConditions) -> Result<Checked<f64>, FrictionError> {
    cite!("Eyring");
    let p_0 = DomainError::positive("maximum pressure", position.max_pressure)?;
    let eta = DomainError::positive("viscosity in the film", position.contact_viscosity)?;
    let alpha = DomainError::positive("pressure-viscosity", position.pressure_viscosity)?;
    let v_s = DomainError::finite("sliding speed", position.sliding)?.abs();
    let h = DomainError::positive("central film", position.central_film)?;
    let limit = DomainError::require(
        position.limiting_stress.is_finite() && position.limiting_stress > 0.0,
        "limiting stress over pressure",
        position.limiting_stress,
        "-",
        "must be finite and greater than zero",
    )?;
    let p_mean = std::f64::consts::FRAC_PI_4 * p_0;
    let tau_0 = 2.0 * limit / alpha;
    let mut outside = Vec::new();
    PRESSURE.check(p_0 * 1e-9, &mut outside);
    VISCOSITY.check(eta, &mut outside);
    SLIDING.check(v_s, &mut outside);
    Ok(Checked {
        value: (tau_0 / p_mean * (eta * v_s / (tau_0 * h)).asinh()).min(limit),
        outside,
    })
}
