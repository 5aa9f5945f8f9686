//! Estimate of time and memory of a run.
//!
//! The work is counted: points of the contacts, of the subsurface stress, of running-in and of the transforms of the traces,
//! and cells and steps of elastohydrodynamic records. It is multiplied by times per unit, measured on the shipped cases
//! (docs/PERFORMANCE.md). The time of a contact also depends on the flanks, by a factor from a third to three. A measured
//! estimate therefore solves a few contacts of the case and scales the time of all contacts by theirs.

use asperity_core::task::{on_threads, threads};
use std::time::Instant;

use asperity::case::{FullFilmName, LoadedCase, ShareLaw};
use asperity::flanks::Texture;
use asperity::mesh::Mesh;
use asperity::pipeline::Kept;
use asperity::uncertainty;
use asperity::{Error, PositionError, Run};

/// Estimated time and memory of a run.
#[derive(Debug, Clone, Copy, PartialEq, Default, serde::Serialize)]
#[non_exhaustive]
pub struct Cost {
    /// Number of rough contacts, one per position and offset.
    pub contacts: usize,
    /// Number of points of all contacts.
    pub points: f64,
    /// Time with the available threads \[s\].
    pub seconds: f64,
    /// Memory of the program, the stored fields and contacts, and the traces \[bytes\].
    pub bytes: f64,
}

impl Cost {
    /// Estimate of two runs, one after the other.
    #[must_use]
    pub fn and(self, other: Self) -> Self {
        Self {
            contacts: self.contacts + other.contacts,
            points: self.points + other.points,
            seconds: self.seconds + other.seconds,
            bytes: self.bytes + other.bytes,
        }
    }
}

/// Time per point \[s\] if each contact is solved at the shares of the load that its film needs (`solved`); measured: 0.6 to
/// 2.2e-6.
const SECONDS_TABULATED: f64 = 1.5e-6;
/// Time per point \[s\] if each contact is solved once; measured: 0.2 to 0.7e-6.
const SECONDS_ONCE: f64 = 5e-7;
/// Time of the stress per point and depth \[s\]; measured: 6.3 to 7.4e-8.
const SECONDS_OF_STRESS: f64 = 7e-8;
/// Time per point of a contact of running-in \[s\].
const SECONDS_OF_WEAR: f64 = 5e-7;
/// Usual number of cycles of running-in, in each of which every window of a trace is in contact with every window of the other.
const CYCLES: f64 = 9.0;
/// Time of the film and its friction at one position and offset \[s\].
const SECONDS_OF_FILM: f64 = 3e-5;
/// Time of a transform per point and logarithm of the points \[s\].
const SECONDS_OF_TRANSFORM: f64 = 3e-9;
/// Points of the piece of a long trace that is transformed around a window, relative to the window.
const PIECE: f64 = 5.0;
/// Number of pieces whose total points a trace must exceed to be transformed in pieces.
const PIECES: f64 = 16.0;
/// Evaluations of the film until a bulk temperature is in equilibrium with its loss; measured: 5.
const EVALUATIONS: f64 = 5.0;
/// Time per cell and step of an elastohydrodynamic record \[s\]; measured: 3 to 13e-6 with 512 cells, more with fewer.
const SECONDS_OF_A_CELL: f64 = 1e-5;
/// Share of the cells of a record per half-width, and half-widths before the record begins.
const RECORD: [f64; 2] = [0.25, 3.0];
/// Time per point of a trace for reading, preparing, evaluating and drawing \[s\].
const SECONDS_OF_A_TRACE_POINT: f64 = 1e-6;
/// Time of the load map and of writing the result \[s\].
const SECONDS_AROUND: f64 = 0.05;
/// Positions whose contact at one offset a measured estimate solves.
const SAMPLED: usize = 6;
/// Further offsets that are solved, to separate the time of the contacts from other work.
const MORE_OFFSETS: usize = 2;
/// Number of the points A to E, which are solved for display.
const NAMED: usize = 5;
/// Numbers stored per point of the surface and per point below it.
const NUMBERS: [f64; 2] = [12.0, 4.0];
/// Numbers stored per point of a trace while it is read, prepared and evaluated.
const NUMBERS_OF_TRACE: f64 = 20.0;
/// Memory of the program without traces, fields and contacts \[bytes\]; measured: 32 to 37e6 with the draws.
const BYTES_AROUND: f64 = 32e6;
/// Memory of a stored contact per point of its window \[bytes\]; measured: 4 to 5.
const BYTES_OF_A_TABLE: f64 = 5.0;
/// Bytes per number.
const BYTES: f64 = 8.0;

