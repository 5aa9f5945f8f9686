//! Efficiency and output torque from the losses.
//!
//! Source: Rodríguez 2022, eqs 16 and 20.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | M₁, M₂ | torque of the driving, the driven gear | N m |
//! | ω₁, ω₂ | speeds of the driving, the driven gear | rad/s |
//! | ΣP | sum of the losses | W |
//! | η | efficiency of the mesh | - |
//!
//! Limits: only losses of the mesh, without bearings, seals, churning and windage.

use asperity_core::DomainError;
use asperity_core::quantity::{AngularSpeed, Power, Torque};
use serde::Serialize;

use crate::error::EfficiencyError;

/// η = 1 − ΣP/(M₁ω₁)                                                          `[P20]`
///
/// # Errors
/// When the input is not positive, the loss is negative, or it is not below the input.
///
/// ```
/// use asperity_efficiency::output_torque::efficiency;
/// assert_eq!(efficiency("200 W".parse()?, "1 W".parse()?)?, 0.995);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn efficiency(input: Power, loss: Power) -> Result<f64, EfficiencyError> {
    asperity_core::cite!("P20");
    let power = DomainError::positive("input power", input)?;
    let sum = DomainError::non_negative("loss", loss)?;
    if sum >= power {
        return Err(EfficiencyError::loss_exceeds_input(loss, input));
    }
    Ok(1.0 - sum / power)
}

/// M₂ = M₁·(ω₁/ω₂)·η                                                          `[P16]`
///
/// # Errors
/// When the torque is not finite, a speed is not positive, or η is not within 0 ≤ η ≤ 1.
///
/// ```
/// use asperity_efficiency::output_torque::output_torque;
/// let torque = output_torque("285 N m".parse()?, "3000 1/min".parse()?, "1250 1/min".parse()?, 0.995)?;
/// assert!((torque.si() - 285.0 * 2.4 * 0.995).abs() < 1e-10);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn output_torque(
    input_torque: Torque,
    input_speed: AngularSpeed,
    output_speed: AngularSpeed,
    efficiency: f64,
) -> Result<Torque, EfficiencyError> {
    asperity_core::cite!("P16");
    let m1 = DomainError::finite("input torque", input_torque)?;
    let omega1 = DomainError::positive("input speed", input_speed)?;
    let omega2 = DomainError::positive("output speed", output_speed)?;
    let eta = DomainError::require(
        (0.0..=1.0).contains(&efficiency),
        "efficiency",
        efficiency,
        "-",
        "must lie between 0 and 1",
    )?;
    Ok(Torque::from_si(m1 * (omega1 / omega2) * eta))
}

/// Operating point of a mesh.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct MeshOperation {
    /// Torque of gear 1; negative when gear 2 drives and gear 1 is the output.
    pub pinion_torque: Torque,
    /// Speed of gear 1.
    pub pinion_speed: AngularSpeed,
    /// Tooth numbers.
    pub teeth: [u32; 2],
}

/// Powers and torques through the mesh, all positive.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct PowerFlow {
    /// Whether gear 1 drives.
    pub pinion_drives: bool,
    /// Power into the mesh.
    pub input_power: Power,
    /// Power out of the mesh.
    pub output_power: Power,
    /// Power lost.
    pub loss: Power,
    /// Efficiency η.
    pub efficiency: f64,
    /// Torque of the driving gear.
    pub input_torque: Torque,
    /// Torque of the driven gear.
    pub output_torque: Torque,
}

/// Power flow of a mesh with a known loss.
///
/// When gear 1 drives, M₁ω₁ is the input. When gear 2 drives, the torque of gear 1 is the output
/// torque, and the input is the output plus the loss.
///
/// # Errors
/// When torque or speed is zero or not finite, a tooth number is zero, the loss is negative, or
/// the loss is not below the input.
///
/// ```
/// use asperity_efficiency::output_torque::{MeshOperation, power_flow};
/// let back = MeshOperation {
///     pinion_torque: "-10 N m".parse()?, pinion_speed: "9.9 rad/s".parse()?, teeth: [20, 40],
/// };
/// let flow = power_flow(&back, "1 W".parse()?)?;
/// assert!(!flow.pinion_drives);
/// assert!((flow.input_power.si() - 100.0).abs() < 1e-12);
/// assert!((flow.efficiency - 0.99).abs() < 1e-15);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn power_flow(operation: &MeshOperation, loss: Power) -> Result<PowerFlow, EfficiencyError> {
    let signed = DomainError::finite("pinion torque", operation.pinion_torque)?;
    DomainError::require(
        signed != 0.0,
        "pinion torque",
        signed,
        "N m",
        "must not be zero",
    )?;
    let omega1 = DomainError::positive("pinion speed", operation.pinion_speed)?;
    let wheel_speed = wheel_speed(operation)?;
    let sum = DomainError::non_negative("loss", loss)?;
    let pinion_drives = signed > 0.0;
    let pinion_power = signed.abs() * omega1;
    let input = if pinion_drives {
        pinion_power
    } else {
        pinion_power + sum
    };
    let input_power = Power::from_si(input);
    let eta = efficiency(input_power, loss)?;
    let (input_speed, output_speed) = if pinion_drives {
        (operation.pinion_speed, wheel_speed)
    } else {
        (wheel_speed, operation.pinion_speed)
    };
    let input_torque = Torque::from_si(input / input_speed.si());
    Ok(PowerFlow {
        pinion_drives,
        input_power,
        output_power: input_power - loss,
        loss,
        efficiency: eta,
        input_torque,
        output_torque: output_torque(input_torque, input_speed, output_speed, eta)?,
    })
}

fn wheel_speed(operation: &MeshOperation) -> Result<AngularSpeed, DomainError> {
    for z in operation.teeth {
        DomainError::require(z > 0, "teeth", z.into(), "-", "must be at least 1")?;
    }
    let [z1, z2] = operation.teeth.map(f64::from);
    Ok(operation.pinion_speed * (z1 / z2))
}
