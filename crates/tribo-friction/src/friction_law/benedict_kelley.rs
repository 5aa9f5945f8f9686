//! Benedict and Kelley's instantaneous friction coefficient.
//!
//! | symbol | meaning | unit in the formula |
//! |---|---|---|
//! | w | load per length of contact line | N/mm |
//! | η | dynamic viscosity of the oil entering the contact | mPa s |
//! | V_s | sliding speed | m/s |
//! | V_Σ | sum of the surface speeds u₁ + u₂ | m/s |
//! | Ra | mean arithmetic roughness (Ra₁ + Ra₂)/2 | um |
//!
//! Source: G. H. Benedict and B. W. Kelley, ASLE Trans. 4 (1961) 59, in the metric form of
//! AGMA 925-A03, 6.2.2 (29 700 and 1.13 are unit conversions of the original). That the clause
//! gives this law is confirmed; its wording was not available. Roller tests: the coefficient rises
//! with load and falls with both speeds and viscosity. Range: the roughness factor has a pole at
//! Ra = 1.13 um and AGMA limits it to 3, that is Ra ≤ 0.753 um. The logarithm turns negative
//! for light loads at high speeds, outside the domain of the law: the value is then 0, with a
//! warning.

use asperity_core::quantity::{DynamicViscosity, Length, LineLoad, Speed};
use asperity_core::{Checked, DomainError, FittedRange, Treatment, cite};

use crate::error::FrictionError;

/// Benedict and Kelley 1961: slope of the logarithm.
const SLOPE: f64 = 0.0127;
/// AGMA 925-A03: their constant for N/mm, mPa s and m/s.
const GROUP: f64 = 29_700.0;
/// AGMA 925-A03: Ra at which the roughness factor has its pole [um].
const POLE: f64 = 1.13;

/// Range in which the roughness factor is at most 3: Ra ≤ 1.13 (1 − 1/3).
const ROUGHNESS: FittedRange = FittedRange::new(
    "mean Ra",
    0.0,
    POLE * (1.0 - 1.0 / 3.0),
    "um",
    "Benedict-Kelley",
);

/// Range in which the logarithm is not negative.
const ARGUMENT: FittedRange = FittedRange::new(
    "29700 w/(eta Vs Vsum^2)",
    1.0,
    f64::INFINITY,
    "-",
    "Benedict-Kelley (held at zero friction)",
);

/// Viscosities of mineral gear oils at their working temperature; the oils of the tests were not
/// available (assumed).
const VISCOSITY: FittedRange =
    FittedRange::new("viscosity", 5.0, 500.0, "mPa s", "Benedict-Kelley");

/// Sum of the surface speeds of roller and gear tests of their time (assumed).
const SPEED: FittedRange = FittedRange::new(
    "sum of the surface speeds",
    0.5,
    40.0,
    "m/s",
    "Benedict-Kelley",
);

/// Inputs of Benedict and Kelley's law at a mesh position.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BenedictKelleyConditions {
    /// Load per length of contact line w.
    pub load: LineLoad,
    /// Viscosity of the oil entering the contact.
    pub viscosity: DynamicViscosity,
    /// Sliding speed V_s, of either sign but not 0: the logarithm diverges there.
    pub sliding: Speed,
    /// Sum of the surface speeds u₁ + u₂.
    pub sum_speed: Speed,
    /// Mean arithmetic roughness.
    pub mean_ra: Length,
}

/// Benedict and Kelley's friction coefficient.
///
/// ```text
/// μ = 0.0127 · 1.13/(1.13 − Ra) · log₁₀( 29 700 w/(η |V_s| V_Σ²) )      [Benedict-Kelley]
/// ```
///
/// # Errors
/// When load, viscosity or the sum of the speeds is not positive, there is no sliding, Ra is
/// negative or not below 1.13 um.
///
/// ```
/// use asperity_tribo_friction::benedict_kelley::{BenedictKelleyConditions, coefficient};
/// let position = BenedictKelleyConditions {
///     load: "100 N/mm".parse()?, viscosity: "29.7 mPa s".parse()?, sliding: "-1 m/s".parse()?,
///     sum_speed: "10 m/s".parse()?, mean_ra: "0 um".parse()?,
/// };
/// assert!((coefficient(&position)?.value - 0.0127 * 3.0).abs() < 1e-15);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn coefficient(position: &BenedictKelleyConditions) -> Result<Checked<f64>, FrictionError> {
    cite!("Benedict-Kelley");
    let w = DomainError::positive("line load", position.load)? * 1e-3;
    let eta = DomainError::positive("viscosity", position.viscosity)? * 1e3;
    let v_sum = DomainError::positive("sum of the surface speeds", position.sum_speed)?;
    let v_s = DomainError::finite("sliding speed", position.sliding)?.abs();
    let rule = "must not be zero: the logarithm diverges without sliding";
    DomainError::require(v_s > 0.0, "sliding speed", v_s, "m/s", rule)?;
    let ra = DomainError::non_negative("mean Ra", position.mean_ra)? * 1e6;
    let rule = "must be below 1.13 um, the pole of the roughness factor";
    DomainError::require(ra < POLE, "mean Ra", ra, "um", rule)?;

    let argument = GROUP * w / (eta * v_s * v_sum * v_sum);
    let mut outside = Vec::new();
    ROUGHNESS.check(ra, &mut outside);
    VISCOSITY.check(eta, &mut outside);
    SPEED.check(v_sum, &mut outside);
    ARGUMENT.check_as(Treatment::Held, argument, &mut outside);
    Ok(Checked {
        value: SLOPE * POLE / (POLE - ra) * argument.log10().max(0.0),
        outside,
    })
}
