//! The records that a case asks for.

use super::along_path::PathRecords;
use crate::case::{FullFilmName, LoadedCase};
use crate::chosen_laws::ChosenLaws;
use crate::error::PositionError;
use crate::friction;
use crate::station::Station;

/// Records of mixed lubrication along `stations`, where the load share or the full film asks for them, and how
/// many of them `progress` counts before the positions.
///
/// # Errors
/// When a record has no solution.
pub(crate) fn of_case(
    loaded: &LoadedCase,
    laws: &ChosenLaws,
    stations: &[Station],
    progress: &(dyn Fn(usize, usize) + Sync),
) -> Result<(Option<PathRecords>, usize), PositionError> {
    let case = &loaded.case;
    let is_film = case.model.full_film == FullFilmName::EhlTransient;
    if !laws.load_share.needs_records() && !is_film {
        return Ok((None, 0));
    }
    let smooth = |station: &Station| match case.model.film_friction.shear_law() {
        Some(_) if case.laws.friction.is_none() => {
            friction::smooth(case, laws, &loaded.surfaces, station).map(Some)
        }
        _ => Ok(None),
    };
    let count = PathRecords::count(loaded, stations);
    let shown = |done: usize, missing: usize| {
        progress(count - missing + done, count + stations.len());
    };
    let Some(records) = PathRecords::solve(loaded, stations, &smooth, &shown)? else {
        return Ok((None, 0));
    };
    records.cite();
    Ok((Some(records), count))
}
