//! The one file that knows the order of the model, the paper's Fig. 2.
//!
//! Where the case asks for it, first the bulk temperature that the loss keeps up ([`settled`]). The load over the
//! flanks and the cells of the path; then at every mesh position, in parallel: motion and load, Hertz contact, smooth
//! film; then at every offset of the traces, pair by pair of teeth where there are several: roughness under the contact, Λ* and with it the regime, the rough contact
//! and from it the load share, friction in film, lubricated asperities and boundary layer. That is all that the losses
//! need ([`losses`]); their contacts can be kept for other oils, speeds and temperatures ([`contact_tables`]). A run
//! goes on with the contacts of the load shares that did not solve them ([`contacts`]), and at the first offset the
//! fields and the stress below them ([`run`]). Then the sums: cycle mean at each offset, mean and spread over the
//! offsets.

use std::borrow::Cow;
use std::collections::BTreeSet;
use std::sync::atomic::{AtomicUsize, Ordering};

use asperity_core::cancel::checkpoint;
use asperity_core::provenance::Provenance;
use asperity_gear::LoadMap;
use rayon::prelude::*;

use crate::bulk;
use crate::case::{Case, LoadedCase};
use crate::chosen_laws::ChosenLaws;
use crate::contact_tables::{ContactTables, KeptContact};
use crate::detail::Detail;
use crate::encounter::{is_substituted, meeting};
use crate::error::{Error, PositionError};
use crate::formulation;
use crate::gearbox;
use crate::kept_fields::{Keeper, KeptFields};
use crate::physical_sense::{check_position, check_station};
use crate::placement::check_coverage;
use crate::position::Position;
use crate::provenance;
use crate::records::{self, PathRecords};
use crate::result::{Losses, Outcome, RunInFlanks};
use crate::rolling;
use crate::rough_film;
use crate::run_in;
use crate::solve::Run;
use crate::solved::Solved;
use crate::station::Station;
use crate::stations::{named_points, stations_under, stations_with};

pub use crate::stations::{station_at, stations};

/// Told after each position: how many are done, of how many.
pub type Progress<'a> = &'a (dyn Fn(usize, usize) + Sync);

/// Checks all that a run checks before it solves a contact: the table of the gearbox, the mesh positions, the place of the
/// traces, and at the first offset of each pair of teeth the windows that meet. Records of mixed lubrication are not
/// computed, and a bulk temperature that follows from the loss is not sought.
///
/// # Errors
/// The error with which [`run`] ends.
///
/// ```
/// use asperity::{case, pipeline};
/// let file = std::path::Path::new("../../fixtures/cases/e-drive.toml");
/// pipeline::check(&case::load(file, None)?)?;
/// // A window that is longer than the traces.
/// let long = case::load_with(file, &|input| input.model.window = Some(40.0))?;
/// assert_eq!(pipeline::check(&long).unwrap_err().code(), "E122");
/// # Ok::<(), asperity::Error>(())
/// ```
pub fn check(loaded: &LoadedCase) -> Result<(), Error> {
    let laws = ChosenLaws::of(&loaded.case);
    let (map, stations) = placed_stations(loaded, &laws, None).map_err(Box::new)?;
    let mesh = Mesh {
        map,
        stations,
        records: None,
        record_count: 0,
    };
    let run = mesh.run(loaded, &laws, (Detail::Losses, None));
    let checked = mesh.stations.par_iter().map(|station| run.check(station));
    numbered(checked.collect())?;
    if loaded.case.model.run_in {
        run_in::places(&loaded.case, &loaded.surfaces, &mesh.stations).map_err(Box::new)?;
    }
    Ok(())
}

/// The load over the flanks and the mesh positions, on traces that cover them.
fn placed_stations(
    loaded: &LoadedCase,
    laws: &ChosenLaws,
    kept: Option<&LoadMap>,
) -> Result<(LoadMap, Vec<Station>), PositionError> {
    // A table that does not reach the operating point is told before the work.
    gearbox::check(&loaded.case)?;
    let (map, stations) = match kept {
        Some(map) => (map.clone(), stations_under(&loaded.case, laws, map)?),
        None => stations_with(&loaded.case, laws)?,
    };
    if let Some(coverage) = loaded.surfaces.coverage(stations.iter()) {
        check_coverage(coverage)?;
    }
    Ok((map, stations))
}

