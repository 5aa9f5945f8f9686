//! The records that a case requires.

use super::chosen_laws::ChosenLaws;
use super::film_of_case::formula_film;
use super::friction;
use super::smooth_position::SmoothPosition;
use crate::mesh::MeshPosition;
use crate::records::PathRecords;
use asperity_case::case::{FullFilmName, OperatingCase, ShareLaw};
use asperity_case::error::PositionError;

/// Reference solutions along `positions`, if the load share or the full film requires them, and how
/// many of them `progress` counts before the positions.
///
/// # Errors
/// When a record has no solution.
pub(crate) fn records_of(
    loaded: &OperatingCase,
    laws: &ChosenLaws,
    positions: &[MeshPosition],
    progress: &(dyn Fn(usize, usize) + Sync),
) -> Result<(Option<PathRecords>, usize), PositionError> {
    let case = loaded;
    let is_film = case.model.full_film == FullFilmName::EhlTransient;
    if !matches!(laws.load_share, ShareLaw::Reference) && !is_film {
        return Ok((None, 0));
    }
    let smooth = |position: &MeshPosition| match case.model.film_friction.shear_law() {
        Some(_) if case.laws.friction.is_none() => {
            let film = formula_film(case, position)?;
            let smooth = SmoothPosition {
                at: position,
                film: &film,
            };
            friction::smooth(case, laws, &loaded.surfaces, smooth).map(Some)
        }
        _ => Ok(None),
    };
    let count = PathRecords::count(loaded, positions);
    let shown = |done: usize, missing: usize| {
        progress(count - missing + done, count + positions.len());
    };
    let Some(records) = PathRecords::solve(loaded, positions, &smooth, &shown)? else {
        return Ok((None, 0));
    };
    records.cite();
    Ok((Some(records), count))
}
