//! Reasons why a lubricated contact has no solution here.

use asperity_contact::ContactError;
use asperity_core::cancel::Cancelled;
use asperity_core::quantity::Pressure;
use asperity_core::remedy::{Remedy, Setting, Value};
use asperity_core::{Code, DomainError, Fault, decimals};

/// Errors of a lubricated line contact. A caller distinguishes work that it stopped itself from work that failed.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum EhlError {
    /// The work was cancelled.
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
    /// The record was stopped by its watcher.
    #[error("stopped at {time} half-widths of travel", time = decimals(*time, 3))]
    Stopped {
        /// Time reached.
        time: f64,
    },
    /// An error that no caller distinguishes from others.
    #[error(transparent)]
    Fault(#[from] Fault),
}

impl EhlError {
    /// The grid cannot be halved often enough for the two-level solver.
    pub(crate) fn cells(cells: usize, multiple: usize, most: usize) -> Self {
        let text =
            format!("{cells} cells: give a multiple of {multiple} between {multiple} and {most}");
        let remedy = Remedy::set(Setting::Key("cells"), Value::Like("512".into()))
            .because(format!("as a multiple of {multiple}"));
        Fault::new(Code::E209, text).with(remedy).into()
    }

    /// The profile of surface 1 or 2 ends before the record does: its length and the length needed \[m\].
    pub(crate) fn profile_too_short(surface: u8, length: f64, needed: f64) -> Self {
        let text = format!(
            "the profile of surface {surface} is {length:.4e} m long and the solution needs {needed:.4e} m of it: shorten its travel, or make the profile periodic"
        );
        Fault::new(Code::E209, text).into()
    }

    /// Newton's method did not settle on a steady solution from any start: its iterations, the largest change of the pressure in
    /// the last one over the Hertz pressure, and the nodes whose state still changed.
    pub(crate) fn not_converged(
        cells: usize,
        iterations: usize,
        change: f64,
        changes: usize,
        hint: &'static str,
    ) -> Self {
        let text = format!(
            "no steady solution on {cells} cells after {iterations} Newton iterations (last change of the pressure {change:.2e} of the Hertz pressure, {changes} nodes still changed state): {hint}"
        );
        let remedy = Remedy::state(Setting::Key("cells"))
            .because("to more")
            .or_set(Setting::Key("viscosity_law"), Value::Any)
            .because(
                "to another: under Barus' law the pressure spike is unbounded above alpha p0 = 14",
            );
        Fault::new(Code::E307, text).with(remedy).into()
    }

    /// A time step failed at `time` half-widths travelled at the mean speed, at the smallest fraction of its length; `change` is
    /// the largest of the pressure in the last Newton iteration.
    pub(crate) fn step_failed(time: f64, fraction: usize, change: f64) -> Self {
        let text = format!(
            "the time step at {} half-widths of travel did not converge at 1/{fraction} of its length (last change of the pressure {change:.2e} of the Hertz pressure): use more cells, a longer cut-off of the profiles, or a plastic ceiling",
            decimals(time, 4)
        );
        let remedy = Remedy::state(Setting::Key("cells"))
            .because("to more")
            .or_do("smooth the profiles")
            .or_set(Setting::Key("pressure_limit"), Value::Any)
            .because("at which the surfaces yield");
        Fault::new(Code::E307, text).with(remedy).into()
    }

    /// Film temperatures and shear stresses did not settle.
    pub(crate) fn temperatures_unsettled(iterations: usize, change: Pressure) -> Self {
        let text = format!(
            "the shear stress still changed by {change:.6} after {iterations} iterations of the temperatures"
        );
        Fault::new(Code::E307, text).into()
    }

    /// Stable code of the message, for a contact without a case.
    pub fn code(&self) -> Code {
        match self {
            Self::Fault(fault) => fault.code(),
            Self::Cancelled(_) | Self::Stopped { .. } => Code::E209,
        }
    }

    /// Whether the iteration failed, and no input is to blame.
    pub fn is_unconverged(&self) -> bool {
        self.code() == Code::E307
    }
}

impl From<DomainError> for EhlError {
    fn from(error: DomainError) -> Self {
        Self::Fault(error.into())
    }
}

/// The Hertz contact that scales the problem does not exist.
impl From<ContactError> for EhlError {
    fn from(error: ContactError) -> Self {
        match error {
            ContactError::Cancelled(cancelled) => Self::Cancelled(cancelled),
            error => {
                let remedy = Remedy::act("correct the radius, the reduced modulus or the load");
                Self::Fault(Fault::from_cause(Code::E209, error).with(remedy))
            }
        }
    }
}

/// A shear stress with its own heat did not converge.
impl From<asperity_oil::LubricantError> for EhlError {
    fn from(error: asperity_oil::LubricantError) -> Self {
        Self::Fault(Fault::from_cause(Code::E307, error))
    }
}

impl From<EhlError> for Fault {
    fn from(error: EhlError) -> Self {
        match error {
            EhlError::Fault(fault) => fault,
            error => Self::from_cause(error.code(), error),
        }
    }
}