/// Runs a case whole. The same input gives the same result to the last digit on any number of threads of one type of
/// processor; transforms round differently with and without AVX2, which moves losses by some 1e-8 of their value.
///
/// # Errors
/// When a position has no solution; the first one along the path is named.
pub fn run(loaded: &LoadedCase, progress: Progress<'_>) -> Result<Outcome, Error> {
    Ok(outcome(loaded, (Detail::Fields, false), &KeptFields::All, progress)?.0)
}

/// The same, holding the fields of some positions alone: a megabyte each with the stress below the surface.
/// All else in the outcome is as without.
///
/// # Errors
/// As [`run`].
///
/// ```
/// use asperity::case;
/// use asperity::kept_fields::KeptFields;
/// use asperity::pipeline::run_keeping;
/// let file = std::path::Path::new("../../fixtures/cases/e-drive.toml");
/// let case = case::load_with(file, &|input| {
///     (input.model.positions, input.model.offsets) = (Some(4), Some(2));
/// })?;
/// assert_eq!(run_keeping(&case, &KeptFields::Highest, &|_, _| {})?.fields.len(), 1);
/// assert_eq!(run_keeping(&case, &KeptFields::All, &|_, _| {})?.fields.len(), 4);
/// # Ok::<(), asperity::Error>(())
/// ```
pub fn run_keeping(
    loaded: &LoadedCase,
    kept: &KeptFields,
    progress: Progress<'_>,
) -> Result<Outcome, Error> {
    Ok(outcome(loaded, (Detail::Fields, false), kept, progress)?.0)
}

/// The same with the contacts of the run for [`losses_with`]; none where the losses hang on contacts that are
/// not kept.
pub(crate) fn run_keeping_contacts(
    loaded: &LoadedCase,
    kept: &KeptFields,
    progress: Progress<'_>,
) -> Result<(Outcome, Option<ContactTables>), Error> {
    outcome(loaded, (Detail::Fields, true), kept, progress)
}

/// Runs a case with the rough contacts at every offset, without fields and stress below the surface.
///
/// # Errors
/// As [`run`].
pub fn contacts(loaded: &LoadedCase, progress: Progress<'_>) -> Result<Outcome, Error> {
    Ok(outcome(
        loaded,
        (Detail::Contacts, false),
        &KeptFields::All,
        progress,
    )?
    .0)
}

/// Losses alone, equal to those of [`run`] to the last digit. The rough contacts are solved where the losses
/// hang on them: with the load shares `solved` and `jgp`, in the paper's formulation, and where running-in is
/// counted.
///
/// # Errors
/// As [`run`].
pub fn losses(loaded: &LoadedCase, progress: Progress<'_>) -> Result<Losses, Error> {
    losses_of(loaded, None, progress)
}

/// The same with the rough contacts made before, by [`contact_tables`], for a case that differs in oil, speed
/// or temperature alone; to the last digit as without them.
///
/// # Errors
/// As [`run`], and when the tables are those of other flanks, gears or loads.
///
/// ```
/// use asperity::{case, pipeline};
/// let file = std::path::Path::new("../../fixtures/cases/e-drive.toml");
/// let case = case::load_with(file, &|input| {
///     (input.model.positions, input.model.offsets) = (Some(4), Some(2));
/// })?;
/// let tables = pipeline::contact_tables(&case)?;
/// for temperature in ["60 °C", "90 °C"] {
///     let case = case.with_key("operation.temperature", temperature)?;
///     let losses = pipeline::losses_with(&tables, &case, &|_, _| {})?;
///     assert!(losses.summary.boundary_w > 0.0);
/// }
/// # Ok::<(), asperity::Error>(())
/// ```
pub fn losses_with(
    tables: &ContactTables,
    loaded: &LoadedCase,
    progress: Progress<'_>,
) -> Result<Losses, Error> {
    let checked = tables.check(&loaded.case, &loaded.surfaces);
    checked.map_err(Box::new)?;
    losses_of(loaded, Some(tables), progress)
}

