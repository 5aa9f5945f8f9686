//! Errors of the lubricated contact, with advice in options of this command.

use asperity_core::Code;
use std::path::Path;

use asperity::ehl::EhlError;
use asperity::error::Error;
use asperity::reference_solution::ReferenceError;

use crate::failure::Failure;

/// Error of the lubricated contact `title`.
pub fn of_contact(title: &str, error: &EhlError) -> Failure {
    let failure = Failure::new(error.code(), format!("{title}: {error}"));
    let advice = match error {
        EhlError::NotConverged { .. } => {
            "Pass more --cells, or another --viscosity-law: under Barus' law the pressure spike is unbounded above alpha p0 = 14."
        }
        EhlError::StepFailed { .. } => {
            "Pass more --cells, smoother profiles, or a --pressure-limit at which the surfaces yield."
        }
        EhlError::Cells { .. } => "Pass --cells as a multiple of 64; 512 is the default.",
        EhlError::Hertz(_) => "Correct --radius, --e-star or --load.",
        _ => return failure,
    };
    failure.advising(advice)
}

/// Error of the reference solution for the case in `file`.
pub fn of_reference(file: &Path, error: &ReferenceError) -> Failure {
    let title = file.display().to_string();
    match error {
        ReferenceError::Position(error) => {
            Failure::about(file, &Error::Whole(Box::new(error.clone())))
        }
        ReferenceError::Ehl(error) => of_contact(&title, error),
        ReferenceError::NoBaseOil => Failure::new(Code::E208, format!("{title}: {error}"))
            .advising("Set lubricant.base_oil in the case: mineral, pao, ester or polyglycol."),
        _ => Failure::new(Code::E305, format!("{title}: {error}")),
    }
}
