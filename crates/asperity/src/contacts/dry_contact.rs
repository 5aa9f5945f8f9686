//! The rough contact without a film: both flanks pressed dry against each other at one position.

use asperity_contact::ContactSolution;
use asperity_contact::hertz_line::HertzLine;

use super::pressed::Pressing;
use crate::mesh::position_at;
use asperity_case::case::LoadedCase;
use asperity_case::error::{Error, PositionError};
use asperity_case::flanks::{OffsetIndex, WindowPair};

/// A dry rough contact.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct DryContact {
    /// Place on the path, 0 at A and 1 at E.
    pub path_fraction: f64,
    /// The smooth contact to compare with.
    pub hertz: HertzLine,
    /// Position across the contact, 0 at its middle \[m\].
    pub x: Vec<f64>,
    /// Undeformed gap \[m\].
    pub undeformed: Vec<f64>,
    /// The solution.
    pub solution: ContactSolution,
}

/// The flanks of `loaded` at their middle offset under the whole line load, without a film.
///
/// # Errors
/// When a flank has no trace or several, or the contact no solution.
pub fn dry_contact(loaded: &LoadedCase, path_fraction: f64) -> Result<DryContact, Error> {
    solve(loaded, path_fraction).map_err(|error| Error::Whole(Box::new(error)))
}

fn solve(loaded: &LoadedCase, path_fraction: f64) -> Result<DryContact, PositionError> {
    let (case, surfaces) = (&loaded.case, &loaded.surfaces);
    surfaces.check_one_pair()?;
    let path = case.gears.path();
    let position = position_at(case, path.a + (path.e - path.a) * path_fraction)?;
    let first = OffsetIndex { k: 0, count: 1 };
    let pair = WindowPair::at(surfaces, &position, case.model.window, case.modulus, first)?;
    let pair = pair.ok_or_else(PositionError::no_profile)?;
    let pressing = Pressing {
        case,
        position: &position,
        pair: &pair,
        film_share: 0.0,
    };
    let solution = pressing
        .solve()?
        .solids
        .ok_or_else(PositionError::no_profile)?;
    Ok(DryContact {
        path_fraction,
        hertz: position.hertz,
        x: pair.x,
        undeformed: pair.gap,
        solution,
    })
}