/// A case at the bulk temperature that its loss keeps up, with contacts made before, if any; itself where the
/// temperature is given.
///
/// ```
/// use asperity::{case, pipeline};
/// let file = std::path::Path::new("../../fixtures/cases/e-drive.toml");
/// let case = case::load_with(file, &|input| {
///     (input.model.positions, input.model.offsets) = (Some(4), Some(2));
/// })?;
/// assert!(pipeline::settled(&case, None)?.case.found_bulk.is_none());
/// let asked = case.with_key("operation.bulk", r#"{ law = "iso", lubrication = "jet" }"#)?;
/// let settled = pipeline::settled(&asked, None)?;
/// let found = settled.case.found_bulk.as_ref().ok_or("it was asked for")?;
/// assert!(found.report.bulk_c > found.report.oil_c + 5.0);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// As [`losses`], and when the temperature does not settle.
pub fn settled<'a>(
    loaded: &'a LoadedCase,
    tables: Option<&ContactTables>,
) -> Result<Cow<'a, LoadedCase>, Error> {
    let Some(model) = loaded.case.bulk else {
        return Ok(Cow::Borrowed(loaded));
    };
    let made;
    let tables = match tables {
        Some(tables) => tables,
        None => {
            made = contact_tables(loaded)?;
            &made
        }
    };
    let losses = |case: &LoadedCase| losses_with(tables, case, &|_, _| {});
    bulk::settle(loaded, model, losses).map(Cow::Owned)
}

/// The rough contacts of a case at every position and offset, without oil, speed or temperature; their roughness
/// alone where the load share does not look at them.
///
/// # Errors
/// When a contact has no solution.
pub fn contact_tables(loaded: &LoadedCase) -> Result<ContactTables, Error> {
    let (case, surfaces) = (&loaded.case, &loaded.surfaces);
    let laws = ChosenLaws::of(case);
    let (map, stations) = stations_with(case, &laws).map_err(Box::new)?;
    let count = surfaces.offsets(case.model.offsets);
    let is_solved = rough_film::is_asked_for(case, &laws, surfaces);
    let solved: Vec<Result<_, PositionError>> = stations
        .into_par_iter()
        .map(|station| {
            let mut tables = Vec::with_capacity(count);
            for k in 0..count {
                checkpoint()?;
                let window = case.model.window;
                if let (Some(met), roughness) = meeting(surfaces, &station, window, k, count)? {
                    let table = is_solved.then(|| rough_film::table(case, &station, &met));
                    tables.push(KeptContact::new(&met, roughness, table.transpose()?));
                }
            }
            Ok((station, tables))
        })
        .collect();
    let rows: Vec<_> = solved
        .into_iter()
        .collect::<Result<_, PositionError>>()
        .map_err(Box::new)?;
    Ok(ContactTables::new(case, surfaces, map, rows.into_iter()))
}

fn losses_of(
    loaded: &LoadedCase,
    tables: Option<&ContactTables>,
    progress: Progress<'_>,
) -> Result<Losses, Error> {
    let found = settled(loaded, tables)?;
    let loaded = found.as_ref();
    let used = Provenance::new();
    let laws = ChosenLaws::of(&loaded.case);
    let kept = tables.and_then(|tables| tables.load_map(&loaded.case));
    let later = RunInSteps::of(&loaded.case);
    let shown = |done, total| progress(done, total + later.after(total));
    let mesh = Mesh::of(loaded, &laws, kept, &shown, &used)?;
    let run = mesh.run(loaded, &laws, (Detail::Losses, tables));
    let keeper = Keeper::new(&KeptFields::All);
    let positions = mesh.positions(&run, &keeper, &shown, &used)?;
    let sums = || mesh.sums(loaded, positions)?.losses();
    let mut losses = used.collect(sums).map_err(Box::new)?;
    losses.run_in = run_in_flanks(loaded, &laws, &mesh, &used, progress)?;
    (losses.equations, _) = provenance::used(&tags(loaded, &used));
    Ok(losses)
}

