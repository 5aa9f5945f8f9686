//! Elastic, hysteresis and plastic work of a contact that sweeps over the flank.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | f, R, a | line load, relative radius, Hertz half width at a position of the contact line | N/m, m, m |
//! | V_e | mean surface speed, at which the contact sweeps the flanks | m/s |
//! | dl | length of contact line that a position represents | m |
//! | D | energy that plastic flow dissipates in a window of width 2a, per metre of face | J/m |
//! | α_h | share of the cycled energy lost to hysteresis | - |
//!
//! Every point of the flank is loaded once per engagement, so energies are per swept area, not per contact
//! patch. The front half of the pressure does work on the approaching surface, per metre of face and metre
//! rolled ∫₀ᵃ p x/R dx = 2 f a/(3πR) (Johnson 1985, 9.1). With sliding each body has half the normal
//! velocity, so the speed is V_e.
//!
//! The cycled energy is recovered except for the share α_h, typically 0.005 to 0.05 for hardened bearing
//! steel (Johnson 1985, as quoted in the report of an open bearing solver). The hysteresis loss is part of the rolling
//! loss. Plastic work in the first pass is running-in and not a steady loss.

use std::f64::consts::PI;

use asperity_core::quantity::{Length, LineEnergy, LineLoad, Power, Speed};
use asperity_core::{DomainError, cite};
use serde::Serialize;

use crate::error::EfficiencyError;

/// Default share of the cycled energy lost to hysteresis in hardened steel: the lower end of its range.
pub const HYSTERESIS: f64 = 0.005;
/// Range of the hysteresis share.
pub const HYSTERESIS_BAND: [f64; 2] = [0.005, 0.05];

/// Position in a mesh cycle, with the inputs of the deformation losses.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct SweptPosition {
    /// Mean length of contact line that the position represents.
    pub weight: Length,
    /// Load per length of contact line f.
    pub load: LineLoad,
    /// Relative radius of curvature R.
    pub radius: Length,
    /// Hertz half width a.
    pub half_width: Length,
    /// Mean surface speed V_e.
    pub entrainment: Speed,
    /// Energy D dissipated by plastic flow in one pass over a window of width 2a.
    pub plastic_work: LineEnergy,
}

/// Powers of deformation over a mesh cycle.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct SweptDeformation {
    /// Elastic energy stored in the flanks and recovered.
    pub elastic_cycling: Power,
    /// Hysteresis loss, the part of it that is not recovered.
    pub hysteresis: Power,
    /// Plastic work in a pass.
    pub plastic: Power,
}

/// Powers of deformation over a mesh cycle.
///
/// ```text
/// P_el = Σ 2 f a/(3πR) V_e dl                                             [Elastic-cycling]
/// P_hyst = α_h P_el                                                            [Hysteresis]
/// P_pl = Σ D/(2a) V_e dl                                                    [Plastic-swept]
/// ```
///
/// # Errors
/// When there is no position, a load, radius, half width or speed is not positive, a weight or plastic work is
/// negative, or α_h is not within 0..1.
///
/// ```
/// use asperity_core::quantity::LineEnergy;
/// use asperity_efficiency::swept::{HYSTERESIS, SweptPosition, swept_deformation};
/// let place = SweptPosition {
///     weight: "50 mm".parse()?, load: "144 N/mm".parse()?, radius: "5.6 mm".parse()?,
///     half_width: "94 um".parse()?, entrainment: "7.3 m/s".parse()?, plastic_work: LineEnergy::from_si(1e-3),
/// };
/// let power = swept_deformation(&[place], HYSTERESIS)?;
/// assert!((power.elastic_cycling.si() - 187.2).abs() < 0.1);
/// assert!((power.hysteresis.si() - 0.936).abs() < 0.001);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn swept_deformation(
    positions: &[SweptPosition],
    hysteresis: f64,
) -> Result<SweptDeformation, EfficiencyError> {
    cite!("Elastic-cycling");
    cite!("Hysteresis");
    cite!("Plastic-swept");
    if positions.is_empty() {
        return Err(EfficiencyError::no_positions());
    }
    let rule = "must lie between 0 and 1";
    let fits = (0.0..=1.0).contains(&hysteresis);
    DomainError::require(fits, "hysteresis fraction", hysteresis, "-", rule)?;
    let (mut elastic, mut plastic) = (0.0, 0.0);
    for position in positions {
        let dl = DomainError::non_negative("weight", position.weight)?;
        let f = DomainError::positive("line load", position.load)?;
        let r = DomainError::positive("radius", position.radius)?;
        let a = DomainError::positive("half width", position.half_width)?;
        let v = DomainError::positive("entrainment speed", position.entrainment)?;
        elastic += 2.0 * f * a / (3.0 * PI * r) * v * dl;
        plastic += run_in_energy(position.plastic_work, position.half_width)? * v * dl;
    }
    Ok(SweptDeformation {
        elastic_cycling: Power::from_si(elastic),
        hysteresis: Power::from_si(hysteresis * elastic),
        plastic: Power::from_si(plastic),
    })
}

/// Plastic work per flank area in one pass \[J/m²\].
///
/// ```text
/// E_A = D/(2a)                                                              [Run-in-energy]
/// ```
///
/// # Errors
/// When the work is negative or the half width not positive.
///
/// ```
/// use asperity_core::quantity::LineEnergy;
/// use asperity_efficiency::swept::run_in_energy;
/// assert!((run_in_energy(LineEnergy::from_si(1e-3), "0.1 mm".parse()?)? - 5.0).abs() < 1e-12);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn run_in_energy(plastic_work: LineEnergy, half_width: Length) -> Result<f64, EfficiencyError> {
    cite!("Run-in-energy");
    let d = DomainError::non_negative("plastic work", plastic_work)?;
    let a = DomainError::positive("half width", half_width)?;
    Ok(d / (2.0 * a))
}