/// Estimates the run of `meshes`, one after the other, on the threads of the pool with the stored fields `kept`.
///
/// # Errors
/// When a position of a mesh has no smooth contact.
pub fn estimate<'a>(
    meshes: impl IntoIterator<Item = &'a LoadedCase>,
    kept: &Kept,
) -> Result<Cost, Error> {
    let mut meshes = meshes.into_iter();
    meshes.try_fold(Cost::default(), |sum, mesh| {
        Ok(sum.and(EstimateWork::new(mesh)?.estimate(mesh, kept, 1.0)))
    })
}

/// Estimates the run of `meshes` with the measured time of a few contacts of each on one thread. Records of mixed
/// lubrication, running-in and bulk temperatures are not computed.
///
/// # Errors
/// As [`estimate`], and when one of these contacts has no solution.
pub fn measured<'a>(
    meshes: impl IntoIterator<Item = &'a LoadedCase>,
    kept: &Kept,
) -> Result<Cost, Error> {
    let mut meshes = meshes.into_iter();
    meshes.try_fold(Cost::default(), |sum, mesh| {
        Ok(sum.and(measured_mesh(mesh, kept)?))
    })
}

fn measured_mesh(loaded: &LoadedCase, kept: &Kept) -> Result<Cost, Error> {
    let work = EstimateWork::new(loaded)?;
    if work.contacts == 0 || has_records(loaded) {
        return Ok(work.estimate(loaded, kept, 1.0));
    }
    let model = &loaded.case.model;
    let few = loaded.with(|input| {
        input.model.positions = Some(model.positions.min(SAMPLED));
        input.operation.running_in = None;
        input
            .operation
            .set_bulk_temperature(loaded.case.stated_temperature);
    })?;
    let of_offsets = |offsets: usize| -> Result<[f64; 2], Error> {
        let few = few.first_pair();
        let few = few.overridden(|over| over.offsets = Some(offsets))?;
        let begin = Instant::now();
        // Without tables the loss alone does not solve every contact.
        let run = || {
            if has_tables(&few) {
                Run::new(&few).losses().map(drop)
            } else {
                Run::new(&few)
                    .pictures(Kept::NoPictures)
                    .execute()
                    .map(drop)
            }
        };
        // Where the system gives no thread the estimate is of what the threads do.
        on_threads(1, run).unwrap_or_else(|_| run())?;
        let modelled = EstimateWork::new(&few)?.of_contacts;
        Ok([begin.elapsed().as_secs_f64(), modelled])
    };
    // The difference between two numbers of offsets excludes the time spent once per position.
    let (one, more) = (of_offsets(1)?, of_offsets(1 + MORE_OFFSETS)?);
    let [seconds, modelled] = [0, 1].map(|k: usize| more[k] - one[k]);
    let scale = if modelled > 0.0 {
        (seconds / modelled).max(0.0)
    } else {
        1.0
    };
    Ok(work.estimate(loaded, kept, scale))
}

/// Whether a run solves records of the lubricated contact.
pub(crate) fn has_records(loaded: &LoadedCase) -> bool {
    matches!(loaded.case.share_law(), ShareLaw::Reference)
        || loaded.case.model.full_film == FullFilmName::EhlTransient
}

/// Whether each contact is tabulated over its share of the load.
fn has_tables(loaded: &LoadedCase) -> bool {
    let case = &loaded.case;
    case.formulation.pressures().is_none() && case.share_law().contact().is_some()
}

/// Counted work of a run and its times \[s\].
struct EstimateWork {
    positions: usize,
    contacts: usize,
    /// Number of points of the windows of all positions.
    window_points: f64,
    /// Number of points of all contacts.
    points: f64,
    /// Number of points of all traces.
    traced: f64,
    /// Time of the contacts at the positions \[s\].
    of_contacts: f64,
    /// Contacts at the positions and the points A to E relative to the contacts at the positions.
    with_named: f64,
    /// Other parallel work of the positions.
    other: f64,
    /// Number of records, solved in parallel, and the time of each.
    records: (usize, f64),
}

impl EstimateWork {
    fn new(loaded: &LoadedCase) -> Result<Self, Error> {
        Self::counted(loaded).map_err(|error| Error::Whole(Box::new(error)))
    }

