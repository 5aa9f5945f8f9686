//! Estimate of the work of a run, before it is done.
//!
//! A quick one follows from the points of all contacts and times per point, as measured on the four shipped cases
//! (docs/PERFORMANCE.md). How long a contact takes depends on the flanks, too: from a third to three times as long. A
//! measured one therefore solves a few contacts of the case and scales their time; it was 0.5 to 1 times that of the run.

use std::time::Instant;

use asperity::case::planetary::LoadedPlanetary;
use asperity::case::{Formulation, LoadedCase};
use asperity::kept_fields::KeptFields;
use asperity::pipeline::{contacts, stations};
use asperity::surfaces::Texture;
use asperity::{Error, PositionError};

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
    /// Memory of the fields that are held \[bytes\].
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
/// The same where each contact is solved once: 0.2 to 0.7e-6 seen.
const SECONDS_ONCE: f64 = 5e-7;
/// The same where the surfaces are lowered step by step (the paper's reading), per step.
const SECONDS_OF_A_STEP: f64 = 1.5e-7;
/// Distance by which the surfaces are lowered altogether \[m\].
const LOWERED: f64 = 6.4e-6;
/// Time of the stress at a point of one depth below the surface \[s\]: 6.3 to 7.4e-8 seen.
const SECONDS_OF_STRESS: f64 = 7e-8;
/// Time of reading and preparing the traces, of the load map and of writing the result \[s\].
const SECONDS_AROUND: f64 = 0.02;
/// Positions of which a measured estimate solves the contact at one offset.
const SAMPLED: usize = 6;
/// Further offsets that are solved to separate the time of a contact from that of the rest.
const MORE_OFFSETS: usize = 2;
/// Points A to E, which are solved for display.
const NAMED: usize = 5;
/// Numbers held for a point of the surface, and for a point at a depth.
const NUMBERS: [f64; 2] = [12.0, 4.0];
/// Bytes of a number.
const BYTES: f64 = 8.0;

/// Estimates the run of `loaded` on the threads of the pool, where the fields `kept` are held.
///
/// # Errors
/// When a position of the mesh has no smooth contact.
pub fn estimate(loaded: &LoadedCase, kept: &KeptFields) -> Result<Estimate, Error> {
    of_case(loaded, kept).map_err(|error| Error::Whole(Box::new(error)))
}

/// Estimates the run of both meshes of a planetary set.
///
/// # Errors
/// As [`estimate`].
pub fn estimate_of_set(loaded: &LoadedPlanetary, kept: &KeptFields) -> Result<Estimate, Error> {
    let [first, second] = &loaded.meshes;
    Ok(estimate(first, kept)?.and(estimate(second, kept)?))
}

/// Estimates the run of `loaded` from the time that a few of its contacts take now, on one thread.
///
/// # Errors
/// As [`estimate`], and when one of these contacts has no solution.
pub fn measured(loaded: &LoadedCase, kept: &KeptFields) -> Result<Estimate, Error> {
    let quick = estimate(loaded, kept)?;
    if quick.contacts == 0 {
        return Ok(quick);
    }
    let model = &loaded.case.model;
    let Ok(alone) = rayon::ThreadPoolBuilder::new().num_threads(1).build() else {
        return Ok(quick);
    };
    let mut solved = 0;
    let mut time = |offsets: usize| -> Result<f64, Error> {
        let few = loaded.with(|input| {
            input.model.positions = Some(model.positions.min(SAMPLED));
            input.model.offsets = Some(offsets);
        })?;
        let begin = Instant::now();
        let outcome = alone.install(|| contacts(&few, &|_, _| {}))?;
        solved = outcome.result.path.len();
        Ok(begin.elapsed().as_secs_f64())
    };
    // Further offsets tell the time of their contacts; the rest is spent once at a position.
    let one = time(1)?;
    let more = time(1 + MORE_OFFSETS)?;
    let of_an_offset = ((more - one) / MORE_OFFSETS as f64).max(0.0);
    let once = (one - of_an_offset).max(0.0);
    // The points A to E cost a contact each where the load share needs one.
    let is_corrected = loaded.case.formulation == Formulation::Corrected;
    let named = match is_corrected && model.load_share.supply().is_some() {
        true => NAMED,
        false => 0,
    };
    let all = loaded.surfaces.offsets(model.offsets).max(1);
    let positions = quick.contacts / all;
    let scale = (positions + named) as f64 / (solved + named).max(1) as f64;
    let work = scale * (once + of_an_offset * model.offsets as f64);
    let stress = SECONDS_OF_STRESS * quick.points / all as f64 * model.depths as f64;
    let threads = rayon::current_num_threads().min(positions.max(1)) as f64;
    Ok(Estimate {
        seconds: SECONDS_AROUND + (work + stress) / threads,
        ..quick
    })
}

/// Estimates the run of both meshes of a planetary set as [`measured`] does.
///
/// # Errors
/// As [`measured`].
pub fn measured_of_set(loaded: &LoadedPlanetary, kept: &KeptFields) -> Result<Estimate, Error> {
    let [first, second] = &loaded.meshes;
    Ok(measured(first, kept)?.and(measured(second, kept)?))
}

fn of_case(loaded: &LoadedCase, kept: &KeptFields) -> Result<Estimate, PositionError> {
    let model = &loaded.case.model;
    let mut traces = loaded.surfaces.textures().iter();
    let spacing = traces.find_map(|texture| match texture {
        Texture::Trace(profile) => Some(profile.spacing()),
        _ => None,
    });
    let stations = stations(&loaded.case)?;
    let Some(spacing) = spacing.filter(|_| loaded.surfaces.are_measured()) else {
        return Ok(Estimate {
            seconds: SECONDS_AROUND,
            ..Estimate::default()
        });
    };
    let windows = stations
        .iter()
        .map(|station| 2.0 * model.window * (station.hertz.half_width / spacing));
    let once: f64 = windows.sum();
    let offsets = loaded.surfaces.offsets(model.offsets);
    let points = once * offsets as f64;
    let depths = model.depths as f64;
    let of_a_point = match loaded.case.formulation {
        Formulation::Paper => SECONDS_OF_A_STEP * (LOWERED / model.delta_step.si()),
        Formulation::Corrected if model.load_share.supply().is_some() => SECONDS_TABULATED,
        Formulation::Corrected => SECONDS_ONCE,
    };
    let work = of_a_point * points + SECONDS_OF_STRESS * once * depths;
    let threads = rayon::current_num_threads();
    // Every thread holds the fields of the position it is at.
    let held = stations.len().min(kept.of(stations.len()) + threads) as f64;
    let of_fields = BYTES * (NUMBERS[0] + NUMBERS[1] * depths);
    Ok(Estimate {
        contacts: stations.len() * offsets,
        points,
        seconds: SECONDS_AROUND + work / threads.min(stations.len()) as f64,
        bytes: held / stations.len() as f64 * once * of_fields,
    })
}