fn outcome(
    loaded: &LoadedCase,
    (detail, keeps): (Detail, bool),
    kept: &KeptFields,
    progress: Progress<'_>,
) -> Result<(Outcome, Option<ContactTables>), Error> {
    let found = settled(loaded, None)?;
    let loaded = found.as_ref();
    let used = Provenance::new();
    let laws = ChosenLaws::of(&loaded.case);
    let later = RunInSteps::of(&loaded.case);
    let shown = |done, total| progress(done, total + later.after(total));
    let mesh = Mesh::of(loaded, &laws, None, &shown, &used)?;
    let run = Run {
        keeps,
        ..mesh.run(loaded, &laws, (detail, None))
    };
    let keeper = Keeper::new(kept);
    let mut positions = mesh.positions(&run, &keeper, &shown, &used)?;
    keeper.give_back(&mut positions);
    let tables = keeps.then(|| {
        let rows = positions.iter_mut();
        let rows = rows.map(|p| (p.station.clone(), std::mem::take(&mut p.kept)));
        ContactTables::new(&loaded.case, &loaded.surfaces, mesh.map.clone(), rows)
    });
    let sums = || {
        let points = mesh.points(loaded, &laws, &used)?;
        mesh.sums(loaded, positions)?.outcome(&points)
    };
    let mut outcome = used.collect(sums).map_err(Box::new)?;
    let result = &mut outcome.result;
    result.run_in = run_in_flanks(loaded, &laws, &mesh, &used, progress)?;
    (result.equations, result.references) = provenance::used(&tags(loaded, &used));
    Ok((outcome, tables))
}

/// Tags of the equations that preparation and run used.
fn tags(loaded: &LoadedCase, used: &Provenance) -> BTreeSet<&'static str> {
    let mut tags = loaded.provenance.tags();
    tags.extend(used.tags());
    tags
}

/// Steps that running-in adds to the progress of a run.
struct RunInSteps(bool);

impl RunInSteps {
    fn of(case: &Case) -> Self {
        Self(case.model.run_in)
    }

    /// Steps after `measured`, those of the flanks as measured: the cycles, and the flanks run in.
    fn after(&self, measured: usize) -> usize {
        match self.0 {
            true => run_in::MAX_CYCLES + measured,
            false => 0,
        }
    }
}

/// The flanks of a case run in and what the mesh then loses, where the case asks for it.
fn run_in_flanks(
    loaded: &LoadedCase,
    laws: &ChosenLaws,
    mesh: &Mesh,
    used: &Provenance,
    progress: Progress<'_>,
) -> Result<Option<RunInFlanks>, Error> {
    let case = &loaded.case;
    if !case.model.run_in {
        return Ok(None);
    }
    let measured = mesh.record_count + mesh.stations.len();
    let total = measured + RunInSteps::of(case).after(measured);
    let cycle = |number| progress(measured + number, total);
    let run_in = || run_in::run_in(case, &loaded.surfaces, &mesh.stations, &cycle);
    let ran_in = used.collect(run_in).map_err(Box::new)?;
    let mut loaded = loaded.clone();
    loaded.surfaces = ran_in.surfaces.clone();
    let loaded = &loaded;
    let shown = |done, _| progress(measured + run_in::MAX_CYCLES + done, total);
    let recorded = || records::of_case(loaded, laws, &mesh.stations, &shown);
    let (records, record_count) = used.collect(recorded).map_err(Box::new)?;
    let mesh = Mesh {
        records,
        record_count,
        ..mesh.clone()
    };
    let run = mesh.run(loaded, laws, (Detail::Losses, None));
    let keeper = Keeper::new(&KeptFields::All);
    let positions = mesh.positions(&run, &keeper, &shown, used)?;
    let sums = || mesh.sums(loaded, positions)?.run_in_flanks(ran_in);
    Ok(Some(used.collect(sums).map_err(Box::new)?))
}

/// Solves mesh positions in parallel and checks each for plausibility; `after` is called with each that has a solution.
fn solve_each(
    run: &Run<'_>,
    stations: &[Station],
    used: &Provenance,
    after: impl Fn(&mut Position) + Sync,
) -> Vec<Result<Position, PositionError>> {
    let solve = |station: &Station| {
        used.collect(|| {
            check_station(station)?;
            let mut position = run.solve(station.clone())?;
            check_position(&position)?;
            after(&mut position);
            Ok(position)
        })
    };
    stations.par_iter().map(solve).collect()
}

