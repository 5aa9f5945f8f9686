//! The one file that knows the order of the model, the paper's Fig. 2.
//!
//! At every mesh position, in parallel: motion and load, Hertz contact, smooth film; then at every
//! offset of the traces: roughness under the contact, friction in the film, Λ* and with it the
//! regime; full film, or a rough contact that carries what the film does not; friction force. Then the
//! losses: cycle mean at each offset, mean and spread over the offsets.

use rayon::prelude::*;

use asperity_core::quantity::Length;
use asperity_gear::PositionRule;

use crate::case::{Case, Formulation, LoadedCase};
use crate::error::{PositionError, RunError};
use crate::position::Position;
use crate::result::Outcome;
use crate::station::Station;
use crate::{assembly, friction};

/// Told after each position: how many are done, of how many.
pub type Progress<'a> = &'a (dyn Fn(usize, usize) + Sync);

/// Runs a case. The same input gives the same result to the last digit on any number of threads.
///
/// # Errors
/// When a position has no solution; the first one along the path is named.
pub fn run(loaded: &LoadedCase, progress: Progress<'_>) -> Result<Outcome, RunError> {
    let case = &loaded.case;
    let stations = stations(case).map_err(Box::new)?;
    let count = stations.len();
    let done = std::sync::atomic::AtomicUsize::new(0);
    let solved: Vec<Result<Position, PositionError>> = stations
        .into_par_iter()
        .map(|station| {
            let position = Position::solve(case, &loaded.surfaces, station);
            let done = 1 + done.fetch_add(1, std::sync::atomic::Ordering::Relaxed);
            progress(done, count);
            position
        })
        .collect();
    let mut positions = Vec::with_capacity(count);
    for (index, position) in solved.into_iter().enumerate() {
        positions.push(position.map_err(|source| RunError::Position {
            number: index + 1,
            count,
            source: Box::new(source),
        })?);
    }
    let rolling = positions
        .iter()
        .map(|position| friction::rolling(case, &position.station))
        .collect::<Result<Vec<_>, _>>()
        .map_err(Box::new)?;
    Ok(assembly::assemble(loaded, positions, &rolling).map_err(Box::new)?)
}

/// The mesh positions without roughness: along the path, or the paper's single one.
pub fn stations(case: &Case) -> Result<Vec<Station>, PositionError> {
    let gears = &case.gears;
    let places: Vec<(Length, Length)> = match case.formulation {
        Formulation::Corrected => gears
            .positions(case.model.positions, PositionRule::default())?
            .into_iter()
            .map(|place| (place.s, place.weight))
            .collect(),
        Formulation::Paper => {
            let path = gears.path();
            let s = path.a + (path.e - path.a) * case.model.position;
            let place = gears.single_position(s)?;
            vec![(place.s, place.weight)]
        }
    };
    places
        .into_iter()
        .enumerate()
        .map(|(index, (s, weight))| Station::new(case, index + 1, s, weight.si()))
        .collect()
}
