//! Sliding and rolling losses as means over a mesh cycle.
//!
//! Source: Rodríguez 2022, eqs 17 and 18. Rolling friction acts on both surfaces (Goksem and
//! Hargreaves 1978), which the paper's eq. 18 leaves out.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | F_s | friction force per metre of contact line | N/m |
//! | F_r | rolling friction force per metre of contact line, on one surface | N/m |
//! | V_s, V_e | sliding, entrainment speed | m/s |
//! | w | weight of a position: the length of contact line it represents | m |
//!
//! The weights of all positions sum to the mean length of the contact lines. In mixed lubrication
//! F_s is the total friction force ∫(μ_m p_solid + μ p_fluid) dx; nothing else changes.

use asperity_core::DomainError;
use asperity_core::quantity::{Length, LineLoad, Power, Speed};
use serde::{Deserialize, Serialize};

use crate::error::EfficiencyError;

/// Friction at one position of the mesh cycle.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct PositionLoss {
    /// Weight in the mean over the mesh cycle: the length of contact line it represents.
    pub weight: Length,
    /// Magnitude of the friction force F_s per metre of contact line.
    pub sliding_force: LineLoad,
    /// Sliding speed V_s, of either sign.
    pub sliding_speed: Speed,
    /// Rolling friction force F_r per metre of contact line, on one surface.
    pub rolling_force: LineLoad,
    /// Entrainment speed V_e.
    pub entrainment_speed: Speed,
}

/// Number of surfaces with rolling friction.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
pub enum RollingSurfaces {
    /// Both surfaces: F_r·(u₁ + u₂) = 2 F_r V_e.
    #[default]
    Both,
    /// One surface: F_r·V_e, as the 2022 paper prints.
    One,
}

impl RollingSurfaces {
    /// Number of surfaces.
    #[must_use]
    pub const fn count(self) -> f64 {
        match self {
            Self::Both => 2.0,
            Self::One => 1.0,
        }
    }
}

/// Friction losses of a mesh.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct MeshLoss {
    /// Sliding loss.
    pub sliding: Power,
    /// Rolling loss.
    pub rolling: Power,
}

/// P_s = Σ w F_s |V_s|                                                         `[P17]`
///
/// # Errors
/// When there is no position, a weight, force or entrainment speed is negative, or a number is
/// not finite.
///
/// ```
/// use asperity_efficiency::mesh_loss::{PositionLoss, sliding_power};
/// let place = PositionLoss {
///     weight: "80 mm".parse()?, sliding_force: "5 N/mm".parse()?, sliding_speed: "-0.7 m/s".parse()?,
///     rolling_force: "0 N/m".parse()?, entrainment_speed: "4.5 m/s".parse()?,
/// };
/// assert!((sliding_power(&[place])?.si() - 280.0).abs() < 1e-12);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn sliding_power(positions: &[PositionLoss]) -> Result<Power, EfficiencyError> {
    asperity_core::cite!("P17");
    mean(positions, |position| {
        let f_s = DomainError::non_negative("sliding force", position.sliding_force)?;
        let v_s = DomainError::finite("sliding speed", position.sliding_speed)?;
        Ok(f_s * v_s.abs())
    })
}

/// P_r = Σ w·2 F_r V_e; with [`RollingSurfaces::One`] Σ w F_r V_e               `[P18]`
///
/// # Errors
/// As [`sliding_power`].
///
/// ```
/// use asperity_efficiency::mesh_loss::{PositionLoss, RollingSurfaces, rolling_power};
/// let place = PositionLoss {
///     weight: "80 mm".parse()?, sliding_force: "5 N/mm".parse()?, sliding_speed: "-0.7 m/s".parse()?,
///     rolling_force: "160 N/m".parse()?, entrainment_speed: "4.5 m/s".parse()?,
/// };
/// assert!((rolling_power(&[place], RollingSurfaces::Both)?.si() - 115.2).abs() < 1e-12);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn rolling_power(
    positions: &[PositionLoss],
    surfaces: RollingSurfaces,
) -> Result<Power, EfficiencyError> {
    asperity_core::cite!("P18");
    mean(positions, |position| {
        let f_r = DomainError::non_negative("rolling force", position.rolling_force)?;
        let v_e = DomainError::non_negative("entrainment speed", position.entrainment_speed)?;
        Ok(surfaces.count() * f_r * v_e)
    })
}

/// Sliding loss `[P17]` and rolling loss `[P18]`.
///
/// # Errors
/// As [`sliding_power`].
///
/// ```
/// use asperity_efficiency::{PositionLoss, RollingSurfaces, mesh_loss};
/// let place = PositionLoss {
///     weight: "80 mm".parse()?, sliding_force: "5 N/mm".parse()?, sliding_speed: "-0.7 m/s".parse()?,
///     rolling_force: "160 N/m".parse()?, entrainment_speed: "4.5 m/s".parse()?,
/// };
/// let loss = mesh_loss(&[place], RollingSurfaces::One)?;
/// assert!((loss.rolling.si() - 57.6).abs() < 1e-12);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn mesh_loss(
    positions: &[PositionLoss],
    surfaces: RollingSurfaces,
) -> Result<MeshLoss, EfficiencyError> {
    Ok(MeshLoss {
        sliding: sliding_power(positions)?,
        rolling: rolling_power(positions, surfaces)?,
    })
}

/// Σ w g, with g \[W/m\] of each position.
fn mean(
    positions: &[PositionLoss],
    per_metre: impl Fn(&PositionLoss) -> Result<f64, DomainError>,
) -> Result<Power, EfficiencyError> {
    if positions.is_empty() {
        return Err(EfficiencyError::no_positions());
    }
    let mut sum = 0.0;
    for position in positions {
        sum += DomainError::non_negative("weight", position.weight)? * per_metre(position)?;
    }
    Ok(Power::from_si(DomainError::finite(
        "loss",
        Power::from_si(sum),
    )?))
}
