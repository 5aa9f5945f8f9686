//! The one file that knows the order of the model, the paper's Fig. 2.
//!
//! At every mesh position, in parallel: motion and load, Hertz contact, smooth film; then at every
//! offset of the traces: roughness under the contact, Λ* and with it the regime, load share, friction in
//! the film, friction force. That is all that the losses need ([`losses`]). A run goes on: full film, or a
//! rough contact that carries what the film does not ([`contacts`]), and at the first offset the fields and
//! the stress below them ([`run`]). Then the sums: cycle mean at each offset, mean and spread over the
//! offsets.

use std::collections::BTreeSet;
use std::sync::atomic::{AtomicUsize, Ordering};

use asperity_core::provenance::Provenance;
use rayon::prelude::*;

use crate::case::LoadedCase;
use crate::chosen_laws::ChosenLaws;
use crate::detail::Detail;
use crate::error::{Error, PositionError};
use crate::friction;
use crate::physical_sense::{check_position, check_station};
use crate::position::Position;
use crate::provenance;
use crate::result::{Losses, Outcome};
use crate::solve::Run;
use crate::solved::Solved;
use crate::stations::stations_with;

pub use crate::stations::{station_at, stations};

/// Told after each position: how many are done, of how many.
pub type Progress<'a> = &'a (dyn Fn(usize, usize) + Sync);

/// Runs a case whole. The same input gives the same result to the last digit on any number of threads.
///
/// # Errors
/// When a position has no solution; the first one along the path is named.
pub fn run(loaded: &LoadedCase, progress: Progress<'_>) -> Result<Outcome, Error> {
    outcome(loaded, Detail::Fields, progress)
}

/// Runs a case with the rough contacts at every offset, without fields and stress below the surface.
///
/// # Errors
/// As [`run`].
pub fn contacts(loaded: &LoadedCase, progress: Progress<'_>) -> Result<Outcome, Error> {
    outcome(loaded, Detail::Contacts, progress)
}

/// Losses alone, equal to those of [`run`] to the last digit. The rough contacts are solved only where the
/// losses hang on them: in the paper's formulation, and where running-in is counted.
///
/// # Errors
/// As [`run`].
pub fn losses(loaded: &LoadedCase, progress: Progress<'_>) -> Result<Losses, Error> {
    let used = Provenance::new();
    let laws = ChosenLaws::of(&loaded.case);
    let positions = positions(loaded, &laws, Detail::Losses, progress, &used)?;
    let sums = || sums(loaded, &laws, positions)?.losses();
    let mut losses = used.collect(sums).map_err(Box::new)?;
    (losses.equations, _) = provenance::used(&tags(loaded, &used));
    Ok(losses)
}

fn outcome(loaded: &LoadedCase, detail: Detail, progress: Progress<'_>) -> Result<Outcome, Error> {
    let used = Provenance::new();
    let laws = ChosenLaws::of(&loaded.case);
    let positions = positions(loaded, &laws, detail, progress, &used)?;
    let sums = || sums(loaded, &laws, positions)?.outcome();
    let mut outcome = used.collect(sums).map_err(Box::new)?;
    let result = &mut outcome.result;
    (result.equations, result.references) = provenance::used(&tags(loaded, &used));
    Ok(outcome)
}

/// Tags of the equations that preparation and run used.
fn tags(loaded: &LoadedCase, used: &Provenance) -> BTreeSet<&'static str> {
    let mut tags = loaded.provenance.tags();
    tags.extend(used.tags());
    tags
}

fn positions(
    loaded: &LoadedCase,
    laws: &ChosenLaws,
    detail: Detail,
    progress: Progress<'_>,
    used: &Provenance,
) -> Result<Vec<Position>, Error> {
    let case = &loaded.case;
    let stations = used
        .collect(|| stations_with(case, laws))
        .map_err(Box::new)?;
    let run = Run {
        case,
        laws,
        surfaces: &loaded.surfaces,
        detail,
    };
    let count = stations.len();
    let done = AtomicUsize::new(0);
    let solved: Vec<Result<Position, PositionError>> = stations
        .into_par_iter()
        .map(|station| {
            let position = used.collect(|| {
                check_station(&station)?;
                let position = run.solve(station)?;
                check_position(&position).map(|()| position)
            });
            progress(1 + done.fetch_add(1, Ordering::Relaxed), count);
            position
        })
        .collect();
    let of_position = |(index, solved): (usize, Result<Position, PositionError>)| {
        solved.map_err(|source| Error::Position {
            number: index + 1,
            count,
            source: Box::new(source),
        })
    };
    solved.into_iter().enumerate().map(of_position).collect()
}

fn sums<'a>(
    loaded: &'a LoadedCase,
    laws: &'a ChosenLaws,
    positions: Vec<Position>,
) -> Result<Solved<'a>, PositionError> {
    let rolling = positions
        .iter()
        .map(|position| friction::rolling(&loaded.case, &position.station))
        .collect::<Result<Vec<_>, _>>()?;
    Solved::new(loaded, laws, positions, rolling)
}
