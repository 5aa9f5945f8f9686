//! Runs of a pair of gears.

use asperity::case::LoadedCase;
use asperity::result::Losses;
use asperity::{Contacts, Error, Run};

/// Losses of a pair of gears.
///
/// # Errors
/// As [`Run::losses`].
pub fn losses(case: &LoadedCase) -> Result<Losses, Error> {
    Run::new(case).losses()?.into_only()
}

/// Losses of a pair of gears with contacts computed before.
///
/// # Errors
/// As [`Run::losses`].
pub fn losses_with(contacts: &Contacts, case: &LoadedCase) -> Result<Losses, Error> {
    Run::new(case).known([contacts]).losses()?.into_only()
}

/// Contacts of a pair of gears.
///
/// # Errors
/// As [`Run::contacts`].
pub fn contacts(case: &LoadedCase) -> Result<Contacts, Error> {
    Ok(Run::new(case).contacts()?.swap_remove(0))
}
