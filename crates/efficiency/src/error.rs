//! Errors of losses and efficiencies.

use asperity_core::quantity::{LineEnergy, Power, Temperature};
use asperity_core::{DomainError, decimals, number};

/// Errors of losses and efficiency.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum EfficiencyError {
    /// A single number outside its domain.
    #[error(transparent)]
    Domain(#[from] DomainError),
    /// A mean without positions.
    #[error("a mesh loss needs at least one position")]
    NoPositions,
    /// Two arrays of a sum differ in length.
    #[error("{name} has {found} points where {expected} are needed")]
    LengthMismatch {
        /// The array.
        name: &'static str,
        /// Its length.
        found: usize,
        /// Length of the other array.
        expected: usize,
    },
    /// The losses are not below the input power.
    #[error("the losses, {loss:.6}, are not below the input power, {input:.6}")]
    LossExceedsInput {
        /// Sum of the losses.
        loss: Power,
        /// Input power.
        input: Power,
    },
    /// The energy of a deformation is negative.
    #[error("{name} = {energy}: a deformation cannot release more than it took")]
    NegativeEnergy {
        /// The energy.
        name: &'static str,
        /// Its value.
        energy: LineEnergy,
    },
    /// The bulk temperature does not converge.
    #[error(
        "the bulk temperature did not settle in {steps} steps (last {:.0} °C, still moving by {residual} K)",
        temperature.celsius(), residual = decimals(*residual, 2))]
    BulkNotSettled {
        /// Last temperature.
        temperature: Temperature,
        /// Change that the next step would make \[K\].
        residual: f64,
        /// Number of steps.
        steps: usize,
    },
    /// The rows of a loss table do not form a grid.
    #[error("{rows} rows do not form a grid of {torques} torques and {speeds} speeds")]
    NoGrid {
        /// Number of rows, of one temperature if there are several.
        rows: usize,
        /// Number of distinct torques.
        torques: usize,
        /// Number of distinct speeds.
        speeds: usize,
    },
    /// A loss table has no row at a torque that lies beyond the torques of its speed.
    #[error(
        "no row at {torque_nm} N m, {speed_rpm} 1/min, where rows at other speeds have this torque, and nothing is extrapolated; add it, or leave this torque or this speed out",
        torque_nm = number(*torque_nm), speed_rpm = number(*speed_rpm)
    )]
    HoleInTable {
        /// Torque \[N m\].
        torque_nm: f64,
        /// Speed \[1/min\].
        speed_rpm: f64,
    },
    /// A row of a loss table has an invalid number.
    #[error("{rule}, and is {value} in a row", value = number(*value))]
    TableRow {
        /// Rule.
        rule: &'static str,
        /// The value; the speed of the row if the rule is about torque, speed or temperature.
        value: f64,
    },
    /// The operating point is outside of the loss table.
    #[error(
        "the table has no loss at {torque_nm} N m, {speed_rpm} 1/min, {temperature_c} °C; nothing is extrapolated", torque_nm = number(*torque_nm), speed_rpm = number(*speed_rpm), temperature_c = number(*temperature_c))]
    NotInTable {
        /// Torque \[N m\].
        torque_nm: f64,
        /// Speed \[1/min\].
        speed_rpm: f64,
        /// Temperature \[°C\].
        temperature_c: f64,
    },
}
