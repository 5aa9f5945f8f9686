//! Estimate of the work of a run, before it is done.
//!
//! The work is counted: points of the contacts, of the stress below them, of running-in, of the transforms of the traces,
//! cells and steps of elastohydrodynamic records. Times per unit, measured on the shipped cases (docs/PERFORMANCE.md),
//! make a time of it. How long a contact takes depends on the flanks, too: from a third to three times as long. A measured
//! estimate therefore solves a few contacts of the case and scales the time of the contacts by theirs.

use std::time::Instant;

use asperity::case::planetary::LoadedPlanetary;
use asperity::case::{Formulation, FullFilmName, LoadShareName, LoadedCase};
use asperity::flanks::Texture;
use asperity::mesh::Mesh;
use asperity::pipeline::KeptFields;
use asperity::uncertainty::{DRAWS, has_band};
use asperity::{Error, PositionError, Run};

/// Time and memory that a run will take.
#[derive(Debug, Clone, Copy, PartialEq, Default, serde::Serialize)]
#[non_exhaustive]
pub struct Estimate {
    /// Rough contacts, one for every position and offset.
    pub contacts: usize,
    /// Points of all contacts together.
    pub points: f64,
    /// Time on the threads that are used \[s\].
    pub seconds: f64,
    /// Memory of the fields that are held and of the traces \[bytes\].
    pub bytes: f64,
}

