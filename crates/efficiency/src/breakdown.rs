//! Losses of a mesh by kind, and the balance of its power.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | P_k | power of a part | W |
//! | E_k | its energy per engagement, P_k·T_z | J |
//! | T_z | time between two engagements | s |
//!
//! Both power and energy are stored, for balances per second and per tooth.

use asperity_core::DomainError;
use asperity_core::quantity::{Energy, Power, Time};
use serde::Serialize;

use crate::deformation::engagement_period;
use crate::error::EfficiencyError;
use crate::output_torque::{MeshOperation, PowerFlow, power_flow};

/// Kind of loss.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum LossKind {
    /// Sliding friction.
    Sliding,
    /// Rolling friction.
    Rolling,
    /// Deformation of flank 1, in the paper's formulation.
    DeformationPinion,
    /// Deformation of flank 2, in the paper's formulation.
    DeformationWheel,
    /// Elastic energy that is not recovered.
    Hysteresis,
}

/// One part of the losses.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct LossComponent {
    /// Kind of loss.
    pub kind: LossKind,
    /// Power.
    pub power: Power,
    /// Energy per engagement.
    pub energy_per_engagement: Energy,
    /// Share of the total of the breakdown \[%\]; 0 without losses.
    pub share_percent: f64,
}

/// Losses by kind.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Breakdown {
    /// The losses, in the order of the input.
    pub components: Vec<LossComponent>,
    /// Sum of their powers.
    pub total: Power,
    /// Sum of their energies per engagement.
    pub energy_per_engagement: Energy,
}

impl Breakdown {
    /// E_k = P_k·T_z, share P_k/Σ P                                            `[Breakdown-1]`
    ///
    /// # Errors
    /// When a power is negative or not finite, or the period is not positive.
    ///
    /// ```
    /// use asperity_efficiency::{Breakdown, LossKind};
    /// let losses = [(LossKind::Sliding, "300 W".parse()?), (LossKind::Rolling, "100 W".parse()?)];
    /// let parts = Breakdown::new(&losses, "0.4 ms".parse()?)?;
    /// assert_eq!(parts.components[0].share_percent, 75.0);
    /// assert_eq!(parts.power(LossKind::Rolling).si(), 100.0);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn new(losses: &[(LossKind, Power)], period: Time) -> Result<Self, EfficiencyError> {
        asperity_core::cite!("Breakdown-1");
        let t_z = DomainError::positive("engagement period", period)?;
        let mut total = 0.0;
        for &(_, power) in losses {
            total += DomainError::non_negative("loss", power)?;
        }
        DomainError::finite("sum of the losses", Power::from_si(total))?;
        let component = |&(kind, power): &(LossKind, Power)| LossComponent {
            kind,
            power,
            energy_per_engagement: Energy::from_si(power.si() * t_z),
            share_percent: if total > 0.0 {
                100.0 * power.si() / total
            } else {
                0.0
            },
        };
        let components: Vec<_> = losses.iter().map(component).collect();
        let energies = components
            .iter()
            .map(|part| part.energy_per_engagement.si());
        Ok(Self {
            energy_per_engagement: Energy::from_si(energies.sum()),
            total: Power::from_si(total),
            components,
        })
    }

    /// Power of all losses of a kind; zero without such losses.
    pub fn power(&self, kind: LossKind) -> Power {
        let same = self.components.iter().filter(|part| part.kind == kind);
        Power::from_si(same.map(|part| part.power.si()).sum())
    }

    /// |P_in − P_out − Σ P_k|/P_in                                             `[Breakdown-2]`
    ///
    /// Share of the input power that the losses do not explain; only round-off in a correct result. The
    /// output power is computed from the output torque and not from the losses, so this is a check.
    ///
    /// ```
    /// use asperity_efficiency::{LossKind, MeshOperation, mesh_efficiency};
    /// let operation = MeshOperation {
    ///     pinion_torque: "285 N m".parse()?, pinion_speed: "3000 1/min".parse()?, teeth: [50, 120],
    /// };
    /// let mesh = mesh_efficiency(&operation, &[(LossKind::Sliding, "318 W".parse()?)])?;
    /// assert!(mesh.breakdown.imbalance(&mesh.flow, &operation) < 1e-14);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn imbalance(&self, flow: &PowerFlow, operation: &MeshOperation) -> f64 {
        asperity_core::cite!("Breakdown-2");
        let [z1, z2] = operation.teeth.map(f64::from);
        let pinion = operation.pinion_speed.si();
        let output_speed = if flow.pinion_drives {
            pinion * z1 / z2
        } else {
            pinion
        };
        let output = flow.output_torque.si() * output_speed;
        let parts: f64 = self.components.iter().map(|part| part.power.si()).sum();
        (flow.input_power.si() - output - parts).abs() / flow.input_power.si()
    }
}

/// Efficiency, power flow and losses of a mesh.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct MeshEfficiency {
    /// Powers and torques.
    pub flow: PowerFlow,
    /// Losses by kind.
    pub breakdown: Breakdown,
    /// Time between two engagements.
    pub engagement_period: Time,
}

/// Computes efficiency, output torque and breakdown from the losses.
///
/// # Errors
/// When a loss is negative, the losses are not below the input, or the operation is not valid.
///
/// ```
/// use asperity_efficiency::{LossKind, MeshOperation, mesh_efficiency};
/// let operation = MeshOperation {
///     pinion_torque: "285 N m".parse()?, pinion_speed: "3000 1/min".parse()?, teeth: [50, 120],
/// };
/// let losses = [(LossKind::Sliding, "300 W".parse()?), (LossKind::Rolling, "9 W".parse()?)];
/// let mesh = mesh_efficiency(&operation, &losses)?;
/// assert_eq!((mesh.flow.loss.si(), mesh.breakdown.total.si()), (309.0, 309.0));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn mesh_efficiency(
    operation: &MeshOperation,
    losses: &[(LossKind, Power)],
) -> Result<MeshEfficiency, EfficiencyError> {
    let period = engagement_period(operation.teeth[0], operation.pinion_speed)?;
    let breakdown = Breakdown::new(losses, period)?;
    Ok(MeshEfficiency {
        flow: power_flow(operation, breakdown.total)?,
        breakdown,
        engagement_period: period,
    })
}
