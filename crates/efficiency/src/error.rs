//! Errors of losses and efficiencies.

use asperity_core::DomainError;
use asperity_core::quantity::{LineEnergy, Power, Temperature};

/// Errors of losses and efficiency.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum EfficiencyError {
    /// A single number outside its domain.
    #[error(transparent)]
    Domain(#[from] DomainError),
    /// A mean over no places.
    #[error("a mesh loss needs at least one position")]
    NoPositions,
    /// Arrays that should go together do not.
    #[error("{name} has {found} points where {expected} are needed")]
    LengthMismatch {
        /// The array.
        name: &'static str,
        /// Its length.
        found: usize,
        /// The length of the array it goes with.
        expected: usize,
    },
    /// The mesh loses all that is put in, or more.
    #[error("the losses, {loss}, are not below the input power, {input}")]
    LossExceedsInput {
        /// Sum of the losses.
        loss: Power,
        /// Input power.
        input: Power,
    },
    /// A deformation that gives energy back.
    #[error("{name} = {energy}: a deformation cannot release more than it took")]
    NegativeEnergy {
        /// The energy.
        name: &'static str,
        /// Its value.
        energy: LineEnergy,
    },
    /// A bulk temperature that does not settle.
    #[error(
        "the bulk temperature did not settle in {steps} steps (last {:.0} °C, still moving by {residual:.2} K)",
        temperature.celsius()
    )]
    BulkNotSettled {
        /// Last temperature.
        temperature: Temperature,
        /// Change that the next step would make \[K\].
        residual: f64,
        /// Steps taken.
        steps: usize,
    },
    /// Rows of a table of losses that do not form a grid.
    #[error("{rows} rows are no grid of {torques} torques and {speeds} speeds")]
    NoGrid {
        /// Rows, at one temperature where there are several.
        rows: usize,
        /// Different torques among them.
        torques: usize,
        /// Different speeds among them.
        speeds: usize,
    },
    /// A row of a table of losses with a number that cannot be.
    #[error("{rule}, and is {value} in a row")]
    TableRow {
        /// Rule.
        rule: &'static str,
        /// The value; the speed of the row where it is about its place.
        value: f64,
    },
    /// A table of losses does not reach the operating point.
    #[error(
        "the table has no loss at {torque_nm} N m, {speed_rpm} 1/min, {temperature_c} °C; nothing is extrapolated"
    )]
    NotInTable {
        /// Torque \[N m\].
        torque_nm: f64,
        /// Speed \[1/min\].
        speed_rpm: f64,
        /// Temperature \[°C\].
        temperature_c: f64,
    },
}