impl Estimate {
    /// Both kinds of work one after the other.
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

/// Time of a point \[s\] where each contact is tabulated over its share of the load (`solved`): 0.8 to 8e-6 seen.
const SECONDS_TABULATED: f64 = 3e-6;
/// Time of a point \[s\] where each contact is solved once: 0.2 to 0.7e-6 seen.
const SECONDS_ONCE: f64 = 5e-7;
/// Time of a point and step \[s\] where the surfaces are lowered step by step (the paper's formulation).
const SECONDS_OF_A_STEP: f64 = 1.5e-7;
/// Distance by which the surfaces are lowered altogether \[m\].
const LOWERED: f64 = 6.4e-6;
/// Time of the stress at a point of one depth below the surface \[s\]: 6.3 to 7.4e-8 seen.
const SECONDS_OF_STRESS: f64 = 7e-8;
/// Time of a point of a contact of running-in \[s\].
const SECONDS_OF_WEAR: f64 = 1e-6;
/// Contacts over each place of a trace in the cycles of running-in: 4 in each of up to 12 cycles.
const PASSES_OF_A_PLACE: f64 = 40.0;
/// Time of the film and its friction at one position and offset \[s\].
const SECONDS_OF_FILM: f64 = 3e-5;
/// Time of one point of a transform and its logarithm \[s\].
const SECONDS_OF_TRANSFORM: f64 = 3e-9;
/// Points of a piece that is transformed around a window of a long trace, over those of the window.
const PIECE: f64 = 5.0;
/// Pieces whose points together a trace must exceed to be transformed in pieces.
const PIECES: f64 = 16.0;
/// Evaluations of the film that find a bulk temperature, and those of alternative laws beside the draws of a band.
const EVALUATIONS: [f64; 2] = [8.0, 5.0];
/// Time of a cell and step of an elastohydrodynamic record \[s\]: 3 to 13e-6 seen with 512 cells, more with fewer.
const SECONDS_OF_A_CELL: f64 = 1e-5;
/// Cells of a record that a half-width spans, over all of its cells, and half-widths before it begins.
const RECORD: [f64; 2] = [0.25, 3.0];
/// Time of reading, preparing and evaluating a point of a trace, and of drawing it \[s\].
const SECONDS_OF_A_TRACE_POINT: f64 = 1e-6;
/// Time of the load map and of writing the result \[s\].
const SECONDS_AROUND: f64 = 0.05;
/// Positions of which a measured estimate solves the contact at one offset.
const SAMPLED: usize = 6;
/// Further offsets that are solved to separate the time of a contact from that of the rest.
const MORE_OFFSETS: usize = 2;
/// Points A to E, which are solved for display.
const NAMED: usize = 5;
/// Numbers held for a point of the surface, and for a point at a depth.
const NUMBERS: [f64; 2] = [12.0, 4.0];
/// Numbers held for a point of a trace while it is read, prepared and evaluated.
const NUMBERS_OF_TRACE: f64 = 20.0;
/// Memory of the program without traces and fields \[bytes\].
const BYTES_AROUND: f64 = 20e6;
/// Bytes of a number.
const BYTES: f64 = 8.0;

/// Estimates the run of `loaded` on the threads of the pool, where the fields `kept` are held.
///
/// # Errors
/// When a position of the mesh has no smooth contact.
pub fn estimate(loaded: &LoadedCase, kept: &KeptFields) -> Result<Estimate, Error> {
    Ok(Work::of(loaded)?.estimate(loaded, kept, 1.0))
}

/// Estimates the run of both meshes of a planetary set.
///
/// # Errors
/// As [`estimate`].
pub fn estimate_of_set(loaded: &LoadedPlanetary, kept: &KeptFields) -> Result<Estimate, Error> {
    let [first, second] = &loaded.meshes;
    Ok(estimate(first, kept)?.and(estimate(second, kept)?))
}

/// Estimates the run of `loaded` with the time that a few of its contacts take now, on one thread. Records of mixed
/// lubrication, running-in and bulk temperatures are not computed for it.
///
/// # Errors
/// As [`estimate`], and when one of these contacts has no solution.
pub fn measured(loaded: &LoadedCase, kept: &KeptFields) -> Result<Estimate, Error> {
    let work = Work::of(loaded)?;
    let Ok(alone) = rayon::ThreadPoolBuilder::new().num_threads(1).build() else {
        return Ok(work.estimate(loaded, kept, 1.0));
    };
    if work.contacts == 0 || has_records(loaded) {
        return Ok(work.estimate(loaded, kept, 1.0));
    }
    let model = &loaded.case.model;
    let of_offsets = |offsets: usize| -> Result<[f64; 2], Error> {
        let few = loaded.with(|input| {
            input.model.positions = Some(model.positions.min(SAMPLED));
            input.model.offsets = Some(offsets);
            input.model.run_in = None;
            input.operation.bulk = None;
        })?;
        let begin = Instant::now();
        alone.install(|| Run::new(&few).without_pictures().execute())?;
        let modelled = Work::of(&few)?.of_contacts;
        Ok([begin.elapsed().as_secs_f64(), modelled])
    };
    // What is spent once at a position does not count: it is that of the offsets which differs.
    let (one, more) = (of_offsets(1)?, of_offsets(1 + MORE_OFFSETS)?);
    let [seconds, modelled] = [0, 1].map(|k: usize| more[k] - one[k]);
    let scale = if modelled > 0.0 {
        (seconds / modelled).max(0.0)
    } else {
        1.0
    };
    Ok(work.estimate(loaded, kept, scale))
}

/// Estimates the run of both meshes of a planetary set as [`measured`] does.
///
/// # Errors
/// As [`measured`].
pub fn measured_of_set(loaded: &LoadedPlanetary, kept: &KeptFields) -> Result<Estimate, Error> {
    let [first, second] = &loaded.meshes;
    Ok(measured(first, kept)?.and(measured(second, kept)?))
}

fn has_records(loaded: &LoadedCase) -> bool {
    let model = &loaded.case.model;
    model.load_share == LoadShareName::Ehl || model.full_film == FullFilmName::EhlTransient
}

/// Counted work of a run and its time by part \[s\].
struct Work {
    positions: usize,
    contacts: usize,
    /// Points of the windows of all positions.
    window_points: f64,
    /// Points of all contacts.
    points: f64,
    /// Points of all traces.
    traced: f64,
    of_contacts: f64,
    /// Other work that positions do at the same time.
    beside: f64,
    /// Work on one thread.
    serial: f64,
    /// Records, solved at the same time, and the time of each.
    records: (usize, f64),
}

impl Work {
    fn of(loaded: &LoadedCase) -> Result<Self, Error> {
        Self::counted(loaded).map_err(|error| Error::Whole(Box::new(error)))
    }

