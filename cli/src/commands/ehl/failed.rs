//! Errors of the lubricated contact, with advice in options of this command.

use std::path::Path;

use asperity::ehl::EhlError;
use asperity::error::Error;
use asperity::reference_solution::RefereeError;

use crate::failure::Failure;

/// Error of the lubricated contact `title`.
pub fn of_contact(title: &str, error: &EhlError) -> Failure {
    let failure = |code| Failure::new(code, format!("{title}: {error}"));
    match error {
        EhlError::NotConverged { .. } => failure("E307").advising(
            "Pass more --cells, or another --viscosity-law: under Barus' law the pressure spike is unbounded above alpha p0 = 14.",
        ),
        EhlError::StepFailed { .. } => failure("E307").advising(
            "Pass more --cells, smoother profiles, or a --pressure-limit at which the surfaces yield.",
        ),
        EhlError::TemperaturesUnsettled { .. } => failure("E307"),
        EhlError::Cells { .. } => {
            failure("E209").advising("Pass --cells as a multiple of 64; 512 is the default.")
        }
        EhlError::Hertz(_) => failure("E209").advising("Correct --radius, --e-star or --load."),
        _ => failure("E209"),
    }
}

/// Error of the reference solution for the case in `file`.
pub fn of_referee(file: &Path, error: &RefereeError) -> Failure {
    let title = file.display().to_string();
    match error {
        RefereeError::Position(error) => {
            Failure::about(file, &Error::Whole(Box::new(error.clone())))
        }
        RefereeError::Ehl(error) => of_contact(&title, error),
        RefereeError::NoBaseOil => Failure::new("E208", format!("{title}: {error}"))
            .advising("Set lubricant.base_oil in the case: mineral, pao, ester or polyglycol."),
        _ => Failure::new("E305", format!("{title}: {error}")),
    }
}
