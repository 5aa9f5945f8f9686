//! Reasons why a lubricated contact has no solution here.

use asperity_contact::ContactError;
use asperity_core::cancel::Cancelled;
use asperity_core::quantity::Pressure;
use asperity_core::remedy::{Remedy, Setting, Value};
use asperity_core::{Code, DomainError, Fault, decimals};

/// Errors of a lubricated line contact.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum EhlError {
    /// An input outside its domain.
    #[error(transparent)]
    Domain(#[from] DomainError),
    /// The Hertz contact that scales the problem does not exist.
    #[error(transparent)]
    Hertz(#[from] ContactError),
    /// The work was cancelled.
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
    /// The grid cannot be halved often enough for the two-level solver.
    #[error("{cells} cells: give a multiple of {multiple} between {least} and {most}")]
    Cells {
        /// Requested cells.
        cells: usize,
        /// Number they must be a multiple of.
        multiple: usize,
        /// Fewest cells.
        least: usize,
        /// Most cells.
        most: usize,
    },
    /// A profile ends before the record does.
    #[error(
        "the profile of surface {surface} is {length:.4e} m long and the record needs {needed:.4e} m of it: shorten the record, or make the profile periodic"
    )]
    ProfileTooShort {
        /// Surface 1 or 2.
        surface: u8,
        /// Length of the profile \[m\].
        length: f64,
        /// Length needed \[m\].
        needed: f64,
    },
    /// Newton's method did not settle on a steady solution from any start.
    #[error(
        "no steady solution on {cells} cells after {iterations} Newton iterations (last change of the pressure {change:.2e} of the Hertz pressure, {changes} nodes still changed state): {hint}"
    )]
    NotConverged {
        /// Cells of the grid.
        cells: usize,
        /// Newton iterations on that grid.
        iterations: usize,
        /// Largest change of the pressure in the last one, over the Hertz pressure.
        change: f64,
        /// Nodes whose state still changed.
        changes: usize,
        /// Advice.
        hint: &'static str,
    },
    /// A time step failed at its smallest length.
    #[error(
        "the time step at {time} half-widths of travel did not converge at 1/{fraction} of its length (last change of the pressure {change:.2e} of the Hertz pressure): use more cells, a longer cut-off of the profiles, or a plastic ceiling", time = decimals(*time, 4))]
    StepFailed {
        /// Time in half-widths travelled at the mean speed.
        time: f64,
        /// Smallest fraction of the step tried.
        fraction: usize,
        /// Largest change of the pressure in the last Newton iteration.
        change: f64,
    },
    /// Film temperatures and shear stresses did not settle.
    #[error(
        "the shear stress still changed by {change:.6} after {iterations} iterations of the temperatures"
    )]
    TemperaturesUnsettled {
        /// Iterations used.
        iterations: usize,
        /// Change of the shear stress in the last one.
        change: Pressure,
    },
    /// A shear stress with its own heat did not converge.
    #[error(transparent)]
    HeatedStress(#[from] asperity_oil::LubricantError),
    /// The record was stopped by its watcher.
    #[error("stopped at {time} half-widths of travel", time = decimals(*time, 3))]
    Stopped {
        /// Time reached.
        time: f64,
    },
}

impl EhlError {
    /// Stable code of the message, for a contact without a case.
    pub fn code(&self) -> Code {
        match self.is_unconverged() {
            true => Code::E307,
            false => Code::E209,
        }
    }

    /// Whether the iteration failed, and no input is to blame.
    pub fn is_unconverged(&self) -> bool {
        matches!(
            self,
            Self::NotConverged { .. }
                | Self::StepFailed { .. }
                | Self::TemperaturesUnsettled { .. }
                | Self::HeatedStress(_)
        )
    }
}

impl From<EhlError> for Fault {
    fn from(error: EhlError) -> Self {
        let key = Setting::Key;
        let remedy = match &error {
            EhlError::NotConverged { .. } => Remedy::state(key("cells"))
                .because("to more")
                .or_set(key("viscosity_law"), Value::Any)
                .because("to another: under Barus' law the pressure spike is unbounded above alpha p0 = 14"),
            EhlError::StepFailed { .. } => Remedy::state(key("cells"))
                .because("to more")
                .or_do("smooth the profiles")
                .or_set(key("pressure_limit"), Value::Any)
                .because("at which the surfaces yield"),
            EhlError::Cells { multiple, .. } => Remedy::set(key("cells"), Value::Like("512".into()))
                .because(format!("as a multiple of {multiple}")),
            EhlError::Hertz(_) => Remedy::act("correct the radius, the reduced modulus or the load"),
            _ => Remedy::none(),
        };
        Self::of(error.code(), error).with(remedy)
    }
}