    fn counted(loaded: &LoadedCase) -> Result<Self, PositionError> {
        let model = &loaded.case.model;
        let stations = Mesh::of(&loaded.case)?.positions;
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
                beside: SECONDS_OF_FILM * positions as f64 * evaluations(loaded),
                serial: 0.0,
                records: (0, 0.0),
            });
        };
        let windows = stations
            .iter()
            .map(|station| 2.0 * model.window * (station.hertz.half_width / trace.spacing()));
        let window_points: f64 = windows.sum();
        let offsets = loaded.surfaces.offsets(model.offsets) as f64;
        let is_corrected = loaded.case.formulation == Formulation::Corrected;
        let tables = is_corrected && model.load_share.supply().is_some();
        let of_a_point = match loaded.case.formulation {
            Formulation::Paper => SECONDS_OF_A_STEP * (LOWERED / model.delta_step.si()),
            Formulation::Corrected if tables => SECONDS_TABULATED,
            Formulation::Corrected => SECONDS_ONCE,
        };
        // A bulk temperature is found with contacts of its own; running-in solves them anew.
        let anew = [loaded.case.bulk.is_some(), model.run_in];
        let solves = 1.0 + anew.into_iter().filter(|is_asked| *is_asked).count() as f64;
        let named = match tables {
            true => 1.0 + NAMED as f64 / positions as f64,
            false => 1.0,
        };
        let points = window_points * offsets;
        let window = window_points / positions as f64;
        // The two traces are transformed together, there and back: as a whole, or a piece around each window.
        let length = trace.len() as f64;
        let transformed = match tables {
            true if length > PIECES * PIECE * window => 2.0 * PIECE * window * offsets,
            true => 2.0 * length,
            false => 0.0,
        };
        let of_film = SECONDS_OF_FILM * offsets
            + SECONDS_OF_TRANSFORM * transformed * transformed.max(2.0).log2();
        let worn = match model.run_in {
            true => PASSES_OF_A_PLACE * model.window * trace.len() as f64,
            false => 0.0,
        };
        let cells = model.ehl.cells as f64;
        let steps = RECORD[0] * cells * (RECORD[1] + model.ehl.travel);
        let records = match has_records(loaded) {
            true => model.ehl.records.min(positions),
            false => 0,
        };
        Ok(Self {
            positions,
            contacts: positions * offsets as usize,
            window_points,
            points,
            traced: traced as f64,
            of_contacts: of_a_point * points * solves * named,
            beside: SECONDS_OF_STRESS * window_points * model.depths as f64
                + of_film * positions as f64 * evaluations(loaded) * solves,
            serial: SECONDS_OF_WEAR * worn,
            records: (records, SECONDS_OF_A_CELL * cells * steps),
        })
    }

    /// The estimate, where the contacts take `scale` times as long as usual.
    fn estimate(&self, loaded: &LoadedCase, kept: &KeptFields, scale: f64) -> Estimate {
        let threads = rayon::current_num_threads();
        let together = threads.min(self.positions.max(1)) as f64;
        let (records, of_a_record) = self.records;
        let rounds = records.div_ceil(threads) as f64;
        // Every thread holds the fields of the position it is at.
        let held = self.positions.min(kept.of(self.positions) + threads) as f64;
        let depths = loaded.case.model.depths as f64;
        let of_fields = BYTES * (NUMBERS[0] + NUMBERS[1] * depths) * self.window_points;
        Estimate {
            contacts: self.contacts,
            points: self.points,
            seconds: SECONDS_AROUND
                + SECONDS_OF_A_TRACE_POINT * self.traced
                + (scale * self.of_contacts + self.beside) / together
                + scale * self.serial
                + rounds * of_a_record,
            bytes: BYTES_AROUND
                + held / self.positions.max(1) as f64 * of_fields
                + BYTES * NUMBERS_OF_TRACE * self.traced,
        }
    }
}

/// Times that the film of every position is evaluated: for the loss, for each draw and alternative of its band, and to
/// find a bulk temperature.
fn evaluations(loaded: &LoadedCase) -> f64 {
    let of_band = match has_band(loaded) {
        true => DRAWS as f64 + EVALUATIONS[1],
        false => 0.0,
    };
    let of_bulk = match loaded.case.bulk {
        Some(_) => EVALUATIONS[0],
        None => 0.0,
    };
    1.0 + of_band + of_bulk
}