/// What every mesh position has, in order; an error names the position.
fn numbered<T>(found: Vec<Result<T, PositionError>>) -> Result<Vec<T>, Error> {
    let count = found.len();
    let of_position = |(index, found): (usize, Result<T, PositionError>)| {
        found.map_err(|source| Error::Position {
            number: index + 1,
            count,
            source: Box::new(source),
        })
    };
    found.into_iter().enumerate().map(of_position).collect()
}

/// The load over the flanks, the mesh positions, and the records between which load shares are read.
#[derive(Clone)]
struct Mesh {
    map: LoadMap,
    stations: Vec<Station>,
    records: Option<PathRecords>,
    /// Records that progress counts before the positions.
    record_count: usize,
}

impl Mesh {
    fn of(
        loaded: &LoadedCase,
        laws: &ChosenLaws,
        kept: Option<&LoadMap>,
        progress: Progress<'_>,
        used: &Provenance,
    ) -> Result<Self, Error> {
        let found = || -> Result<Self, PositionError> {
            let (map, stations) = placed_stations(loaded, laws, kept)?;
            let (records, record_count) = records::of_case(loaded, laws, &stations, progress)?;
            Ok(Self {
                map,
                stations,
                records,
                record_count,
            })
        };
        Ok(used.collect(found).map_err(Box::new)?)
    }

    fn run<'a>(
        &'a self,
        loaded: &'a LoadedCase,
        laws: &'a ChosenLaws,
        (detail, tables): (Detail, Option<&'a ContactTables>),
    ) -> Run<'a> {
        Run {
            case: &loaded.case,
            laws,
            surfaces: &loaded.surfaces,
            detail,
            tables,
            keeps: false,
            records: self.records.as_ref(),
        }
    }

    fn positions(
        &self,
        run: &Run<'_>,
        keeper: &Keeper<'_>,
        progress: Progress<'_>,
        used: &Provenance,
    ) -> Result<Vec<Position>, Error> {
        let count = self.stations.len();
        let done = AtomicUsize::new(self.record_count);
        let after = |position: &mut Position| {
            keeper.take(position);
            let before = done.fetch_add(1, Ordering::Relaxed);
            progress(1 + before, self.record_count + count);
        };
        numbered(solve_each(run, &self.stations, used, after))
    }

    /// The points A to E of the path, solved as the positions are, without fields. A point whose contact the traces do
    /// not resolve is left out, as the load share there would be that of another law, and so is one whose window is
    /// longer than they are.
    fn points(
        &self,
        loaded: &LoadedCase,
        laws: &ChosenLaws,
        used: &Provenance,
    ) -> Result<Vec<(&'static str, Position)>, PositionError> {
        let case = &loaded.case;
        if formulation::of(case.formulation).takes_one_position() {
            return Ok(Vec::new());
        }
        let run = self.run(loaded, laws, (Detail::Contacts, None));
        let (names, stations): (Vec<_>, Vec<_>) = named_points(case, laws, &self.map)?
            .into_iter()
            .filter(|(_, station)| !is_substituted(&loaded.surfaces, station))
            .unzip();
        let solved = solve_each(&run, &stations, used, |_| {}).into_iter();
        let mut points = Vec::with_capacity(names.len());
        for (name, position) in names.into_iter().zip(solved) {
            match position {
                Ok(position) => points.push((name, position)),
                // Its window is wider than those of the positions, which have theirs.
                Err(PositionError::TraceTooShort { .. }) => {}
                Err(error) => return Err(error),
            }
        }
        Ok(points)
    }

    fn sums<'a>(
        &'a self,
        loaded: &'a LoadedCase,
        positions: Vec<Position>,
    ) -> Result<Solved<'a>, PositionError> {
        let rolling = positions
            .iter()
            .map(|position| rolling::rolling(&loaded.case, &position.station))
            .collect::<Result<Vec<_>, _>>()?;
        let solved = Solved::new(loaded, &self.map, positions, rolling)?;
        Ok(Solved {
            records: self.records.as_ref(),
            ..solved
        })
    }
}