    fn counted(loaded: &LoadedCase) -> Result<Self, PositionError> {
        let model = &loaded.case.model;
        let stations = Mesh::new(&loaded.case)?.positions;
        let positions = stations.len();
        let traces = loaded.all_traces().into_iter();
        let traced: usize = traces
            .filter_map(|flank| Some(flank.trace.as_ref()?.len()))
            .sum();
        let textures = loaded.surfaces.textures();
        let prepared = textures.iter().filter_map(|texture| match texture {
            Texture::Trace(profile) => Some(profile),
            _ => None,
        });
        let longest = prepared.max_by_key(|profile| profile.len());
        let Some(trace) = longest.filter(|_| loaded.surfaces.are_measured()) else {
            return Ok(Self {
                positions,
                contacts: 0,
                window_points: 0.0,
                points: 0.0,
                traced: traced as f64,
                of_contacts: 0.0,
                with_named: 1.0,
                other: SECONDS_OF_FILM * positions as f64 * evaluations(loaded),
                records: (0, 0.0),
            });
        };
        let windows = stations
            .iter()
            .map(|station| 2.0 * model.window * (station.hertz.half_width / trace.spacing()));
        let window_points: f64 = windows.sum();
        let offsets = loaded.surfaces.offsets(model.offsets) as f64;
        let tables = has_tables(loaded);
        let of_a_point = match loaded.case.formulation.pressures() {
            Some(law) => law.seconds_of_a_point(&loaded.case.paper),
            None if tables => SECONDS_TABULATED,
            None => SECONDS_ONCE,
        };
        // Running-in solves the contacts again.
        let runs_in = loaded.case.running_in.is_some();
        let solves = if runs_in { 2.0 } else { 1.0 };
        let with_named = if tables {
            1.0 + NAMED as f64 / positions as f64
        } else {
            1.0
        };
        let points = window_points * offsets;
        let window = window_points / positions as f64;
        // The two traces are transformed together, forward and back: as a whole, or in pieces around the windows.
        let length = trace.len() as f64;
        let transformed = match tables {
            true if length > PIECES * PIECE * window => 2.0 * PIECE * window * offsets,
            true => 2.0 * length,
            false => 0.0,
        };
        let of_film = SECONDS_OF_FILM * offsets
            + SECONDS_OF_TRANSFORM * transformed * transformed.max(2.0).log2();
        let worn = match runs_in {
            // Windows lie a contact width apart.
            true => CYCLES * window * (trace.len() as f64 * model.window / window).powi(2),
            false => 0.0,
        };
        let cells = model.ehl.cells as f64;
        let steps = RECORD[0] * cells * (RECORD[1] + model.ehl.travel);
        let records = if has_records(loaded) {
            model.ehl.records.min(positions)
        } else {
            0
        };
        Ok(Self {
            positions,
            contacts: positions * offsets as usize,
            window_points,
            points,
            traced: traced as f64,
            of_contacts: of_a_point * points * solves,
            with_named,
            other: SECONDS_OF_STRESS * window_points * model.depths as f64
                + of_film * positions as f64 * evaluations(loaded) * solves
                + SECONDS_OF_WEAR * worn,
            records: (records, SECONDS_OF_A_CELL * cells * steps),
        })
    }

    /// The estimate with the time of the contacts multiplied by `scale`.
    fn estimate(&self, loaded: &LoadedCase, kept: &Kept, scale: f64) -> Cost {
        let threads = threads();
        let together = threads.min(self.positions.max(1)) as f64;
        let (records, of_a_record) = self.records;
        let rounds = records.div_ceil(threads) as f64;
        // Every thread stores the fields of its current position.
        let stored = self.positions.min(kept.of(self.positions) + threads) as f64;
        let depths = loaded.case.model.depths as f64;
        let of_fields = BYTES * (NUMBERS[0] + NUMBERS[1] * depths) * self.window_points;
        let of_tables = if has_tables(loaded) {
            BYTES_OF_A_TABLE * self.points
        } else {
            0.0
        };
        Cost {
            contacts: self.contacts,
            points: self.points,
            seconds: SECONDS_AROUND
                + SECONDS_OF_A_TRACE_POINT * self.traced
                + (scale * self.of_contacts * self.with_named + self.other) / together
                + rounds * of_a_record,
            bytes: BYTES_AROUND
                + stored / self.positions.max(1) as f64 * of_fields
                + BYTES * NUMBERS_OF_TRACE * self.traced
                + of_tables,
        }
    }
}

/// Evaluations of the film per position: for the loss, and for its draws and other models. Each has its own bulk temperature
/// if that follows from the loss.
fn evaluations(loaded: &LoadedCase) -> f64 {
    let of_draws = uncertainty::evaluations(loaded) as f64;
    let of_bulk = match loaded.case.bulk {
        Some(_) => EVALUATIONS,
        None => 1.0,
    };
    (1.0 + of_draws) * of_bulk
}
